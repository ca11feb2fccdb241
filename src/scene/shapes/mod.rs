//! Shapes as a scene names them, and the surfaces that they mean, in place.

mod mesh;
mod plane;
mod space;

use std::any::Any;
use std::path::Path;
use std::sync::Arc;

use aero_geometry::{GeometryError, Placed, Placement, Revolution, Shape, Watch};
use aero_packer::{PackOptions, Packing, Warning, pack};
use serde::Deserialize;

use super::file::PlaceEntry;
use super::flow::vector;
use super::spin::Rotation;

pub use mesh::{StlEntry, Tessellated, Unit};
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

/// A surface in place, and what was done to its mesh.
#[derive(Clone, Debug)]
pub(crate) struct Made<const D: usize> {
    /// The surface.
    pub shape: Arc<dyn Shape<D>>,
    /// What was wrong with its mesh and what was done.
    pub repairs: Vec<String>,
    /// What the user should know about its mesh.
    pub warnings: Vec<Warning>,
}

impl<const D: usize> Made<D> {
    /// A surface without a mesh.
    fn exact(shape: impl Shape<D> + 'static) -> Self {
        Self {
            shape: Arc::new(shape),
            repairs: Vec::new(),
            warnings: Vec::new(),
        }
    }

    /// Packs the surface; the report tells of its mesh too.
    pub(crate) fn pack(&self, options: &PackOptions<D>) -> Result<Packing<D>, String> {
        let mut packing = pack(self.shape.as_ref(), options).map_err(|error| error.to_string())?;
        let report = &mut packing.report;
        report.repairs.splice(0..0, self.repairs.iter().cloned());
        report.warnings.splice(0..0, self.warnings.iter().cloned());
        Ok(packing)
    }

    /// The same, where `E` is `D` under another name.
    fn cast<const E: usize>(self) -> Option<Made<E>> {
        let any: Box<dyn Any> = Box::new(self);
        any.downcast().ok().map(|made| *made)
    }
}

impl ShapeEntry {
    /// The surface in dimension `D`, in place; relative paths start at `folder`. In an `axisymmetric`
    /// flow a body of revolution is its section. `watch` is told how far the reading of a mesh is.
    pub(crate) fn make<const D: usize>(
        &self,
        place: Option<&PlaceEntry>,
        folder: &Path,
        axisymmetric: bool,
        watch: &Watch,
    ) -> Result<Made<D>, String> {
        let made = if axisymmetric && let Some(round) = self.round() {
            let section = round.and_then(|body| body.section());
            let section = section.map_err(|error| error.to_string())?;
            Made::exact(section.placed(&place_in_plane(place)?)).cast()
        } else if D == 2 {
            self.in_plane(place, folder)?.and_then(Made::cast)
        } else {
            self.in_space(place, folder, watch)?.and_then(Made::cast)
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
        folder: &Path,
    ) -> Result<Option<Made<2>>, String> {
        let outline = match self {
            Self::Circle(entry) => entry.outline(),
            Self::Rectangle(entry) => entry.outline(),
            Self::Polygon(entry) => entry.outline(),
            Self::PolygonFile(entry) => entry.outline(folder),
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
        Ok(Some(Made::exact(outline.placed(&place_in_plane(place)?))))
    }

    /// The surface of a shape in space; none for a plane shape.
    fn in_space(
        &self,
        place: Option<&PlaceEntry>,
        folder: &Path,
        watch: &Watch,
    ) -> Result<Option<Made<3>>, String> {
        let round = match self {
            Self::Cuboid(entry) => {
                let block = entry.body().map_err(|error| error.to_string())?;
                return Ok(Some(Made::exact(Placed::new(
                    block,
                    place_in_space(place)?,
                ))));
            }
            Self::Stl(entry) => return mesh::made(entry.mesh(folder, watch), place).map(Some),
            Self::Tessellated(entry) => return mesh::made(entry.mesh(), place).map(Some),
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

/// Where a plane body stands.
fn place_in_plane(place: Option<&PlaceEntry>) -> Result<Placement<2>, String> {
    let Some(place) = place else {
        return Ok(Placement::default());
    };
    let mut placement = scaled(place)?;
    match &place.rotate {
        None => {}
        Some(Rotation::Plane(degrees)) => placement = placement.rotated(degrees.to_radians()),
        Some(Rotation::Axis { .. }) => {
            return Err("`place.rotate` is a number of degrees in dimension 2".into());
        }
    }
    moved(placement, place)
}

/// Where a body in space stands.
fn place_in_space(place: Option<&PlaceEntry>) -> Result<Placement<3>, String> {
    let Some(place) = place else {
        return Ok(Placement::default());
    };
    let mut placement = scaled(place)?;
    match &place.rotate {
        None => {}
        Some(Rotation::Axis { axis, angle }) => {
            let axis = vector("place.rotate.axis", axis).map_err(|error| error.to_string())?;
            placement = placement
                .rotated_about(&axis, angle.to_radians())
                .map_err(|error| error.to_string())?;
        }
        Some(Rotation::Plane(_)) => {
            return Err(
                "`place.rotate` is `{ axis = [..], angle = degrees }` in dimension 3".into(),
            );
        }
    }
    moved(placement, place)
}

fn scaled<const D: usize>(place: &PlaceEntry) -> Result<Placement<D>, String> {
    match place.scale {
        None => Ok(Placement::default()),
        Some(factor) => Placement::default()
            .scaled(factor.get())
            .map_err(|error| error.to_string()),
    }
}

fn moved<const D: usize>(
    placement: Placement<D>,
    place: &PlaceEntry,
) -> Result<Placement<D>, String> {
    match &place.translate {
        None => Ok(placement),
        Some(numbers) => vector("place.translate", numbers)
            .map(|offset| placement.moved(offset))
            .map_err(|error| error.to_string()),
    }
}
