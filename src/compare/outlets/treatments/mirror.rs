//! What has left mirrors the gas.

use aero_geometry::Vector;

use crate::outlets::particle::Particle;
use crate::outlets::treatment::{ECHO, Next, SLOW, Sight, Treatment};
use crate::outlets::wave::Sound;
use crate::points::weights::linear;

/// Tafuni et al. 2018, doi:10.1016/j.cma.2018.08.004, as Negi et al. 2020 mean it: the state of the gas at the mirror point, by a linear fit
/// [Liu & Liu 2006], so that nothing changes along the duct at the outlet. Their eq 24, `f - (r_o - r_k).grad f`, makes `a - 3 b d` of
/// `a + b x`, which is no such thing; Tafuni's own, with a plus, extrapolates.
pub struct Mirror;

impl Treatment for Mirror {
    fn name(&self) -> &'static str {
        "mirror"
    }

    /// It is level where the wave is not.
    fn echo(&self, sound: &Sound) -> Option<f64> {
        (sound.mach > SLOW).then_some(2.0 * ECHO)
    }

    fn next(&self, one: &Particle, sight: &Sight<'_>) -> Next {
        let mirror = Vector::<2>::new(2.0 * sight.duct.length - one.position.x, one.position.y);
        let Some(weights) = linear(&sight.gas_crowd.cloud, &mirror) else {
            return Next::with(one.state);
        };
        Next::with(sight.state(&weights))
    }
}
