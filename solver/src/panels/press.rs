//! How hard particles press on the panels.
//!
//! The force of a wall on a particle is the integral of the kernel's gradient over the solid, and so one of the kernel over its
//! surface, `F = 2 p V sum_panels W n A` for a pressure `p` on both sides [Ferrand et al. 2013]: each panel's share is known, at
//! edges, in corners and between bodies too. What the pair sums say otherwise, because pressure falls or rises towards the wall,
//! gas is squeezed or shocked, is shared out among the same panels so that the force is the pair sums'. Panels thus show what the
//! gas is held off with, smoothed over the kernel.

use aero_geometry::kernel::{QuinticSpline, SUPPORT};
use aero_geometry::{Pencils, Vector};
use rayon::prelude::*;

use super::Panels;
use crate::Simulation;
use crate::records::Matrix;
use crate::rings::Rings;
use crate::sides::Domain;
use crate::sides::closed::Map;

/// What of the panels' spread of directions counts as none: the part of a force along a flat wall is no pressure, and on one that
/// hardly bends it is not made one.
const FLAT: f64 = 0.02;

/// Pressure and Mach number on a panel.
#[derive(Clone, Copy, Debug, Default)]
pub struct Pressed {
    /// Pressure.
    pub pressure: f64,
    /// Mach number of the gas in front.
    pub mach: f64,
}

/// A panel, or its image beyond a side that maps the flow, where it is now.
#[derive(Clone, Copy, Debug)]
struct Seen<const D: usize> {
    centre: Vector<D>,
    normal: Vector<D>,
    size: f64,
    number: u32,
}

/// A particle that may press.
#[derive(Clone, Copy, Debug)]
struct Presser<const D: usize> {
    position: Vector<D>,
    reach: f64,
    /// `2 p V`.
    even: f64,
    mach: f64,
    /// Force of the walls on it, where its pair sums have been taken.
    force: Option<Vector<D>>,
}

/// Pressure on each panel at the last evaluation.
pub fn pressed<const D: usize>(flow: &Simulation<D>, panels: &Panels<D>) -> Vec<Pressed> {
    let pressers = pressers(flow);
    let reach = pressers.iter().fold(0.0, |most: f64, p| most.max(p.reach));
    let seen = seen(flow, panels, reach);
    let places: Vec<Vector<D>> = seen.iter().map(|seen| seen.centre).collect();
    let grid = Pencils::new(&places, reach.max(flow.problem.spacing));
    let met = |presser: &Presser<D>, visit: &mut dyn FnMut(&Seen<D>, f64)| {
        let at = &presser.position;
        grid.for_each_run_near(at, at, presser.reach, |run| {
            for &n in &grid.order()[run] {
                let seen = &seen[n as usize];
                let weight = seen.weight(presser);
                if weight > 0.0 {
                    visit(seen, weight);
                }
            }
        });
    };
    let corrections: Vec<Option<Vector<D>>> = pressers
        .par_iter()
        .map(|presser| correction(presser, |visit| met(presser, visit)))
        .collect();
    let mut sums = vec![[0.0; 3]; panels.all().len()];
    for (presser, correction) in pressers.iter().zip(&corrections) {
        let Some(correction) = correction else {
            continue;
        };
        met(presser, &mut |seen, weight| {
            let share = weight * (presser.even + seen.normal.dot(correction));
            let sum = &mut sums[seen.number as usize];
            sum[0] += share;
            sum[1] += weight;
            sum[2] += weight * presser.mach;
        });
    }
    let pressures = sums.iter().zip(panels.all());
    pressures
        .map(|(&[force, weight, mach], panel)| Pressed {
            pressure: force / panel.size,
            mach: if weight > 0.0 { mach / weight } else { 0.0 },
        })
        .collect()
}

impl<const D: usize> Seen<D> {
    /// Area times kernel, of a panel that faces the particle.
    fn weight(&self, presser: &Presser<D>) -> f64 {
        let arm = presser.position - self.centre;
        if arm.dot(&self.normal) <= 0.0 {
            return 0.0;
        }
        self.size * QuinticSpline::<D>::value(arm.norm(), presser.reach / SUPPORT)
    }
}

/// What to add to `2 p V`, times the normal of each panel, for the force to be that of the pair sums; none for a particle that no
/// panel is near.
fn correction<const D: usize>(
    presser: &Presser<D>,
    each: impl FnOnce(&mut dyn FnMut(&Seen<D>, f64)),
) -> Option<Vector<D>> {
    let mut even = Vector::<D>::zeros();
    let mut moment = Matrix::<D>::zeros();
    each(&mut |seen, weight| {
        even += seen.normal * weight;
        moment += seen.normal * seen.normal.transpose() * weight;
    });
    let trace = moment.trace();
    if trace == 0.0 {
        return None;
    }
    let Some(force) = presser.force else {
        return Some(Vector::zeros());
    };
    let lacking = force - even * presser.even;
    let stiffened = moment + Matrix::identity() * (FLAT * trace);
    Some(
        stiffened
            .try_inverse()
            .map_or_else(Vector::zeros, |inverse| inverse * lacking),
    )
}

/// All gas within reach of which panels may be, buffers too.
fn pressers<const D: usize>(flow: &Simulation<D>) -> Vec<Presser<D>> {
    let rings = Rings::new(&flow.problem);
    let gas = &flow.problem.gas;
    let rates = flow.fluid.rates().iter().map(Some);
    let open = flow.buffers.particles().iter();
    let all = flow.fluid.iter().zip(rates);
    let all = all.chain(open.map(|open| (&open.particle, None)));
    all.map(|(particle, rates)| {
        let mass = rings.plane_mass(particle);
        let pressure = gas.pressure(particle.density, particle.energy);
        let sound = gas.sound_speed_at(particle.density, pressure);
        // No wall near is no force; one that has just come in has none yet.
        let force = rates.map(|rates| rates.wall_acceleration * mass);
        Presser {
            position: particle.position,
            reach: SUPPORT * particle.smoothing_length,
            even: 2.0 * pressure * mass / particle.density,
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

/// The panels where they are now, and their images beyond the sides that map the flow, as far as particles reach.
fn seen<const D: usize>(flow: &Simulation<D>, panels: &Panels<D>, reach: f64) -> Vec<Seen<D>> {
    let poses: Vec<_> = (0..flow.walls.body_count())
        .map(|owner| flow.walls.pose(owner, flow.clock.time))
        .collect();
    let mut seen: Vec<Seen<D>> = panels
        .all()
        .iter()
        .enumerate()
        .map(|(number, panel)| {
            let pose = &poses[panel.owner as usize];
            Seen {
                centre: pose.position(&panel.centre),
                normal: pose.direction(&panel.normal),
                size: panel.size,
                number: number as u32,
            }
        })
        .collect();
    for axis in 0..D {
        let domain: &Domain<D> = &flow.problem.domain;
        for (end, map) in Map::of_axis(domain, axis).into_iter().enumerate() {
            let Some(map) = map else { continue };
            let plane = domain.face(axis, end);
            let images: Vec<_> = seen
                .iter()
                .map(|own| {
                    let mut image = *own;
                    image.centre[axis] = map.place(own.centre[axis]);
                    image.normal[axis] *= map.sign;
                    image
                })
                .filter(|image| (image.centre[axis] - plane).abs() < reach)
                .collect();
            seen.extend(images);
        }
    }
    seen
}
