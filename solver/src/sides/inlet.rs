//! Inlets and free-stream sides: gas enters in the undisturbed state, or in one that is given, whatever the flow inside [Lastiwka et al.
//! 2009]; a free-stream side is one that the flow inside does not reach. Below the speed of sound that sends waves back in, and
//! an inlet that lets them out holds two of three values: the entropy and the wave that come in with the stream.

use aero_geometry::Vector;

use super::model::{OpenModel, Place};
use super::waves::{Along, Waves, inwards, outgoing};
use crate::particles::Particle;
use crate::problem::{Given, Problem, State};

/// A side that the free stream, or gas in a state that is given, is beyond.
#[derive(Clone, Debug)]
pub struct Inlet<const D: usize> {
    middle: Vector<D>,
    given: Option<Given<D>>,
}

impl<const D: usize> Inlet<D> {
    /// The one of `problem` at `place`.
    pub fn new(problem: &Problem<D>, place: Place, given: Option<&Given<D>>) -> Self {
        Self {
            middle: place.middle(&problem.domain),
            given: given.cloned(),
        }
    }
}

impl<const D: usize> OpenModel<D> for Inlet<D> {
    fn inflow(&self, problem: &Problem<D>) -> Option<State<D>> {
        let given = self.given.as_ref();
        Some(given.map_or(problem.free_stream, |given| given.at(&self.middle, 0.0)))
    }

    /// What is given, at the middle of the side.
    fn answer(
        &self,
        _problem: &Problem<D>,
        _fluid: &[Particle<D>],
        _before: &State<D>,
        [_, now]: [f64; 2],
    ) -> Option<State<D>> {
        let given = self.given.as_ref()?;
        Some(given.at(&self.middle, now))
    }

    fn answers(&self) -> bool {
        self.given.is_some()
    }

    fn profile(&self, stream: &State<D>, position: &Vector<D>, time: f64) -> State<D> {
        let given = self.given.as_ref();
        given.map_or(*stream, |given| given.at(position, time))
    }
}

/// One that lets sound out.
#[derive(Clone, Debug)]
pub struct SoftInlet<const D: usize> {
    place: Place,
    gamma: f64,
    middle: Vector<D>,
    /// The stream, where that is not the free one.
    given: Option<Given<D>>,
}

impl<const D: usize> SoftInlet<D> {
    /// The one of `problem` at `place`.
    pub fn new(problem: &Problem<D>, place: Place, given: Option<&Given<D>>) -> Self {
        let stream = &problem.free_stream;
        Self {
            place,
            gamma: problem.gas.ratio_at(stream.density, stream.pressure),
            middle: place.middle(&problem.domain),
            given: given.cloned(),
        }
    }

    /// The stream at a time.
    fn stream(&self, problem: &Problem<D>, time: f64) -> State<D> {
        let given = self.given.as_ref();
        given.map_or(problem.free_stream, |given| given.at(&self.middle, time))
    }

    /// What comes in with `stream`.
    fn waves(&self, stream: &State<D>) -> Waves {
        let along = Along {
            density: stream.density,
            speed: self.place.inward() * stream.velocity[self.place.axis],
            pressure: stream.pressure,
        };
        along.waves(self.gamma)
    }
}

impl<const D: usize> OpenModel<D> for SoftInlet<D> {
    fn inflow(&self, problem: &Problem<D>) -> Option<State<D>> {
        Some(self.stream(problem, 0.0))
    }

    /// The stream's state less what the wave on its way out asks for; the stream's own where that would stop it, or where it is
    /// faster than sound.
    fn answer(
        &self,
        problem: &Problem<D>,
        fluid: &[Particle<D>],
        _before: &State<D>,
        [_, now]: [f64; 2],
    ) -> Option<State<D>> {
        let axis = self.place.axis;
        let stream = self.stream(problem, now);
        let entering = self.waves(&stream);
        let back = outgoing(&self.place, problem.resolution.lattice(), self.gamma, fluid)?;
        let gas = Waves { back, ..entering }.state(self.gamma)?;
        let is_slower = gas.speed < gas.sound(self.gamma) && entering.back < 0.0;
        if gas.speed <= 0.0 || !is_slower {
            return Some(stream);
        }
        let mut velocity = stream.velocity;
        velocity[axis] = inwards::<D>(&self.place, gas.speed)[axis];
        Some(State {
            density: gas.density,
            velocity,
            pressure: gas.pressure,
        })
    }

    fn answers(&self) -> bool {
        true
    }
}
