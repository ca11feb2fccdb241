//! Viscosity and heat conduction of the particles: from the gradients of an evaluation to what they add to its rates.

use aero_geometry::kernel::{QuinticSpline, SUPPORT};
use aero_geometry::parallel::prelude::*;

use super::diffusive::Gradients;
use super::gas::Gas;
use super::neighbourhood::Neighbourhood;
use super::neighbours::Lists;
use super::pairs::diffusion::{diffuse, diffuse_by_differences};
use super::pairs::renormalisation::even_renormalisation;
use super::particles::{Columns, Particle, Particles};
use super::problem::Problem;
use super::records::{Diffusive, GHOSTS, Matrix, Near, Records};
use super::scheme::Stress;
use super::sides::Buffers;
use super::walls::{Walls, beyond};

/// Adds what viscosity and conduction do to the rates of the fluid, whose gradients they hold.
pub fn add<const D: usize>(
    problem: &Problem<D>,
    fluid: &mut Particles<D>,
    buffers: &Buffers<D>,
    walls: &Walls<D>,
    around: &mut Neighbourhood<D>,
) {
    let stress = problem.scheme.operators.stress;
    fill(problem, fluid, buffers, &mut around.records);
    around.copies.gas.refresh_diffusive(&mut around.records);
    fill_ghosts(
        (&problem.gas, stress),
        walls,
        &around.wall_lists.near,
        &mut around.records,
    );
    around.copies.ghosts.refresh_diffusive(&mut around.records);
    let Columns {
        rates,
        renormalisations,
        ..
    } = fluid.columns();
    let (arch, lists, records) = (&around.arch, &around.lists, &around.records);
    match stress {
        Stress::Conservative => diffuse(arch, lists, records, rates),
        Stress::Coupled | Stress::Pairwise => {
            diffuse_by_differences(arch, lists, records, renormalisations, rates);
        }
    }
}

/// Writes what flows through the gas, and through what has left.
fn fill<const D: usize>(
    problem: &Problem<D>,
    fluid: &mut Particles<D>,
    buffers: &Buffers<D>,
    records: &mut Records<D>,
) {
    let (gas, law) = (&problem.gas, problem.scheme.operators.stress);
    let Columns {
        state,
        rates,
        renormalisations,
        ..
    } = fluid.columns();
    let (near, diffusive) = (&records.near, &mut records.diffusive);
    let count = state.len();
    diffusive[..count]
        .par_iter_mut()
        .zip(&*state)
        .zip(&*rates)
        .zip(&*renormalisations)
        .zip(near)
        .for_each(|((((diffusive, particle), rates), r), near)| {
            let gradients = Gradients {
                velocity: rates.velocity_gradient,
                energy: rates.energy_gradient,
            };
            let (gradients, matrix) = read_by(law, &gradients, &r.matrix);
            let coefficients = gas.coefficients(particle.density, particle.energy);
            let weight = (near.volume, &matrix);
            *diffusive = Diffusive::new(&gradients, weight, coefficients);
        });
    for (slot, open) in (count..).zip(buffers.particles()) {
        let Particle {
            density, energy, ..
        } = open.particle;
        let coefficients = gas.coefficients(density, energy);
        let (gradients, matrix) = read_by(law, &open.gradients, &open.renormalisation);
        let weight = (near[slot].volume, &matrix);
        diffusive[slot] = Diffusive::new(&gradients, weight, coefficients);
    }
}

/// Gradients and renormalisation as the records of a stress by this law have them.
fn read_by<const D: usize>(
    law: Stress,
    gradients: &Gradients<D>,
    matrix: &Matrix<D>,
) -> (Gradients<D>, Matrix<D>) {
    match law {
        Stress::Conservative => (*gradients, *matrix),
        Stress::Coupled => (*gradients, Matrix::identity()),
        Stress::Pairwise => (Gradients::zeros(), Matrix::identity()),
    }
}

/// Writes what flows through ghosts: what flows through the gas nearby, as it goes on beyond the wall.
fn fill_ghosts<const D: usize>(
    (gas, law): (&Gas, Stress),
    walls: &Walls<D>,
    lists: &Lists,
    records: &mut Records<D>,
) {
    let first = records.start[GHOSTS];
    let even = even_renormalisation();
    let (seen, own) = records.diffusive.split_at_mut(first);
    let near = &records.near;
    own[..walls.ghosts.len()]
        .par_chunks_mut(lists.run_targets())
        .zip(lists.par_runs())
        .for_each(|(own, run)| {
            let first_target = run.clusters.first().map_or(0, |first| first.targets.start);
            for cluster in run.clusters {
                let gas_near = &run.entries[cluster.gas.clone()];
                for target in cluster.targets.clone() {
                    let ghost = &walls.ghosts[target];
                    let Some(inside) = mean(&near[first + target], gas_near, near, seen) else {
                        continue;
                    };
                    let gradients = beyond(gas, walls.kind(ghost.body), ghost, &inside);
                    let (density, energy) = (ghost.shown.density, ghost.shown.energy);
                    let coefficients = gas.coefficients(density, energy);
                    let (gradients, matrix) = read_by(law, &gradients, &even);
                    let weight = (ghost.volume, &matrix);
                    own[target - first_target] = Diffusive::new(&gradients, weight, coefficients);
                }
            }
        });
}

/// Mean gradients of the gas in reach, by Shepard's sum; none where there is none.
fn mean<const D: usize>(
    at: &Near<D>,
    listed: &[u32],
    near: &[Near<D>],
    diffusive: &[Diffusive<D>],
) -> Option<Gradients<D>> {
    let mut sum = Gradients::zeros();
    let mut weights = 0.0;
    for &slot in listed {
        let other = &near[slot as usize];
        let apart = (other.position - at.position).norm();
        let h = at.half_h + other.half_h;
        if apart >= SUPPORT * h {
            continue;
        }
        let weight = QuinticSpline::<D>::value(apart, h);
        let gradients = diffusive[slot as usize].gradients();
        sum.velocity += gradients.velocity * weight;
        sum.energy += gradients.energy * weight;
        weights += weight;
    }
    (weights > 0.0).then(|| Gradients {
        velocity: sum.velocity / weights,
        energy: sum.energy / weights,
    })
}
