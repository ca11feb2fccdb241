//! Values that are a number in two dimensions and something longer in three.

use std::fmt;

use serde::Deserialize;
use serde::de::value::{MapAccessDeserializer, SeqAccessDeserializer};
use serde::de::{Deserializer, Error, MapAccess, SeqAccess, Visitor};

use super::number::Finite;

/// A turn: degrees counter-clockwise in 2D, `{ axis = [..], angle = degrees }` in 3D.
#[derive(Clone, Debug, PartialEq)]
pub enum Rotation {
    /// About the normal of the plane.
    Plane(f64),
    /// About an axis through the origin.
    Axis {
        /// The axis, of any length but zero.
        axis: Vec<Finite>,
        /// Degrees, right-handed.
        angle: f64,
    },
}

/// An angular velocity in rad/s: a number in 2D, a vector in 3D.
#[derive(Clone, Debug, PartialEq)]
pub enum Spin {
    /// About the normal of the plane, counter-clockwise.
    Plane(f64),
    /// Vector.
    Vector(Vec<Finite>),
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct AxisAngle {
    axis: Vec<Finite>,
    angle: Finite,
}

// Both are read by hand because serde's `untagged` would lose the position of an error in the file.

impl<'de> Deserialize<'de> for Rotation {
    fn deserialize<T: Deserializer<'de>>(deserializer: T) -> Result<Self, T::Error> {
        deserializer.deserialize_any(RotationVisitor)
    }
}

struct RotationVisitor;

impl<'de> Visitor<'de> for RotationVisitor {
    type Value = Rotation;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("degrees, or a table `{ axis = [..], angle = degrees }`")
    }

    fn visit_f64<E: Error>(self, degrees: f64) -> Result<Rotation, E> {
        finite(degrees).map(Rotation::Plane)
    }

    fn visit_i64<E: Error>(self, degrees: i64) -> Result<Rotation, E> {
        Ok(Rotation::Plane(degrees as f64))
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Rotation, A::Error> {
        let AxisAngle { axis, angle } = AxisAngle::deserialize(MapAccessDeserializer::new(map))?;
        Ok(Rotation::Axis {
            axis,
            angle: angle.get(),
        })
    }
}

impl<'de> Deserialize<'de> for Spin {
    fn deserialize<T: Deserializer<'de>>(deserializer: T) -> Result<Self, T::Error> {
        deserializer.deserialize_any(SpinVisitor)
    }
}

struct SpinVisitor;

impl<'de> Visitor<'de> for SpinVisitor {
    type Value = Spin;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a number, or a list of three, in rad/s")
    }

    fn visit_f64<E: Error>(self, rate: f64) -> Result<Spin, E> {
        finite(rate).map(Spin::Plane)
    }

    fn visit_i64<E: Error>(self, rate: i64) -> Result<Spin, E> {
        Ok(Spin::Plane(rate as f64))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, list: A) -> Result<Spin, A::Error> {
        Vec::deserialize(SeqAccessDeserializer::new(list)).map(Spin::Vector)
    }
}

fn finite<E: Error>(value: f64) -> Result<f64, E> {
    Finite::try_from(value).map(Finite::get).map_err(E::custom)
}
