//! What a problem adds to the equations of the gas.

use std::fmt::Debug;

use aero_geometry::Vector;

/// What is added to the equations, as a function of position and time: the sources of a manufactured solution, for one.
pub trait Source<const D: usize>: Debug + Send + Sync {
    /// What is added there and then.
    fn at(&self, position: &Vector<D>, time: f64) -> Added<D>;
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
