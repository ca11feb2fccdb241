//! Open boundaries: buffers of particles beyond inlets, free-stream sides and outlets
//! [Federico et al. 2012; Lastiwka et al. 2009].
//!
//! Inlets and free-stream sides hold a lattice that moves with the free stream. A lattice
//! particle that enters the domain becomes fluid; fluid that enters the lattice is absorbed. Fluid that
//! crosses an outlet freezes its state, drifts on and is removed past the buffer.

use aero_geometry::Vector;
use aero_geometry::kernel::SMOOTHING_RATIO;
use serde::{Deserialize, Serialize};

use super::lattice;
use super::particle::{OpenParticle, Particle};
use super::records::Matrix;
use super::rings::Rings;
use crate::case::{Case, Side, State};
use crate::frame::Totals;

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
    next_id: u64,
}

impl<const D: usize> Case<D> {
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
                    Side::Inlet | Side::FreeStream | Side::Outlet if depth > buffer => {
                        return Zone::Outside;
                    }
                    Side::Inlet | Side::FreeStream => zone = Zone::Prescribed,
                    Side::Outlet if zone == Zone::Interior => zone = Zone::Outlet,
                    _ => {}
                }
            }
        }
        zone
    }

    /// True where a gas particle may start: not behind a side that is not open, not in a body
    /// nor nearer to it than half a spacing.
    pub fn is_free(&self, position: &Vector<D>) -> bool {
        // The lattice may touch the half spacing exactly; round-off must not decide.
        let least = 0.5 * self.spacing * (1.0 - 1e-6);
        let bounds = &self.domain.bounds;
        let behind_closed_side = (0..D).any(|axis| {
            let [lower, upper] = self.domain.sides[axis];
            (position[axis] < bounds.min[axis] && !is_open(lower))
                || (position[axis] > bounds.max[axis] && !is_open(upper))
        });
        !behind_closed_side
            && self.bodies.iter().all(|body| {
                !body.shape.bounds().grown(self.spacing).contains(position)
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
            energy: state.pressure / ((self.gamma - 1.0) * state.density),
            smoothing_length: SMOOTHING_RATIO * self.spacing,
            mass: plane_mass * Rings::new(self).circumference(&position),
            first_plane_mass: plane_mass,
            strain: Matrix::zeros(),
            id,
        }
    }

    /// True where any side lets gas in or out.
    pub fn has_open_sides(&self) -> bool {
        self.domain
            .sides
            .iter()
            .flatten()
            .any(|side| is_open(*side))
    }

    /// Place of lattice point `index` at `time`, drifting with the free stream.
    fn lattice_position(&self, index: &[i64; D], time: f64) -> Vector<D> {
        lattice::position(&self.domain.bounds.min, self.spacing, index)
            + self.free_stream.velocity * time
    }

    /// First and last lattice index, at `time`, of the domain with its buffers.
    fn lattice_range(&self, time: f64) -> ([i64; D], [i64; D]) {
        let mut first = [0; D];
        let mut last = [0; D];
        let size = self.domain.bounds.size();
        for k in 0..D {
            let drift = self.free_stream.velocity[k] * time / self.spacing;
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

    /// Slabs of lattice indices that cover all buffers at `time`, without overlap.
    fn buffer_slabs(&self, time: f64) -> Vec<([i64; D], [i64; D])> {
        let (mut first, mut last) = self.lattice_range(time);
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
    matches!(side, Side::Inlet | Side::FreeStream | Side::Outlet)
}

impl<const D: usize> OpenBoundaries<D> {
    /// Fills the domain and its buffers; returns the fluid.
    ///
    /// # Errors
    /// Where the gas cannot start as it should.
    pub fn fill(case: &Case<D>) -> Result<(Vec<Particle<D>>, Self), String> {
        let mut fluid = Vec::new();
        let mut open = Self {
            particles: Vec::new(),
            inflow: Totals::default(),
            next_id: 0,
        };
        let (first, last) = case.lattice_range(0.0);
        let disorder = case.disorder * case.spacing;
        for index in lattice::points(first, last) {
            let position = case.lattice_position(&index, 0.0);
            let zone = case.zone(&position);
            if zone == Zone::Outside || !case.is_free(&position) {
                continue;
            }
            if zone == Zone::Prescribed {
                let id = open.new_id();
                let particle = case.particle(position, &case.free_stream, id);
                open.particles.push(still(particle, Some(index)));
                continue;
            }
            let Some(state) = case.initial_state(&position)? else {
                continue;
            };
            let id = open.new_id();
            if zone == Zone::Outlet {
                let particle = case.particle(position, &state, id);
                open.particles.push(still(particle, None));
            } else {
                let position = position + lattice::displacement(&index) * disorder;
                fluid.push(case.particle(position, &state, id));
            }
        }
        Ok((fluid, open))
    }

    /// After all particles have moved from `before` to `now`: turns lattice particles that
    /// entered into fluid, absorbs or freezes fluid that left, refills the lattice.
    ///
    /// `frozen` gives a fluid particle's renormalisation matrix and density gradient.
    pub fn exchange(
        &mut self,
        case: &Case<D>,
        before: f64,
        now: f64,
        fluid: &mut Vec<Particle<D>>,
        frozen: impl Fn(usize) -> (Matrix<D>, Vector<D>),
    ) {
        let mut entering = Vec::new();
        self.particles.retain_mut(|open| {
            if let Some(index) = &open.lattice {
                open.particle.position = case.lattice_position(index, now);
            }
            match (case.zone(&open.particle.position), open.lattice) {
                (Zone::Interior, _) => {
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
        let mut kept = 0;
        for i in 0..fluid.len() {
            let particle = fluid[i];
            let zone = case.zone(&particle.position);
            if zone == Zone::Interior {
                fluid[kept] = particle;
                kept += 1;
                continue;
            }
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
        fluid.truncate(kept);
        for particle in entering {
            add(&mut self.inflow, &particle, 1.0);
            fluid.push(particle);
        }
        self.refill(case, before, now);
    }

    /// Adds the lattice points that came into a prescribed buffer between `before` and `now`.
    fn refill(&mut self, case: &Case<D>, before: f64, now: f64) {
        if case.free_stream.velocity == Vector::<D>::zeros() {
            return;
        }
        for (first, last) in case.buffer_slabs(now) {
            for index in lattice::points(first, last) {
                let position = case.lattice_position(&index, now);
                let earlier = case.lattice_position(&index, before);
                if case.zone(&position) == Zone::Prescribed
                    && case.zone(&earlier) != Zone::Prescribed
                    && case.is_free(&position)
                {
                    let id = self.new_id();
                    let particle = case.particle(position, &case.free_stream, id);
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
