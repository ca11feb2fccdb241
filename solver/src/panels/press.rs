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

/// Panels whose normal's cosine with that of the near side is below this are the far side of a thin part.
const FAR_SIDE: f64 = -0.5;

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
    let near = |presser: &Presser<D>| {
        let mut met = Vec::new();
        let at = &presser.position;
        grid.for_each_run_near(at, at, presser.reach, |run| {
            let run = grid.order()[run].iter().map(|&n| &seen[n as usize]);
            met.extend(run.filter_map(|seen| seen.met(presser)));
        });
        part_sides(&mut met);
        met
    };
    let ambient = ambient(&pressers, panels, &near);
    let shares: Vec<Vec<Share>> = pressers
        .par_iter()
        .map(|presser| {
            shares(presser, &near(presser), |number| {
                ambient[panels.all()[number as usize].owner as usize]
            })
        })
        .collect();
    let mut sums = vec![[0.0; 3]; panels.all().len()];
    for (presser, shares) in pressers.iter().zip(&shares) {
        for share in shares {
            let sum = &mut sums[share.number as usize];
            sum[0] += share.force;
            sum[1] += share.weight;
            sum[2] += share.weight * presser.mach;
        }
    }
    let pressures = sums.iter().zip(panels.all());
    pressures
        .map(|(&[force, weight, mach], panel)| Pressed {
            pressure: ambient[panel.owner as usize] + force / panel.size,
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

/// What a particle presses a panel with, over what the body's mean pressure does.
#[derive(Clone, Copy, Debug)]
struct Share {
    number: u32,
    force: f64,
    /// Nothing where the particle is behind it.
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

/// Leaves out the far side of thin parts, which the gas in front of the near side does not feel.
fn part_sides<const D: usize>(met: &mut Vec<Met<D>>) {
    let facing = met.iter().filter(|met| met.faces);
    let mean: Vector<D> = facing.map(|met| met.normal * met.weight).sum();
    if let Some(mean) = mean.try_normalize(0.0) {
        met.retain(|met| met.faces || met.normal.dot(&mean) > FAR_SIDE);
    }
}

/// Mean pressure in front of each body and wall side: on a closed body it presses with nothing, and what is no more than that is shown
/// even at edges.
fn ambient<const D: usize>(
    pressers: &[Presser<D>],
    panels: &Panels<D>,
    near: &(impl Fn(&Presser<D>) -> Vec<Met<D>> + Sync),
) -> Vec<f64> {
    let owners = panels.all().iter().map(|panel| panel.owner as usize + 1);
    let mut sums = vec![[0.0; 2]; owners.max().unwrap_or(0)];
    let met: Vec<_> = pressers.par_iter().map(near).collect();
    for (presser, met) in pressers.iter().zip(&met) {
        for met in met.iter().filter(|met| met.faces) {
            let sum = &mut sums[panels.all()[met.number as usize].owner as usize];
            sum[0] += met.weight * presser.volume * presser.pressure;
            sum[1] += met.weight * presser.volume;
        }
    }
    let mean = |[pressure, weight]: [f64; 2]| if weight > 0.0 { pressure / weight } else { 0.0 };
    sums.into_iter().map(mean).collect()
}

/// What a particle presses the panels near it with. Of the force of the pair sums, what an even pressure explains goes by the panels'
/// own shares; the rest by the least squares.
fn shares<const D: usize>(
    presser: &Presser<D>,
    met: &[Met<D>],
    ambient: impl Fn(u32) -> f64,
) -> Vec<Share> {
    let twice = 2.0 * presser.volume;
    let mut lacking = presser.force.unwrap_or_else(Vector::zeros);
    let mut moment = Matrix::<D>::zeros();
    for met in met {
        lacking -= met.normal * (twice * presser.pressure * met.weight);
        moment += met.normal * met.normal.transpose() * met.weight;
    }
    let stiffened = moment + Matrix::identity() * (FLAT * moment.trace());
    let inverse = presser.force.and_then(|_| stiffened.try_inverse());
    let correction = inverse.map_or_else(Vector::zeros, |inverse| {
        // Twice, so that of what the walls can press nothing is lost [iterated regularisation: Engl 1987].
        let first = inverse * lacking;
        first + inverse * (lacking - moment * first)
    });
    let share = |met: &Met<D>| Share {
        number: met.number,
        force: met.weight
            * (twice * (presser.pressure - ambient(met.number)) + met.normal.dot(&correction)),
        weight: if met.faces { met.weight } else { 0.0 },
    };
    met.iter().map(share).collect()
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
