//! Viscosity and heat conduction, from `[gas]`.

use std::fmt;

use serde::Deserialize;
use serde::de::{Deserializer, Error, MapAccess, Visitor, value::MapAccessDeserializer};

use super::error::SceneError;
use super::file::SceneFile;
use super::number::{Finite, Positive};
use super::{flow, stream};
use aero_solver::gas::{Gas, IdealGas, Transport, Viscosity};
use aero_solver::problem::State;

/// Prandtl number of air about room temperature.
const PRANDTL: f64 = 0.72;

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

/// Specific gas constant, where the scene says one: its own, or the free stream's.
pub(super) fn gas_constant(file: &SceneFile) -> Option<f64> {
    let of_stream = file.free_stream.as_ref().and_then(|entry| {
        let entry = flow::with_constant(file, entry);
        stream::gas_constant(&entry)
    });
    of_stream.or(file.gas.gas_constant.map(Positive::get))
}

/// The gas of the scene.
pub(super) fn gas<const D: usize>(
    file: &SceneFile,
    free_stream: &State<D>,
) -> Result<Gas, SceneError> {
    check_constant(file)?;
    let constant = gas_constant(file);
    Ok(Gas::Ideal(IdealGas {
        gamma: flow::gamma(file),
        constant: constant.unwrap_or(1.0),
        transport: transport(file, free_stream, constant)?,
    }))
}

/// Refuses a gas constant that is said twice.
fn check_constant(file: &SceneFile) -> Result<(), SceneError> {
    let Some(stream) = file
        .free_stream
        .as_ref()
        .filter(|_| file.gas.gas_constant.is_some())
    else {
        return Ok(());
    };
    let wrong = |message| Err(SceneError::value("gas.gas_constant", message));
    if stream.gas_constant.is_some() {
        return wrong("says what free_stream.gas_constant says; leave one of the two out");
    }
    if stream.altitude.is_some() {
        return wrong(
            "follows from free_stream.altitude, which is in air; leave one of the two out",
        );
    }
    Ok(())
}

fn transport<const D: usize>(
    file: &SceneFile,
    free_stream: &State<D>,
    constant: Option<f64>,
) -> Result<Option<Transport>, SceneError> {
    let Some(entry) = file.gas.viscosity else {
        return match file.gas.prandtl {
            None => Ok(None),
            Some(_) => Err(SceneError::value(
                "gas.prandtl",
                "makes heat conduction of a viscosity, and there is none; add `viscosity`, or leave it out",
            )),
        };
    };
    let viscosity = match entry {
        ViscosityEntry::Law(law) => law,
        ViscosityEntry::Reynolds { number, length } => {
            let flux = free_stream.density * free_stream.velocity.norm();
            if flux <= 0.0 {
                return Err(SceneError::value(
                    "gas.viscosity.reynolds",
                    "is of the free stream, which is at rest; give the viscosity itself",
                ));
            }
            Viscosity::Constant(flux * length / number)
        }
    };
    if viscosity.asks_for_temperature() && constant.is_none() {
        return Err(SceneError::value(
            "gas.viscosity",
            "depends on the temperature, which is not known; give `gas.gas_constant` (287.05 J/(kg K) of air), or \
             free_stream.temperature",
        ));
    }
    Ok(Some(Transport {
        viscosity,
        prandtl: file.gas.prandtl.map_or(PRANDTL, Positive::get),
    }))
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
