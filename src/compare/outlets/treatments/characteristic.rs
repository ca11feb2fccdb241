//! What has left has the wave that goes out, and none that comes in.

use crate::outlets::particle::Particle;
use crate::outlets::treatment::{Next, Sight, Treatment};

/// Lastiwka, Basa & Quinlan 2009, doi:10.1002/fld.1971; Negi et al. 2020, eqs 25 to 27: `J = rho c (u - u_ref) + (p - p_ref)` is the mean
/// of the gas in reach, what comes in is zero, the velocity across the duct stays; the reference is the stream.
pub struct Characteristic;

impl Treatment for Characteristic {
    fn name(&self) -> &'static str {
        "characteristic"
    }

    fn next(&self, one: &Particle, sight: &Sight<'_>) -> Next {
        let (impedance, stream) = (sight.impedance(), sight.duct.stream);
        let wave = sight.heard(one, |gas| {
            gas.state[0] + impedance * (gas.state[1] - stream)
        });
        let half = 0.5 * wave.0;
        Next {
            wave,
            ..Next::with([half, stream + half / impedance, one.state[2]])
        }
    }
}
