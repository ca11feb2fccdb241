//! Bodies made of triangles: from an STL file, or from an exact body for comparison.

use std::path::{Path, PathBuf};

use aero_geometry::{GeometryError, Mesh, Placed, Watch, stl};
use serde::Deserialize;

use super::made::Made;
use super::place::{PlaceEntry, place_in_space};
use super::space::Round;

/// Length unit of an STL file.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "kebab-case")]
pub enum Unit {
    /// Metres.
    M,
    /// Millimetres.
    Mm,
    /// Inches.
    In,
}

impl From<Unit> for stl::Unit {
    fn from(unit: Unit) -> Self {
        match unit {
            Unit::M => Self::Metre,
            Unit::Mm => Self::Millimetre,
            Unit::In => Self::Inch,
        }
    }
}

/// `stl = { file, unit }`
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct StlEntry {
    /// The file; a relative path starts at the scene's folder.
    pub file: PathBuf,
    /// Its unit of length; metres unless given.
    pub unit: Option<Unit>,
}

impl StlEntry {
    pub(super) fn mesh(&self, folder: &Path, watch: &Watch) -> Result<Mesh, GeometryError> {
        let unit = self.unit.map_or(stl::Unit::Metre, Into::into);
        Mesh::read_watched(&folder.join(&self.file), unit, watch)
    }
}

/// A number of facets around an axis, 3 to 2000.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(try_from = "i64")]
struct Around(usize);

impl TryFrom<i64> for Around {
    type Error = String;

    fn try_from(value: i64) -> Result<Self, String> {
        // The number of facets goes with its square.
        match value {
            3..=2000 => Ok(Self(value as usize)),
            _ => Err(format!(
                "{value} is not a number of facets around an axis, which is 3 to 2000"
            )),
        }
    }
}

/// `tessellated = { body = { sphere = { .. } }, around = 96 }`: so many facets around the axis.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Tessellated {
    /// A body of revolution.
    body: Round,
    /// Facets around its axis, 3 to 2000.
    around: Around,
}

impl Tessellated {
    /// The mesh as if it had been written to an STL file and read back: in single precision.
    pub(super) fn mesh(&self) -> Result<Mesh, GeometryError> {
        let facets = self.body.body()?.tessellate(self.around.0);
        let mut bytes = Vec::new();
        stl::write_binary(&mut bytes, &facets)
            .map_err(|error| GeometryError::Stl(error.to_string()))?;
        Mesh::new(&stl::parse(bytes)?)
    }
}

/// A mesh in place, with what was done to it.
pub(super) fn made(
    mesh: Result<Mesh, GeometryError>,
    place: Option<&PlaceEntry>,
) -> Result<Made<3>, String> {
    let mesh = mesh.map_err(|error| error.to_string())?;
    let repairs = mesh.repairs().to_vec();
    let exact = match place {
        None => Made::exact(mesh),
        Some(_) => Made::exact(Placed::new(mesh, place_in_space(place)?)),
    };
    Ok(Made { repairs, ..exact })
}
