//! Mistakes in one term of one equation. A factor in a term of the source is what the same factor in the solver's own term would be, with
//! the other sign: what does not show here would not show there.

use std::fmt;

use aero::scene::manufactured::{Manufactured, Share, Terms};
use aero_geometry::Vector;
use aero_solver::problem::{Added, Source};

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
    /// What viscosity does along straight lines, or its heat.
    Rubbed,
    /// What viscosity does where gas spreads, or the heat that is conducted.
    Spread,
    /// What a change of the viscosity does.
    Thickened,
}

/// A wrong factor of a term.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mistake {
    /// Where.
    pub equation: Equation,
    /// Of what.
    pub term: Term,
    /// How wrong.
    pub factor: f64,
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
            (Equation::Velocity, Term::Rubbed) => "mu lap u / rho",
            (Equation::Velocity, Term::Spread) => "mu grad div u / (3 rho)",
            (Equation::Velocity, Term::Thickened) => "strain grad mu / rho",
            (Equation::Energy, Term::Rubbed) => "tau : grad u / rho",
            (Equation::Energy, Term::Spread | Term::Thickened) => "div (k grad T) / rho",
            (Equation::Density, _) => "nothing",
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
        let rubbed = &mut terms.rubbed;
        match (equation, term) {
            (Equation::Velocity, Term::Rubbed) => rubbed.strained *= factor,
            (Equation::Velocity, Term::Spread) => rubbed.dilated *= factor,
            (Equation::Velocity, Term::Thickened) => rubbed.thickened *= factor,
            (Equation::Energy, Term::Rubbed) => rubbed.dissipated *= factor,
            (Equation::Energy, Term::Spread | Term::Thickened) => rubbed.conducted *= factor,
            _ => {}
        }
        match equation {
            Equation::Density => scale(&mut terms.density, term, factor),
            Equation::Velocity => scale(&mut terms.velocity, term, factor),
            Equation::Energy => scale(&mut terms.energy, term, factor),
        }
        terms.added()
    }
}

fn scale<T: std::ops::MulAssign<f64>>(share: &mut Share<T>, term: Term, factor: f64) {
    match term {
        Term::Unsteady => share.unsteady *= factor,
        Term::Carried => share.carried *= factor,
        Term::Pressed => share.pressed *= factor,
        Term::Rubbed | Term::Spread | Term::Thickened => {}
    }
}
