//! A liquid, from `gas.equation_of_state`, and what of a scene has no meaning with one.

use super::error::SceneError;
use super::file::SceneFile;
use super::number::Positive;
use super::side::SideEntry;
use super::vector::side_key;

use aero_solver::gas::{Liquid, Viscosity};
use aero_solver::problem::{Domain, Side, WallHeat, WallKind};

/// Density and pressure of a liquid of which a scene gives one of the two at `place`.
pub(super) fn state(
    liquid: &Liquid,
    place: &str,
    given: [Option<Positive>; 2],
) -> Result<[f64; 2], SceneError> {
    let found = match given.map(|value| value.map(Positive::get)) {
        [Some(density), None] => [density, liquid.pressure(density)],
        [None, Some(pressure)] => [liquid.density(pressure), pressure],
        [Some(_), Some(_)] => {
            return Err(SceneError::value(
                format!("{place}.pressure"),
                "follows from the density, as gas.equation_of_state says; leave one of the two out",
            ));
        }
        [None, None] => {
            return Err(SceneError::value(
                place,
                "give density or pressure of the liquid",
            ));
        }
    };
    let [density, _] = found;
    if density > 0.0 && density.is_finite() {
        return Ok(found);
    }
    Err(SceneError::value(
        format!("{place}.pressure"),
        format!(
            "is below {}, where the liquid has no density left; give more",
            liquid.least_pressure()
        ),
    ))
}

/// Refuses what is said of gas or of heat where the gas is a liquid.
pub(super) fn check(file: &SceneFile) -> Result<(), SceneError> {
    let stream = file.free_stream.as_ref();
    let heat = "is of a gas, and gas.equation_of_state names a liquid, which carries no heat; leave it out";
    let beside = "follows from gas.equation_of_state, which names a liquid; give free_stream.density or pressure alone";
    let of_stream =
        |is_given: fn(&super::file::FreeStreamEntry) -> bool| stream.is_some_and(is_given);
    let refused = [
        ("gas.gamma", file.gas.gamma.is_some(), heat),
        ("gas.gas_constant", file.gas.gas_constant.is_some(), heat),
        ("gas.prandtl", file.gas.prandtl.is_some(), heat),
        (
            "free_stream.altitude",
            of_stream(|stream| stream.altitude.is_some()),
            beside,
        ),
        (
            "free_stream.temperature",
            of_stream(|stream| stream.temperature.is_some()),
            beside,
        ),
        (
            "free_stream.gas_constant",
            of_stream(|stream| stream.gas_constant.is_some()),
            beside,
        ),
        (
            "initial.stream",
            file.initial.stream.is_some(),
            "turns an earlier flow of gas; a liquid's is taken over as it is, so leave it out",
        ),
        (
            "initial.trend",
            file.initial.trend.is_some(),
            "goes on from earlier flows of gas; a liquid's is taken over as it is, so leave it out",
        ),
        (
            "manufactured",
            file.manufactured.is_some(),
            "is a solution of an ideal gas; leave out gas.equation_of_state",
        ),
        (
            "scheme.motion",
            file.scheme.motion == Some(super::words::MotionWord::Fixed),
            "points that stay go with gas; a liquid takes `with-the-gas`",
        ),
    ];
    match refused.into_iter().find(|(_, is_given, _)| *is_given) {
        Some((key, _, message)) => Err(SceneError::value(key, message)),
        None => check_given(file),
    }
}

/// Refuses a viscosity that asks for a temperature.
pub(super) fn check_viscosity(viscosity: &Viscosity) -> Result<(), SceneError> {
    if viscosity.asks_for_temperature() {
        return Err(SceneError::value(
            "gas.viscosity",
            "depends on the temperature, and a liquid has none here; give a number in Pa s, or `{ reynolds = .. }`",
        ));
    }
    Ok(())
}

/// Refuses gas beyond a side that is not the free stream: its formulas name density and pressure of a gas.
fn check_given(file: &SceneFile) -> Result<(), SceneError> {
    let gives = |(_, _, side): &(usize, usize, &SideEntry)| {
        side.given.is_some() || side.parts.iter().any(|part| part.given.is_some())
    };
    match file.domain.sides.each().find(gives) {
        None => Ok(()),
        Some((axis, end, _)) => Err(SceneError::value(
            side_key(axis, end),
            "gives the state of a gas beyond it, and gas.equation_of_state names a liquid; leave it to the free stream",
        )),
    }
}

/// Refuses an axis, about which nobody has tried a liquid.
pub(super) fn check_sides<const D: usize>(domain: &Domain<D>) -> Result<(), SceneError> {
    if domain.has(|side| side == Side::Axis) {
        return Err(SceneError::value(
            "domain.sides",
            "have an axis, about which a liquid is not tried; take the plane or space",
        ));
    }
    Ok(())
}

/// Refuses heat that a wall gives a liquid.
pub(super) fn check_wall(place: &str, kind: WallKind) -> Result<(), SceneError> {
    match kind {
        WallKind::NoSlip(wall) if wall.heat != WallHeat::Adiabatic => Err(SceneError::value(
            place,
            "gives heat, and gas.equation_of_state names a liquid, which carries none; leave out temperature and heat_flux",
        )),
        _ => Ok(()),
    }
}
