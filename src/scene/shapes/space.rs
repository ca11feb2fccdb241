//! Shapes in space, key by key. Angles are in degrees; lengths in the scene's unit.

use aero_geometry::bodies::{self, Capsule, Cuboid};
use aero_geometry::outline::Piece;
use aero_geometry::{GeometryError, Revolution, Vector};
use serde::Deserialize;

use super::super::number::Finite;

/// A body of revolution about the x axis.
#[derive(Clone, Debug, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Round {
    /// A sphere about the origin.
    Sphere(Sphere),
    /// A cone with its tip at the origin.
    Cone(Cone),
    /// A cylinder with a hemispherical nose.
    RoundRod(RoundRod),
    /// An entry capsule.
    Capsule(CapsuleEntry),
    /// The body swept by a line of straight pieces.
    Profile(Profile),
}

impl Round {
    pub(super) fn body(&self) -> Result<Revolution, GeometryError> {
        match self {
            Self::Sphere(entry) => entry.body(),
            Self::Cone(entry) => entry.body(),
            Self::RoundRod(entry) => entry.body(),
            Self::Capsule(entry) => entry.body(),
            Self::Profile(entry) => entry.body(),
        }
    }
}

/// `sphere = { radius }`, about the origin.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Sphere {
    /// Radius.
    radius: Finite,
}

impl Sphere {
    pub(super) fn body(&self) -> Result<Revolution, GeometryError> {
        bodies::sphere(self.radius.get())
    }
}

/// `cone = { half_angle, length }`: tip at the origin, facing `-x`, flat base.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Cone {
    /// Degrees between its side and the x axis.
    half_angle: Finite,
    /// From tip to base.
    length: Finite,
}

impl Cone {
    pub(super) fn body(&self) -> Result<Revolution, GeometryError> {
        bodies::cone(self.half_angle.get(), self.length.get())
    }
}

/// `round_rod = { radius, length }`: hemispherical nose about the origin, facing `-x`, flat base.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RoundRod {
    /// Radius of rod and nose.
    radius: Finite,
    /// From the tip of the nose to the base.
    length: Finite,
}

impl RoundRod {
    pub(super) fn body(&self) -> Result<Revolution, GeometryError> {
        bodies::round_rod(self.radius.get(), self.length.get())
    }
}

/// `capsule = { radius, length, shield_radius, apex_radius, shoulder_radius }`: heat shield
/// upstream, its middle at the origin.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CapsuleEntry {
    /// Largest radius.
    radius: Finite,
    /// Length along the axis.
    length: Finite,
    /// Radius of the heat shield's sphere.
    shield_radius: Finite,
    /// Radius of the apex.
    apex_radius: Finite,
    /// Radius of the shoulder between shield and cone.
    shoulder_radius: Finite,
}

impl CapsuleEntry {
    pub(super) fn body(&self) -> Result<Revolution, GeometryError> {
        let capsule = Capsule {
            radius: self.radius.get(),
            length: self.length.get(),
            shield_radius: self.shield_radius.get(),
            apex_radius: self.apex_radius.get(),
            shoulder_radius: self.shoulder_radius.get(),
        };
        capsule.body()
    }
}

/// `profile = { points = [[x, r], ..] }`: from the axis to the axis, or closed beside it.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Profile {
    /// Corners `[x, r]` in order.
    points: Vec<[Finite; 2]>,
}

impl Profile {
    pub(super) fn body(&self) -> Result<Revolution, GeometryError> {
        let point = |[x, r]: &[Finite; 2]| Vector::<2>::new(x.get(), r.get());
        let pieces = self
            .points
            .windows(2)
            .map(|pair| Piece::segment(point(&pair[0]), point(&pair[1])));
        Revolution::new(pieces.collect())
    }
}

/// `cuboid = { edges = [x, y, z] }`, about the origin.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Block {
    /// Lengths of its edges.
    edges: [Finite; 3],
}

impl Block {
    pub(super) fn body(&self) -> Result<Cuboid, GeometryError> {
        bodies::cuboid(self.edges.map(Finite::get))
    }
}
