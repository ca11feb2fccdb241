//! Sides of the domain as a scene names them.

use std::fmt;

use serde::Deserialize;
use serde::de::{Deserializer, Error, MapAccess, SeqAccess, Visitor, value::MapAccessDeserializer};

use aero_solver::problem::Side;

use super::number::Finite;
use super::side_tables::{SideTable, WallEntry};
use super::side_words::{GivenEntry, PatchEntry, TABLES, named, words};

/// What bounds the domain on one side: a word, a table of one word, or a list of a wall and the parts of it that are something else.
#[derive(Clone, Debug, PartialEq)]
pub struct SideEntry {
    /// What it is, but for its parts and the velocity of a wall along itself.
    pub side: Side,
    /// Velocity of a wall as a vector.
    pub velocity: Option<Vec<Finite>>,
    /// The gas beyond it, where that is not the free stream.
    pub given: Option<GivenEntry>,
    /// Its parts.
    pub parts: Vec<PartEntry>,
}

/// A part of a side.
#[derive(Clone, Debug, PartialEq)]
pub struct PartEntry {
    /// Where it is.
    pub patch: PatchEntry,
    /// What it is.
    pub side: Side,
    /// The gas beyond it, where that is not the free stream.
    pub given: Option<GivenEntry>,
}

impl From<Side> for SideEntry {
    fn from(side: Side) -> Self {
        Self {
            side,
            velocity: None,
            given: None,
            parts: Vec::new(),
        }
    }
}

impl<'de> Deserialize<'de> for SideEntry {
    fn deserialize<T: Deserializer<'de>>(deserializer: T) -> Result<Self, T::Error> {
        deserializer.deserialize_any(SideVisitor)
    }
}

/// Written by hand because serde's `untagged` would lose the position of an error in the file.
struct SideVisitor;

impl<'de> Visitor<'de> for SideVisitor {
    type Value = SideEntry;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "one of {}, or {TABLES}, or a list of a wall and its parts that are something else",
            words()
        )
    }

    fn visit_str<E: Error>(self, word: &str) -> Result<SideEntry, E> {
        named(word).map(SideEntry::from)
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<SideEntry, A::Error> {
        let table = SideTable::deserialize(MapAccessDeserializer::new(map))?;
        if table.patch.is_some() {
            return Err(A::Error::custom(
                "a patch is a part of a wall; give a list that begins with the wall: `[\"wall\", { patch = { .. }, .. }]`",
            ));
        }
        let velocity = table.wall.as_ref().and_then(WallEntry::vector);
        let (side, given) = table.side()?;
        Ok(SideEntry {
            velocity,
            given,
            ..side.into()
        })
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<SideEntry, A::Error> {
        let whole: Option<SideEntry> = list.next_element()?;
        let Some(mut entry) = whole.filter(|entry| entry.side.is_wall()) else {
            return Err(A::Error::custom(
                "a list of parts begins with the wall that they are in: `[\"wall\", { patch = { .. }, .. }]`",
            ));
        };
        while let Some(mut table) = list.next_element::<SideTable>()? {
            let Some(patch) = table.patch.take() else {
                return Err(A::Error::custom(
                    "a part of a side needs `patch = { min = [..], max = [..] }`, which says where it is",
                ));
            };
            let (side, given) = table.side()?;
            if !side.is_open() && side != Side::Symmetry {
                return Err(A::Error::custom(
                    "a part of a wall is an inlet, an outlet, a reservoir, a free stream or a mirror (`side = \"symmetry\"`); \
                     leave out what is wall",
                ));
            }
            entry.parts.push(PartEntry { patch, side, given });
        }
        Ok(entry)
    }
}
