//! Shapes of the plane, key by key. Angles are in degrees; lengths in the scene's unit.

use std::path::{Path, PathBuf};

use aero_geometry::bodies::{self, Nozzle};
use aero_geometry::{GeometryError, Outline, Placement, Vector};
use serde::Deserialize;

use super::super::number::Finite;

type Made = Result<Outline, GeometryError>;

/// `circle = { radius }`, about the origin.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Circle {
    radius: Finite,
}

impl Circle {
    pub(super) fn outline(&self) -> Made {
        bodies::circle(self.radius.get())
    }
}

/// `rectangle = { width, height, corner_radius }`, about the origin.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Rectangle {
    width: Finite,
    height: Finite,
    corner_radius: Option<Finite>,
}

impl Rectangle {
    pub(super) fn outline(&self) -> Made {
        let corner_radius = self.corner_radius.map_or(0.0, Finite::get);
        bodies::rectangle(self.width.get(), self.height.get(), corner_radius)
    }
}

/// `polygon = { points = [[x, y], ..] }`, closed.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Polygon {
    points: Vec<[Finite; 2]>,
}

impl Polygon {
    pub(super) fn outline(&self) -> Made {
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
    file: PathBuf,
}

impl PolygonFile {
    pub(super) fn outline(&self, folder: &Path) -> Made {
        bodies::polygon_file(&folder.join(&self.file))
    }
}

/// `biconvex = { chord, thickness_ratio }`, leading edge at the origin.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Biconvex {
    chord: Finite,
    thickness_ratio: Finite,
}

impl Biconvex {
    pub(super) fn outline(&self) -> Made {
        bodies::biconvex(self.chord.get(), self.thickness_ratio.get())
    }
}

/// `half_space = { height }`: solid below it.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct HalfSpace {
    height: Option<Finite>,
}

impl HalfSpace {
    pub(super) fn outline(&self) -> Made {
        bodies::wall(self.height.map_or(0.0, Finite::get))
    }
}

/// `compression_corner = { angle, corner }` and `expansion_corner` likewise: solid below a level
/// wall that turns at the corner.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Corner {
    angle: Finite,
    corner: Option<[Finite; 2]>,
}

impl Corner {
    pub(super) fn compression(&self) -> Made {
        bodies::compression_corner(0.0, self.angle.get()).map(|outline| self.at_corner(outline))
    }

    pub(super) fn expansion(&self) -> Made {
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
    foot: Finite,
    height: Finite,
}

impl ForwardStep {
    pub(super) fn outline(&self) -> Made {
        bodies::forward_step(self.foot.get(), self.height.get())
    }
}

/// `blunt_wedge = { radius, half_angle, length }`: nose about the origin, facing `-x`; endless
/// without a length.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BluntWedge {
    radius: Finite,
    half_angle: Finite,
    length: Option<Finite>,
}

impl BluntWedge {
    pub(super) fn outline(&self) -> Made {
        let length = self.length.map_or(f64::INFINITY, Finite::get);
        bodies::blunt_wedge(self.radius.get(), self.half_angle.get(), length)
    }
}

/// `nozzle = { inlet, throat, contraction_radius, throat_radius, divergence, half }`: half-heights,
/// arc radii and the half-angle; throat at `x = 0`; the upper wall alone if `half` is set.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Duct {
    inlet: Finite,
    throat: Finite,
    contraction_radius: Finite,
    throat_radius: Finite,
    divergence: Finite,
    half: Option<bool>,
}

impl Duct {
    pub(super) fn outline(&self) -> Made {
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
