//! Shapes of the plane, key by key. Angles are in degrees; lengths in the scene's unit.

use std::path::{Path, PathBuf};

use aero_geometry::bodies::{self, Nozzle};
use aero_geometry::{GeometryError, Outline, Placement, Vector};
use serde::Deserialize;

use super::super::number::Finite;

type OutlineResult = Result<Outline, GeometryError>;

/// `circle = { radius }`, about the origin.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Circle {
    /// Radius.
    radius: Finite,
}

impl Circle {
    pub(super) fn outline(&self) -> OutlineResult {
        bodies::circle(self.radius.get())
    }
}

/// `rectangle = { width, height, corner_radius }`, about the origin.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Rectangle {
    /// Extent along x.
    width: Finite,
    /// Extent along y.
    height: Finite,
    /// Radius of its corners; 0 unless given.
    corner_radius: Option<Finite>,
}

impl Rectangle {
    pub(super) fn outline(&self) -> OutlineResult {
        let corner_radius = self.corner_radius.map_or(0.0, Finite::get);
        bodies::rectangle(self.width.get(), self.height.get(), corner_radius)
    }
}

/// `polygon = { points = [[x, y], ..] }`, closed.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Polygon {
    /// Corners in order, either way round; the last is joined to the first.
    points: Vec<[Finite; 2]>,
}

impl Polygon {
    pub(super) fn outline(&self) -> OutlineResult {
        let points = self
            .points
            .iter()
            .map(|[x, y]| Vector::<2>::new(x.get(), y.get()));
        bodies::polygon(&points.collect::<Vec<_>>())
    }
}

/// `polygon_file = { file }`: a line `x y` per point.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PolygonFile {
    /// The file; a relative path starts at the scene's folder.
    file: PathBuf,
}

impl PolygonFile {
    pub(super) fn outline(&self, folder: &Path) -> OutlineResult {
        bodies::polygon_file(&folder.join(&self.file))
    }
}

/// `biconvex = { chord, thickness_ratio }`, leading edge at the origin.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Biconvex {
    /// Length.
    chord: Finite,
    /// Thickness over chord.
    thickness_ratio: Finite,
}

impl Biconvex {
    pub(super) fn outline(&self) -> OutlineResult {
        bodies::biconvex(self.chord.get(), self.thickness_ratio.get())
    }
}

/// `half_space = { height }`: solid below it.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct HalfSpace {
    /// Height of the wall; 0 unless given.
    height: Option<Finite>,
}

impl HalfSpace {
    pub(super) fn outline(&self) -> OutlineResult {
        bodies::wall(self.height.map_or(0.0, Finite::get))
    }
}

/// `compression_corner = { angle, corner }` and `expansion_corner` likewise: solid below a level
/// wall that turns at the corner.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Corner {
    /// Degrees by which the wall turns.
    angle: Finite,
    /// Where it turns; the origin unless given.
    corner: Option<[Finite; 2]>,
}

impl Corner {
    pub(super) fn compression(&self) -> OutlineResult {
        bodies::compression_corner(0.0, self.angle.get()).map(|outline| self.at_corner(outline))
    }

    pub(super) fn expansion(&self) -> OutlineResult {
        bodies::expansion_corner(0.0, self.angle.get()).map(|outline| self.at_corner(outline))
    }

    fn at_corner(&self, outline: Outline) -> Outline {
        match self.corner {
            None => outline,
            Some([x, y]) => {
                outline.placed(&Placement::default().moved(Vector::<2>::new(x.get(), y.get())))
            }
        }
    }
}

/// `forward_step = { foot, height }`: solid below `y = 0`, from `x = foot` on below the height.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ForwardStep {
    /// Where the step stands on the x axis.
    foot: Finite,
    /// Its height.
    height: Finite,
}

impl ForwardStep {
    pub(super) fn outline(&self) -> OutlineResult {
        bodies::forward_step(self.foot.get(), self.height.get())
    }
}

/// `blunt_wedge = { radius, half_angle, length }`: nose about the origin, facing `-x`; endless
/// without a length.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BluntWedge {
    /// Radius of the nose.
    radius: Finite,
    /// Degrees between a flank and the x axis.
    half_angle: Finite,
    /// From the tip of the nose to the base; endless unless given.
    length: Option<Finite>,
}

impl BluntWedge {
    pub(super) fn outline(&self) -> OutlineResult {
        let length = self.length.map_or(f64::INFINITY, Finite::get);
        bodies::blunt_wedge(self.radius.get(), self.half_angle.get(), length)
    }
}

/// `nozzle = { inlet, throat, contraction_radius, throat_radius, divergence, half }`: half-heights,
/// arc radii and the half-angle; throat at `x = 0`; the upper wall alone if `half` is set.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Duct {
    /// Half-height of the inlet.
    inlet: Finite,
    /// Half-height of the throat.
    throat: Finite,
    /// Radius of the arc that leads into the contraction.
    contraction_radius: Finite,
    /// Radius of the arc at the throat.
    throat_radius: Finite,
    /// Half-angle of the divergent part, degrees.
    divergence: Finite,
    /// The upper wall alone; off unless given.
    half: Option<bool>,
}

impl Duct {
    pub(super) fn outline(&self) -> OutlineResult {
        let nozzle = Nozzle {
            inlet: self.inlet.get(),
            throat: self.throat.get(),
            contraction_radius: self.contraction_radius.get(),
            throat_radius: self.throat_radius.get(),
            divergence: self.divergence.get(),
        };
        if self.half.unwrap_or(false) {
            nozzle.upper_wall()
        } else {
            nozzle.walls()
        }
    }
}
