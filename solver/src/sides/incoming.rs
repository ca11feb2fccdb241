//! The wave that comes in through an outlet, see [`super::held`].

use serde::{Deserialize, Serialize};

use super::waves::{Along, Waves};

/// The wave that comes in through a face.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Incoming {
    /// `u - 2 c / (gamma - 1)`.
    pub back: f64,
    /// Logarithm of `p / rho^gamma` of the gas that it met last.
    pub entropy: f64,
    /// How fast gas parts along the side, per time, in the mean of late.
    pub parting: f64,
}

impl Incoming {
    /// That of gas in this state, its speed out of the domain.
    pub fn of(gas: &Along, gamma: f64) -> Self {
        let waves = gas.waves(gamma);
        Self {
            back: waves.back,
            entropy: waves.entropy.ln(),
            parting: 0.0,
        }
    }

    /// The same of gas that parts along the side at this rate.
    #[must_use]
    pub fn parting(self, parting: f64) -> Self {
        Self { parting, ..self }
    }

    /// The state that it makes of such gas; none where it leaves a vacuum.
    pub fn meeting(&self, gas: &Along, gamma: f64) -> Option<Along> {
        let back = self.back;
        Waves {
            back,
            ..gas.waves(gamma)
        }
        .state(gamma)
    }
}
