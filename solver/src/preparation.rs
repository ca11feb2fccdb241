//! What a step starts with: all particles sorted in space, the records of where they are, their neighbours listed.

use crate::fill::{fill_ghosts, fill_near};
use crate::neighbourhood::Neighbourhood;
use crate::particles::Particles;
use crate::problem::Problem;
use crate::sides::Buffers;
use crate::walls::Walls;

/// Sorts all particles in space, writes the records and lists neighbours for a step whose half is `half_step` long; `time` is
/// now.
pub fn prepare<const D: usize>(
    problem: &Problem<D>,
    (time, half_step): (f64, f64),
    fluid: &mut Particles<D>,
    buffers: &mut Buffers<D>,
    walls: &mut Walls<D>,
    around: &mut Neighbourhood<D>,
) {
    around.sort(problem, (time, half_step), fluid, buffers, walls);
    fill_near(problem, 0.0, fluid, buffers, around);
    fill_ghosts(walls, around);
    around.list((time, half_step), fluid, buffers, walls);
}
