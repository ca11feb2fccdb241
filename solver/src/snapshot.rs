//! What a run shows of itself: frames, totals and counts.

use aero_geometry::kernel::SUPPORT;
use aero_geometry::{Bounds, Vector};
use serde::{Deserialize, Serialize};

use super::Simulation;
use super::gas::Gas;
use super::open::add;
use super::particle::{ByPressure, Ghost, Particle};
use super::rigid::pad;
use crate::frame::{Frame, Kind, SurfaceFrame, Totals};

/// Counts and extremes since the start.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Statistics {
    /// Particles that move by the equations now.
    pub fluid: usize,
    /// Ghosts of bodies and walls.
    pub ghost: usize,
    /// Fluid particles advanced one full step, summed over all steps.
    pub particle_updates: u64,
    /// Mean number of neighbours within the support.
    pub neighbours_mean: f64,
    /// Fluid particles inside a body or behind a wall now.
    pub leaked: usize,
    /// Ghosts whose mirror was short of neighbours, at the last evaluation.
    pub mirror_fallbacks: usize,
    /// Smallest density met.
    pub min_density: f64,
    /// Smallest specific internal energy met.
    pub min_energy: f64,
}

/// Running counts and extremes.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub struct Extremes {
    /// Particle updates so far.
    pub updates: u64,
    min_density: f64,
    min_energy: f64,
}

impl Default for Extremes {
    fn default() -> Self {
        Self {
            updates: 0,
            min_density: f64::INFINITY,
            min_energy: f64::INFINITY,
        }
    }
}

impl Extremes {
    /// Takes note of a particle; one whose state makes no sense leaves a density that is not a number.
    pub(super) fn meet<const D: usize>(&mut self, particle: &Particle<D>) {
        let density = if particle.makes_sense() {
            particle.density
        } else {
            f64::NAN
        };
        self.min_density = smaller(self.min_density, density);
        self.min_energy = self.min_energy.min(particle.energy);
    }

    /// What both met.
    pub(super) fn merge(self, other: Self) -> Self {
        Self {
            updates: self.updates + other.updates,
            min_density: smaller(self.min_density, other.min_density),
            min_energy: self.min_energy.min(other.min_energy),
        }
    }

    /// False after a particle whose state made no sense.
    pub(super) fn make_sense(&self) -> bool {
        !self.min_density.is_nan()
    }
}

impl<const D: usize> Simulation<D> {
    /// All particles now.
    pub fn frame(&self) -> Frame {
        self.frame_of(|_| true)
    }

    /// The particles within a box now.
    pub fn frame_within(&self, region: &Bounds<D>) -> Frame {
        self.frame_of(|position| region.contains(position))
    }

    fn frame_of(&self, is_shown: impl Fn(&Vector<D>) -> bool) -> Frame {
        let mut frame = Frame {
            time: self.time,
            step: self.steps,
            ..Frame::default()
        };
        let gas = self.problem.gas;
        let mut push = |particle: &Particle<D>, kind| {
            if is_shown(&particle.position) {
                push(&mut frame, particle, &gas, kind);
            }
        };
        for particle in &self.fluid {
            push(particle, Kind::Fluid);
        }
        for open in &self.open.particles {
            let kind = if open.lattice.is_some() {
                Kind::Inlet
            } else {
                Kind::Outlet
            };
            push(&open.particle, kind);
        }
        for (number, ghost) in self.walls.own().iter().enumerate() {
            let particle = Particle {
                position: ghost.position,
                velocity: ghost.velocity,
                density: ghost.density,
                energy: ghost.energy,
                smoothing_length: ghost.smoothing_length,
                mass: ghost.density * ghost.volume,
                first_plane_mass: ghost.density * ghost.volume,
                by_pressure: ByPressure::default(),
                strain: ghost.strain,
                energy_slope: Vector::zeros(),
                smoothness: 1.0,
                is_calm: false,
                id: number as u64,
            };
            push(&particle, Kind::Ghost);
        }
        frame
    }

