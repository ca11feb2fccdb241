//! Buffers of particles beyond open sides [Federico et al. 2012; Lastiwka et al. 2009].
//!
//! Sides that gas enters through hold a lattice that moves with their stream. A lattice particle that enters the domain becomes
//! fluid; fluid that enters the lattice is absorbed. Fluid that crosses an outlet drifts on, as the outlet's model holds it, and
//! is removed past the buffer.

use std::ops::Range;

use aero_geometry::Vector;
use aero_geometry::parallel::prelude::*;
use serde::{Deserialize, Serialize};

use super::particle::OpenParticle;
use super::zone::{OpenSide, OpenSides, Zone};
use crate::books::Books;
use crate::diffusive::Gradients;
use crate::lattice;
use crate::particles::{Particle, Particles};
use crate::problem::{Problem, State};

/// The open sides and the particles of their buffers.
#[derive(Debug)]
pub struct Buffers<const D: usize> {
    /// The sides.
    pub sides: OpenSides<D>,
    pub(super) contents: Contents<D>,
}

/// What a checkpoint keeps of the buffers.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Contents<const D: usize> {
    pub(super) particles: Vec<OpenParticle<D>>,
    streams: Vec<Stream<D>>,
    /// The first number that no particle can have yet.
    pub(super) ids: u64,
}

/// Gas that enters through one or more sides: a lattice that moves on.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
struct Stream<const D: usize> {
    state: State<D>,
    /// How far the lattice has drifted since the start.
    drift: Vector<D>,
}

impl<const D: usize> Buffers<D> {
    /// The open sides of `problem`, nothing beyond them yet.
    pub fn new(problem: &Problem<D>) -> Self {
        let (sides, streams) = OpenSides::new(problem);
        let drift = Vector::zeros();
        let streams = streams.into_iter().map(|state| Stream { state, drift });
        let contents = Contents {
            particles: Vec::new(),
            streams: streams.collect(),
            ids: 0,
        };
        Self { sides, contents }
    }

    /// The particles of all buffers.
    pub fn particles(&self) -> &[OpenParticle<D>] {
        &self.contents.particles
    }

    /// The particles of all buffers, to change.
    pub fn particles_mut(&mut self) -> &mut [OpenParticle<D>] {
        &mut self.contents.particles
    }

    /// Puts a particle into a buffer.
    pub fn add(&mut self, particle: OpenParticle<D>) {
        self.contents.particles.push(particle);
    }

    /// Brings the particles into a new order.
    pub fn permute(&mut self, order: &[u32]) {
        let old = &self.contents.particles;
        let moved = order.par_iter().map(|&n| old[n as usize]);
        self.contents.particles = moved.collect();
    }

    /// What a checkpoint keeps.
    pub fn contents(&self) -> &Contents<D> {
        &self.contents
    }

    /// Goes on from what a checkpoint kept.
    pub fn restore(&mut self, contents: Contents<D>) {
        self.contents = contents;
    }

    /// State at the start of gas at `position` that is to enter; none where none does.
    pub fn first_state(&self, zone: Zone, position: &Vector<D>) -> Option<State<D>> {
        let (Zone::Beyond(side), Some(stream)) = (zone, self.sides.stream_at(zone)) else {
            return None;
        };
        let state = &self.contents.streams[stream].state;
        Some(self.sides.side(side).model.profile(state, position, 0.0))
    }

    /// The fastest that any stream enters.
    pub fn fastest_stream(&self) -> f64 {
        let speeds = self
            .contents
            .streams
            .iter()
            .map(|s| s.state.velocity.norm());
        speeds.fold(0.0, f64::max)
    }

