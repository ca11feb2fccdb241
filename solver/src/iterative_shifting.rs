//! Iterative shifting: particles are moved apart, again and again, until they stand evenly, and take the state of where they come to.
//!
//! The flow does not move with them: `f(x + dx) = f(x) + dx.grad f` for velocity and density [Huang, Long, Li & Liu 2019, Eng. Anal. Bound.
//! Elem. 106, 571-587; Negi & Ramachandran 2021, section II]. No pair exchanges what this changes.

use aero_geometry::Vector;
use aero_geometry::kernel::SUPPORT;
use aero_geometry::parallel::prelude::*;

use crate::evaluation::{Moment, arrange, sum_rates};
use crate::neighbourhood::{Neighbourhood, open_side_distance};
use crate::particles::{Columns, Particles};
use crate::preparation::prepare;
use crate::problem::Problem;
use crate::shifting::spread;
use crate::sides::{Buffers, closed};
use crate::walls::Walls;

/// Shift along a gradient of concentration over the square of the smoothing length [Lind, Xu, Stansby & Rogers 2012, J. Comput. Phys. 231,
/// eqs 16-18].
const DIFFUSION: f64 = 0.5;

/// Longest shift over the smoothing length [Lind et al. 2012, section 3.2].
const LONGEST: f64 = 0.2;

/// Particles stand evenly where none has less room than its share by more than this part.
const TOLERANCE: f64 = 0.01;

/// Shifts that are tried at most.
const MOST: usize = 5;

/// Moves the particles apart at `time`.
pub fn even_out<const D: usize>(
    problem: &Problem<D>,
    time: f64,
    fluid: &mut Particles<D>,
    buffers: &mut Buffers<D>,
    walls: &mut Walls<D>,
    around: &mut Neighbourhood<D>,
) {
    for _ in 0..MOST {
        if !move_apart(problem, time, fluid, buffers, walls, around) {
            break;
        }
    }
}

/// Moves the particles apart once; false where they stand evenly.
pub fn move_apart<const D: usize>(
    problem: &Problem<D>,
    time: f64,
    fluid: &mut Particles<D>,
    buffers: &mut Buffers<D>,
    walls: &mut Walls<D>,
    around: &mut Neighbourhood<D>,
) -> bool {
    let moment = Moment {
        start: time,
        ahead: 0.0,
    };
    prepare(problem, (time, 0.0), fluid, buffers, walls, around);
    arrange(problem, moment, fluid, buffers, walls, around);
    if unevenness(problem, fluid) <= TOLERANCE {
        return false;
    }
    sum_rates(problem, fluid, around);
    shift(problem, fluid);
    closed::bring_back(&problem.domain, fluid);
    true
}

/// By how much the most crowded particle has less room than its share.
fn unevenness<const D: usize>(problem: &Problem<D>, fluid: &mut Particles<D>) -> f64 {
    let share = |x: &Vector<D>| problem.resolution.at(x).powi(D as i32);
    let Columns {
        state, densities, ..
    } = fluid.columns();
    let crowds = state.par_iter().zip(&*densities);
    let crowds =
        crowds.map(|(particle, density)| density * share(&particle.position) / particle.mass - 1.0);
    crowds.reduce(|| 0.0, f64::max)
}

/// Moves each particle once.
fn shift<const D: usize>(problem: &Problem<D>, fluid: &mut Particles<D>) {
    let Columns {
        state,
        rates,
        renormalisations,
        ..
    } = fluid.columns();
    state
        .par_iter_mut()
        .zip(&*rates)
        .zip(&*renormalisations)
        .for_each(|((particle, rates), renormalisation)| {
            let h = particle.smoothing_length;
            if open_side_distance(&problem.domain, &particle.position) < SUPPORT * h {
                return;
            }
            let mut way = spread(renormalisation, -DIFFUSION * h * h, h);
            let (length, longest) = (way.norm(), LONGEST * h);
            if length > longest {
                way *= longest / length;
            }
            particle.position += way;
            particle.velocity += rates.velocity_gradient * way;
            particle.density += renormalisation.density_gradient.dot(&way);
        });
}
