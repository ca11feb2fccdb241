//! Waves that come in through outlets that relax to a pressure: each face has its own, which changes in time by what the outlet asks for, and by
//! what of entropy and vortices passes.
//!
//! Told from the gas in front of the face, from what flows along the side there, such a wave is off by all that is off in that: the pressure
//! at the end of a duct that widens was up to 4 % too high for good, and gas along its wall came to rest. With a life of its own it changes
//! until the pressure at its face is the one that is held.

use crate::sides::{Along, Held, Incoming};

/// Such an outlet, as a face sees it.
#[derive(Clone, Copy, Debug)]
pub struct Riding {
    held: Held,
    /// None before the first step: that of the gas itself.
    pub wave: Option<Incoming>,
}

impl Riding {
    /// A face of the outlet `held`.
    pub fn new(held: Held) -> Self {
        Self { held, wave: None }
    }

    /// The same at another pressure.
    #[must_use]
    pub fn at(self, pressure: f64) -> Self {
        Self {
            held: self.held.at(pressure),
            ..self
        }
    }

    /// What is beyond gas that reaches the face in this state, its speed out of the domain.
    pub fn beyond(&self, gas: &Along) -> Along {
        self.wave.map_or(*gas, |wave| self.held.behind(&wave, gas))
    }

    /// Lets a `step` pass, at the end of which gas reaches the face in this state.
    pub fn go_on(&mut self, gas: &Along, parting: f64, step: f64) {
        let own = self.held.own(gas).parting(parting);
        let wave = self.wave.unwrap_or(own);
        self.wave = Some(self.held.later(&wave, gas, parting, step));
    }
}
