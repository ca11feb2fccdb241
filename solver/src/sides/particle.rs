//! A particle in the buffer of an open side.

use aero_geometry::Vector;
use aero_geometry::kernel::SMOOTHING_RATIO;
use serde::{Deserialize, Serialize};

use crate::diffusive::Gradients;
use crate::lattice;
use crate::particles::Particle;
use crate::records::Matrix;

/// A particle in the buffer of an open side. It moves at its own constant velocity.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub struct OpenParticle<const D: usize> {
    /// State.
    pub particle: Particle<D>,
    /// Number of the open side whose buffer it is in.
    pub side: u8,
    /// Place in the moving lattice of the side's stream, if it carries the state of the gas that enters. Otherwise it
    /// has left the domain, with its state as the side's model holds it.
    #[serde(with = "lattice_index")]
    pub lattice: Option<[i64; D]>,
    /// Renormalisation matrix when it left.
    pub renormalisation: Matrix<D>,
    /// Density gradient when it left.
    pub gradient: Vector<D>,
    /// Gradients of velocity and energy when it left, of viscous gas.
    pub gradients: Gradients<D>,
}

impl<const D: usize> OpenParticle<D> {
    /// One whose neighbours are a lattice.
    pub fn of_lattice(particle: Particle<D>, side: usize, lattice: Option<[i64; D]>) -> Self {
        Self {
            particle,
            side: side as u8,
            lattice,
            renormalisation: Matrix::identity() * lattice::renormalisation::<D>(SMOOTHING_RATIO),
            gradient: Vector::zeros(),
            gradients: Gradients::zeros(),
        }
    }
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
