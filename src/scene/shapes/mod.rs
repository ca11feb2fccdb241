//! Shapes as a scene names them, and the surfaces that they mean, in place.

mod made;
mod mesh;
mod place;
mod plane;
mod space;

use std::path::Path;

use aero_geometry::{
    GeometryError, Mending, Mesh, MirrorPlane, Placed, Revolution, Shape, Solid, Watch, made_whole,
};
use serde::Deserialize;

use place::{place_in_plane, place_in_space};

pub(crate) use made::Made;
pub(crate) use mesh::made;
pub use mesh::{StlEntry, Tessellated, Unit};
pub use place::PlaceEntry;
pub use plane::{
    Biconvex, BluntWedge, Circle, Corner, Duct, ForwardStep, HalfSpace, Polygon, PolygonFile,
    Rectangle,
};
pub use space::{Block, CapsuleEntry, Cone, Profile, Round, RoundRod, Sphere};

/// The surface of a body. Those of the plane go with dimension 2, the others with dimension 3.
#[derive(Clone, Debug, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum ShapeEntry {
    /// Plane: a circle about the origin.
    Circle(Circle),
    /// Plane: a rectangle about the origin, with round corners if asked.
    Rectangle(Rectangle),
    /// Plane: a closed polygon.
    Polygon(Polygon),
    /// Plane: a closed polygon from a text file of points.
    PolygonFile(PolygonFile),
    /// Plane: an aerofoil of two circular arcs.
    Biconvex(Biconvex),
    /// Plane: the half space below a height.
    HalfSpace(HalfSpace),
    /// Plane: a wall that turns into the flow.
    CompressionCorner(Corner),
    /// Plane: a wall that turns away from the flow.
    ExpansionCorner(Corner),
    /// Plane: a wall with a step.
    ForwardStep(ForwardStep),
    /// Plane: a cylinder nose with flat flanks.
    BluntWedge(BluntWedge),
    /// Plane: a convergent-divergent duct.
    Nozzle(Duct),
    /// Space: a sphere about the origin.
    Sphere(Sphere),
    /// Space: a cone with its tip at the origin.
    Cone(Cone),
    /// Space: a cylinder with a hemispherical nose.
    RoundRod(RoundRod),
    /// Space: an entry capsule.
    Capsule(CapsuleEntry),
    /// Space: a body of revolution from the corners of its meridian.
    Profile(Profile),
    /// Space: a block about the origin.
    Cuboid(Block),
    /// Space: a mesh from a file.
    Stl(StlEntry),
    /// Space: an exact body turned into a mesh, which then goes the way of one from a file.
    Tessellated(Tessellated),
}

/// What a surface depends on beside its own entry.
pub(crate) struct Making<'a> {
    /// Where relative paths start.
    pub folder: &'a Path,
    /// Mirrors, which make bodies whole that end at them.
    pub mirrors: Vec<MirrorPlane>,
    /// In an axisymmetric flow a body of revolution is its section.
    pub axisymmetric: bool,
    /// Spacing at which it is packed, in the scene's unit.
    pub spacing: f64,
    /// Is told how far the reading of a mesh is.
    pub watch: &'a Watch,
}

impl ShapeEntry {
    /// The surface in dimension `D`, in place.
    pub(crate) fn make<const D: usize>(
        &self,
        place: Option<&PlaceEntry>,
        making: &Making<'_>,
    ) -> Result<Made<D>, String> {
        let made = if making.axisymmetric
            && let Some(round) = self.round()
        {
            let section = round.and_then(|body| body.section());
            let section = section.map_err(|error| error.to_string())?;
            Made::exact(section.placed(&place_in_plane(place)?)).cast()
        } else if D == 2 {
            self.in_plane(place, making)?.and_then(Made::cast)
        } else {
            self.in_space(place, making)?.and_then(Made::cast)
        };
        made.ok_or_else(|| {
            let other = if D == 2 { 3 } else { 2 };
            let round = match self.round() {
                Some(_) => "; round bodies may be flown in dimension 2 with `y_min = \"axis\"`",
                None => "",
            };
            format!("its shape is one of dimension {other}, but the scene has dimension {D}{round}")
        })
    }

    /// The body of revolution about the x axis, if it is one.
    fn round(&self) -> Option<Result<Revolution, GeometryError>> {
        Some(match self {
            Self::Sphere(entry) => entry.body(),
            Self::Cone(entry) => entry.body(),
            Self::RoundRod(entry) => entry.body(),
            Self::Capsule(entry) => entry.body(),
            Self::Profile(entry) => entry.body(),
            _ => return None,
        })
    }

    /// The surface of a plane shape; none for a shape in space.
    fn in_plane(
        &self,
        place: Option<&PlaceEntry>,
        making: &Making<'_>,
    ) -> Result<Option<Made<2>>, String> {
        let outline = match self {
            Self::Circle(entry) => entry.outline(),
            Self::Rectangle(entry) => entry.outline(),
            Self::Polygon(entry) => entry.outline(),
            Self::PolygonFile(entry) => entry.outline(making.folder),
            Self::Biconvex(entry) => entry.outline(),
            Self::HalfSpace(entry) => entry.outline(),
            Self::CompressionCorner(entry) => entry.compression(),
            Self::ExpansionCorner(entry) => entry.expansion(),
            Self::ForwardStep(entry) => entry.outline(),
            Self::BluntWedge(entry) => entry.outline(),
            Self::Nozzle(entry) => entry.outline(),
            _ => return Ok(None),
        };
        let outline = outline.map_err(|error| error.to_string())?;
        let outline = outline.placed(&place_in_plane(place)?);
        let whole = outline.made_whole(&making.mirrors);
        let whole = whole.map_err(|error| error.to_string())?;
        Ok(Some(Made::exact(whole.unwrap_or(outline))))
    }

    /// The surface of a shape in space; none for a plane shape.
    fn in_space(
        &self,
        place: Option<&PlaceEntry>,
        making: &Making<'_>,
    ) -> Result<Option<Made<3>>, String> {
        let round = match self {
            Self::Cuboid(entry) => {
                let block = entry.body().map_err(|error| error.to_string())?;
                let block = Placed::new(block, place_in_space(place)?);
                let facets = block.facets(f64::INFINITY, &block.bounds());
                let whole = made_whole(&facets, &making.mirrors).map(Mesh::from_facets);
                let whole = whole.transpose().map_err(|error| error.to_string())?;
                return Ok(Some(whole.map_or_else(|| Made::exact(block), Made::exact)));
            }
            Self::Stl(entry) => {
                let soup = entry.read(making.folder, making.watch);
                let soup = soup.map_err(|error| error.to_string())?;
                let solid = |soup, spacing| entry.solid(soup, spacing, making.watch);
                return mesh::in_place(soup, place, making, solid).map(Some);
            }
            Self::Tessellated(entry) => {
                let soup = entry.soup().map_err(|error| error.to_string())?;
                let solid = |soup, _| {
                    let solid = Solid::new(soup, Mending::Refuse, &Watch::default());
                    solid.map_err(|error| error.to_string())
                };
                return mesh::in_place(soup, place, making, solid).map(Some);
            }
            _ => match self.round() {
                Some(round) => round,
                None => return Ok(None),
            },
        };
        let round = round.map_err(|error| error.to_string())?;
        Ok(Some(match place {
            None => Made::exact(round),
            Some(_) => Made::exact(Placed::new(round, place_in_space(place)?)),
        }))
    }
}
