//! From `[gas.second]` to a second gas beside the first, and what does not go with two.

use std::sync::Arc;

use aero_geometry::Vector;

use super::error::SceneError;
use super::field;
use super::file::SceneFile;
use super::number::Positive;
use super::transport;

use aero_solver::gas::{Gas, IdealGas};
use aero_solver::problem::{Domain, Problem, SecondGas, side_name};
use aero_solver::scheme::Density;

/// Key of the table.
const KEY: &str = "gas.second";

/// The second gas of the scene, if it names one.
///
/// # Errors
/// Where it cannot be beside the first.
pub(super) fn second<const D: usize>(
    file: &SceneFile,
    domain: &Domain<D>,
) -> Result<Option<SecondGas<D>>, SceneError> {
    let Some(entry) = &file.gas.second else {
        return Ok(None);
    };
    check_file(file)?;
    let constant = match (transport::gas_constant(file), entry.gas_constant) {
        (Some(_), Some(constant)) => constant.get(),
        (None, None) => 1.0,
        (Some(_), None) => {
            return Err(SceneError::value(
                "gas.second.gas_constant",
                "missing, though the first gas has one; add it, in J/(kg K)",
            ));
        }
        (None, Some(_)) => {
            return Err(SceneError::value(
                "gas.second.gas_constant",
                "goes with a gas.gas_constant of the first gas; add that, or leave both out",
            ));
        }
    };
    transport::check_waves(
        domain,
        "rests on the waves of one gas, and gas.second names another",
    )?;
    let (inside, spacing) = (entry.inside.clone(), file.spacing.get());
    let fills = move |position: &Vector<D>| inside.at(&field::place(position, spacing)) > 0.0;
    Ok(Some(SecondGas {
        gas: Gas::Ideal(IdealGas {
            gamma: entry.gamma.get(),
            constant,
            transport: None,
        }),
        fills: Arc::new(fills),
        density: entry.density.map(Positive::get),
    }))
}

/// Refuses what does not go with two gases.
fn check_file(file: &SceneFile) -> Result<(), SceneError> {
    let taken = [
        (
            file.gas
                .equation_of_state
                .is_some_and(|law| law.gas().is_some()),
            "goes with an ideal gas beside it; leave gas.equation_of_state out",
        ),
        (
            file.gas.viscosity.is_some(),
            "has no viscosity, nor has what is beside it; leave gas.viscosity out",
        ),
        (
            file.initial.frame.is_some(),
            "is placed by `inside` at the start, and frames do not tell which gas was where; leave initial.frame out",
        ),
        (
            file.manufactured.is_some(),
            "does not go with [manufactured], a solution of one gas; leave one of the two out",
        ),
    ];
    match taken.into_iter().find(|(is_given, _)| *is_given) {
        Some((_, message)) => Err(SceneError::value(KEY, message)),
        None => Ok(()),
    }
}

/// Refuses what cannot carry two gases, and a second gas that is nowhere or comes in.
pub(super) fn check<const D: usize>(problem: &Problem<D>) -> Result<(), SceneError> {
    let Some(second) = &problem.second else {
        return Ok(());
    };
    if problem.method.fixed().is_some() {
        return Err(SceneError::value(
            KEY,
            "goes with particles, which keep the gas that they are made of; leave out scheme.motion = \"fixed\"",
        ));
    }
    if problem.scheme.density != Density::Summation {
        return Err(SceneError::value(
            KEY,
            "goes with scheme.equations = \"conservative\": those that diffuse density would mix the gases; take that",
        ));
    }
    if problem.scheme.transport_velocity.shifting {
        return Err(SceneError::value(
            KEY,
            "does not go with shifting, by which neighbours exchange gas; leave scheme.shifting out",
        ));
    }
    let bounds = &problem.domain.bounds;
    let counts: [usize; D] = std::array::from_fn(|k| {
        (bounds.size()[k] / problem.resolution.lattice())
            .round()
            .max(1.0) as usize
    });
    let place = |mut number: usize| {
        Vector::<D>::from_fn(|k, _| {
            let index = number % counts[k];
            number /= counts[k];
            bounds.min[k] + (index as f64 + 0.5) * problem.resolution.lattice()
        })
    };
    let all = || (0..counts.iter().product()).map(place);
    if !all().any(|place| (second.fills)(&place)) {
        return Err(SceneError::value(
            "gas.second.inside",
            "is above zero nowhere in the domain; say where the second gas is at the start",
        ));
    }
    for (axis, end, _, face) in problem.domain.each_side() {
        let comes_in = |place: &Vector<D>| {
            (place[axis] - face).abs() < problem.resolution.lattice()
                && problem.domain.side_at(axis, end, place).lets_in()
        };
        if all().any(|place| comes_in(&place) && (second.fills)(&place)) {
            return Err(SceneError::value(
                "gas.second.inside",
                format!(
                    "is above zero at side {}, where gas comes in; keep the second gas off that side, or close it",
                    side_name(axis, end)
                ),
            ));
        }
    }
    Ok(())
}
