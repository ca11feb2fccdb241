//! What ends a flow: how a particle beyond the outlet goes on.

use super::duct::{Crowd, DENSITY, Duct};
use super::particle::Particle;
use super::wave::Sound;
use crate::points::weights::{Weights, shepard};

/// The part of a sound that may come back, as of the project's open sides.
pub const ECHO: f64 = 0.05;
/// Mach number below which a wave in the buffer that rides with its particles, `M / (1 + M)` as long as in the gas, is too short for the
/// spacing.
pub const SLOW: f64 = 0.2;

/// How gas that has left goes on.
pub trait Treatment: Sync {
    /// As in the tables.
    fn name(&self) -> &'static str;

    /// A particle beyond the outlet a step later: its state, and how fast it drifts along the duct, m/s; none where it hears no gas to
    /// tell that, and drifts with the others.
    fn next(&self, one: &Particle, sight: &Sight<'_>) -> Next;

    /// The largest part of such a sound that may come back; none where nothing is asked.
    fn echo(&self, _: &Sound) -> Option<f64> {
        Some(ECHO)
    }
}

/// A particle beyond the outlet a step later.
#[derive(Clone, Copy, Debug)]
pub struct Next {
    /// Pressure and velocity.
    pub state: [f64; 3],
    /// m/s.
    pub drift: Option<f64>,
    /// What it hears, and whether of gas.
    pub wave: (f64, bool),
}

impl Next {
    /// In this state, which it drifts with.
    pub fn with(state: [f64; 3]) -> Self {
        Self {
            state,
            drift: Some(state[1]),
            wave: (0.0, false),
        }
    }
}

/// What a particle beyond the outlet sees.
#[derive(Clone, Copy)]
pub struct Sight<'a> {
    pub duct: &'a Duct,
    /// The gas near the outlet.
    pub gas: &'a [Particle],
    pub gas_crowd: &'a Crowd,
    /// What is beyond, as it was a step before.
    pub beyond: &'a [Particle],
    pub beyond_crowd: &'a Crowd,
}

impl Sight<'_> {
    /// `sum w_j f_j` of the gas.
    pub fn sum(&self, weights: &Weights, value: impl Fn(&Particle) -> f64) -> f64 {
        let term = |(j, w): &(u32, f64)| w * value(&self.gas[self.gas_crowd.owner(*j as usize)]);
        weights.iter().map(term).sum()
    }

    /// The state `sum w_j q_j` of the gas.
    pub fn state(&self, weights: &Weights) -> [f64; 3] {
        let mut sum = [0.0; 3];
        for (j, w) in weights {
            let state = self.gas_crowd.state(*j as usize, self.gas);
            sum = std::array::from_fn(|k| sum[k] + w * state[k]);
        }
        sum
    }

    /// What `one` hears of a `wave` of the gas: the mean of the gas in reach [eq 26], or where there is none of what others in reach, which
    /// have gas in theirs, heard a step before [eq 27].
    pub fn heard(&self, one: &Particle, wave: impl Fn(&Particle) -> f64) -> (f64, bool) {
        if let Some(weights) = shepard(&self.gas_crowd.cloud, &one.position) {
            return (self.sum(&weights, wave), true);
        }
        let (mut sum, mut count) = (0.0, 0.0);
        self.beyond_crowd.cloud.near(&one.position, |j, _| {
            let (wave, is_of_gas) = self.beyond[self.beyond_crowd.owner(j)].wave;
            if is_of_gas {
                sum += wave;
                count += 1.0;
            }
        });
        (if count > 0.0 { sum / count } else { 0.0 }, false)
    }

    /// `rho c`, kg/(m^2 s).
    pub fn impedance(&self) -> f64 {
        DENSITY * self.duct.sound
    }
}

/// A mistake in a treatment.
#[cfg_attr(not(test), allow(dead_code))] // planted in tests
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mistake {
    /// The speed is off the stream's the wrong way.
    Sign,
    /// The pressure is twice as much above the stream's.
    Double,
    /// Particles beyond the outlet stay where they are.
    Still,
}

impl Mistake {
    /// What the gas sees of a particle beyond the outlet.
    pub fn shown(self, [p, u, v]: [f64; 3], stream: f64) -> [f64; 3] {
        match self {
            Self::Sign => [p, 2.0 * stream - u, v],
            Self::Double => [2.0 * p, u, v],
            Self::Still => [p, u, v],
        }
    }
}
