//! Bodies made of triangles: from a file, or from an exact body for comparison.

use std::path::{Path, PathBuf};

use aero_geometry::stl::{Facet, Soup};
use aero_geometry::{
    GeometryError, Mending, Placed, Solid, Watch, files, made_whole, may_be_half, stl,
    whole_from_half,
};
use serde::Deserialize;

use super::super::number::Positive;
use super::super::way::Way;
use super::Making;
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

/// `stl = { file, unit, half, fill, thicken, wrap }`: STL, OBJ or PLY, packed as `.gz` or not.
#[derive(Clone, Debug, Default, Deserialize, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct StlEntry {
    /// The file; a relative path starts at the scene's folder.
    pub file: PathBuf,
    /// Its unit of length; metres unless given.
    pub unit: Option<Unit>,
    /// Where the other half of the body lies of which the file holds one: its mirror image is joined there; none unless given.
    pub half: Option<Way>,
    /// Closes all holes.
    pub fill: Option<bool>,
    /// Makes a sheet so many metres thick.
    pub thicken: Option<Positive>,
    /// Lays a closed surface around whatever it is, at the body's spacing.
    pub wrap: Option<bool>,
}

impl StlEntry {
    /// The triangles, in metres.
    pub(crate) fn read(&self, folder: &Path, watch: &Watch) -> Result<Soup, GeometryError> {
        watch.begin("reading");
        let unit = self.unit.map_or(stl::Unit::Metre, Into::into);
        let path = folder.join(&self.file);
        let mut soup = files::read(&path, unit)?;
        if let Some(way) = self.half {
            soup.facets = whole_from_half(&soup.facets, way.axis, way.is_negative)
                .ok_or_else(|| not_half(path, way))?;
        }
        Ok(soup)
    }

    /// True where the body depends on the spacing at which it is packed.
    pub(crate) fn wraps(&self) -> bool {
        self.wrap == Some(true)
    }

    /// The body that the triangles make, packed at `spacing` metres.
    pub(crate) fn solid(&self, soup: Soup, spacing: f64, watch: &Watch) -> Result<Solid, String> {
        let wanted = [
            (self.fill == Some(true)).then_some(Mending::Fill),
            self.thicken.map(|t| Mending::Thicken(t.get())),
            self.wraps().then_some(Mending::Wrap(spacing)),
        ];
        let mut wanted = wanted.into_iter().flatten();
        let mending = wanted.next().unwrap_or_default();
        if wanted.next().is_some() {
            return Err("`fill`, `thicken` and `wrap` exclude each other; give one".into());
        }
        let mut solid = Solid::new(soup, mending, watch)
            .map_err(|error| format!("`{}`: {error}", self.file.display()))?;
        if let Some(way) = self.half {
            let joined = format!("joined the other half of the body, toward {way} of the file");
            solid.repairs.insert(0, joined);
        }
        Ok(solid)
    }
}

/// A body that does not end that way as a half does.
fn not_half(path: PathBuf, way: Way) -> GeometryError {
    let source = GeometryError::File {
        format: "half",
        reason: format!(
            "the body has neither a flat face nor an opening where it ends toward {way}; give the direction in which its other half lies"
        ),
    };
    GeometryError::In {
        path,
        source: Box::new(source),
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
    /// The triangles as if they had been written to an STL file and read back: in single precision.
    pub(super) fn soup(&self) -> Result<Soup, GeometryError> {
        let facets = self.body.body()?.tessellate(self.around.0);
        let mut bytes = Vec::new();
        stl::write_binary(&mut bytes, &facets)
            .map_err(|error| GeometryError::Stl(error.to_string()))?;
        stl::parse(bytes)
    }
}

/// The `solid` that triangles make at a spacing, in place; of half a body that ends at a mirror, the whole.
pub(super) fn in_place(
    soup: Soup,
    place: Option<&PlaceEntry>,
    making: &Making<'_>,
    solid: impl Fn(Soup, f64) -> Result<Solid, String>,
) -> Result<Made<3>, String> {
    let placement = place_in_space(place)?;
    let all = soup.facets.iter().flatten();
    let all = all.map(|corner| placement.point(corner));
    // Millions of triangles are not copied in vain.
    if may_be_half(all, &making.mirrors) {
        let corners = |facet: &Facet| facet.each_ref().map(|corner| placement.point(corner));
        let facets: Vec<Facet> = soup.facets.iter().map(corners).collect();
        if let Some(facets) = made_whole(&facets, &making.mirrors) {
            let solids = soup.solids;
            return made(solid(Soup { facets, solids }, making.spacing)?, None);
        }
    }
    made(solid(soup, making.spacing / placement.scale())?, place)
}

/// A solid in place, with what was done to its triangles.
pub(crate) fn made(solid: Solid, place: Option<&PlaceEntry>) -> Result<Made<3>, String> {
    let Solid { shape, repairs } = solid;
    let exact = match place {
        None => Made::exact(shape),
        Some(_) => Made::exact(Placed::new(shape, place_in_space(place)?)),
    };
    Ok(Made { repairs, ..exact })
}
