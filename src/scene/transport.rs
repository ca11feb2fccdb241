//! The gas with its viscosity and heat conduction, from `[gas]`.

use super::error::SceneError;
use super::file::SceneFile;
use super::number::Positive;
use super::viscosity::ViscosityEntry;
use super::{flow, stream};
use aero_solver::gas::{Gas, IdealGas, Transport, Viscosity};
use aero_solver::problem::State;

/// Prandtl number of air about room temperature.
const PRANDTL: f64 = 0.72;

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
