//! From where the particles are to their rates: reads the density off them, lets ghosts take the state of the gas, sums.
//! Moves none.

use aero_geometry::Vector;
use aero_geometry::kernel::SMOOTHING_RATIO;
use aero_geometry::parallel::prelude::*;

use super::diffusion;
use super::fill::{fill_gas, fill_ghosts, fill_near};
use super::neighbourhood::{Neighbourhood, limit_widths};
use super::neighbours::GROWTH;
use super::pairs::arrangement::renormalise as sum_moments;
use super::pairs::rates::rates;
use super::pairs::shield::shield;
use super::pairs::summation::densities;
use super::particles::{Columns, Particles};
use super::problem::Problem;
use super::records::{GHOSTS, Records};
use super::rings::Rings;
use super::scheme::Volume;
use super::shifting::{shift, stand_still};
use super::shock_sensor::find_shocks;
use super::sides::Buffers;
use super::sources;
use super::walls::Walls;

/// When an evaluation takes place.
#[derive(Clone, Copy, Debug)]
pub struct Moment {
    /// Start of the step.
    pub start: f64,
    /// Time since then.
    pub ahead: f64,
}

/// Replaces each density by the sum over the particles, and the smoothing length with it
/// (`h = 1.5 (m / rho)^(1/D)`), so that neither can drift from the particles' spacing.
///
/// In rarefied gas the smoothing length stops growing where [`limit_widths`] says.
pub fn read_densities<const D: usize>(
    problem: &Problem<D>,
    fluid: &mut Particles<D>,
    around: &mut Neighbourhood<D>,
) {
    sum_masses(fluid, around);
    let Columns {
        state,
        densities: sums,
        ..
    } = fluid.columns();
    let rings = Rings::new(problem);
    state
        .par_iter_mut()
        .zip(sums)
        .for_each(|(particle, density)| {
            particle.density = *density;
            let mass = rings.spanned_mass(particle);
            let h = SMOOTHING_RATIO * edge::<D>(mass / particle.density);
            particle.smoothing_length = h.min(GROWTH * particle.smoothing_length);
        });
    limit_widths(problem, &around.records, &around.lists, fluid);
}

/// Reads the density off the particles where they and the walls are at `moment`.
pub fn sum_densities<const D: usize>(
    problem: &Problem<D>,
    moment: Moment,
    fluid: &mut Particles<D>,
    buffers: &Buffers<D>,
    walls: &mut Walls<D>,
    around: &mut Neighbourhood<D>,
) {
    fill_near(problem, moment.ahead, fluid, buffers, around);
    move_walls(walls, moment);
    fill_ghosts(walls, around);
    read_densities(problem, fluid, around);
}

/// Moves the walls to where they are at `moment`.
fn move_walls<const D: usize>(walls: &mut Walls<D>, moment: Moment) {
    if walls.are_moving() {
        walls.move_to(moment.start + moment.ahead);
    }
}

/// What stands where at `moment`, what ghosts show, how large all are, and their renormalisation.
pub fn arrange<const D: usize>(
    problem: &Problem<D>,
    moment: Moment,
    fluid: &mut Particles<D>,
    buffers: &Buffers<D>,
    walls: &mut Walls<D>,
    around: &mut Neighbourhood<D>,
) {
    fill_gas(problem, moment.ahead, fluid, buffers, around);
    move_walls(walls, moment);
    let time = moment.start + moment.ahead;
    let source = problem.source.as_ref();
    let added = source.map(|source| move |foot: &Vector<D>| source.at(foot, time).acceleration);
    let (lists, records) = (&around.wall_lists, &around.records);
    let added = added
        .as_ref()
        .map(|added| added as &(dyn Fn(&_) -> _ + Sync));
    walls.extrapolate(&around.arch, lists, records, added);
    fill_ghosts(walls, around);
    if problem.scheme.operators.volume == Volume::Summed {
        sum_volumes(fluid, around);
    }
    renormalise(problem, fluid, around);
}

/// Sums the masses about each particle, `sum m W`.
fn sum_masses<const D: usize>(fluid: &mut Particles<D>, around: &mut Neighbourhood<D>) {
    round_near(around);
    if around.arch.is_mixed() {
        // Of the state they read the slopes at walls.
        let Records {
            state,
            rounded,
            start,
            ..
        } = &mut around.records;
        rounded.round_state_in(start[GHOSTS]..state.len(), state);
    }
    densities(
        &around.arch,
        &around.lists,
        &around.records,
        around.lattice_sum,
        fluid.columns().densities,
    );
}

