//! Sides of the domain as a scene names them.

use std::fmt;

use serde::Deserialize;
use serde::de::{Deserializer, Error, MapAccess, Visitor, value::MapAccessDeserializer};

use super::number::{Finite, Positive};
use aero_solver::problem::{Side, WallKind};

/// What bounds the domain on one side: a word, or a table of one word.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SideEntry(pub Side);

/// Words that name a side without further values.
const WORDS: [&str; 9] = [
    "inlet",
    "outlet",
    "free-stream",
    "reservoir",
    "symmetry",
    "axis",
    "periodic",
    "wall",
    "body",
];

/// The tables that a side may be.
const TABLES: &str = "`{ wall = { .. } }`, `{ inlet = { reflecting = false } }`, `{ outlet = { pressure = .. } }`, \
    `{ reservoir = { relaxation = .. } }`";

/// How fast an outlet goes back to its pressure where a scene does not say: Poinsot & Lele (1992) find 0.25 to hold it while
/// sound still leaves.
const RELAXATION: f64 = 0.25;

/// The table form.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct SideTable {
    wall: Option<WallEntry>,
    inlet: Option<InletEntry>,
    outlet: Option<OutletEntry>,
    reservoir: Option<ReservoirEntry>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct InletEntry {
    reflecting: bool,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct OutletEntry {
    pressure: Positive,
    relaxation: Option<Positive>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ReservoirEntry {
    relaxation: Positive,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct WallEntry {
    kind: Option<WallWord>,
    velocity: Option<Finite>,
    acceleration: Option<Finite>,
}

/// Slip or no slip, as a scene spells it.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq)]
#[serde(rename_all = "kebab-case")]
pub enum WallWord {
    /// The gas slides along the wall.
    Slip,
    /// The gas sticks to the wall.
    NoSlip,
}

impl From<WallWord> for WallKind {
    fn from(word: WallWord) -> Self {
        match word {
            WallWord::Slip => Self::Slip,
            WallWord::NoSlip => Self::NoSlip,
        }
    }
}

impl<'de> Deserialize<'de> for SideEntry {
    fn deserialize<T: Deserializer<'de>>(deserializer: T) -> Result<Self, T::Error> {
        deserializer.deserialize_any(SideVisitor)
    }
}

/// Written by hand because serde's `untagged` would lose the position of an error in the file.
struct SideVisitor;

impl<'de> Visitor<'de> for SideVisitor {
    type Value = SideEntry;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "one of {}, or {TABLES}", words())
    }

    fn visit_str<E: Error>(self, word: &str) -> Result<SideEntry, E> {
        Ok(SideEntry(match word {
            "inlet" => Side::Inlet,
            "outlet" => Side::Outlet,
            "free-stream" => Side::FreeStream,
            "reservoir" => Side::Reservoir { relaxation: None },
            "symmetry" => Side::Symmetry,
            "axis" => Side::Axis,
            "periodic" => Side::Periodic,
            "body" => Side::Body,
            "wall" => Side::Wall {
                kind: WallKind::Slip,
                velocity: 0.0,
                acceleration: 0.0,
            },
            _ => return Err(E::unknown_variant(word, &WORDS)),
        }))
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<SideEntry, A::Error> {
        let table = SideTable::deserialize(MapAccessDeserializer::new(map))?;
        let side = match (table.wall, table.inlet, table.outlet, table.reservoir) {
            (Some(wall), None, None, None) => Side::Wall {
                kind: wall.kind.unwrap_or(WallWord::Slip).into(),
                velocity: wall.velocity.map_or(0.0, Finite::get),
                acceleration: wall.acceleration.map_or(0.0, Finite::get),
            },
            (None, Some(InletEntry { reflecting: true }), None, None) => Side::Inlet,
            (None, Some(InletEntry { reflecting: false }), None, None) => Side::SoftInlet,
            (None, None, Some(outlet), None) => Side::HeldOutlet {
                pressure: outlet.pressure.get(),
                relaxation: outlet.relaxation.map_or(RELAXATION, Positive::get),
            },
            (None, None, None, Some(reservoir)) => Side::Reservoir {
                relaxation: Some(reservoir.relaxation.get()),
            },
            _ => {
                return Err(A::Error::custom(format!(
                    "a side takes one table of {TABLES}"
                )));
            }
        };
        Ok(SideEntry(side))
    }
}

fn words() -> String {
    WORDS.map(|word| format!("`{word}`")).join(", ")
}
