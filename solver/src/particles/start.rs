//! The particles as a run begins: a lattice over the domain and the buffers of its open sides, and what is packed around
//! bodies.

use aero_geometry::Vector;
use aero_geometry::kernel::SMOOTHING_RATIO;
use aero_geometry::parallel::prelude::*;

use super::rooms::{Place, Rooms};
use super::{ByPressure, Particle, Particles, Spared};
use crate::lattice;
use crate::problem::{Body, Domain, Initial, Problem, State};
use crate::rings::Rings;
use crate::scheme::Volume;
use crate::sides::{Buffers, OpenParticle, Rows, Zone};

impl<const D: usize> Problem<D> {
    /// True where a gas particle may be put: not behind a side that is not open, not in a body
    /// nor nearer to it than half a spacing.
    pub fn is_free(&self, position: &Vector<D>, rows: &Rows<D>) -> bool {
        // The lattice may touch the half spacing exactly; round-off must not decide.
        let least = 0.5 * self.resolution.at(position) * (1.0 - 1e-6) * rows.nearest();
        self.is_clear(position, |_| least)
    }

    /// As [`Self::is_free`], with the distance that each body wants.
    fn is_clear(&self, position: &Vector<D>, least: impl Fn(&Body<D>) -> f64) -> bool {
        let Domain { bounds, .. } = &self.domain;
        let is_closed = |axis, end| !self.domain.side_at(axis, end, position).is_open();
        let behind_closed_side = (0..D).any(|axis| {
            (position[axis] < bounds.min[axis] && is_closed(axis, 0))
                || (position[axis] > bounds.max[axis] && is_closed(axis, 1))
        });
        !behind_closed_side
            && self.bodies.iter().all(|body| {
                let least = least(body);
                let reach = least.max(self.resolution.at(position));
                !body.shape.bounds().grown(reach).contains(position)
                    || body.shape.signed_distance(position) >= least
            })
    }

    /// A particle of the starting lattice in `state`, of the gas of the free stream.
    pub fn particle(&self, position: Vector<D>, state: &State<D>, id: u64) -> Particle<D> {
        self.particle_of(false, position, state, id)
    }

    /// The same of the second gas, if it `is_second`.
    fn particle_of(
        &self,
        is_second: bool,
        position: Vector<D>,
        state: &State<D>,
        id: u64,
    ) -> Particle<D> {
        let spacing = self.resolution.at(&position);
        let density = match self.scheme.operators.volume {
            Volume::OfDensity => state.density,
            Volume::Summed => self.free_stream.density,
        };
        let plane_mass = density * spacing.powi(D as i32);
        Particle {
            position,
            velocity: state.velocity,
            density: state.density,
            energy: (self.gases().of(is_second)).energy(state.density, state.pressure),
            smoothing_length: SMOOTHING_RATIO * spacing,
            mass: plane_mass * Rings::new(self).circumference(&position),
            first_plane_mass: plane_mass,
            by_pressure: ByPressure::default(),
            spared: Spared::unknown(),
            is_second,
            is_calm: false,
            id,
        }
    }

    /// True where the free stream moves on without sums: all gas that enters is it.
    pub fn skips_undisturbed(&self) -> bool {
        self.scheme.skip_undisturbed && self.domain.openings.is_empty()
    }

    /// True where the lattice starts as the undisturbed free stream, so that not even the first sums need be
    /// taken far from bodies and walls. Rings are not spread evenly, and must show that they are calm.
    fn starts_calm(&self) -> bool {
        self.skips_undisturbed()
            && self.source.is_none()
            && self.second.is_none()
            && matches!(self.initial, Initial::FreeStream)
            && self.disorder == 0.0
            && !self.domain.is_axisymmetric()
    }
}

