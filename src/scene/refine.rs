//! `scheme.refine`: a number of halvings, `{ flow = N, bodies = M, bends = K }`, `{ points = N }` or `{ minutes = T }`.

use std::fmt;

use serde::Deserialize;
use serde::de::{Deserializer, Error, MapAccess, Visitor, value::MapAccessDeserializer};

use super::number::{Count, Positive};
use aero_solver::method::Refine;

/// Where points are added.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum RefineEntry {
    /// As far as it says.
    To(Refine),
    /// As far as so many minutes go, which have yet to be turned into points.
    Minutes(f64),
}

/// The table form: one of the three.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Table {
    flow: Option<Halvings>,
    bodies: Option<Halvings>,
    bends: Option<Halvings>,
    points: Option<Count>,
    minutes: Option<Positive>,
}

/// So often is a spacing halved.
#[derive(Clone, Copy, Deserialize)]
#[serde(try_from = "i64")]
struct Halvings(u8);

impl TryFrom<i64> for Halvings {
    type Error = String;

    fn try_from(value: i64) -> Result<Self, String> {
        match u8::try_from(value) {
            Ok(halvings) if halvings <= Refine::DEEPEST => Ok(Self(halvings)),
            _ => Err(format!(
                "{value} is not a number of halvings from 0 to {}",
                Refine::DEEPEST
            )),
        }
    }
}

impl<'de> Deserialize<'de> for RefineEntry {
    fn deserialize<T: Deserializer<'de>>(deserializer: T) -> Result<Self, T::Error> {
        deserializer.deserialize_any(Either)
    }
}

struct Either;

impl<'de> Visitor<'de> for Either {
    type Value = RefineEntry;

    fn expecting(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            formatter,
            "a number of halvings from 0 to {}, `{{ flow = N, bodies = M }}`, `{{ points = N }}` or `{{ minutes = T }}`",
            Refine::DEEPEST
        )
    }

    fn visit_i64<E: Error>(self, value: i64) -> Result<RefineEntry, E> {
        let Halvings(halvings) = value.try_into().map_err(E::custom)?;
        Ok(RefineEntry::To(Refine::Levels(halvings)))
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<RefineEntry, A::Error> {
        match Table::deserialize(MapAccessDeserializer::new(map))? {
            Table {
                flow: Some(Halvings(flow)),
                bodies: Some(bodies),
                bends,
                points: None,
                minutes: None,
            } => Ok(RefineEntry::To(Refine::Apart {
                flow,
                bodies: bodies.0,
                bends: bends.unwrap_or(bodies).0,
            })),
            Table {
                flow: None,
                bodies: None,
                bends: None,
                points: Some(points),
                minutes: None,
            } => Ok(RefineEntry::To(Refine::Points(points.get() as u64))),
            Table {
                flow: None,
                bodies: None,
                bends: None,
                points: None,
                minutes: Some(minutes),
            } => Ok(RefineEntry::Minutes(minutes.get())),
            _ => Err(A::Error::custom(
                "give one of `points = N` and `minutes = T`, or both `flow = N` and `bodies = M`, and `bends = K` beside these",
            )),
        }
    }
}
