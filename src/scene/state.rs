//! `gas.equation_of_state`.

use serde::Deserialize;

use super::number::{Finite, Positive};
use aero_solver::gas::{Air, Gas, Liquid};

/// A word, or `{ linear = { .. } }` or `{ tait = { .. } }` of a liquid: how pressure and temperature follow from density and energy.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq)]
#[serde(rename_all = "kebab-case")]
pub enum EquationOfState {
    /// Constant specific heats.
    #[default]
    Ideal,
    /// Air whose molecules vibrate as it gets hot.
    ThermallyPerfectAir,
    /// Air whose molecules come apart too, in chemical equilibrium.
    EquilibriumAir,
    /// A liquid whose pressure is linear in its density.
    Linear(LinearEntry),
    /// A liquid by Tait's equation.
    Tait(TaitEntry),
}

impl EquationOfState {
    /// The gas that it is, if that is not an ideal one: without viscosity.
    pub(super) fn gas(self) -> Option<Gas> {
        match self {
            Self::Ideal => None,
            Self::ThermallyPerfectAir => Some(Gas::Air {
                air: Air::ThermallyPerfect,
                transport: None,
            }),
            Self::EquilibriumAir => Some(Gas::Air {
                air: Air::Equilibrium,
                transport: None,
            }),
            Self::Linear(entry) => Some(Gas::Liquid(entry.into())),
            Self::Tait(entry) => Some(Gas::Liquid(entry.into())),
        }
    }
}

/// Exponent of water [Cole 1948; Monaghan 1994].
const WATER: f64 = 7.0;

/// `linear = { .. }`: pressure `pressure + sound_speed^2 (rho - density)`.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct LinearEntry {
    /// Speed of sound; that of the liquid, or ten times the fastest flow to show one that can hardly be compressed.
    pub sound_speed: Positive,
    /// Density of the liquid at rest.
    pub density: Positive,
    /// Pressure at that density; zero unless given.
    pub pressure: Option<Finite>,
}

/// `tait = { .. }`: pressure `pressure + density sound_speed^2 / exponent ((rho / density)^exponent - 1)`.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct TaitEntry {
    /// Speed of sound at the density.
    pub sound_speed: Positive,
    /// Density of the liquid at rest.
    pub density: Positive,
    /// Pressure at that density; zero unless given.
    pub pressure: Option<Finite>,
    /// Exponent, one or more; 7 (water) unless given.
    pub exponent: Option<Exponent>,
}

/// An exponent of Tait's equation, one or more.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq)]
#[serde(try_from = "f64")]
pub struct Exponent(f64);

impl TryFrom<f64> for Exponent {
    type Error = String;

    fn try_from(value: f64) -> Result<Self, String> {
        if value.is_finite() && value >= 1.0 {
            Ok(Self(value))
        } else {
            Err(format!(
                "{value} is not an exponent of a liquid, which is one or more (7 of water)"
            ))
        }
    }
}

impl From<LinearEntry> for Liquid {
    fn from(entry: LinearEntry) -> Self {
        Self {
            sound_speed: entry.sound_speed.get(),
            density: entry.density.get(),
            pressure: entry.pressure.map_or(0.0, Finite::get),
            exponent: 1.0,
            transport: None,
        }
    }
}

impl From<TaitEntry> for Liquid {
    fn from(entry: TaitEntry) -> Self {
        Self {
            exponent: entry.exponent.map_or(WATER, |exponent| exponent.0),
            ..LinearEntry {
                sound_speed: entry.sound_speed,
                density: entry.density,
                pressure: entry.pressure,
            }
            .into()
        }
    }
}
