//! Gas that enters from a reservoir at less than the speed of sound, see [`super::plenum`]. Not for the particles of the buffer: those are in [`super::buffers`].
//!
//! A reservoir that holds its total state sends `(1 - M) / (1 + M)` of a sound wave back in. One that relaxes to it lets
//! sound out: the wave that comes in goes to the one held at the rate `sigma c / L`, as at an outlet ([`super::held`]).

use super::model::{OpenModel, Place};
use super::plenum::Plenum;
use super::waves::{Along, Waves, inwards, outgoing};
use crate::particles::Particle;
use crate::problem::{Problem, State};

/// A side that gas enters through from a reservoir.
#[derive(Clone, Copy, Debug)]
pub struct Reservoir {
    place: Place,
    plenum: Plenum,
    /// `sigma / L` where it relaxes to that.
    strength: Option<f64>,
}

impl Reservoir {
    /// The reservoir beyond `place`, at the stagnation state of the free stream of `problem`; `relaxation` is `sigma`, none of
    /// one that holds it.
    pub fn new<const D: usize>(
        problem: &Problem<D>,
        place: Place,
        relaxation: Option<f64>,
    ) -> Self {
        Self {
            place,
            plenum: Plenum::of_stream(problem),
            strength: relaxation.map(|sigma| sigma / problem.domain.bounds.size()[place.axis]),
        }
    }

    /// State in which gas enters against the invariant `back`, where it entered in state `before` a `time` ago.
    fn entering(&self, back: f64, before: &Along, time: f64) -> Along {
        let held = self.plenum.entering(back);
        let gamma = self.plenum.gamma();
        let Some(strength) = self.strength else {
            return held;
        };
        let share = (time * strength * before.sound(gamma)).min(1.0);
        let [held_waves, waves] = [held, *before].map(|gas| gas.waves(gamma));
        let relaxed = Waves {
            ahead: waves.ahead + share * (held_waves.ahead - waves.ahead),
            back,
            entropy: held_waves.entropy,
        };
        let relaxed = relaxed.state(gamma);
        relaxed.filter(|gas| gas.speed >= 0.0).unwrap_or(held)
    }

    /// The state beyond a face that `gas` reaches, its speed into the domain, from a cell whose `mean` is at this `distance` behind it: the
    /// wave that comes in crosses that at `u + c`. It goes on from the mean; drawn out to the face it would feed on itself.
    pub fn beyond(&self, gas: &Along, mean: &Along, distance: f64) -> Along {
        let gamma = self.plenum.gamma();
        let time = distance / (mean.speed.max(0.0) + mean.sound(gamma));
        self.entering(gas.waves(gamma).back, mean, time)
    }
}

impl<const D: usize> OpenModel<D> for Reservoir {
    fn inflow(&self, problem: &Problem<D>) -> Option<State<D>> {
        Some(problem.free_stream)
    }

    /// State in which gas enters a flow whose particles are `fluid`, straight into the domain; none where no gas is near the
    /// side.
    fn answer(
        &self,
        problem: &Problem<D>,
        fluid: &[Particle<D>],
        before: &State<D>,
        [earlier, now]: [f64; 2],
    ) -> Option<State<D>> {
        let back = outgoing(
            &self.place,
            problem.resolution.lattice(),
            self.plenum.gamma(),
            fluid,
        )?;
        let before = Along {
            density: before.density,
            speed: self.place.inward() * before.velocity[self.place.axis],
            pressure: before.pressure,
        };
        let gas = self.entering(back, &before, now - earlier);
        Some(State {
            density: gas.density,
            velocity: inwards(&self.place, gas.speed),
            pressure: gas.pressure,
        })
    }

    fn answers(&self) -> bool {
        true
    }
}