    /// After the fluid has moved from `before` to `now`: moves the buffers on, turns lattice particles that entered into fluid,
    /// absorbs fluid that left or hands it to its outlet, refills the lattices.
    pub fn exchange(
        &mut self,
        problem: &Problem<D>,
        [before, now]: [f64; 2],
        fluid: &mut Particles<D>,
        books: &mut Books,
    ) {
        if self.sides.is_empty() {
            return;
        }
        self.drift_on(now - before);
        let earlier: Vec<_> = self.contents.streams.iter().map(|s| s.drift).collect();
        for (number, stream) in self.contents.streams.iter_mut().enumerate() {
            let mut feeds = self.sides.iter().filter(|s| s.stream == Some(number));
            stream.drift = if feeds.any(|side| side.model.answers()) {
                stream.drift + stream.state.velocity * (now - before)
            } else {
                stream.state.velocity * now
            };
        }
        let entering = self.let_in(problem);
        let gone = self.contents.particles.len();
        self.go_on(problem, fluid, 0..gone, [before, now]);
        self.let_out(fluid, books);
        // What leaves in this step has gone through it with the flow inside, and is seen at the middle of the next.
        let all = self.contents.particles.len();
        self.go_on(problem, fluid, gone..all, [0.5 * (before + now), now]);
        self.thin_out(problem);
        self.fill_up(problem, now);
        for particle in entering {
            books.cross(&particle, 1.0);
            fluid.add(particle);
        }
        for number in 0..self.contents.streams.len() {
            self.listen(problem, fluid, number, [before, now]);
            self.refill(problem, number, &earlier[number], now);
        }
    }

    /// Lets what has left the domain drift on.
    fn drift_on(&mut self, step: f64) {
        for open in &mut self.contents.particles {
            if open.lattice.is_none() {
                open.particle.position += open.particle.velocity * step;
            }
        }
    }

    /// Lets the models of sides that gas leaves by say what becomes of what has left, of the particles of this range.
    fn go_on(
        &mut self,
        problem: &Problem<D>,
        fluid: &[Particle<D>],
        range: Range<usize>,
        times: [f64; 2],
    ) {
        let (older, particles) = self.contents.particles.split_at_mut(range.start);
        let particles = &mut particles[..range.end - range.start];
        for (number, side) in self.sides.iter().enumerate() {
            if !side.model.goes_on() {
                continue;
            }
            let is_own =
                |open: &OpenParticle<D>| usize::from(open.side) == number && open.lattice.is_none();
            let own = particles.iter().filter(|open| is_own(open)).copied();
            let mut gone: Vec<_> = own.collect();
            if gone.is_empty() {
                continue;
            }
            let older: Vec<_> = older.iter().filter(|open| is_own(open)).copied().collect();
            side.model.go_on(problem, fluid, &mut gone, &older, times);
            let places = particles.iter_mut().filter(|open| is_own(open));
            for (place, open) in places.zip(gone) {
                *place = open;
            }
        }
    }

    /// Moves the lattices to where their streams have drifted; takes out what is in the domain then, and drops what left
    /// its buffer otherwise.
    fn let_in(&mut self, problem: &Problem<D>) -> Vec<Particle<D>> {
        let mut entering = Vec::new();
        let Contents {
            particles, streams, ..
        } = &mut self.contents;
        let sides = &self.sides;
        particles.retain_mut(|open| {
            let own = sides.stream_at(Zone::Beyond(usize::from(open.side)));
            if let (Some(index), Some(own)) = (&open.lattice, own) {
                open.particle.position = sides.rows.position(index, &streams[own].drift);
            }
            match sides.zone(&open.particle.position) {
                // What has gone round the rim of its side is behind the rest of it, or behind a side next to it.
                Zone::Interior
                    if sides.is_behind(usize::from(open.side), &open.particle.position)
                        || problem.domain.is_walled_off(&open.particle.position) =>
                {
                    false
                }
                Zone::Interior => {
                    // The lattice is the free stream itself.
                    open.particle.is_calm |= open.lattice.is_some() && problem.skips_undisturbed();
                    entering.push(open.particle);
                    false
                }
                Zone::Beyond(side) => {
                    if let Some(stream) = sides.side(side).stream {
                        return open.lattice.is_some() && own == Some(stream);
                    }
                    // The lattice may drift round the corner of a free-stream side and an outlet.
                    open.lattice = None;
                    open.side = side as u8;
                    true
                }
                Zone::Outside => false,
            }
        });
        entering
    }

