//! What goes with the schemes of liquids alone, and what they cannot do.

use super::error::SceneError;
use super::vector::AXES;
use aero_solver::problem::Problem;
use aero_solver::scheme::Precision;

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
                format!("domain.sides.{}_{}", AXES[axis], ["min", "max"][end]),
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
