//! Words for the viscosity of `[gas]`.

use std::fmt;

use serde::Deserialize;
use serde::de::{Deserializer, Error, MapAccess, Visitor, value::MapAccessDeserializer};

use super::number::{Finite, Positive};
use aero_solver::gas::Viscosity;

/// Dynamic viscosity: Pa s, `{ sutherland = { .. } }`, `{ power = { .. } }` or `{ reynolds = .., length = .. }`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ViscosityEntry {
    /// By a law of its own.
    Law(Viscosity),
    /// By the Reynolds number of the free stream.
    Reynolds {
        /// Reynolds number.
        number: f64,
        /// Its length.
        length: f64,
    },
}

/// The table form: one of the laws.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ViscosityTable {
    sutherland: Option<SutherlandEntry>,
    power: Option<PowerEntry>,
    reynolds: Option<Positive>,
    length: Option<Positive>,
}

/// Sutherland's law, `viscosity (T / temperature)^(3/2) (temperature + constant) / (T + constant)`.
#[derive(Clone, Copy, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SutherlandEntry {
    /// Viscosity at the reference temperature, Pa s; 1.716e-5 (air) unless given.
    pub viscosity: Option<Positive>,
    /// Reference temperature, K; 273.15 unless given.
    pub temperature: Option<Positive>,
    /// Sutherland's constant, K; 110.4 (air) unless given.
    pub constant: Option<Positive>,
}

/// A power of the temperature, `viscosity (T / temperature)^exponent`.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PowerEntry {
    /// Viscosity at the reference temperature, Pa s.
    pub viscosity: Positive,
    /// Reference temperature, K.
    pub temperature: Positive,
    /// Exponent; 0.7 is near for air.
    pub exponent: Finite,
}

impl SutherlandEntry {
    fn law(self) -> Option<Viscosity> {
        let Viscosity::Sutherland {
            viscosity,
            temperature,
            constant,
        } = Viscosity::AIR
        else {
            return None;
        };
        Some(Viscosity::Sutherland {
            viscosity: self.viscosity.map_or(viscosity, Positive::get),
            temperature: self.temperature.map_or(temperature, Positive::get),
            constant: self.constant.map_or(constant, Positive::get),
        })
    }
}

impl PowerEntry {
    fn law(self) -> Viscosity {
        Viscosity::Power {
            viscosity: self.viscosity.get(),
            temperature: self.temperature.get(),
            exponent: self.exponent.get(),
        }
    }
}

impl<'de> Deserialize<'de> for ViscosityEntry {
    fn deserialize<T: Deserializer<'de>>(deserializer: T) -> Result<Self, T::Error> {
        deserializer.deserialize_any(Either)
    }
}

/// Written by hand because serde's `untagged` would lose the position of an error in the file.
struct Either;

impl<'de> Visitor<'de> for Either {
    type Value = ViscosityEntry;

    fn expecting(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(
            "a viscosity in Pa s, `{ sutherland = { .. } }`, `{ power = { .. } }` or `{ reynolds = .., length = .. }`",
        )
    }

    fn visit_f64<E: Error>(self, value: f64) -> Result<ViscosityEntry, E> {
        let viscosity = Positive::try_from(value).map_err(E::custom)?;
        Ok(ViscosityEntry::Law(Viscosity::Constant(viscosity.get())))
    }

    fn visit_i64<E: Error>(self, value: i64) -> Result<ViscosityEntry, E> {
        self.visit_f64(value as f64)
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<ViscosityEntry, A::Error> {
        let table = ViscosityTable::deserialize(MapAccessDeserializer::new(map))?;
        let ViscosityTable {
            sutherland,
            power,
            reynolds,
            length,
        } = table;
        let law = match (sutherland, power, reynolds, length) {
            (Some(entry), None, None, None) => entry.law().map(ViscosityEntry::Law),
            (None, Some(entry), None, None) => Some(ViscosityEntry::Law(entry.law())),
            (None, None, Some(number), length) => Some(ViscosityEntry::Reynolds {
                number: number.get(),
                length: length.map_or(1.0, Positive::get),
            }),
            _ => None,
        };
        law.ok_or_else(|| {
            A::Error::custom(
                "give one of `sutherland = { .. }`, `power = { .. }` and `reynolds = ..`, the last with a `length` if that is not 1",
            )
        })
    }
}

#[cfg(test)]
mod tests {
    use super::super::file::GasEntry;
    use super::*;

    fn read(text: &str) -> Result<ViscosityEntry, String> {
        let entry: Result<GasEntry, _> = toml::from_str(text);
        let entry = entry.map_err(|error| error.to_string())?;
        entry.viscosity.ok_or_else(|| "none".into())
    }

    #[test]
    fn each_law_is_read() {
        assert_eq!(
            read("viscosity = 1.8e-5"),
            Ok(ViscosityEntry::Law(Viscosity::Constant(1.8e-5)))
        );
        assert_eq!(
            read("viscosity = { sutherland = {} }"),
            Ok(ViscosityEntry::Law(Viscosity::AIR))
        );
        assert_eq!(
            read("viscosity = { power = { viscosity = 2.0, temperature = 300, exponent = 0.7 } }"),
            Ok(ViscosityEntry::Law(Viscosity::Power {
                viscosity: 2.0,
                temperature: 300.0,
                exponent: 0.7
            }))
        );
        assert_eq!(
            read("viscosity = { reynolds = 1e5, length = 0.2 }"),
            Ok(ViscosityEntry::Reynolds {
                number: 1e5,
                length: 0.2
            })
        );
    }

    #[test]
    fn what_is_no_viscosity_is_refused_with_the_mend() {
        for (text, words) in [
            ("viscosity = -1e-5", "not a positive number"),
            ("viscosity = 0", "not a positive number"),
            ("viscosity = nan", "not a positive number"),
            ("viscosity = \"air\"", "Pa s"),
            ("viscosity = {}", "give one of"),
            ("viscosity = { length = 1.0 }", "give one of"),
            ("viscosity = { reynolds = -1.0 }", "not a positive number"),
            (
                "viscosity = { sutherland = {}, reynolds = 1e5 }",
                "give one of",
            ),
            ("viscosity = { sutherlnd = {} }", "unknown field"),
            ("viscosity = 1.0\nprandtl = 0.0", "not a positive number"),
        ] {
            let error = read(text).unwrap_err();
            assert!(error.contains(words), "{text}: {error}");
        }
    }
}
