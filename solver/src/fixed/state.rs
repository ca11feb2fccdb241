//! The state of the gas in a cell: what it holds, and what it feels like.

use std::array;

use super::gas::Gas;
use super::real::Real;
use crate::problem::State;

/// Density, velocity and pressure.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Primitive<const D: usize, R = f64> {
    /// Density, kg/m^3.
    pub density: R,
    /// Velocity, m/s.
    pub velocity: [R; D],
    /// Pressure, Pa.
    pub pressure: R,
}

/// Mass, momentum and energy: per volume, in sum, or per time through a face.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Conserved<const D: usize, R = f64> {
    /// Mass.
    pub mass: R,
    /// Momentum.
    pub momentum: [R; D],
    /// Internal and kinetic energy.
    pub energy: R,
}

/// `a.b`.
#[inline(always)]
pub fn dot<R: Real, const D: usize>(a: &[R; D], b: &[R; D]) -> R {
    let mut sum = a[0] * b[0];
    for k in 1..D {
        sum = sum + a[k] * b[k];
    }
    sum
}

impl<const D: usize, R: Real> Primitive<D, R> {
    /// Mass, momentum and energy per volume.
    #[inline(always)]
    pub fn conserved<G: Gas>(&self, gas: &G) -> Conserved<D, R> {
        let kinetic = self.density * dot(&self.velocity, &self.velocity) * 0.5;
        Conserved {
            mass: self.density,
            momentum: array::from_fn(|k| self.density * self.velocity[k]),
            energy: gas.internal_energy(self.density, self.pressure) + kinetic,
        }
    }

    /// Flux through a unit area whose normal the gas moves along at `speed`: `u.n U + p (0, n, u.n)`.
    #[inline(always)]
    pub fn flux(&self, energy: R, speed: R, normal: &[R; D]) -> Conserved<D, R> {
        let mass = self.density * speed;
        Conserved {
            mass,
            momentum: array::from_fn(|k| mass * self.velocity[k] + self.pressure * normal[k]),
            energy: (energy + self.pressure) * speed,
        }
    }

    /// The same state seen in a mirror across the unit `normal`.
    #[inline(always)]
    pub fn mirrored(&self, normal: &[R; D]) -> Self {
        let twice = dot(&self.velocity, normal) * 2.0;
        Self {
            velocity: array::from_fn(|k| self.velocity[k] - twice * normal[k]),
            ..*self
        }
    }
}

impl<const D: usize> Primitive<D> {
    /// The state of a case, as an array.
    pub fn of(state: &State<D>) -> Self {
        Self {
            density: state.density,
            velocity: state.velocity.into(),
            pressure: state.pressure,
        }
    }

    /// True of a gas.
    pub fn makes_sense(&self) -> bool {
        self.density > 0.0
            && self.pressure > 0.0
            && self.density.is_finite()
            && self.pressure.is_finite()
            && self.velocity.iter().all(|u| u.is_finite())
    }

    /// All variables zero.
    pub const ZERO: Self = Self {
        density: 0.0,
        velocity: [0.0; D],
        pressure: 0.0,
    };

    /// `self + factor other`.
    #[inline(always)]
    #[must_use]
    pub fn plus(&self, factor: f64, other: &Self) -> Self {
        Self {
            density: self.density + factor * other.density,
            velocity: array::from_fn(|k| self.velocity[k] + factor * other.velocity[k]),
            pressure: self.pressure + factor * other.pressure,
        }
    }
}

impl<const D: usize> Conserved<D> {
    /// Nothing.
    pub const ZERO: Self = Self {
        mass: 0.0,
        momentum: [0.0; D],
        energy: 0.0,
    };

    /// Density, velocity and pressure of what holds this much per volume; not of a gas where the pressure is not above zero.
    #[inline(always)]
    pub fn primitive<G: Gas>(&self, gas: &G) -> Primitive<D> {
        let volume = 1.0 / self.mass;
        let velocity = array::from_fn(|k| self.momentum[k] * volume);
        let kinetic = 0.5 * dot(&self.momentum, &velocity);
        Primitive {
            density: self.mass,
            velocity,
            pressure: gas.pressure(self.mass, self.energy - kinetic),
        }
    }

    /// `self + factor other`.
    #[inline(always)]
    #[must_use]
    pub fn plus(&self, factor: f64, other: &Self) -> Self {
        Self {
            mass: self.mass + factor * other.mass,
            momentum: array::from_fn(|k| self.momentum[k] + factor * other.momentum[k]),
            energy: self.energy + factor * other.energy,
        }
    }
}
