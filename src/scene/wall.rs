//! What gas and heat do at a wall, as a scene says it of sides and bodies.

use std::fmt;

use serde::Deserialize;
use serde::de::value::{MapAccessDeserializer, SeqAccessDeserializer};
use serde::de::{Deserializer, Error, MapAccess, SeqAccess, Visitor};

use super::number::{Finite, Positive};
use super::spin::Rate;
use aero_solver::problem::{NoSlip, Slide, WallHeat, WallKind};

/// Slip or no slip, as a scene spells it.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "kebab-case")]
pub enum WallWord {
    /// The gas slides along the wall.
    #[default]
    Slip,
    /// The gas sticks to the wall.
    NoSlip,
}

/// `"slip"`, `"no-slip"`, or a table that says more of a wall that gas sticks to.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BodyWallEntry(pub WallTable);

/// `wall = { kind = "no-slip", .. }`
#[derive(Clone, Debug, Default, Deserialize, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct WallTable {
    /// Whether the gas slides along it; `slip` unless given.
    pub kind: Option<WallWord>,
    /// Temperature of the wall, K; heat goes through no wall that says neither this nor a flux.
    pub temperature: Option<Positive>,
    /// Heat that goes from the wall into the gas, W/m^2, in place of a temperature.
    pub heat_flux: Option<Finite>,
    /// Velocity of its surface along itself; none unless given.
    pub velocity: Option<Vec<Finite>>,
    /// Angular velocity of its surface, rad/s: a number in 2D, a vector in 3D; none unless given.
    pub angular_velocity: Option<Rate>,
    /// Point that its surface turns about; the moment centre unless given.
    pub pivot: Option<Vec<Finite>>,
}

/// Velocity of a plane wall: a number along its axis, or a vector.
#[derive(Clone, Debug, PartialEq)]
pub enum WallVelocity {
    /// Along the axis, into the gas or out of it.
    Across(f64),
    /// As a vector, whose part along the plane is that of the surface.
    Vector(Vec<Finite>),
}

impl<'de> Deserialize<'de> for BodyWallEntry {
    fn deserialize<T: Deserializer<'de>>(deserializer: T) -> Result<Self, T::Error> {
        deserializer.deserialize_any(WallVisitor)
    }
}

impl<'de> Deserialize<'de> for WallVelocity {
    fn deserialize<T: Deserializer<'de>>(deserializer: T) -> Result<Self, T::Error> {
        deserializer.deserialize_any(VelocityVisitor)
    }
}

// Both are read by hand because serde's `untagged` would lose the position of an error in the file.

struct WallVisitor;

impl<'de> Visitor<'de> for WallVisitor {
    type Value = BodyWallEntry;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("`slip`, `no-slip`, or a table `{ kind = \"no-slip\", temperature = .. }`")
    }

    fn visit_str<E: Error>(self, word: &str) -> Result<BodyWallEntry, E> {
        let kind = match word {
            "slip" => WallWord::Slip,
            "no-slip" => WallWord::NoSlip,
            _ => return Err(E::unknown_variant(word, &["slip", "no-slip"])),
        };
        Ok(BodyWallEntry(WallTable {
            kind: Some(kind),
            ..WallTable::default()
        }))
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<BodyWallEntry, A::Error> {
        WallTable::deserialize(MapAccessDeserializer::new(map)).map(BodyWallEntry)
    }
}

struct VelocityVisitor;

impl<'de> Visitor<'de> for VelocityVisitor {
    type Value = WallVelocity;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a velocity along the axis, or a list of one per axis")
    }

    fn visit_f64<E: Error>(self, value: f64) -> Result<WallVelocity, E> {
        let value = Finite::try_from(value).map_err(E::custom)?;
        Ok(WallVelocity::Across(value.get()))
    }

    fn visit_i64<E: Error>(self, value: i64) -> Result<WallVelocity, E> {
        Ok(WallVelocity::Across(value as f64))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, list: A) -> Result<WallVelocity, A::Error> {
        Vec::deserialize(SeqAccessDeserializer::new(list)).map(WallVelocity::Vector)
    }
}

/// The kind of a wall, but for how its surface moves.
pub(super) fn kind(
    word: Option<WallWord>,
    temperature: Option<Positive>,
    heat_flux: Option<Finite>,
) -> Result<WallKind, &'static str> {
    let heat = match (temperature, heat_flux) {
        (None, None) => WallHeat::Adiabatic,
        (Some(temperature), None) => WallHeat::Temperature(temperature.get()),
        (None, Some(flux)) => WallHeat::Flux(flux.get()),
        (Some(_), Some(_)) => return Err("give one of temperature and heat_flux"),
    };
    match word.unwrap_or_default() {
        WallWord::NoSlip => Ok(WallKind::NoSlip(NoSlip {
            heat,
            slide: Slide::default(),
        })),
        WallWord::Slip if heat == WallHeat::Adiabatic => Ok(WallKind::Slip),
        WallWord::Slip => {
            Err("heat goes through walls that gas sticks to; add `kind = \"no-slip\"`")
        }
    }
}
