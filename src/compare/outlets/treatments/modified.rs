//! What has left stays as it was, and drifts as fast as the gas.

use crate::outlets::particle::Particle;
use crate::outlets::treatment::{ECHO, Next, SLOW, Sight, Treatment};
use crate::outlets::wave::Sound;
use crate::points::weights::shepard;

/// Negi et al. 2020, eqs 17, 18: as do-nothing, but the particle drifts with the mean speed of the gas in reach.
pub struct ModifiedDoNothing;

impl Treatment for ModifiedDoNothing {
    fn name(&self) -> &'static str {
        "modified do-nothing"
    }

    fn echo(&self, sound: &Sound) -> Option<f64> {
        (sound.mach > SLOW).then_some(ECHO)
    }

    fn next(&self, one: &Particle, sight: &Sight<'_>) -> Next {
        let weights = shepard(&sight.gas_crowd.cloud, &one.position);
        Next {
            drift: weights.map(|weights| sight.sum(&weights, |gas| gas.state[1])),
            ..Next::with(one.state)
        }
    }
}
