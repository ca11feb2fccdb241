//! Words of a scene that stand for a choice, as they are spelled.

use serde::Deserialize;

use crate::case::{Pressure, Stop};
use crate::sample::Quantity;
use aero_solver::method::Time;
use aero_solver::scheme::{Extrapolation, Precision, Scheme};

/// What carries the gas, as a scene spells it.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "kebab-case")]
pub enum MotionWord {
    /// Particles that move with it.
    WithTheGas,
    /// Points that stay where they are.
    Fixed,
}

/// Whether the way to the end matters, as a scene spells it.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "kebab-case")]
pub enum TimeWord {
    /// It does.
    Accurate,
    /// Only the steady flow is wanted.
    Settle,
}

impl From<TimeWord> for Time {
    fn from(word: TimeWord) -> Self {
        match word {
            TimeWord::Accurate => Self::Accurate,
            TimeWord::Settle => Self::Settle,
        }
    }
}

/// When a run ends, as a scene spells it.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum StopWord {
    /// At the end time.
    EndTime,
    /// As soon as forces and shocks have settled, at the end time at the latest.
    Steady,
}

impl From<StopWord> for Stop {
    fn from(word: StopWord) -> Self {
        match word {
            StopWord::EndTime => Self::EndTime,
            StopWord::Steady => Self::Steady,
        }
    }
}

/// What colours show, as a scene spells it.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum QuantityWord {
    /// Mach number.
    Mach,
    /// Pressure.
    Pressure,
    /// Pressure over that of the free stream, in its dynamic pressures.
    PressureCoefficient,
    /// Density.
    Density,
    /// Temperature.
    Temperature,
    /// Entropy over that of the free stream.
    Entropy,
    /// Speed.
    Speed,
    /// Size of the density's gradient, darker where it is larger.
    Schlieren,
}

impl From<QuantityWord> for Quantity {
    fn from(word: QuantityWord) -> Self {
        match word {
            QuantityWord::Mach => Self::Mach,
            QuantityWord::Pressure => Self::Pressure,
            QuantityWord::PressureCoefficient => Self::PressureCoefficient,
            QuantityWord::Density => Self::Density,
            QuantityWord::Temperature => Self::Temperature,
            QuantityWord::Entropy => Self::Entropy,
            QuantityWord::Speed => Self::Speed,
            QuantityWord::Schlieren => Self::Schlieren,
        }
    }
}

/// The pressure of force coefficients, as a scene spells it.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum PressureWord {
    /// Less that of the free stream.
    Gauge,
    /// As it is.
    Absolute,
}

impl From<PressureWord> for Pressure {
    fn from(word: PressureWord) -> Self {
        match word {
            PressureWord::Gauge => Self::Gauge,
            PressureWord::Absolute => Self::Absolute,
        }
    }
}

/// Numbers of the pair sums, as a scene spells it.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum PrecisionWord {
    /// All in `f64`.
    Double,
    /// Pairs in `f32`.
    Mixed,
}

impl From<PrecisionWord> for Precision {
    fn from(word: PrecisionWord) -> Self {
        match word {
            PrecisionWord::Double => Self::Double,
            PrecisionWord::Mixed => Self::Mixed,
        }
    }
}

/// The name of a scheme, as a scene spells it.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(try_from = "String")]
pub struct SchemeName(Scheme);

impl SchemeName {
    /// The scheme of that name.
    pub fn scheme(self) -> Scheme {
        self.0
    }
}

impl TryFrom<String> for SchemeName {
    type Error = String;

    fn try_from(name: String) -> Result<Self, String> {
        let named = Scheme::named(&name);
        named.map(Self).ok_or_else(|| {
            let names = Scheme::NAMED.map(|scheme| format!("`{}`", scheme.name));
            format!(
                "`{name}` is no set of equations; there are {}",
                names.join(", ")
            )
        })
    }
}

/// How ghosts get their state, as a scene spells it.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ExtrapolationWord {
    /// Without ghost mirrors.
    Wom,
    /// With ghost mirrors.
    Wm,
}

impl From<ExtrapolationWord> for Extrapolation {
    fn from(word: ExtrapolationWord) -> Self {
        match word {
            ExtrapolationWord::Wom => Self::Wom,
            ExtrapolationWord::Wm => Self::Wm,
        }
    }
}