    /// Takes fluid that is in a buffer out of the flow: a lattice absorbs it, an outlet keeps it.
    fn let_out(&mut self, fluid: &mut Particles<D>, books: &mut Books) {
        let sides = &self.sides;
        let leaving: Vec<_> = fluid
            .par_iter()
            .enumerate()
            .map(|(i, particle)| (i, sides.zone(&particle.position)))
            .filter(|(_, zone)| *zone != Zone::Interior)
            .collect();
        for &(i, zone) in &leaving {
            let particle = fluid[i];
            books.cross(&particle, -1.0);
            if let (Zone::Beyond(side), None) = (zone, sides.stream_at(zone)) {
                let frozen = &fluid.renormalisations()[i];
                let rates = &fluid.rates()[i];
                self.contents.particles.push(OpenParticle {
                    particle,
                    side: side as u8,
                    lattice: None,
                    renormalisation: frozen.matrix,
                    gradient: frozen.density_gradient,
                    gradients: Gradients {
                        velocity: rates.velocity_gradient,
                        energy: rates.energy_gradient,
                    },
                });
            }
        }
        fluid.remove(leaving.iter().map(|&(i, _)| i));
    }

    /// Gives a stream, and all that it has in buffers, the state that the flow inside asks for, if any.
    fn listen(
        &mut self,
        problem: &Problem<D>,
        fluid: &[Particle<D>],
        number: usize,
        times: [f64; 2],
    ) {
        let now = times[1];
        let mut own = self.sides.iter().filter(|s| s.stream == Some(number));
        let current = self.contents.streams[number].state;
        let answer = |side: &OpenSide<D>| {
            let model = &side.model;
            model.answer(problem, fluid, &current, times)
        };
        let Some(state) = own.find_map(answer) else {
            return;
        };
        let Contents {
            particles, streams, ..
        } = &mut self.contents;
        streams[number].state = state;
        for open in particles.iter_mut().filter(|o| o.lattice.is_some()) {
            let side = self.sides.side(usize::from(open.side));
            if side.stream == Some(number) {
                let old = open.particle;
                let state = side.model.profile(&state, &old.position, now);
                let particle = problem.particle(old.position, &state, old.id);
                open.particle = particle.of_share(self.sides.rows.share());
            }
        }
    }

    /// Adds the lattice points that came into a stream's buffers since its lattice stood at `earlier`.
    fn refill(&mut self, problem: &Problem<D>, number: usize, earlier: &Vector<D>, now: f64) {
        let Stream { state, drift } = self.contents.streams[number];
        if drift == *earlier {
            return;
        }
        let is_own = |zone| self.sides.stream_at(zone) == Some(number);
        let Contents { particles, ids, .. } = &mut self.contents;
        for (first, last) in self.sides.slabs(&drift) {
            let id = *ids;
            *ids += lattice::count(&first, &last);
            for (id, index) in (id..).zip(lattice::points(first, last)) {
                let position = self.sides.rows.position(&index, &drift);
                let before = self.sides.rows.position(&index, earlier);
                let zone = self.sides.zone(&position);
                if let (Zone::Beyond(side), true) = (zone, is_own(zone))
                    && !is_own(self.sides.zone(&before))
                    && problem.is_free(&position, &self.sides.rows)
                {
                    let model = &self.sides.side(side).model;
                    let state = model.profile(&state, &position, now);
                    let particle = problem
                        .particle(position, &state, id)
                        .of_share(self.sides.rows.share());
                    particles.push(OpenParticle::of_lattice(particle, side, Some(index)));
                }
            }
        }
    }

    /// Sets aside numbers for `count` places that particles may be born at; returns the first. Every place looked at has a
    /// number of its own, taken or not, so that a particle's number follows from its place in the lattice and from which
    /// refill it is born in, and not from how many were born before.
    pub fn set_aside(&mut self, count: u64) -> u64 {
        let first = self.contents.ids;
        self.contents.ids += count;
        first
    }
}
