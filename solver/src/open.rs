//! Open boundaries: buffers of particles beyond inlets, free-stream sides and outlets
//! [Federico et al. 2012; Lastiwka et al. 2009].
//!
//! Inlets and free-stream sides hold a lattice that moves with the free stream. A lattice
//! particle that enters the domain becomes fluid; fluid that enters the lattice is absorbed. Fluid that
//! crosses an outlet freezes its state, drifts on and is removed past the buffer.

use aero_geometry::Vector;
use aero_geometry::kernel::SMOOTHING_RATIO;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use super::lattice;
use super::particle::{ByPressure, OpenParticle, Particle};
use super::records::Matrix;
use super::reservoir::Reservoir;
use super::rings::Rings;
use crate::frame::Totals;
use crate::problem::{Body, Initial, Problem, Side, State};

/// Depth of a buffer in spacings: the support at `h = 1.5 dx` and what a step moves, rounded up.
pub const BUFFER: usize = 6;

/// Where a point is in relation to the domain.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Zone {
    /// In the domain, or behind a side that is not open.
    Interior,
    /// In the buffer of an inlet or a free-stream side.
    Prescribed,
    /// In the buffer of an outlet.
    Outlet,
    /// Past all buffers.
    Outside,
}

/// The particles of all buffers.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct OpenBoundaries<const D: usize> {
    /// Particles, in no particular order.
    pub particles: Vec<OpenParticle<D>>,
    /// What has entered the fluid minus what has left it.
    pub inflow: Totals,
    /// How far the lattice has drifted since the start.
    drift: Vector<D>,
    /// State of the lattice.
    state: State<D>,
    reservoir: Option<Reservoir>,
    next_id: u64,
}

impl<const D: usize> Problem<D> {
    /// The zone of `position`.
    pub fn zone(&self, position: &Vector<D>) -> Zone {
        let buffer = BUFFER as f64 * self.spacing;
        let mut zone = Zone::Interior;
        for axis in 0..D {
            let ends = [
                self.domain.bounds.min[axis] - position[axis],
                position[axis] - self.domain.bounds.max[axis],
            ];
            for (end, depth) in ends.into_iter().enumerate() {
                // The lower face belongs to the domain, the upper one does not, so that
                // neighbouring cells of the lattice never claim the same point.
                let beyond = if end == 0 { depth > 0.0 } else { depth >= 0.0 };
                if !beyond {
                    continue;
                }
                match self.domain.sides[axis][end] {
                    side if is_open(side) && depth > buffer => return Zone::Outside,
                    Side::Inlet | Side::FreeStream | Side::Reservoir => zone = Zone::Prescribed,
                    Side::Outlet if zone == Zone::Interior => zone = Zone::Outlet,
                    _ => {}
                }
            }
        }
        zone
    }

    /// True where a gas particle may be put: not behind a side that is not open, not in a body
    /// nor nearer to it than half a spacing.
    pub fn is_free(&self, position: &Vector<D>) -> bool {
        // The lattice may touch the half spacing exactly; round-off must not decide.
        let least = 0.5 * self.spacing * (1.0 - 1e-6);
        self.is_clear(position, |_| least)
    }

    /// As [`Self::is_free`], with the distance that each body wants.
    fn is_clear(&self, position: &Vector<D>, least: impl Fn(&Body<D>) -> f64) -> bool {
        let bounds = &self.domain.bounds;
        let behind_closed_side = (0..D).any(|axis| {
            let [lower, upper] = self.domain.sides[axis];
            (position[axis] < bounds.min[axis] && !is_open(lower))
                || (position[axis] > bounds.max[axis] && !is_open(upper))
        });
        !behind_closed_side
            && self.bodies.iter().all(|body| {
                let least = least(body);
                let reach = least.max(self.spacing);
                !body.shape.bounds().grown(reach).contains(position)
                    || body.shape.signed_distance(position) >= least
            })
    }

    /// A particle of the starting lattice in `state`.
    pub fn particle(&self, position: Vector<D>, state: &State<D>, id: u64) -> Particle<D> {
        let plane_mass = state.density * self.spacing.powi(D as i32);
        Particle {
            position,
            velocity: state.velocity,
            density: state.density,
            energy: self.gas.energy(state.density, state.pressure),
            smoothing_length: SMOOTHING_RATIO * self.spacing,
            mass: plane_mass * Rings::new(self).circumference(&position),
            first_plane_mass: plane_mass,
            by_pressure: ByPressure::default(),
            strain: Matrix::zeros(),
            energy_slope: Vector::zeros(),
            smoothness: 1.0,
            is_calm: false,
            id,
        }
    }

    /// True where the lattice starts as the undisturbed free stream, so that not even the first sums need be
    /// taken far from bodies and walls. Rings are not spread evenly, and must show that they are calm.
    fn starts_calm(&self) -> bool {
        self.scheme.skip_undisturbed
            && matches!(self.initial, Initial::FreeStream)
            && self.disorder == 0.0
            && !self.domain.is_axisymmetric()
    }

