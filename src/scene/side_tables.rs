//! Sides of the domain that a scene says more of than a word.

use serde::Deserialize;
use serde::de::Error;

use aero_solver::problem::Side;

use super::formula::TimedFormula;
use super::number::{Finite, Positive};
use super::side_words::{GivenEntry, PatchEntry, TABLES, named};
use super::wall::{WallVelocity, WallWord, kind};

/// How fast an outlet goes back to its pressure where a scene does not say: Poinsot & Lele (1992) find 0.25 to hold it while
/// sound still leaves.
const RELAXATION: f64 = 0.25;

/// A side, or a part of one, as a table: one key, and of a part its patch.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SideTable {
    /// Of a part, and of it alone: where it is.
    pub patch: Option<PatchEntry>,
    /// Of a part: a word in place of a table.
    pub side: Option<String>,
    /// A wall, at rest or moving by itself.
    pub wall: Option<WallEntry>,
    /// Gas comes in.
    pub inlet: Option<InletEntry>,
    /// Gas leaves at a pressure.
    pub outlet: Option<OutletEntry>,
    /// Gas comes in from a vessel, and sound goes out.
    pub reservoir: Option<ReservoirEntry>,
    /// Gas goes along or across, in or out.
    #[serde(rename = "free-stream")]
    pub free_stream: Option<StreamEntry>,
}

/// `inlet = { reflecting = false, .. }`
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct InletEntry {
    /// Sound comes back from it, and gas comes in as it is; on unless given. Of points that stay sound goes out through every inlet.
    reflecting: Option<bool>,
    /// Density of the gas that comes in; the free stream's unless given.
    density: Option<TimedFormula>,
    /// Its pressure; the free stream's unless given.
    pressure: Option<TimedFormula>,
    /// Its velocity, one formula per axis; the free stream's unless given.
    velocity: Option<Vec<TimedFormula>>,
}

/// `free-stream = { .. }`
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct StreamEntry {
    /// Density of the gas beyond; the free stream's unless given.
    density: Option<TimedFormula>,
    /// Its pressure; the free stream's unless given.
    pressure: Option<TimedFormula>,
    /// Its velocity, one formula per axis; the free stream's unless given.
    velocity: Option<Vec<TimedFormula>>,
}

/// `outlet = { pressure = .., relaxation = .. }`
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct OutletEntry {
    /// Pressure that is held where gas leaves slower than sound.
    pressure: TimedFormula,
    /// How fast the pressure is gone back to; 0.25 unless given.
    relaxation: Option<Positive>,
}

/// `reservoir = { relaxation = .. }`
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ReservoirEntry {
    /// How fast total pressure and temperature are gone back to.
    relaxation: Positive,
}

/// `wall = { kind = "no-slip", .. }` of a side
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct WallEntry {
    /// Whether the gas slides along it; `"slip"` unless given.
    kind: Option<WallWord>,
    /// Temperature that it is held at, K; no heat goes through it unless given.
    temperature: Option<Positive>,
    /// Heat that it gives the gas, W/m².
    heat_flux: Option<Finite>,
    /// Along its axis, by which it moves, or as a list, of which the part along the plane is that of its surface; 0 unless given.
    velocity: Option<WallVelocity>,
    /// Along its axis, by which the velocity grows; 0 unless given.
    acceleration: Option<Finite>,
}

impl SideTable {
    /// What it says, beside a patch.
    pub(super) fn side<E: Error>(self) -> Result<(Side, Option<GivenEntry>), E> {
        let Self {
            patch: _,
            side,
            wall,
            inlet,
            outlet,
            reservoir,
            free_stream,
        } = self;
        let tables = (wall, inlet, outlet, reservoir, free_stream);
        if let Some(word) = side {
            return match tables {
                (None, None, None, None, None) => Ok((named(&word)?, None)),
                _ => Err(E::custom(
                    "`side` names what a table says more of; leave one of the two out",
                )),
            };
        }
        Ok(match tables {
            (Some(wall), None, None, None, None) => (wall.side()?, None),
            (None, Some(inlet), None, None, None) => {
                let side = if inlet.reflecting == Some(false) {
                    Side::SoftInlet
                } else {
                    Side::Inlet
                };
                let given = GivenEntry::of(inlet.density, inlet.pressure, inlet.velocity);
                (side, given)
            }
            (None, None, Some(outlet), None, None) => outlet.side()?,
            (None, None, None, Some(reservoir), None) => {
                let relaxation = Some(reservoir.relaxation.get());
                (Side::Reservoir { relaxation }, None)
            }
            (None, None, None, None, Some(stream)) => {
                let given = GivenEntry::of(stream.density, stream.pressure, stream.velocity);
                (Side::FreeStream, given)
            }
            _ => return Err(E::custom(format!("a side takes one table of {TABLES}"))),
        })
    }
}

impl WallEntry {
    /// What it says, but for a velocity along it.
    fn side<E: Error>(self) -> Result<Side, E> {
        Ok(Side::Wall {
            kind: kind(self.kind, self.temperature, self.heat_flux).map_err(E::custom)?,
            velocity: match self.velocity {
                Some(WallVelocity::Across(velocity)) => velocity,
                Some(WallVelocity::Vector(_)) | None => 0.0,
            },
            acceleration: self.acceleration.map_or(0.0, Finite::get),
        })
    }

    /// Its velocity where that is a vector.
    pub(super) fn vector(&self) -> Option<Vec<Finite>> {
        match &self.velocity {
            Some(WallVelocity::Vector(numbers)) => Some(numbers.clone()),
            _ => None,
        }
    }
}

impl OutletEntry {
    /// A pressure that is a number is the side's own.
    fn side<E: Error>(self) -> Result<(Side, Option<GivenEntry>), E> {
        let relaxation = self.relaxation.map_or(RELAXATION, Positive::get);
        let side = |pressure| Side::HeldOutlet {
            pressure,
            relaxation,
        };
        match self.pressure.number() {
            Some(pressure) => {
                let pressure = Positive::try_from(pressure).map_err(E::custom)?;
                Ok((side(pressure.get()), None))
            }
            // The number is found where the domain is known.
            None => Ok((
                side(f64::NAN),
                GivenEntry::of(None, Some(self.pressure), None),
            )),
        }
    }
}
