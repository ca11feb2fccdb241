//! What is asked of a flight.

use super::attitude::Axes;
use super::centre::Centre;
use crate::scene::atmosphere;
use crate::scene::shapes::StlEntry;

/// The state of the stream at rest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Air {
    /// Of the standard atmosphere, at a height in m.
    Altitude(f64),
    /// Pressure in Pa and temperature in K.
    State(f64, f64),
}

impl Air {
    /// Pressure in Pa and temperature in K.
    pub(super) fn at_rest(self) -> [f64; 2] {
        match self {
            Self::Altitude(height) => {
                let air = atmosphere::Air::at(height);
                [air.pressure, air.temperature]
            }
            Self::State(pressure, temperature) => [pressure, temperature],
        }
    }
}

/// What is asked for.
#[derive(Clone, Debug, PartialEq)]
pub struct Wishes {
    /// The body's file, and how it is read.
    pub body: StlEntry,
    /// How it lies; as it looks if none.
    pub axes: Option<Axes>,
    /// Turn about its length, degrees.
    pub roll: f64,
    /// Mach number.
    pub mach: f64,
    /// Degrees.
    pub incidence: f64,
    /// Degrees.
    pub sideslip: f64,
    /// The air.
    pub air: Air,
    /// Particles rather than points.
    pub with_the_gas: bool,
    /// Reference area; the frontal one if none.
    pub area: Option<f64>,
    /// Reference length; the body's if none.
    pub length: Option<f64>,
    /// Moment centre; the middle if none.
    pub centre: Option<Centre>,
}
