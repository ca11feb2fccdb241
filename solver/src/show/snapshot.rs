//! What a run shows of itself: frames, totals and counts.

use aero_geometry::kernel::SUPPORT;
use aero_geometry::{Bounds, Vector};

use crate::Simulation;
use crate::books::add;
use crate::frame::{Frame, Kind, Load, SurfaceFrame, Totals};
use crate::gas::Gas;
use crate::particles::{ByPressure, Particle, Spared};
use crate::walls::rigid::pad;
use crate::walls::{Ghost, loads};

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
    /// Fluid particles inside a body or behind a wall now; of points, pieces of gas that belong to no cell.
    pub leaked: usize,
    /// How often gas was brought back that a step had carried into a wall.
    pub returned: u64,
    /// Ghosts whose mirror was short of neighbours, at the last evaluation.
    pub mirror_fallbacks: usize,
    /// Smallest density met.
    pub min_density: f64,
    /// Smallest specific internal energy met.
    pub min_energy: f64,
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
            time: self.clock.time,
            ..Frame::default()
        };
        let gases = self.problem.gases();
        let mut push = |particle: &Particle<D>, kind| {
            if is_shown(&particle.position) {
                push(&mut frame, particle, gases.of(particle.is_second), kind);
                if gases.are_two() {
                    frame.extra.second.push(u8::from(particle.is_second));
                }
            }
        };
        for particle in &self.fluid {
            push(particle, Kind::Fluid);
        }
        for open in self.buffers.particles() {
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
                velocity: ghost.shown.velocity,
                density: ghost.shown.density,
                energy: ghost.shown.energy,
                smoothing_length: ghost.shown.smoothing_length,
                mass: ghost.shown.density * ghost.volume,
                first_plane_mass: ghost.shown.density * ghost.volume,
                by_pressure: ByPressure::default(),
                spared: Spared {
                    strain: ghost.shown.strain,
                    ..Spared::unknown()
                },
                is_second: ghost.shown.second > 0.5,
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
            time: self.clock.time,
            ..SurfaceFrame::default()
        };
        let is_shown = |ghost: &&Ghost<D>| {
            ghost.layer == 0 && loads::is_on_this_side(&self.problem.domain, ghost)
        };
        for ghost in self.walls.ghosts.iter().filter(is_shown) {
            surface.position.push(pad(&ghost.foot()).into());
            surface.normal.push(pad(&ghost.normal).into());
            surface.pressure.push(ghost.shown.wall_pressure);
            let over = ghost.shown.wall_pressure - gas.pressure;
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

    /// Loads on the bodies, in scene order; then on the wall sides in the order of
    /// [`crate::wall_sides`]. They belong to the state of the last evaluation, half a step back.
    ///
    /// By the pair laws' symmetry the force on a ghost is minus what the ghost gives the gas:
    /// `F = -sum m_i a_i^(body)`. A body that a symmetry plane cuts is reported whole; of a body that runs
    /// on through an open side, what lies in the domain.
    pub fn loads(&self) -> Vec<Load> {
        loads::loads(&self.problem, self.clock.time, &self.walls, &self.around)
    }

    /// What the fluid received since the start: inflow minus outflow through open sides, the
    /// impulse of walls, the work of moving walls.
    pub fn inflow(&self) -> Totals {
        self.books.inflow()
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
            particle_updates: self.books.extremes.updates,
            neighbours_mean: self.neighbours_mean(),
            leaked: self
                .fluid
                .iter()
                .filter(|p| self.has_leaked(&p.position))
                .count(),
            returned: self.books.extremes.returned,
            mirror_fallbacks: self.walls.mirror_fallbacks,
            min_density: self.books.extremes.min_density,
            min_energy: self.books.extremes.min_energy,
        }
    }

    fn neighbours_mean(&self) -> f64 {
        let near = &self.around.records.near;
        let mut pairs = 0_usize;
        let mut particles = 0_usize;
        let run = self.around.lists.all();
        for cluster in run.clusters.iter().filter(|cluster| !cluster.is_calm) {
            for i in cluster.targets.clone() {
                particles += 1;
                pairs += run.entries[cluster.gas.start..cluster.wall.end]
                    .iter()
                    .map(|&j| &near[j as usize])
                    .filter(|j| {
                        let reach = SUPPORT * (near[i].half_h + j.half_h);
                        (near[i].position - j.position).norm_squared() < reach * reach
                    })
                    .count();
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
