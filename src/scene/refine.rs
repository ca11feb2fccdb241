//! `scheme.refine`: a number of halvings, or `{ points = N }`.

use std::fmt;

use serde::Deserialize;
use serde::de::{Deserializer, Error, MapAccess, Visitor, value::MapAccessDeserializer};

use super::number::Count;
use aero_solver::method::Refine;

/// Where points are added.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RefineEntry(pub Refine);

/// The table form.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Budget {
    points: Count,
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
            "a number of halvings from 0 to {}, or `{{ points = N }}`",
            Refine::DEEPEST
        )
    }

    fn visit_i64<E: Error>(self, value: i64) -> Result<RefineEntry, E> {
        match u8::try_from(value) {
            Ok(levels) if levels <= Refine::DEEPEST => Ok(RefineEntry(Refine::Levels(levels))),
            _ => Err(E::custom(format!(
                "{value} is not a number of halvings from 0 to {}",
                Refine::DEEPEST
            ))),
        }
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<RefineEntry, A::Error> {
        let Budget { points } = Budget::deserialize(MapAccessDeserializer::new(map))?;
        Ok(RefineEntry(Refine::Points(points.get() as u64)))
    }
}
