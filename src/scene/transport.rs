//! The gas with its viscosity and heat conduction, from `[gas]`.

use super::error::SceneError;
use super::file::SceneFile;
use super::liquid;
use super::number::{Gamma, Positive};
use super::state::EquationOfState;
use super::stream;
use super::vector::side_key;

use super::viscosity::ViscosityEntry;
use aero_solver::gas::{Gas, IdealGas, Liquid, Transport, Viscosity};
use aero_solver::problem::{Domain, Side, State};

/// Ratio of specific heats of a diatomic gas.
const DIATOMIC: f64 = 1.4;

/// Prandtl number of air about room temperature.
const PRANDTL: f64 = 0.72;

/// Specific gas constant, where the scene says one: its own, or the free stream's; air that is named has one.
pub(super) fn gas_constant(file: &SceneFile) -> Option<f64> {
    if let Some(Gas::Air { air, .. }) = named(file) {
        return Some(air.gas_constant());
    }
    let of_stream = file.free_stream.as_ref().and_then(|entry| {
        let entry = stream::with_constant(file, entry);
        stream::gas_constant(&entry)
    });
    of_stream.or(file.gas.gas_constant.map(Positive::get))
}

/// The gas that the scene names, if that is not an ideal one.
fn named(file: &SceneFile) -> Option<Gas> {
    file.gas.equation_of_state.and_then(EquationOfState::gas)
}

/// How pressure and temperature follow from density and energy: the gas, whether or not it is viscous.
pub(super) fn equation_of_state(file: &SceneFile) -> Gas {
    named(file).unwrap_or_else(|| {
        Gas::Ideal(IdealGas {
            gamma: file.gas.gamma.map_or(DIATOMIC, Gamma::get),
            constant: gas_constant(file).unwrap_or(1.0),
            transport: None,
        })
    })
}

/// The gas of the scene.
pub(super) fn gas<const D: usize>(
    file: &SceneFile,
    free_stream: &State<D>,
) -> Result<Gas, SceneError> {
    check_constant(file)?;
    match equation_of_state(file) {
        Gas::Ideal(gas) => Ok(Gas::Ideal(IdealGas {
            transport: transport(file, free_stream, gas_constant(file))?,
            ..gas
        })),
        Gas::Air { air, .. } => {
            check_air(file)?;
            let transport = transport(file, free_stream, Some(air.gas_constant()))?;
            Ok(Gas::Air { air, transport })
        }
        Gas::Liquid(liquid) => {
            let transport = transport(file, free_stream, None)?;
            Ok(Gas::Liquid(Liquid {
                transport,
                ..liquid
            }))
        }
    }
}

/// Refuses what is said of an ideal gas where air is named.
fn check_air(file: &SceneFile) -> Result<(), SceneError> {
    let stream = file.free_stream.as_ref();
    let own = [
        ("gas.gamma", file.gas.gamma.is_some()),
        ("gas.gas_constant", file.gas.gas_constant.is_some()),
        (
            "free_stream.gas_constant",
            stream.is_some_and(|stream| stream.gas_constant.is_some()),
        ),
    ];
    match own.into_iter().find(|(_, is_given)| *is_given) {
        None => Ok(()),
        Some((key, _)) => Err(SceneError::value(
            key,
            "follows from gas.equation_of_state, which names air; leave one of the two out",
        )),
    }
}

/// Refuses sides that know what comes in or goes out slower than sound of an ideal gas alone, where the gas is another.
pub(super) fn check_sides<const D: usize>(gas: &Gas, domain: &Domain<D>) -> Result<(), SceneError> {
    if gas.ideal_gas().is_some() {
        return Ok(());
    }
    if gas.liquid().is_some() {
        liquid::check_sides(domain)?;
    }
    check_waves(
        domain,
        "rests on the waves of an ideal gas, which gas.equation_of_state does not name",
    )
}

/// Refuses sides that follow the waves of one ideal gas, and says `why`.
pub(super) fn check_waves<const D: usize>(domain: &Domain<D>, why: &str) -> Result<(), SceneError> {
    let sides = domain
        .each_side()
        .map(|(axis, end, side, _)| (axis, end, side));
    let openings = domain.openings.iter();
    let openings = openings.map(|opening| (opening.axis, opening.end, opening.side));
    for (axis, end, side) in sides.chain(openings) {
        if !side.follows_waves() {
            continue;
        }
        let mend = match side {
            Side::Reservoir { .. } => "inlet` or `free-stream",
            side if side.lets_in() => "inlet",
            _ => "outlet",
        };
        let place = side_key(axis, end);
        return Err(SceneError::value(
            place,
            format!("{why}; use `{mend}`, or one ideal gas"),
        ));
    }
    Ok(())
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
    if named(file).is_some_and(|gas| gas.liquid().is_some()) {
        liquid::check_viscosity(&viscosity)?;
    }
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
