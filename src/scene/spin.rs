//! Values that are a number in two dimensions and something longer in three.

use std::fmt;

use serde::Deserialize;
use serde::de::value::{MapAccessDeserializer, SeqAccessDeserializer};
use serde::de::{Deserializer, Error, MapAccess, SeqAccess, Visitor};

use super::number::{Finite, Positive};

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
pub enum Rate {
    /// About the normal of the plane, counter-clockwise.
    Plane(f64),
    /// Vector.
    Vector(Vec<Finite>),
}

/// Moments of inertia: a number in 2D, a list in 3D.
#[derive(Clone, Debug, PartialEq)]
pub enum Inertia {
    /// About the normal of the plane.
    Plane(f64),
    /// `[xx, yy, zz]`, or `[xx, yy, zz, xy, xz, yz]`, the elements of the matrix.
    List(Vec<Finite>),
}

/// An angular velocity over time: a constant, `{ cosine = { .. } }` or `{ table = { .. } }`.
#[derive(Clone, Debug, PartialEq)]
pub enum Spin {
    /// Constant.
    Steady(Rate),
    /// `amplitude cos(2 pi t / period + phase)`.
    Cosine(CosineEntry),
    /// Straight lines between points in time.
    Table(TableEntry),
}

/// `cosine = { amplitude, period, phase }`: rad/s, time, degrees.
#[derive(Clone, Debug, Deserialize, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct CosineEntry {
    /// Greatest angular velocity.
    pub amplitude: Rate,
    /// Period.
    pub period: Positive,
    /// Phase at time zero; none unless given.
    pub phase: Option<Finite>,
}

/// `table = { times, rates, axis }`: rates in rad/s; the axis in 3D alone.
#[derive(Clone, Debug, Deserialize, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct TableEntry {
    /// Times, increasing.
    pub times: Vec<Finite>,
    /// Angular velocity at each of them; the first and the last hold outside.
    pub rates: Vec<Finite>,
    /// The axis, of any length but zero.
    pub axis: Option<Vec<Finite>>,
}

/// The table form, one of the two.
#[derive(Deserialize)]
#[serde(deny_unknown_fields, rename_all = "snake_case")]
enum History {
    Cosine(CosineEntry),
    Table(TableEntry),
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct AxisAngle {
    axis: Vec<Finite>,
    angle: Finite,
}

// All are read by hand because serde's `untagged` would lose the position of an error in the file.

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

impl<'de> Deserialize<'de> for Rate {
    fn deserialize<T: Deserializer<'de>>(deserializer: T) -> Result<Self, T::Error> {
        deserializer.deserialize_any(RateVisitor)
    }
}

struct RateVisitor;

impl<'de> Visitor<'de> for RateVisitor {
    type Value = Rate;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a number, or a list of three, in rad/s")
    }

    fn visit_f64<E: Error>(self, rate: f64) -> Result<Rate, E> {
        finite(rate).map(Rate::Plane)
    }

    fn visit_i64<E: Error>(self, rate: i64) -> Result<Rate, E> {
        Ok(Rate::Plane(rate as f64))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, list: A) -> Result<Rate, A::Error> {
        Vec::deserialize(SeqAccessDeserializer::new(list)).map(Rate::Vector)
    }
}

impl<'de> Deserialize<'de> for Inertia {
    fn deserialize<T: Deserializer<'de>>(deserializer: T) -> Result<Self, T::Error> {
        deserializer.deserialize_any(InertiaVisitor)
    }
}

struct InertiaVisitor;

impl<'de> Visitor<'de> for InertiaVisitor {
    type Value = Inertia;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a number, or a list of three or six, in kg m^2")
    }

    fn visit_f64<E: Error>(self, number: f64) -> Result<Inertia, E> {
        finite(number).map(Inertia::Plane)
    }

    fn visit_i64<E: Error>(self, number: i64) -> Result<Inertia, E> {
        Ok(Inertia::Plane(number as f64))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, list: A) -> Result<Inertia, A::Error> {
        Vec::deserialize(SeqAccessDeserializer::new(list)).map(Inertia::List)
    }
}

struct SpinVisitor;

impl<'de> Visitor<'de> for SpinVisitor {
    type Value = Spin;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(
            "a number, a list of three, or a table `{ cosine = { .. } }` or `{ table = { .. } }`, in rad/s",
        )
    }

    fn visit_f64<E: Error>(self, rate: f64) -> Result<Spin, E> {
        RateVisitor.visit_f64(rate).map(Spin::Steady)
    }

    fn visit_i64<E: Error>(self, rate: i64) -> Result<Spin, E> {
        RateVisitor.visit_i64(rate).map(Spin::Steady)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, list: A) -> Result<Spin, A::Error> {
        RateVisitor.visit_seq(list).map(Spin::Steady)
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Spin, A::Error> {
        match History::deserialize(MapAccessDeserializer::new(map))? {
            History::Cosine(entry) => Ok(Spin::Cosine(entry)),
            History::Table(entry) => Ok(Spin::Table(entry)),
        }
    }
}

fn finite<E: Error>(value: f64) -> Result<f64, E> {
    Finite::try_from(value).map(Finite::get).map_err(E::custom)
}
