//! Formulas of position for the gas at the start: `1 + 0.2 * sin(5 * x)`.
//!
//! Knows `x`, `y`, `z`, `r` (distance from the origin), `dx` (the scene's spacing), `pi`, the
//! operators `+ - * / ^`, comparisons (1 where they hold, else 0) and the functions that `parse.rs` lists; a [`TimedFormula`] knows
//! the time `t` too. Evaluated in any kind of number: dual ones give derivatives.

mod parse;
mod timed;

use std::fmt;

use num_dual::DualNum;
use serde::de::{Deserialize, Deserializer, Error, Visitor};

pub use timed::TimedFormula;

/// What formulas are evaluated in: `f64`, and dual numbers over it.
pub trait Number: DualNum<Primitive = f64> + Copy {}

impl<T: DualNum<Primitive = f64> + Copy> Number for T {}

/// A number, or a formula of position.
#[derive(Clone, Debug, PartialEq)]
pub struct Formula(Node);

/// Where a formula is evaluated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place<T = f64> {
    /// Coordinates; missing axes are zero.
    pub position: [T; 3],
    /// Time; zero for formulas that do not know it.
    pub time: T,
    /// Particle spacing of the scene.
    pub spacing: f64,
}

#[derive(Clone, Debug, PartialEq)]
enum Node {
    Number(f64),
    Variable(Variable),
    Negative(Box<Node>),
    Pair(Operator, Box<[Node; 2]>),
    Call(Function, Vec<Node>),
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Variable {
    Axis(usize),
    Radius,
    Spacing,
    Time,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Operator {
    Add,
    Subtract,
    Multiply,
    Divide,
    Power,
    Less,
    AtMost,
    Greater,
    AtLeast,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Function {
    Sin,
    Cos,
    Exp,
    Ln,
    Sqrt,
    Abs,
    Tanh,
    Min,
    Max,
    /// `if(condition, then, else)`: the other branch is not looked at.
    If,
}

impl Formula {
    /// The value at `place`; not finite where the formula divides by zero and the like.
    pub fn at<T: Number>(&self, place: &Place<T>) -> T {
        self.0.at(place)
    }
}

impl From<f64> for Formula {
    fn from(number: f64) -> Self {
        Self(Node::Number(number))
    }
}

impl Node {
    fn at<T: Number>(&self, place: &Place<T>) -> T {
        match self {
            Self::Number(number) => (*number).into(),
            Self::Variable(Variable::Axis(axis)) => place.position[*axis],
            Self::Variable(Variable::Radius) => {
                place.position.iter().map(|x| *x * *x).sum::<T>().sqrt()
            }
            Self::Variable(Variable::Spacing) => place.spacing.into(),
            Self::Variable(Variable::Time) => place.time,
            Self::Negative(node) => -node.at(place),
            Self::Pair(Operator::Power, nodes) => {
                let [base, exponent] = [nodes[0].at(place), nodes[1].at(place)];
                // A logarithm would want a base above zero, also where the exponent does not change.
                if T::NDERIV == 0 || nodes[1].is_constant() {
                    base.powf(exponent.re())
                } else {
                    base.powd(exponent)
                }
            }
            Self::Pair(operator, nodes) => operator.apply(nodes[0].at(place), nodes[1].at(place)),
            Self::Call(function, nodes) => function.apply(nodes, place),
        }
    }

    /// True of what is the same everywhere and at all times.
    fn is_constant(&self) -> bool {
        !self.knows(&|variable| variable != Variable::Spacing)
    }

    /// True where any variable in it is as `is_sought` says.
    fn knows(&self, is_sought: &impl Fn(Variable) -> bool) -> bool {
        match self {
            Self::Number(_) => false,
            Self::Variable(variable) => is_sought(*variable),
            Self::Negative(node) => node.knows(is_sought),
            Self::Pair(_, nodes) => nodes.iter().any(|node| node.knows(is_sought)),
            Self::Call(_, nodes) => nodes.iter().any(|node| node.knows(is_sought)),
        }
    }
}

impl Operator {
    fn apply<T: Number>(self, a: T, b: T) -> T {
        let truth = |holds: bool| f64::from(u8::from(holds)).into();
        match self {
            Self::Add => a + b,
            Self::Subtract => a - b,
            Self::Multiply => a * b,
            Self::Divide => a / b,
            Self::Power => a.powd(b),
            Self::Less => truth(a.re() < b.re()),
            Self::AtMost => truth(a.re() <= b.re()),
            Self::Greater => truth(a.re() > b.re()),
            Self::AtLeast => truth(a.re() >= b.re()),
        }
    }
}

impl Function {
    fn apply<T: Number>(self, nodes: &[Node], place: &Place<T>) -> T {
        let value = |number: usize| nodes[number].at(place);
        match self {
            Self::Sin => value(0).sin(),
            Self::Cos => value(0).cos(),
            Self::Exp => value(0).exp(),
            Self::Ln => value(0).ln(),
            Self::Sqrt => value(0).sqrt(),
            Self::Abs => value(0).abs(),
            Self::Tanh => value(0).tanh(),
            Self::Min => chosen([value(0), value(1)], |a, b| a <= b),
            Self::Max => chosen([value(0), value(1)], |a, b| a >= b),
            Self::If if value(0).re() != 0.0 => value(1),
            Self::If => value(2),
        }
    }
}

/// The first of two where `is_first`, else the second; the other one of what is no number.
fn chosen<T: Number>([a, b]: [T; 2], is_first: impl Fn(f64, f64) -> bool) -> T {
    if is_first(a.re(), b.re()) || b.re().is_nan() {
        a
    } else {
        b
    }
}

impl std::str::FromStr for Formula {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        parse::parse(text, false).map(Self)
    }
}

impl<'de> Deserialize<'de> for Formula {
    fn deserialize<T: Deserializer<'de>>(deserializer: T) -> Result<Self, T::Error> {
        deserializer.deserialize_any(FormulaVisitor)
    }
}

/// Written by hand because serde's `untagged` would lose the position of an error in the file.
struct FormulaVisitor;

impl Visitor<'_> for FormulaVisitor {
    type Value = Formula;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a number, or a formula in quotes such as \"1 + 0.2 * sin(5 * x)\"")
    }

    fn visit_f64<E: Error>(self, number: f64) -> Result<Formula, E> {
        if number.is_finite() {
            Ok(number.into())
        } else {
            Err(E::custom(format!("{number} is not a finite number")))
        }
    }

    fn visit_i64<E: Error>(self, number: i64) -> Result<Formula, E> {
        Ok((number as f64).into())
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<Formula, E> {
        text.parse().map_err(E::custom)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn value(text: &str) -> f64 {
        let formula: Formula = text.parse().unwrap();
        formula.at(&Place {
            position: [3.0, 4.0, 0.0],
            time: 0.0,
            spacing: 0.5,
        })
    }

    #[test]
    fn operators_bind_as_on_paper() {
        assert_eq!(value("1 + 2 * 3 - 4 / 2"), 5.0);
        assert_eq!(value("-x^2"), -9.0);
        assert_eq!(value("2^3^2"), 512.0);
        assert_eq!(value("2^-1"), 0.5);
        assert_eq!(value("8 / 4 / 2"), 1.0);
        assert_eq!(value("1e-3 * 2.5E+2"), 0.25);
    }

    #[test]
    fn position_distance_and_spacing_are_known() {
        assert_eq!(value("x + y * z + r + dx"), 8.5);
        assert_eq!(value("cos(pi)"), -1.0);
    }

    #[test]
    fn a_condition_chooses_and_spares_the_other_branch() {
        assert_eq!(value("if(x < 3, 1 / 0, if(y >= 4, 7, 8))"), 7.0);
        assert_eq!(value("max(x, min(9, 5))"), 5.0);
    }
}
