//! `scheme.refine`: a number of halvings, `{ points = N }` or `{ minutes = T }`.

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

/// The table form: one of the two.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Budget {
    points: Option<Count>,
    minutes: Option<Positive>,
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
            "a number of halvings from 0 to {}, `{{ points = N }}` or `{{ minutes = T }}`",
            Refine::DEEPEST
        )
    }

    fn visit_i64<E: Error>(self, value: i64) -> Result<RefineEntry, E> {
        match u8::try_from(value) {
            Ok(levels) if levels <= Refine::DEEPEST => Ok(RefineEntry::To(Refine::Levels(levels))),
            _ => Err(E::custom(format!(
                "{value} is not a number of halvings from 0 to {}",
                Refine::DEEPEST
            ))),
        }
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<RefineEntry, A::Error> {
        match Budget::deserialize(MapAccessDeserializer::new(map))? {
            Budget {
                points: Some(points),
                minutes: None,
            } => Ok(RefineEntry::To(Refine::Points(points.get() as u64))),
            Budget {
                points: None,
                minutes: Some(minutes),
            } => Ok(RefineEntry::Minutes(minutes.get())),
            _ => Err(A::Error::custom(
                "give one of `points = N` and `minutes = T`",
            )),
        }
    }
}
