//! How hard particles press on the panels.
//!
//! The force of a wall on a particle is the integral of the kernel's gradient over the solid, and so one of the kernel over its
//! surface, `F = 2 p V sum_panels W n A` for a pressure `p` on both sides [Ferrand et al. 2013]: each panel's share is known, at
//! edges and between bodies too. What the pair sums say otherwise, because pressure falls or rises towards the wall or gas is
//! squeezed or shocked there, goes to the same panels: they show what the gas is held off with, pressure and viscous stress,
//! smoothed over the kernel. What no pressure on them can make, because it is along them, is friction: that of the viscosity that
//! shocks need, and what gas ahead of a tip holds it back with.
//!
//! On round walls gas presses with more than its pressure, see [`super::bend`].
//!
//! Nothing presses what another solid covers, the wall below a post and the post's foot: had they shares, those above would lack them.
//! Where another wall stands in front of a panel, as in a corner, less gas is there than in front of a plane wall. Nothing presses in
//! place of what is missing, and how much is missing is told by few particles and ghosts: in a corner panels show the mean pressure of
//! the gas in front where that is even, which is its own where it is at rest, whatever the angle and however well the gas fills it. Where a
//! shock stands in the corner the mean would be of both its sides, and what gas presses with tells more.

use aero_geometry::kernel::SUPPORT;
use aero_geometry::parallel::prelude::*;
use aero_geometry::{Pencils, Vector};

use super::Panels;
use super::bend::{Bent, bends};
use super::pressed::{Pressed, Sum};
use super::seen::{Met, seen};
use crate::Simulation;
use crate::records::Matrix;
use crate::rings::Rings;

/// What of the panels' spread of directions counts as none: the part of a force along a flat wall is no pressure, and on one that
/// hardly bends it is not made one.
const FLAT: f64 = 0.02;

/// A particle that may press.
#[derive(Clone, Copy, Debug)]
struct Presser<const D: usize> {
    position: Vector<D>,
    reach: f64,
    pressure: f64,
    /// Area in the plane.
    volume: f64,
    mach: f64,
    /// Force of the walls on it, where its pair sums have been taken.
    force: Option<Vector<D>>,
}

/// What presses a particle presses the panels within its reach, or where there are none those within so many times that.
const FARTHER: [f64; 3] = [1.25, 1.5, 2.0];

/// What each panel is pressed with at the last evaluation.
pub fn pressed<const D: usize>(flow: &Simulation<D>, panels: &Panels<D>) -> Vec<Pressed<D>> {
    let pressers = pressers(flow);
    let ghosts = flow.walls.own();
    let of_ghosts = ghosts.iter().map(|g| SUPPORT * g.shown.smoothing_length);
    let reach = pressers.iter().map(|p| p.reach).chain(of_ghosts);
    let reach = reach.fold(0.0, f64::max);
    let seen = seen(flow, panels, reach);
    let places: Vec<Vector<D>> = seen.iter().map(|seen| seen.centre).collect();
    let widest = reach.max(flow.problem.resolution.lattice());
    let grid = Pencils::new(&places, widest);
    let met_by = |at: &Vector<D>, reach: f64| {
        let mut met: Vec<Met<'_, D>> = Vec::new();
        grid.for_each_run_near(at, at, reach, |run| {
            let run = grid.order()[run].iter().map(|&n| &seen[n as usize]);
            met.extend(run.filter_map(|seen| seen.met(at, reach)));
        });
        met
    };
    let poses: Vec<_> = (0..flow.walls.body_count())
        .map(|owner| flow.walls.pose(owner, flow.clock.time))
        .collect();
    // In front of a thin part the solid goes on beyond the far side, which is not there then.
    let sees_all = |presser: &Presser<D>| {
        let faces = flow.walls.faces();
        faces.is_none_or(|f| f.in_front_of(&presser.position, &poses, presser.reach) == 0)
    };
    let all: Vec<Vec<Share<D>>> = pressers
        .par_iter()
        .map(|presser| {
            let mut met = met_by(&presser.position, presser.reach);
            // Ghosts of thinner gas may reach a particle farther than it does.
            for wider in FARTHER {
                if met.is_empty() && presser.force.is_some() {
                    met = met_by(&presser.position, wider * presser.reach);
                }
            }
            let mut behind = Vector::zeros();
            // Gas that has come into the wall presses what is near.
            let in_front = met.iter().filter(|met| met.faces);
            let nearest = in_front.max_by(|a, b| a.kernel.total_cmp(&b.kernel));
            if let Some(nearest) = nearest.copied() {
                // Where the surface bends on, what is over its horizon is pressed as well.
                let is_pressed = |met: &Met<'_, D>| met.faces || nearest.seen.bends_on_to(met.seen);
                if sees_all(presser) {
                    let others = met.iter().filter(|met| !is_pressed(met));
                    behind = others.map(|met| met.seen.normal * met.weight).sum();
                }
                met.retain(is_pressed);
            }
            shares(presser, &met, &behind)
        })
        .collect();
    let solid: Vec<Vec<(u32, f64)>> = ghosts
        .par_iter()
        .map(|ghost| {
            let met = met_by(&ghost.position, SUPPORT * ghost.shown.smoothing_length);
            let in_front = met.iter().filter(|met| met.faces);
            let part = |met: &Met<'_, D>| (met.seen.number, met.kernel * ghost.volume);
            in_front.map(part).collect()
        })
        .collect();
    let mut sums = vec![Sum::none(); panels.all().len()];
    for (presser, shares) in pressers.iter().zip(&all) {
        for share in shares {
            let sum = &mut sums[share.number as usize];
            sum.force += share.force;
            sum.gas += share.weight * presser.volume;
            let pressure = share.weight * presser.volume * presser.pressure;
            sum.gas_pressure += pressure;
            sum.gas_square += pressure * presser.pressure;
            sum.gas_reach += share.weight * presser.volume * presser.reach;
            sum.weight += share.weight;
            sum.mach += share.weight * presser.mach;
            sum.friction += share.friction;
        }
    }
    for &(number, part) in solid.iter().flatten() {
        sums[number as usize].solid += part;
    }
    let rings = Rings::new(&flow.problem);
    let bends = bends(&seen, (&rings, widest), |panel| {
        sums[panel.number as usize].front()
    });
    let unbent = Bent {
        beyond: 0.0,
        pull: Vector::zeros(),
    };
    let mut bent = vec![(Vector::zeros(), unbent); sums.len()];
    for (panel, bend) in seen.iter().zip(bends).filter(|(panel, _)| !panel.is_image) {
        bent[panel.number as usize] = (panel.normal, bend);
    }
    let each = sums.iter().zip(panels.all()).zip(bent);
    let calm = flow.problem.free_stream.pressure;
    each.map(|((sum, panel), bent)| {
        if panel.is_covered {
            Pressed::calm(calm)
        } else {
            sum.pressed(panel.size, bent)
        }
    })
    .collect()
}