    /// True where any side lets gas in or out.
    pub fn has_open_sides(&self) -> bool {
        self.domain
            .sides
            .iter()
            .flatten()
            .any(|side| is_open(*side))
    }

    /// Place of point `index` of the lattice after it has drifted.
    fn lattice_position(&self, index: &[i64; D], drift: &Vector<D>) -> Vector<D> {
        lattice::position(&self.domain.bounds.min, self.spacing, index) + drift
    }

    /// First and last lattice index, after a drift, of the domain with its buffers.
    fn lattice_range(&self, drift: &Vector<D>) -> ([i64; D], [i64; D]) {
        let mut first = [0; D];
        let mut last = [0; D];
        let size = self.domain.bounds.size();
        for k in 0..D {
            let drift = drift[k] / self.spacing;
            let margin = |side| if is_open(side) { BUFFER as i64 } else { 0 };
            let cells = (size[k] / self.spacing).round() as i64;
            let lower = margin(self.domain.sides[k][0]);
            let upper = margin(self.domain.sides[k][1]);
            if lower + upper == 0 {
                (first[k], last[k]) = (0, cells);
            } else {
                first[k] = (-drift).floor() as i64 - lower - 1;
                last[k] = (-drift).ceil() as i64 + cells + upper + 1;
            }
        }
        (first, last)
    }

    /// Slabs of lattice indices that cover all buffers after a drift, without overlap.
    fn buffer_slabs(&self, drift: &Vector<D>) -> Vec<([i64; D], [i64; D])> {
        let (mut first, mut last) = self.lattice_range(drift);
        let mut slabs = Vec::new();
        let depth = BUFFER as i64 + 3;
        for k in 0..D {
            if is_open(self.domain.sides[k][0]) && first[k] < last[k] {
                let mut end = last;
                end[k] = (first[k] + depth).min(last[k]);
                slabs.push((first, end));
                first[k] = end[k];
            }
            if is_open(self.domain.sides[k][1]) && first[k] < last[k] {
                let mut begin = first;
                begin[k] = (last[k] - depth).max(first[k]);
                slabs.push((begin, last));
                last[k] = begin[k];
            }
        }
        slabs
    }
}

/// True of sides that let gas in or out.
pub fn is_open(side: Side) -> bool {
    matches!(
        side,
        Side::Inlet | Side::FreeStream | Side::Reservoir | Side::Outlet
    )
}

impl<const D: usize> OpenBoundaries<D> {
    /// Fills the domain and its buffers; returns the fluid.
    ///
    /// # Errors
    /// Where the gas cannot start as it should.
    pub fn fill(problem: &Problem<D>) -> Result<(Vec<Particle<D>>, Self), String> {
        let mut fluid = Vec::new();
        let mut open = Self {
            particles: Vec::new(),
            inflow: Totals::default(),
            drift: Vector::zeros(),
            state: problem.free_stream,
            reservoir: Reservoir::of(problem),
            next_id: 0,
        };
        let (first, last) = problem.lattice_range(&open.drift);
        let disorder = problem.disorder * problem.spacing;
        for index in lattice::points(first, last) {
            let position = problem.lattice_position(&index, &open.drift);
            match problem.zone(&position) {
                // Buffers go on as they are refilled, by the lattice.
                Zone::Prescribed if problem.is_free(&position) => {
                    let id = open.new_id();
                    let particle = problem.particle(position, &problem.free_stream, id);
                    open.particles.push(still(particle, Some(index)));
                }
                zone @ (Zone::Outlet | Zone::Interior)
                    if problem
                        .is_clear(&position, |body| body.starting_distance(problem.spacing)) =>
                {
                    let shift = lattice::displacement(&index) * disorder;
                    open.place(problem, (position, shift), zone, &mut fluid)?;
                }
                _ => {}
            }
        }
        if problem.starts_calm() {
            let gone = open.particles.iter_mut().map(|open| &mut open.particle);
            for particle in fluid.iter_mut().chain(gone) {
                particle.is_calm = true;
            }
        }
        let packed = problem
            .bodies
            .iter()
            .filter_map(|b| b.packed_fluid.as_ref());
        for &position in packed.flat_map(|packed| &packed.position) {
            let zone = problem.zone(&position);
            if matches!(zone, Zone::Outlet | Zone::Interior) && problem.is_clear(&position, |_| 0.0)
            {
                open.place(problem, (position, Vector::zeros()), zone, &mut fluid)?;
            }
        }
        Ok((fluid, open))
    }

