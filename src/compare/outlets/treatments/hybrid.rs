//! What changes slowly stays as it was, what is sound goes on.

use crate::outlets::particle::Particle;
use crate::outlets::treatment::{ECHO, Next, SLOW, Sight, Treatment};
use crate::outlets::wave::Sound;

/// Negi et al. 2020, section 3.4: the particle keeps the mean of its last steps in the gas [eq 28], taken where the sound was weaker than
/// eq 30 says, and on top of that hears the wave that goes out, relative to the means of the gas in reach [eq 31].
pub struct Hybrid;

impl Treatment for Hybrid {
    fn name(&self) -> &'static str {
        "hybrid"
    }

    /// Sound weaker than its measure is mean flow to it, which stays as it was.
    fn echo(&self, sound: &Sound) -> Option<f64> {
        let is_heard = sound.strength > 0.5 * sound.mach * sound.mach;
        (is_heard || sound.mach > SLOW).then_some(ECHO)
    }

    fn next(&self, one: &Particle, sight: &Sight<'_>) -> Next {
        let impedance = sight.impedance();
        let wave = sight.heard(one, |gas| {
            let [p, u] = gas.mean();
            gas.state[0] - p + impedance * (gas.state[1] - u)
        });
        let half = 0.5 * wave.0;
        let [p, u] = one.mean();
        let state = [p + half, u + half / impedance, one.state[2]];
        Next {
            wave,
            drift: wave.1.then_some(state[1]),
            ..Next::with(state)
        }
    }
}
