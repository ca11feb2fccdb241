//! The suite: a pulse, a ramp and a vortex that leave a duct of two metres [Negi et al. 2020, sections 4.2 to 4.4].

use std::f64::consts::PI;

use aero_geometry::Vector;

use super::duct::{DENSITY, Duct};
use super::flow::Flow;
use super::treatment::Treatment;
use super::treatments::DoNothing;

/// Where the flow is measured, m from the inlet.
const PROBE: f64 = 1.7;
const LENGTH: f64 = 2.0;
const SPACING: f64 = 0.1;
/// m/s.
const STREAM: f64 = 1.0;
const SOUND: f64 = 10.0;
/// Of the damping of pressure.
pub const DAMPING: f64 = 0.5;
/// `delta` of the pulse, s^2, which the paper does not give: the square of how long it lasts.
const PULSE: f64 = 0.01;
/// Strength of the vortex, m^2/s.
const STRENGTH: f64 = 0.1;

/// A flow of the suite.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Case {
    Pulse,
    Ramp,
    Vortex,
}

impl Case {
    pub fn name(self) -> &'static str {
        match self {
            Self::Pulse => "pulse",
            Self::Ramp => "ramp",
            Self::Vortex => "vortex",
        }
    }

    /// s.
    fn duration(self) -> f64 {
        match self {
            Self::Pulse | Self::Ramp => 3.0,
            Self::Vortex => 4.0,
        }
    }

    /// Velocity that comes in, m/s, at a place and time [eqs 34, with a minus in the exponent, to 36].
    fn inflow(self) -> fn(&Vector<2>, f64, f64) -> [f64; 2] {
        match self {
            Self::Pulse => |place, time, stream| {
                let since = time - 1.0;
                if !(0.0..0.1).contains(&since) {
                    return [stream, 0.0];
                }
                let rise = 0.5 * (PI * place.y / 12.0).cos() * (-since * since / PULSE).exp();
                [stream + rise, 0.0]
            },
            Self::Ramp => |_, time, stream| [stream * time.min(1.0), 0.0],
            Self::Vortex => |place, time, stream| {
                let x = place.x - stream * (time - 1.0);
                let factor = STRENGTH / (x * x + place.y * place.y + 0.2);
                [stream + factor * place.y, -factor * x]
            },
        }
    }

    /// Rows from wall to wall: the ramp is the same across the duct.
    fn rows(self) -> usize {
        match self {
            Self::Pulse => 20,
            Self::Ramp => 1,
            Self::Vortex => 40,
        }
    }
}

/// A case with its damping and viscosity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Suite {
    pub case: Case,
    pub damping: f64,
    /// m^2/s.
    pub viscosity: f64,
}

/// States at the probe, step by step, in units of `rho u^2 / 2` and `u`.
pub type Record = Vec<[f64; 3]>;

impl Suite {
    /// In words.
    pub fn name(&self) -> String {
        let damping = (self.damping != DAMPING).then(|| format!("alpha {}", self.damping));
        let viscous = (self.viscosity > 0.0).then(|| format!("Re {}", STREAM / self.viscosity));
        let case = Some(self.case.name().to_owned());
        let words: Vec<String> = [case, damping, viscous].into_iter().flatten().collect();
        words.join(", ")
    }

    pub fn duct(&self, length: f64) -> Duct {
        Duct {
            length,
            rows: self.case.rows(),
            spacing: SPACING,
            sound: SOUND,
            stream: STREAM,
            damping: self.damping,
            viscosity: self.viscosity,
            inflow: self.case.inflow(),
        }
    }

    /// Through a duct so long that nothing comes back to the probe.
    pub fn reference(&self) -> Record {
        let (with, against) = (SOUND + STREAM, SOUND - STREAM);
        let length = (self.case.duration() + PROBE / against) / (1.0 / with + 1.0 / against);
        self.record(length, &DoNothing)
    }

    /// Ended by a treatment.
    pub fn treated(&self, treatment: &dyn Treatment) -> Record {
        self.record(LENGTH, treatment)
    }

    fn record(&self, length: f64, treatment: &dyn Treatment) -> Record {
        let mut flow = Flow::new(self.duct(length), treatment, None);
        let place = Vector::<2>::new(PROBE, 0.0);
        let steps = (self.case.duration() / flow.duct.step()).round() as usize;
        let mut record = Vec::with_capacity(steps);
        let head = 0.5 * DENSITY * STREAM * STREAM;
        for _ in 0..steps {
            flow.step();
            let [p, u, v] = flow.at(&place);
            record.push([p / head, u / STREAM, v / STREAM]);
        }
        record
    }

    /// Times of a record, s.
    pub fn time(&self, step: usize) -> f64 {
        (step + 1) as f64 * self.duct(LENGTH).step()
    }
}

/// `sqrt(sum (f - f_l)^2 / sum f_l^2)` over all steps of each quantity [eq 32].
pub fn errors(record: &Record, reference: &Record) -> [f64; 3] {
    std::array::from_fn(|k| {
        let pairs = record.iter().zip(reference);
        let off = pairs.map(|(a, b)| (a[k] - b[k]).powi(2)).sum::<f64>();
        let all = reference.iter().map(|b| b[k].powi(2)).sum::<f64>();
        (off / all).sqrt()
    })
}
