//! The scheme that a scene puts together; what goes with those of liquids alone, and what they cannot do.

use super::error::SceneError;
use super::file::SchemeEntry;
use super::vector::side_key;

use super::words::SchemeName;
use aero_solver::gas::Gas;
use aero_solver::problem::Problem;
use aero_solver::scheme::{Conduction, Precision, Scheme, Viscosity};

/// The parts that a scene names, and the usual ones of `gas`.
pub(super) fn scheme(entry: SchemeEntry, gas: &Gas) -> Scheme {
    let mut scheme = entry
        .equations
        .map_or_else(Scheme::default, SchemeName::scheme);
    if gas.is_viscous() {
        scheme = scheme.of_viscous_gas();
    }
    if gas.liquid().is_some() {
        scheme = scheme.of_liquid();
    }
    if let Some(word) = entry.extrapolation {
        scheme.wall.extrapolation = word.into();
    }
    if let Some(word) = entry.precision {
        scheme.precision = word.into();
    }
    if let Some(limits) = entry.limited_viscosity {
        scheme.limit_viscosity(limits);
    }
    if let Some(limits) = entry.limited_conduction {
        scheme.limit_conduction(limits);
    }
    if entry.artificial_dissipation == Some(false) {
        scheme.viscosity = Viscosity::None;
        scheme.conduction = Conduction::None;
    }
    if let Some(cfl) = entry.cfl {
        scheme.step.cfl = cfl.get();
    }
    let switches = [
        (&mut scheme.transport_velocity.shield, entry.shield),
        (&mut scheme.transport_velocity.shifting, entry.shifting),
        (
            &mut scheme.wall.constant_volume,
            entry.constant_ghost_volume,
        ),
        (&mut scheme.wall.surface_tags, entry.surface_tags),
        (&mut scheme.skip_undisturbed, entry.skip_undisturbed),
    ];
    for (switch, wanted) in switches {
        *switch = wanted.unwrap_or(*switch);
    }
    scheme
}

/// Refuses a scheme of liquids where the gas is none, or where its particles cannot do what the scene wants.
pub(super) fn check<const D: usize>(problem: &Problem<D>) -> Result<(), SceneError> {
    let scheme = &problem.scheme;
    if !scheme.is_of_liquids() || problem.method.fixed().is_some() {
        return Ok(());
    }
    let name = scheme.name;
    if problem.gas.liquid().is_none() {
        return Err(SceneError::value(
            "scheme.equations",
            format!(
                "`{name}` evolves the density of a liquid, and carries no heat; set gas.equation_of_state = {{ linear = {{ sound_speed = .., density = .. }} }}, \
                 or take `conservative`"
            ),
        ));
    }
    if scheme.precision == Precision::Mixed {
        return Err(SceneError::value(
            "scheme.precision",
            format!("is `mixed`, and `{name}` is computed in `double` alone; leave it out"),
        ));
    }
    if scheme.transport_velocity.at_rest {
        check_rest(problem, name)?;
    }
    Ok(())
}

/// Refuses what particles at rest cannot follow.
fn check_rest<const D: usize>(problem: &Problem<D>, name: &str) -> Result<(), SceneError> {
    let remedy = "take `TV-C` or `L-IPST-C`";
    for (axis, end, ..) in problem.domain.each_side() {
        if problem.domain.opens(axis, end) {
            return Err(SceneError::value(
                side_key(axis, end),
                format!("is open, and the particles of `{name}` stay where they are; {remedy}"),
            ));
        }
    }
    if let Some(body) = problem.bodies.iter().find(|body| body.motion.is_moving()) {
        return Err(SceneError::value(
            format!("body.{}.motion", body.name),
            format!("moves, and the particles of `{name}` stay where they are; {remedy}"),
        ));
    }
    Ok(())
}