    /// Puts a particle at `position`, displaced by `shift` if it is fluid, in the state of the start.
    fn place(
        &mut self,
        problem: &Problem<D>,
        (position, shift): (Vector<D>, Vector<D>),
        zone: Zone,
        fluid: &mut Vec<Particle<D>>,
    ) -> Result<(), String> {
        let Some(state) = problem.initial_state(&position)? else {
            return Ok(());
        };
        let id = self.new_id();
        if zone == Zone::Outlet {
            self.particles
                .push(still(problem.particle(position, &state, id), None));
        } else {
            fluid.push(problem.particle(position + shift, &state, id));
        }
        Ok(())
    }

    /// After all particles have moved from `before` to `now`: turns lattice particles that
    /// entered into fluid, absorbs or freezes fluid that left, refills the lattice.
    ///
    /// `frozen` gives a fluid particle's renormalisation matrix and density gradient.
    pub fn exchange(
        &mut self,
        problem: &Problem<D>,
        before: f64,
        now: f64,
        fluid: &mut Vec<Particle<D>>,
        frozen: impl Fn(usize) -> (Matrix<D>, Vector<D>),
    ) {
        let mut entering = Vec::new();
        let earlier = self.drift;
        self.drift = match self.reservoir {
            Some(_) => earlier + self.state.velocity * (now - before),
            None => self.state.velocity * now,
        };
        let drift = self.drift;
        self.particles.retain_mut(|open| {
            if let Some(index) = &open.lattice {
                open.particle.position = problem.lattice_position(index, &drift);
            }
            match (problem.zone(&open.particle.position), open.lattice) {
                (Zone::Interior, lattice) => {
                    // The lattice is the free stream itself.
                    open.particle.is_calm |= lattice.is_some() && problem.scheme.skip_undisturbed;
                    entering.push(open.particle);
                    false
                }
                (Zone::Prescribed, lattice) => lattice.is_some(),
                (Zone::Outlet, _) => {
                    // The lattice may drift round the corner of a free-stream side and an outlet.
                    open.lattice = None;
                    true
                }
                (Zone::Outside, _) => false,
            }
        });
        let leaving: Vec<_> = fluid
            .par_iter()
            .enumerate()
            .map(|(i, particle)| (i, problem.zone(&particle.position)))
            .filter(|(_, zone)| *zone != Zone::Interior)
            .collect();
        for &(i, zone) in &leaving {
            let particle = fluid[i];
            add(&mut self.inflow, &particle, -1.0);
            if zone == Zone::Outlet {
                let (renormalisation, gradient) = frozen(i);
                let open = OpenParticle {
                    particle,
                    lattice: None,
                    renormalisation,
                    gradient,
                };
                self.particles.push(open);
            }
        }
        // From the end, so that the last particle, which takes the place, is never one that leaves.
        for &(i, _) in leaving.iter().rev() {
            fluid.swap_remove(i);
        }
        for particle in entering {
            add(&mut self.inflow, &particle, 1.0);
            fluid.push(particle);
        }
        if let Some(state) = self.reservoir.and_then(|r| r.inflow(problem, fluid)) {
            self.carry(problem, state);
        }
        self.refill(problem, &earlier);
    }

    /// Gives all particles of the lattice a new state.
    fn carry(&mut self, problem: &Problem<D>, state: State<D>) {
        self.state = state;
        for open in self.particles.iter_mut().filter(|o| o.lattice.is_some()) {
            let old = open.particle;
            open.particle = problem.particle(old.position, &state, old.id);
        }
    }

    /// Adds the lattice points that came into a prescribed buffer since the lattice stood at `earlier`.
    fn refill(&mut self, problem: &Problem<D>, earlier: &Vector<D>) {
        if self.drift == *earlier {
            return;
        }
        for (first, last) in problem.buffer_slabs(&self.drift) {
            for index in lattice::points(first, last) {
                let position = problem.lattice_position(&index, &self.drift);
                let earlier = problem.lattice_position(&index, earlier);
                if problem.zone(&position) == Zone::Prescribed
                    && problem.zone(&earlier) != Zone::Prescribed
                    && problem.is_free(&position)
                {
                    let id = self.new_id();
                    let particle = problem.particle(position, &self.state, id);
                    self.particles.push(still(particle, Some(index)));
                }
            }
        }
    }

    fn new_id(&mut self) -> u64 {
        self.next_id += 1;
        self.next_id - 1
    }
}

fn still<const D: usize>(particle: Particle<D>, lattice: Option<[i64; D]>) -> OpenParticle<D> {
    OpenParticle {
        particle,
        lattice,
        renormalisation: Matrix::identity() * lattice::renormalisation::<D>(SMOOTHING_RATIO),
        gradient: Vector::zeros(),
    }
}

/// Adds `sign` times a particle's mass, momentum and energy to `totals`.
pub fn add<const D: usize>(totals: &mut Totals, particle: &Particle<D>, sign: f64) {
    let mass = sign * particle.mass;
    totals.mass += mass;
    for k in 0..D {
        totals.momentum[k] += mass * particle.velocity[k];
    }
    totals.energy += mass * (particle.energy + 0.5 * particle.velocity.norm_squared());
}
