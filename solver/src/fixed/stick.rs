//! How gas sticks to faces on walls.

use super::equation_of_state::EquationOfState;
use super::state::Primitive;

/// Least part of a cell's density that its image behind a hot wall has.
const LEAST_DENSITY: f64 = 0.1;

/// How gas sticks to a face.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stick<const D: usize> {
    /// Velocity of the surface, along the face.
    pub velocity: [f64; D],
    /// The same of what moves as the surface does where the cell's point is: gas that turns with its wall is not sheared.
    pub beside: [f64; D],
    /// What heat does.
    pub heat: Heat,
}

/// What heat does at a face.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Heat {
    /// The gas there has this temperature.
    Temperature(f64),
    /// So much goes into the gas per area and time.
    Flux(f64),
}

impl<const D: usize> Stick<D> {
    /// The state behind the wall that makes that on it the mean of both, of gas in the state of `cell`.
    pub fn beyond<G: EquationOfState>(&self, gas: &G, cell: &Primitive<D>) -> Primitive<D> {
        let mut velocity = self.velocity;
        for k in 0..D {
            velocity[k] += self.velocity[k] - cell.velocity[k];
        }
        let density = match self.heat {
            Heat::Temperature(temperature) => {
                let level = gas.heat_at(temperature, cell.pressure);
                (2.0 * cell.pressure / level - cell.density).max(LEAST_DENSITY * cell.density)
            }
            Heat::Flux(_) => cell.density,
        };
        Primitive {
            density,
            velocity,
            pressure: cell.pressure,
        }
    }
}
