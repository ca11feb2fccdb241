//! What a problem adds to the rates of particles.

use aero_geometry::parallel::prelude::*;

use super::particles::{Columns, Particles};
use super::problem::Source;

/// Adds the source where the particles are at `time`. The leapfrog's prediction of the next step goes by it too, or its states in the
/// middle would be of first order.
pub fn add<const D: usize>(source: &dyn Source<D>, time: f64, fluid: &mut Particles<D>) {
    let Columns { state, rates, .. } = fluid.columns();
    rates
        .par_iter_mut()
        .zip(&*state)
        .for_each(|(rates, particle)| {
            let added = source.at(&particle.position, time);
            rates.acceleration += added.acceleration;
            rates.energy += added.heating;
            rates.by_pressure.acceleration += added.acceleration;
            rates.by_pressure.heating += added.heating;
        });
}
