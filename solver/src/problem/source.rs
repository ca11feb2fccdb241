//! What a problem adds to the equations of the gas.

use std::fmt::Debug;

use aero_geometry::Vector;

/// What is added to the equations, as a function of position and time: the sources of a manufactured solution, for one.
pub trait Source<const D: usize>: Debug + Send + Sync {
    /// What is added there and then.
    fn at(&self, position: &Vector<D>, time: f64) -> Added<D>;

    /// True of one that is the same at all times; none unless told.
    fn is_steady(&self) -> bool {
        false
    }

    /// True of one that adds no mass; none unless told.
    fn keeps_mass(&self) -> bool {
        false
    }

    /// What it is, in words.
    fn description(&self) -> String {
        "sources are added to the equations".into()
    }
}

/// A force at a distance that accelerates all gas alike, m/s^2: gravity, or what drives a channel that is periodic.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BodyForce<const D: usize>(pub Vector<D>);

impl<const D: usize> Source<D> for BodyForce<D> {
    fn at(&self, _position: &Vector<D>, _time: f64) -> Added<D> {
        Added {
            density: 0.0,
            acceleration: self.0,
            heating: 0.0,
        }
    }

    fn is_steady(&self) -> bool {
        true
    }

    fn keeps_mass(&self) -> bool {
        true
    }

    fn description(&self) -> String {
        format!("a force accelerates all gas by {:?}", self.0.as_slice())
    }
}

/// What is added to the gas at a place and time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Added<const D: usize> {
    /// Mass per volume and time, kg/(m^3 s), that comes with velocity and energy of the gas there. Particles keep their mass: none
    /// is theirs.
    pub density: f64,
    /// Acceleration, m/s^2.
    pub acceleration: Vector<D>,
    /// Rate of specific internal energy, J/(kg s).
    pub heating: f64,
}
