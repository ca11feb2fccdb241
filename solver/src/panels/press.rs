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
use crate::problem::Domain;
use crate::records::Matrix;
use crate::rings::Rings;
use crate::sides::closed::Map;

/// What of the panels' spread of directions counts as none: the part of a force along a flat wall is no pressure, and on one that
/// hardly bends it is not made one.
const FLAT: f64 = 0.02;

/// The same for a whole body: a slender one shows its drag by little else.
const SLENDER: f64 = 1e-4;

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
    pressure: f64,
    /// Area in the plane.
    volume: f64,
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
    let all: Vec<(Vec<Share>, Vector<D>)> = pressers
        .par_iter()
        .map(|presser| {
            let mut met = Vec::new();
            let at = &presser.position;
            grid.for_each_run_near(at, at, presser.reach, |run| {
                let run = grid.order()[run].iter().map(|&n| &seen[n as usize]);
                met.extend(run.filter_map(|seen| seen.met(presser)));
            });
            // Gas that has come into the wall presses what is near.
            if met.iter().any(|met: &Met<D>| met.faces) {
                met.retain(|met| met.faces);
            }
            shares(presser, &met)
        })
        .collect();
    let mut sums = vec![[0.0; 4]; panels.all().len()];
    for (presser, (shares, lost)) in pressers.iter().zip(&all) {
        for share in shares {
            let sum = &mut sums[share.number as usize];
            sum[0] += share.force;
            sum[1] += share.weight;
            sum[2] += share.weight * presser.mach;
            sum[3] += share.weight * lost.norm();
        }
    }
    let lacking = lacking(flow, panels, &pressers, &all);
    let regained = regained(flow, panels, &sums, &lacking);
    let pressures = sums.iter().zip(panels.all());
    pressures
        .map(|(&[force, weight, mach, lost], panel)| Pressed {
            pressure: force / panel.size
                + regained[panel.owner as usize].dot(&panel.normal) * (lost / panel.size),
            mach: if weight > 0.0 { mach / weight } else { 0.0 },
        })
        .collect()
}

/// A panel within reach of a particle.
#[derive(Clone, Copy, Debug)]
struct Met<const D: usize> {
    number: u32,
    normal: Vector<D>,
    /// Area times kernel.
    weight: f64,
    /// The particle is in front of it.
    faces: bool,
}

/// What a particle presses a panel with.
#[derive(Clone, Copy, Debug)]
struct Share {
    number: u32,
    force: f64,
    weight: f64,
}

impl<const D: usize> Seen<D> {
    /// None out of the kernel's reach.
    fn met(&self, presser: &Presser<D>) -> Option<Met<D>> {
        let arm = presser.position - self.centre;
        let kernel = QuinticSpline::<D>::value(arm.norm(), presser.reach / SUPPORT);
        (kernel > 0.0).then_some(Met {
            number: self.number,
            normal: self.normal,
            weight: self.size * kernel,
            faces: arm.dot(&self.normal) > 0.0,
        })
    }
}

/// What a particle presses the panels near it with, and what of its force they cannot show. Of the force of the pair sums, what an
/// even pressure explains goes by the panels' own shares, the rest by least squares.
fn shares<const D: usize>(presser: &Presser<D>, met: &[Met<D>]) -> (Vec<Share>, Vector<D>) {
    let even = 2.0 * presser.volume * presser.pressure;
    let mut moment = Matrix::<D>::zeros();
    let mut lacking = presser.force.unwrap_or_else(Vector::zeros);
    for met in met {
        lacking -= met.normal * (even * met.weight);
        moment += met.normal * met.normal.transpose() * met.weight;
    }
    let stiffened = moment + Matrix::identity() * (FLAT * moment.trace());
    let inverse = presser.force.and_then(|_| stiffened.try_inverse());
    // On a flat wall nothing of what is normal to it is lost.
    let correction = inverse.map_or_else(Vector::zeros, |inverse| inverse * lacking * (1.0 + FLAT));
    let lost = match presser.force {
        Some(_) if !met.is_empty() => lacking - moment * correction,
        _ => Vector::zeros(),
    };
    let share = |met: &Met<D>| Share {
        number: met.number,
        force: met.weight * (even + met.normal.dot(&correction)),
        weight: met.weight,
    };
    (met.iter().map(share).collect(), lost)
}

/// Sum of what the panels of each owner do not show, all around an axis if there is one.
fn lacking<const D: usize>(
    flow: &Simulation<D>,
    panels: &Panels<D>,
    pressers: &[Presser<D>],
    all: &[(Vec<Share>, Vector<D>)],
) -> Vec<Vector<D>> {
    let rings = Rings::new(&flow.problem);
    let mut sums = vec![Vector::zeros(); flow.walls.body_count()];
    for (presser, (shares, lost)) in pressers.iter().zip(all) {
        let nearest = shares.iter().max_by(|a, b| a.weight.total_cmp(&b.weight));
        if let Some(share) = nearest {
            let owner = panels.all()[share.number as usize].owner as usize;
            sums[owner] += lost * rings.circumference(&presser.position);
        }
    }
    sums
}

/// By what each owner's panels, where something is lost and as much as is, are pressed more for each unit of their normals, for the
/// force on it to be the pair sums': at tips and edges, where gas ahead of a panel holds the body back.
fn regained<const D: usize>(
    flow: &Simulation<D>,
    panels: &Panels<D>,
    sums: &[[f64; 4]],
    lacking: &[Vector<D>],
) -> Vec<Vector<D>> {
    let rings = Rings::new(&flow.problem);
    let mut moments = vec![Matrix::<D>::zeros(); lacking.len()];
    for (panel, sum) in panels.all().iter().zip(sums) {
        let weight = sum[3] * rings.circumference(&panel.centre);
        moments[panel.owner as usize] += panel.normal * panel.normal.transpose() * weight;
    }
    let domain = &flow.problem.domain;
    // A wall that comes in through an inlet has no tip: what it lacks is friction.
    let has_tip = |owner: usize| {
        let body = flow.problem.bodies.get(owner);
        body.is_some_and(|body| {
            let extent = body.shape.bounds();
            let mut entrances = domain.each_side().filter(|(_, _, side, _)| side.lets_in());
            !entrances
                .any(|(axis, end, _, face)| [extent.min[axis] < face, extent.max[axis] > face][end])
        })
    };
    let solve = |(owner, (moment, lacking)): (usize, (&Matrix<D>, &Vector<D>))| {
        if !has_tip(owner) {
            return Vector::zeros();
        }
        let stiffened = moment + Matrix::identity() * (SLENDER * moment.trace());
        let inverse = stiffened.try_inverse();
        inverse.map_or_else(Vector::zeros, |inverse| inverse * lacking)
    };
    moments.iter().zip(lacking).enumerate().map(solve).collect()
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
