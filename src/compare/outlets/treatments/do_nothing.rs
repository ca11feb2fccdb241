//! What has left stays as it was.

use crate::outlets::particle::Particle;
use crate::outlets::treatment::{ECHO, Next, SLOW, Sight, Treatment};
use crate::outlets::wave::Sound;

/// Federico et al. 2012; Negi et al. 2020, eqs 14 to 16: pressure and velocity stay those with which the particle crossed the outlet, and
/// it drifts at that speed along the duct. The project's outlet without a pressure does so, and drifts across the duct too.
pub struct DoNothing;

impl Treatment for DoNothing {
    fn name(&self) -> &'static str {
        "do-nothing"
    }

    fn echo(&self, sound: &Sound) -> Option<f64> {
        (sound.mach > SLOW).then_some(ECHO)
    }

    fn next(&self, one: &Particle, _: &Sight<'_>) -> Next {
        Next::with(one.state)
    }
}
