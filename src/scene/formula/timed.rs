//! Formulas of position and time.

use serde::de::{Deserialize, Deserializer, Error, Visitor};

use super::{Formula, FormulaVisitor, Node, Number, Place, Variable, parse};

/// A number, or a formula of position and time.
#[derive(Clone, Debug, PartialEq)]
pub struct TimedFormula(Formula);

impl TimedFormula {
    /// The value at `place`; not finite where the formula divides by zero and the like.
    pub fn at<T: Number>(&self, place: &Place<T>) -> T {
        self.0.at(place)
    }

    /// The number that it is; none of a formula.
    pub fn number(&self) -> Option<f64> {
        match self.0.0 {
            Node::Number(number) => Some(number),
            _ => None,
        }
    }

    /// True where it changes with time.
    pub fn knows_time(&self) -> bool {
        self.0.0.knows(&|variable| variable == Variable::Time)
    }

    /// True where it changes from place to place.
    pub fn knows_place(&self) -> bool {
        let is_place = |variable| matches!(variable, Variable::Axis(_) | Variable::Radius);
        self.0.0.knows(&is_place)
    }
}

impl std::str::FromStr for TimedFormula {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        parse::parse(text, true).map(|node| Self(Formula(node)))
    }
}

impl<'de> Deserialize<'de> for TimedFormula {
    fn deserialize<T: Deserializer<'de>>(deserializer: T) -> Result<Self, T::Error> {
        deserializer.deserialize_any(TimedVisitor)
    }
}

struct TimedVisitor;

impl Visitor<'_> for TimedVisitor {
    type Value = TimedFormula;

    fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("a number, or a formula in quotes such as \"1 + 0.2 * sin(5 * x - t)\"")
    }

    fn visit_f64<E: Error>(self, number: f64) -> Result<TimedFormula, E> {
        FormulaVisitor.visit_f64(number).map(TimedFormula)
    }

    fn visit_i64<E: Error>(self, number: i64) -> Result<TimedFormula, E> {
        FormulaVisitor.visit_i64(number).map(TimedFormula)
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<TimedFormula, E> {
        text.parse().map_err(E::custom)
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::SVector;
    use num_dual::{DualSVec64, gradient};

    use super::*;

    /// Value and derivatives by x, y, z and t.
    fn derivatives(text: &str, at: [f64; 4]) -> (f64, [f64; 4]) {
        let formula: TimedFormula = text.parse().unwrap();
        let value = |at: SVector<DualSVec64<4>, 4>| {
            formula.at(&Place {
                position: [at[0], at[1], at[2]],
                time: at[3],
                spacing: 0.5,
            })
        };
        let (value, slopes) = gradient(value, &SVector::from(at));
        (value, slopes.into())
    }

    #[test]
    fn derivatives_are_those_of_the_formula() {
        let at = [-0.3, 0.4, 0.7, 1.2];
        let [x, y, _, t] = at;
        let (value, slopes) = derivatives("x^2 * sin(3 * t) + exp(y) / (2 - z) + dx", at);
        assert!((value - (x * x * (3.0 * t).sin() + y.exp() / 1.3 + 0.5)).abs() < 1e-15);
        let expected = [
            2.0 * x * (3.0 * t).sin(),
            y.exp() / 1.3,
            y.exp() / 1.69,
            3.0 * x * x * (3.0 * t).cos(),
        ];
        for (slope, expected) in slopes.into_iter().zip(expected) {
            assert!((slope - expected).abs() < 1e-14, "{slope} {expected}");
        }
    }

    #[test]
    fn powers_of_negative_numbers_and_choices_have_slopes() {
        let at = [-2.0, 3.0, 0.0, 0.0];
        assert_eq!(derivatives("x^3", at), (-8.0, [12.0, 0.0, 0.0, 0.0]));
        assert_eq!(
            derivatives("max(x, y) + abs(x)", at).1,
            [-1.0, 1.0, 0.0, 0.0]
        );
        assert_eq!(
            derivatives("if(x < 0, y * y, x)", at).1,
            [0.0, 6.0, 0.0, 0.0]
        );
        let (value, slopes) = derivatives("y^x", at);
        assert!((value - 1.0 / 9.0).abs() < 1e-15);
        assert!((slopes[0] - 3.0_f64.ln() / 9.0).abs() < 1e-15);
        assert!((slopes[1] + 2.0 / 27.0).abs() < 1e-15);
    }

    #[test]
    fn time_is_known_here_alone() {
        assert!("1 + t".parse::<TimedFormula>().is_ok());
        let message = "1 + t".parse::<Formula>().unwrap_err();
        assert!(
            message.contains("`t` is unknown; there are x, y, z, r, dx"),
            "{message}"
        );
    }
}