/// The fluid of `problem`, and its open sides with their buffers filled.
///
/// # Errors
/// Where the gas cannot start as it should.
pub fn start<const D: usize>(problem: &Problem<D>) -> Result<(Particles<D>, Buffers<D>), String> {
    let mut fluid = Vec::new();
    let mut buffers = Buffers::new(problem);
    let rows = buffers.sides.rows;
    let drift = Vector::zeros();
    let (first, last) = buffers.sides.lattice_range(&drift);
    let id = buffers.set_aside(lattice::count(&first, &last));
    let starts = |position: &Vector<D>| {
        let nearest = problem.resolution.at(position) * rows.nearest();
        problem.is_clear(position, |body| body.starting_distance(nearest))
    };
    let sides = &buffers.sides;
    let places = (0..lattice::count(&first, &last) as usize).into_par_iter();
    let places: Vec<_> = places
        .map(|number| {
            let position = rows.position(&lattice::at(first, last, number), &drift);
            match sides.zone(&position) {
                Zone::Interior if starts(&position) => Place::Particle,
                Zone::Interior if problem.domain.bounds.contains(&position) => Place::Empty,
                _ => Place::Beyond,
            }
        })
        .collect();
    let rooms = Rooms::new(problem, &rows, [first, last], &places);
    for (number, index) in lattice::points(first, last).enumerate() {
        let id = id + number as u64;
        let position = rows.position(&index, &drift);
        let zone = buffers.sides.zone(&position);
        if let (Zone::Beyond(side), Some(state)) = (zone, buffers.first_state(zone, &position)) {
            // Buffers go on as they are refilled, by the lattice.
            if problem.is_free(&position, &rows) {
                let particle = problem
                    .particle(position, &state, id)
                    .of_share(rows.share());
                buffers.add(OpenParticle::of_lattice(particle, side, Some(index)));
            }
        } else if places[number] == Place::Particle || (zone != Zone::Interior && starts(&position))
        {
            let room = rooms.at(&index);
            let disorder = problem.disorder * problem.resolution.at(&position);
            let shift = lattice::displacement(&index) * disorder;
            if let Some(mut particle) = born(problem, (position + room.offset, shift), zone, id)? {
                particle.smoothing_length *= room.share.powf(1.0 / D as f64);
                let particle = particle.of_share(rows.share() * room.share);
                place(particle, zone, &mut fluid, &mut buffers);
            }
        }
    }
    if problem.starts_calm() {
        let buffered = buffers.particles_mut().iter_mut();
        let buffered = buffered.map(|open| &mut open.particle);
        for particle in fluid.iter_mut().chain(buffered) {
            particle.is_calm = true;
        }
    }
    let packed = problem
        .bodies
        .iter()
        .filter_map(|b| b.packed_fluid.as_ref());
    for &position in packed.flat_map(|packed| &packed.position) {
        let id = buffers.set_aside(1);
        let zone = buffers.sides.zone(&position);
        if buffers.sides.stream_at(zone).is_none()
            && problem.is_clear(&position, |_| 0.0)
            && let Some(particle) = born(problem, (position, Vector::zeros()), zone, id)?
        {
            place(particle, zone, &mut fluid, &mut buffers);
        }
    }
    Ok((Particles::new(fluid), buffers))
}

/// A particle at `position`, displaced by `shift` if it is fluid, in the state of the start; none in a vacuum or past all
/// buffers.
fn born<const D: usize>(
    problem: &Problem<D>,
    (position, shift): (Vector<D>, Vector<D>),
    zone: Zone,
    id: u64,
) -> Result<Option<Particle<D>>, String> {
    let displaced = match zone {
        Zone::Interior => position + shift,
        Zone::Beyond(_) => position,
        Zone::Outside => return Ok(None),
    };
    // A field takes the state that its lattice place had along; next to a solution that is known, that would be an error of first order.
    let known = problem.source.as_ref().map_or(position, |_| displaced);
    let state = problem.initial_state(&known)?;
    let second = problem.second.as_ref();
    let is_second = second.is_some_and(|second| (second.fills)(&known));
    Ok(state.map(|state| problem.particle_of(is_second, displaced, &state, id)))
}

/// Puts a particle where it belongs.
fn place<const D: usize>(
    particle: Particle<D>,
    zone: Zone,
    fluid: &mut Vec<Particle<D>>,
    buffers: &mut Buffers<D>,
) {
    match zone {
        Zone::Beyond(side) => buffers.add(OpenParticle::of_lattice(particle, side, None)),
        _ => fluid.push(particle),
    }
}
