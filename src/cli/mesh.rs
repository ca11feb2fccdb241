//! What commands that read a body from its file share: its unit, and what is done where it is not a whole solid.

use std::path::Path;

use aero::scene::number::Positive;
use aero::scene::shapes::{StlEntry, Unit};
use aero::scene::way::Way;
use clap::{Args, ValueEnum};

use super::numbers::positive;

/// How a file of triangles is read.
#[derive(Args, Clone, Debug, Default, PartialEq)]
pub struct MeshArgs {
    /// Unit of the body's file; metres unless given
    #[arg(long, value_enum)]
    unit: Option<UnitWord>,
    /// The file holds half of the body, and the other half lies this way of it: -z, say
    #[arg(long, value_name = "WAY", allow_hyphen_values = true)]
    half: Option<Way>,
    /// Close all holes of the body's surface
    #[arg(long, conflicts_with = "thicken")]
    fill: bool,
    /// Make a solid so many metres thick of a sheet: terrain, a sail, panels
    #[arg(long, value_name = "T", value_parser = positive)]
    thicken: Option<f64>,
}

/// A unit of length.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum UnitWord {
    M,
    Mm,
    In,
}

impl MeshArgs {
    /// The body's file as a scene would have it.
    pub fn entry(&self, file: &Path) -> StlEntry {
        StlEntry {
            file: file.to_owned(),
            unit: self.unit.map(|unit| match unit {
                UnitWord::M => Unit::M,
                UnitWord::Mm => Unit::Mm,
                UnitWord::In => Unit::In,
            }),
            half: self.half,
            fill: self.fill.then_some(true),
            // Checked when it was read.
            thicken: self.thicken.and_then(|t| Positive::try_from(t).ok()),
            wrap: None,
        }
    }

    /// The first flag of these that was given.
    pub fn given(&self) -> Option<&'static str> {
        let flags = [
            ("unit", self.unit.is_some()),
            ("half", self.half.is_some()),
            ("fill", self.fill),
            ("thicken", self.thicken.is_some()),
        ];
        let (flag, _) = flags.iter().find(|(_, given)| *given)?;
        Some(flag)
    }
}
