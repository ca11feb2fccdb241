//! The particles themselves.

use aero_geometry::Vector;
use serde::{Deserialize, Serialize};

use super::faces::Sight;
use super::records::Matrix;

/// A particle of gas.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub struct Particle<const D: usize> {
    /// Position.
    pub position: Vector<D>,
    /// Velocity of the gas.
    pub velocity: Vector<D>,
    /// Density.
    pub density: f64,
    /// Specific internal energy.
    pub energy: f64,
    /// Smoothing length.
    pub smoothing_length: f64,
    /// Mass; of a whole ring in an axisymmetric flow.
    pub mass: f64,
    /// Mass that it stood for in the plane sums at the start: all of it, or what its ring had per length.
    pub first_plane_mass: f64,
    /// Rates by pressure at the last evaluation, which the leapfrog predicts with.
    pub by_pressure: ByPressure<D>,
    /// Rate of strain at the last evaluation that the artificial viscosity leaves alone.
    pub strain: Matrix<D>,
    /// Gradient of the specific internal energy at the last evaluation that the artificial conduction
    /// leaves alone.
    pub energy_slope: Vector<D>,
    /// One in smooth flow, nothing in a shock, at the last evaluation; one where nobody asks.
    pub smoothness: f64,
    /// Moves with the undisturbed free stream ([`super::calm`]); without meaning where none is looked for.
    pub is_calm: bool,
    /// Number that the particle keeps for life.
    pub id: u64,
}

impl<const D: usize> Particle<D> {
    /// True of a state that gas can be in.
    pub fn makes_sense(&self) -> bool {
        self.density > 0.0
            && self.energy > 0.0
            && self.smoothing_length > 0.0
            && self.energy.is_finite()
            && self.density.is_finite()
            && self.smoothing_length.is_finite()
            && self
                .position
                .iter()
                .chain(&self.velocity)
                .all(|x| x.is_finite())
    }
}

/// What pressure alone does to a particle: not viscosity, nor conduction.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub struct ByPressure<const D: usize> {
    /// Acceleration.
    pub acceleration: Vector<D>,
    /// Rate of specific internal energy, by compression.
    pub heating: f64,
}

impl<const D: usize> Default for ByPressure<D> {
    fn default() -> Self {
        Self {
            acceleration: Vector::zeros(),
            heating: 0.0,
        }
    }
}

/// Rates of change of one particle, and what walls contribute to them.
#[derive(Clone, Copy, Debug)]
pub struct Rates<const D: usize> {
    /// Acceleration by gas.
    pub acceleration: Vector<D>,
    /// Acceleration by ghosts, to be added to the one by gas.
    pub wall_acceleration: Vector<D>,
    /// Rate of density.
    pub density: f64,
    /// Rate of specific internal energy.
    pub energy: f64,
    /// That part of acceleration and heating that pressure gives.
    pub by_pressure: ByPressure<D>,
    /// Gradient of the velocity, `du_a / dx_b`.
    pub velocity_gradient: Matrix<D>,
    /// Gradient of the specific internal energy; of the conservative scheme only.
    pub energy_gradient: Vector<D>,
    /// Transport velocity minus velocity: of the penetration shield, and of shifting.
    pub shift: Vector<D>,
}

impl<const D: usize> Default for Rates<D> {
    fn default() -> Self {
        Self {
            acceleration: Vector::zeros(),
            wall_acceleration: Vector::zeros(),
            density: 0.0,
            energy: 0.0,
            by_pressure: ByPressure::default(),
            velocity_gradient: Matrix::zeros(),
            energy_gradient: Vector::zeros(),
            shift: Vector::zeros(),
        }
    }
}

/// A particle in the buffer of an inlet, a free-stream side or an outlet. It moves at its own
/// constant velocity and its state does not change.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub struct OpenParticle<const D: usize> {
    /// State.
    pub particle: Particle<D>,
    /// Place in the moving free-stream lattice, if it carries the prescribed state. Otherwise it
    /// has left the domain through an outlet with its state frozen.
    #[serde(with = "lattice_index")]
    pub lattice: Option<[i64; D]>,
    /// Renormalisation matrix when it was frozen.
    pub renormalisation: Matrix<D>,
    /// Density gradient when it was frozen.
    pub gradient: Vector<D>,
}

/// Serde knows arrays of given length only, nalgebra's vectors of any.
#[allow(clippy::ref_option)] // serde's `with` calls it so
mod lattice_index {
    use nalgebra::SVector;
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    pub fn serialize<S: Serializer, const D: usize>(
        index: &Option<[i64; D]>,
        serializer: S,
    ) -> Result<S::Ok, S::Error> {
        index.map(SVector::<i64, D>::from).serialize(serializer)
    }

    pub fn deserialize<'de, T: Deserializer<'de>, const D: usize>(
        deserializer: T,
    ) -> Result<Option<[i64; D]>, T::Error> {
        let index = Option::<SVector<i64, D>>::deserialize(deserializer)?;
        Ok(index.map(Into::into))
    }
}

/// A ghost: a fixed volume of a body or wall that takes its state from the gas.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub struct Ghost<const D: usize> {
    /// Position now.
    pub position: Vector<D>,
    /// Normal now, into the gas.
    pub normal: Vector<D>,
    /// Position at time zero.
    pub origin: Vector<D>,
    /// Normal at time zero.
    pub origin_normal: Vector<D>,
    /// Depth below the surface, positive.
    pub depth: f64,
    /// Volume; constant unless the experiment without constant volume is asked for.
    pub volume: f64,
    /// Mass that the experiment without constant volume holds constant instead.
    pub reference_mass: f64,
    /// The mirror point lies in the gas at the same distance from the same wall; false near
    /// tips and edges, where it falls across them.
    pub has_mirror: bool,
    /// Number of the body: scene order, wall sides after.
    pub body: u32,
    /// Layer, 0 at the wall.
    pub layer: u32,
    /// From where it is seen.
    pub sight: Sight,
    /// Velocity of the wall here.
    pub wall_velocity: Vector<D>,
    /// Acceleration of the wall here.
    pub wall_acceleration: Vector<D>,
    /// Shape operator of the surface here at time zero.
    pub origin_curvature: Matrix<D>,
    /// Shape operator now: gas that slides at `u` is accelerated by `-u.K u` along the normal.
    pub curvature: Matrix<D>,
    /// Twice normal times angular velocity: gas that slides at `u` over a turning wall is accelerated by its
    /// scalar product with `u` along the normal.
    pub coriolis: Vector<D>,
    /// Velocity given to the gas.
    pub velocity: Vector<D>,
    /// Rate of strain given to the gas.
    pub strain: Matrix<D>,
    /// Pressure.
    pub pressure: f64,
    /// Pressure at the surface above.
    pub wall_pressure: f64,
    /// Specific internal energy.
    pub energy: f64,
    /// Density, from the equation of state.
    pub density: f64,
    /// Smoothing length.
    pub smoothing_length: f64,
}

impl<const D: usize> Ghost<D> {
    /// Mirror point in the gas.
    pub fn mirror(&self) -> Vector<D> {
        self.position + self.normal * (2.0 * self.depth)
    }

    /// Closest point of the surface.
    pub fn foot(&self) -> Vector<D> {
        self.position + self.normal * self.depth
    }
}