/// Gives each particle as much room as there is, `V = m / sum m W`, whatever its density is.
fn sum_volumes<const D: usize>(fluid: &mut Particles<D>, around: &mut Neighbourhood<D>) {
    sum_masses(fluid, around);
    let near = around.records.near.par_iter_mut();
    near.zip(fluid.columns().densities)
        .for_each(|(near, sum)| near.volume = near.mass / *sum);
    around.copies.gas.refresh_near(&mut around.records);
}

/// Rates of the fluid at `moment`.
pub fn evaluate<const D: usize>(
    problem: &Problem<D>,
    moment: Moment,
    fluid: &mut Particles<D>,
    buffers: &Buffers<D>,
    walls: &mut Walls<D>,
    around: &mut Neighbourhood<D>,
) {
    arrange(problem, moment, fluid, buffers, walls, around);
    let transport = problem.scheme.transport_velocity;
    if transport.shield {
        shield_walls(fluid, walls, around);
    }
    if transport.shifting {
        shift(problem, fluid, around);
    }
    if transport.at_rest {
        stand_still(fluid);
    }
    sum_rates(problem, fluid, around);
    if problem.gas.is_viscous() {
        diffusion::add(problem, fluid, buffers, walls, around);
    }
    if let Some(source) = &problem.source {
        sources::add(&**source, moment.start + moment.ahead, fluid);
    }
    let Columns { state, rates, .. } = fluid.columns();
    let rings = Rings::new(problem);
    find_shocks(problem, rings, rates, state);
    rings.stretch(state, &problem.gases(), rates);
    fluid.mark_evaluated();
}

/// Sums the rates of the fluid.
pub fn sum_rates<const D: usize>(
    problem: &Problem<D>,
    fluid: &mut Particles<D>,
    around: &Neighbourhood<D>,
) {
    let columns = fluid.columns();
    rates(
        &around.arch,
        &around.lists,
        &around.records,
        columns.renormalisations,
        &problem.scheme,
        columns.rates,
    );
}

/// Renormalisation of the fluid; buffers keep theirs, and ghosts have that of a lattice.
pub fn renormalise<const D: usize>(
    problem: &Problem<D>,
    fluid: &mut Particles<D>,
    around: &mut Neighbourhood<D>,
) {
    round_near(around);
    let renormalisations = fluid.columns().renormalisations;
    sum_moments(
        &around.arch,
        &around.lists,
        &around.records,
        &problem.scheme,
        renormalisations,
    );
    if !problem.scheme.operators.renormalised {
        for renormalisation in renormalisations.iter_mut() {
            renormalisation.leave_out();
        }
    }
    let Records { near, state, .. } = &mut around.records;
    state
        .par_iter_mut()
        .zip(near.par_iter())
        .zip(&*renormalisations)
        .for_each(|((state, near), r)| {
            state.renormalise(&r.matrix, &r.density_gradient, near.volume);
        });
    around.copies.gas.refresh(&mut around.records);
    if around.arch.is_mixed() {
        let Records { state, rounded, .. } = &mut around.records;
        rounded.round_state(state);
    }
}

/// Rounds the geometry where pairs are computed in `f32`.
fn round_near<const D: usize>(around: &mut Neighbourhood<D>) {
    if around.arch.is_mixed() {
        let Records { near, rounded, .. } = &mut around.records;
        rounded.round_near(near);
    }
}

fn shield_walls<const D: usize>(
    fluid: &mut Particles<D>,
    walls: &Walls<D>,
    around: &Neighbourhood<D>,
) {
    let first = around.records.start[GHOSTS];
    let (ghosts, images) = (&walls.ghosts, &around.copies.ghosts);
    let wall = |slot: usize| {
        let (ghost, sign) = images.seen(ghosts, slot - first);
        (
            sign.component_mul(&ghost.normal),
            sign.component_mul(&ghost.wall.velocity),
        )
    };
    let Columns { state, rates, .. } = fluid.columns();
    shield(&around.lists, &around.records.near, state, wall, rates);
}

/// Edge of a cube of this `D`-dimensional volume.
fn edge<const D: usize>(volume: f64) -> f64 {
    match D {
        1 => volume,
        2 => volume.sqrt(),
        _ => volume.cbrt(),
    }
}