/// What a particle presses a panel with.
#[derive(Clone, Copy, Debug)]
struct Share<const D: usize> {
    number: u32,
    force: f64,
    weight: f64,
    /// As the panel itself sees it, no image.
    friction: Vector<D>,
}

/// What a particle presses the panels near it with. Of the force of the pair sums, what an even pressure explains goes by the
/// panels' own shares, the rest by least squares, and what they cannot show is friction. Panels `behind` an edge, a sum of areas times
/// kernel, explain a part as well: no pressure makes up for it.
fn shares<const D: usize>(
    presser: &Presser<D>,
    met: &[Met<'_, D>],
    behind: &Vector<D>,
) -> Vec<Share<D>> {
    let even = 2.0 * presser.volume * presser.pressure;
    let mut moment = Matrix::<D>::zeros();
    let mut weights = 0.0;
    let mut lacking = presser.force.unwrap_or_else(Vector::zeros);
    for met in met {
        lacking -= met.seen.normal * (even * met.weight);
        moment += met.seen.normal * met.seen.normal.transpose() * met.weight;
        weights += met.weight;
    }
    let stiffened = moment + Matrix::identity() * (FLAT * moment.trace());
    let inverse = presser.force.and_then(|_| stiffened.try_inverse());
    // On a flat wall nothing of what is normal to it is lost.
    let correction = inverse.map_or_else(Vector::zeros, |inverse| {
        inverse * (lacking - behind * even) * (1.0 + FLAT)
    });
    // The force on the wall is the other way round.
    let friction = match presser.force {
        Some(_) => (moment * correction - lacking) / weights,
        None => Vector::zeros(),
    };
    let share = |met: &Met<'_, D>| Share {
        number: met.seen.number,
        force: met.weight * (even + met.seen.normal.dot(&correction)),
        weight: met.weight,
        friction: friction.component_mul(&met.seen.sign) * met.weight,
    };
    met.iter().map(share).collect()
}

/// All gas within reach of which panels may be, buffers too.
fn pressers<const D: usize>(flow: &Simulation<D>) -> Vec<Presser<D>> {
    let rings = Rings::new(&flow.problem);
    let gases = flow.problem.gases();
    let rates = flow.fluid.rates().iter().map(Some);
    let open = flow.buffers.particles().iter();
    let all = flow.fluid.iter().zip(rates);
    let all = all.chain(open.map(|open| (&open.particle, None)));
    all.map(|(particle, rates)| {
        let mass = rings.plane_mass(particle);
        let gas = gases.of(particle.is_second);
        let pressure = gas.pressure(particle.density, particle.energy);
        let sound = gas.sound_speed_at(particle.density, pressure);
        // No wall near is no force; one that has just come in has none yet.
        let force = rates.map(|rates| rates.wall_acceleration * mass);
        Presser {
            position: particle.position,
            reach: SUPPORT * particle.smoothing_length,
            pressure,
            volume: mass / particle.density,
            mach: if sound > 0.0 {
                particle.velocity.norm() / sound
            } else {
                0.0
            },
            force: force.filter(|force| force.norm_squared() > 0.0),
        }
    })
    .collect()
}
