//! A sound that meets an outlet, and what comes back of it.

use std::f64::consts::PI;

use aero_geometry::Vector;

use super::cases::DAMPING;
use super::duct::{DENSITY, Duct};
use super::flow::Flow;
use super::treatment::{Mistake, Treatment};
use super::treatments::DoNothing;
use super::wave::Sound;

/// Half of the largest rise of the wave along the stream over its strength, `max sin(4 pi x) exp(-(x / 0.2)^2)`.
const PEAK: f64 = 0.742;

impl Sound {
    /// The wave against the stream once the sound, from crest to crest half as long as the duct, has crossed the outlet and all but the last tenth
    /// of what comes back is in the duct, at the particles' first places, over the speed of sound.
    pub fn back(
        &self,
        length: f64,
        treatment: &dyn Treatment,
        mistake: Option<Mistake>,
    ) -> Vec<f64> {
        let mut flow = Flow::new(self.duct(length), treatment, mistake);
        for one in &mut flow.gas {
            let off = one.position.x - 0.5;
            let rise = self.strength * (4.0 * PI * off).sin() * (-(off / 0.2).powi(2)).exp();
            one.state = [DENSITY * rise, self.mach + rise, 0.0];
        }
        while flow.time < self.time() {
            flow.step();
        }
        let place = |k| Vector::<2>::new((f64::from(k) + 0.5) / f64::from(self.cells), 0.0);
        let wave = |k| {
            let [p, u, _] = flow.at(&place(k));
            u - p / DENSITY
        };
        (0..self.cells).map(wave).collect()
    }

    fn time(&self) -> f64 {
        0.5 / (1.0 + self.mach) + 0.4 / (1.0 - self.mach)
    }

    /// What is left of the sound in a duct so long that nothing comes back.
    pub fn reference(&self) -> Vec<f64> {
        let length = 1.0 + 0.5 * self.time() * (1.0 - self.mach * self.mach);
        let cells = f64::from(self.cells);
        self.back((length * cells).ceil() / cells, &DoNothing, None)
    }

    /// The part that comes back: the largest wave against the stream beside the `reference`'s over the largest along it.
    pub fn comes_back(
        &self,
        reference: &[f64],
        treatment: &dyn Treatment,
        mistake: Option<Mistake>,
    ) -> f64 {
        let back = self.back(1.0, treatment, mistake);
        let off = back.iter().zip(reference).map(|(a, b)| (a - b).abs());
        // Not f64::max, which would hide what is no number.
        let most = off.fold(0.0, |most: f64, now| if now <= most { most } else { now });
        most / (2.0 * PEAK * self.strength)
    }

    fn duct(&self, length: f64) -> Duct {
        Duct {
            length,
            rows: 1,
            spacing: 1.0 / f64::from(self.cells),
            sound: 1.0,
            stream: self.mach,
            damping: DAMPING,
            viscosity: 0.0,
            inflow: |_, _, stream| [stream, 0.0],
        }
    }
}