    /// State on the surfaces now, bodies in scene order and wall sides after.
    pub fn surface(&self) -> SurfaceFrame {
        let gas = &self.problem.free_stream;
        let dynamic_pressure = 0.5 * gas.density * gas.velocity.norm_squared();
        let mut surface = SurfaceFrame {
            time: self.time,
            ..SurfaceFrame::default()
        };
        let is_shown = |ghost: &&Ghost<D>| ghost.layer == 0 && self.foot(ghost) == ghost.foot();
        for ghost in self.walls.ghosts.iter().filter(is_shown) {
            surface.position.push(pad(&ghost.foot()).into());
            surface.normal.push(pad(&ghost.normal).into());
            surface.pressure.push(ghost.wall_pressure);
            let over = ghost.wall_pressure - gas.pressure;
            let coefficient = if dynamic_pressure > 0.0 {
                over / dynamic_pressure
            } else {
                0.0
            };
            surface.pressure_coefficient.push(coefficient);
            surface.body.push(ghost.body);
        }
        surface
    }

    /// Conserved totals of the fluid now.
    pub fn totals(&self) -> Totals {
        let mut totals = Totals::default();
        for particle in &self.fluid {
            add(&mut totals, particle, 1.0);
        }
        totals
    }

    /// Mass of the fluid now, and its centre; missing axes zero.
    pub fn mass_and_centre(&self) -> (f64, [f64; 3]) {
        let mut mass = 0.0;
        let mut moment = Vector::<D>::zeros();
        for particle in &self.fluid {
            mass += particle.mass;
            moment += particle.position * particle.mass;
        }
        (mass, pad(&(moment / mass)).into())
    }

    /// Counts and extremes; costs about as much as a step.
    pub fn statistics(&self) -> Statistics {
        Statistics {
            fluid: self.fluid.len(),
            ghost: self.walls.own_count(),
            particle_updates: self.extremes.updates,
            neighbours_mean: self.neighbours_mean(),
            leaked: self
                .fluid
                .iter()
                .filter(|p| self.has_leaked(&p.position))
                .count(),
            mirror_fallbacks: self.walls.mirror_fallbacks,
            min_density: self.extremes.min_density,
            min_energy: self.extremes.min_energy,
        }
    }

    fn neighbours_mean(&self) -> f64 {
        let near = &self.records.near;
        let mut pairs = 0_usize;
        let mut particles = 0_usize;
        for chunk in &self.lists.chunks {
            for cluster in chunk.clusters.iter().filter(|cluster| !cluster.is_calm) {
                for i in cluster.targets.clone() {
                    particles += 1;
                    pairs += chunk.entries[cluster.gas.start..cluster.wall.end]
                        .iter()
                        .map(|&j| &near[j as usize])
                        .filter(|j| {
                            let reach = SUPPORT * (near[i].half_h + j.half_h);
                            (near[i].position - j.position).norm_squared() < reach * reach
                        })
                        .count();
                }
            }
        }
        pairs as f64 / particles.max(1) as f64
    }

    /// True inside a body or behind a wall side.
    fn has_leaked(&self, position: &Vector<D>) -> bool {
        self.body_around(position).is_some()
            || self.side_depths(position).any(|(_, depth)| depth > 0.0)
    }
}

/// The smaller number; none, where one of the two is none.
fn smaller(a: f64, b: f64) -> f64 {
    if a.is_nan() || a < b { a } else { b }
}

fn push<const D: usize>(frame: &mut Frame, particle: &Particle<D>, gas: &Gas, kind: Kind) {
    let pressure = gas.pressure(particle.density, particle.energy);
    let sound = gas.sound_speed_at(particle.density, pressure);
    frame.position.push(pad(&particle.position).into());
    frame.velocity.push(pad(&particle.velocity).into());
    frame.density.push(particle.density);
    frame.pressure.push(pressure);
    frame.energy.push(particle.energy);
    frame.mach.push(if sound > 0.0 {
        particle.velocity.norm() / sound
    } else {
        0.0
    });
    frame.smoothing_length.push(particle.smoothing_length);
    frame.volume.push(particle.mass / particle.density);
    frame.kind.push(kind as u8);
    frame.id.push(particle.id);
}
