//! Mistakes in one term of one equation. A factor in a term of the source is what the same factor in the solver's own term would be, with
//! the other sign: what does not show here would not show there.

use std::fmt;

use aero::scene::manufactured::{Manufactured, Share, Terms};
use aero_geometry::Vector;
use aero_solver::problem::{Added, Source};
use aero_validation::table::{Check, Subject};

use super::series::Series;
use super::{NAME, PLANE};
use crate::compare::context::{CompareError, Context, Level};
use crate::compare::variant::Scheme;

/// An equation, by what it is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Equation {
    /// Of mass; points alone have one, particles keep theirs.
    Density,
    /// Of momentum.
    Velocity,
    /// Of energy.
    Energy,
}

/// A term of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Term {
    /// The derivative by time.
    Unsteady,
    /// What the gas carries past.
    Carried,
    /// What pressure or divergence does.
    Pressed,
}

/// A wrong factor of a term.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mistake {
    equation: Equation,
    term: Term,
    factor: f64,
}

impl fmt::Display for Mistake {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let term = match (self.equation, self.term) {
            (Equation::Density, Term::Unsteady) => "rho_t",
            (Equation::Density, Term::Carried) => "u.grad rho",
            (Equation::Density, Term::Pressed) => "rho div u",
            (Equation::Velocity, Term::Unsteady) => "u_t",
            (Equation::Velocity, Term::Carried) => "u.grad u",
            (Equation::Velocity, Term::Pressed) => "grad p / rho",
            (Equation::Energy, Term::Unsteady) => "e_t",
            (Equation::Energy, Term::Carried) => "u.grad e",
            (Equation::Energy, Term::Pressed) => "p div u / rho",
        };
        if self.factor == -1.0 {
            write!(f, "the wrong sign of {term}")
        } else {
            write!(f, "{} times {term}", self.factor)
        }
    }
}

/// The sources of a solution, with a mistake.
#[derive(Debug)]
pub struct Mistaken<const D: usize> {
    /// The solution.
    pub solution: Manufactured<D>,
    /// The mistake.
    pub mistake: Mistake,
}

impl<const D: usize> Source<D> for Mistaken<D> {
    fn at(&self, position: &Vector<D>, time: f64) -> Added<D> {
        let mut terms: Terms<D> = self.solution.terms(position, time);
        let Mistake {
            equation,
            term,
            factor,
        } = self.mistake;
        match equation {
            Equation::Density => scale(&mut terms.density, term, factor),
            Equation::Velocity => scale(&mut terms.velocity, term, factor),
            Equation::Energy => scale(&mut terms.energy, term, factor),
        }
        terms.added()
    }
}

fn scale<T: std::ops::MulAssign<f64>>(share: &mut Share<T>, term: Term, factor: f64) {
    *match term {
        Term::Unsteady => &mut share.unsteady,
        Term::Carried => &mut share.carried,
        Term::Pressed => &mut share.pressed,
    } *= factor;
}

/// A mistake is caught where the order of the error of what its equation is for falls below this.
const CAUGHT: f64 = 1.5;

/// Every term of every equation with the wrong sign and with one per cent too much.
pub fn compare(scheme: Scheme, context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    let cells: &[u32] = match context.level {
        Level::Quick => &[16, 32],
        Level::Full => &[32, 64, 128],
    };
    let factors: &[f64] = match context.level {
        Level::Quick => &[-1.0],
        Level::Full => &[-1.0, 1.01],
    };
    let mut checks = Vec::new();
    for equation in [Equation::Density, Equation::Velocity, Equation::Energy] {
        if equation == Equation::Density && !scheme.is_of_points() {
            continue;
        }
        for term in [Term::Unsteady, Term::Carried, Term::Pressed] {
            for &factor in factors {
                let mistake = Mistake {
                    equation,
                    term,
                    factor,
                };
                checks.push(caught(mistake, scheme, cells, context)?);
            }
        }
    }
    Ok(checks)
}

/// The row of a mistake: the order of the last pair, with those before in its name.
fn caught(
    mistake: Mistake,
    scheme: Scheme,
    cells: &[u32],
    context: &Context<'_>,
) -> Result<Check, CompareError> {
    // The error of the energy is that of the pressure.
    let quantity = match mistake.equation {
        Equation::Velocity => 0,
        Equation::Density => 1,
        Equation::Energy => 2,
    };
    let series = Series::run(PLANE, scheme, &[], cells, Some(mistake), context)?;
    let orders = series.orders(quantity);
    let first = cells[1..]
        .iter()
        .zip(&orders)
        .find(|(_, order)| **order < CAUGHT);
    let seen = match (&series.stopped, first) {
        (Some(_), _) => "stops".to_owned(),
        (None, Some((cells, _))) => format!("seen from {cells} on"),
        (None, None) => "not seen".to_owned(),
    };
    let what = format!(
        "planted: {}, lattice, {mistake}, {seen}: order of the last pair",
        scheme.laws()
    );
    let subject = Subject::new(NAME, &what, "must not converge");
    Ok(match series.stopped {
        // A run that the mistake ends is one that is caught.
        Some(_) => subject.informs(0.0, CAUGHT),
        // One per cent is less than what some of the particles' terms are off by at these spacings.
        None if mistake.factor > 0.0 && !scheme.is_of_points() => {
            subject.informs(series.order(quantity), CAUGHT)
        }
        None => subject.at_most(series.order(quantity), CAUGHT),
    })
}
