//! Inlets and free-stream sides: gas enters in the undisturbed state, whatever the flow inside [Lastiwka et al.
//! 2009]; a free-stream side is one that the flow inside does not reach. Below the speed of sound that sends waves back in, and
//! an inlet that lets them out holds two of three values: the entropy and the wave that come in with the stream.

use super::model::{OpenModel, Place};
use super::waves::{Along, Waves, inwards, outgoing};
use crate::gas::{Gas, IdealGas};
use crate::particles::Particle;
use crate::problem::{Problem, State};

/// A side that the free stream is beyond.
#[derive(Clone, Copy, Debug)]
pub struct Inlet;

impl<const D: usize> OpenModel<D> for Inlet {
    fn inflow(&self, problem: &Problem<D>) -> Option<State<D>> {
        Some(problem.free_stream)
    }
}

/// One that lets sound out.
#[derive(Clone, Copy, Debug)]
pub struct SoftInlet {
    place: Place,
    gamma: f64,
    /// What comes in with the stream.
    stream: Waves,
}

impl SoftInlet {
    /// The one of `problem` at `place`.
    pub fn new<const D: usize>(problem: &Problem<D>, place: Place) -> Self {
        let Gas::Ideal(IdealGas { gamma, .. }) = problem.gas;
        let stream = &problem.free_stream;
        let along = Along {
            density: stream.density,
            speed: place.inward() * stream.velocity[place.axis],
            pressure: stream.pressure,
        };
        Self {
            place,
            gamma,
            stream: along.waves(gamma),
        }
    }
}

impl<const D: usize> OpenModel<D> for SoftInlet {
    fn inflow(&self, problem: &Problem<D>) -> Option<State<D>> {
        Some(problem.free_stream)
    }

    /// The stream's state less what the wave on its way out asks for; the stream's own where that would stop it, or where it is
    /// faster than sound.
    fn answer(
        &self,
        problem: &Problem<D>,
        fluid: &[Particle<D>],
        _before: &State<D>,
        _step: f64,
    ) -> Option<State<D>> {
        let (stream, axis) = (&problem.free_stream, self.place.axis);
        let back = outgoing(&self.place, problem.spacing, self.gamma, fluid)?;
        let waves = Waves {
            back,
            ..self.stream
        };
        let gas = waves.state(self.gamma)?;
        let is_slower = gas.speed < gas.sound(self.gamma) && self.stream.back < 0.0;
        if gas.speed <= 0.0 || !is_slower {
            return Some(*stream);
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
