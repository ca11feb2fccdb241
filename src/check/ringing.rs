//! Liquids whose pressure nothing damps, beside walls that they stick to.

use aero_packer::{About, Warning};
use aero_solver::problem::{Problem, Side};
use aero_solver::scheme::Damping;

use super::Check;

/// Looks at scheme and walls.
pub(super) fn look<const D: usize>(problem: &Problem<D>, found: &mut Check) {
    let scheme = &problem.scheme;
    if !scheme.is_of_liquids() || scheme.operators.damping != Damping::None {
        return;
    }
    let sticks = |side: Side| matches!(side, Side::Wall { kind, .. } if kind.sticks());
    if problem.domain.has(sticks) || problem.bodies.iter().any(|body| body.wall.sticks()) {
        let text = format!(
            "`{}` does not damp pressure, which may ring beside walls that the liquid sticks to until the flow is lost; take `PE-IPST-C`",
            scheme.name
        );
        found.warnings.push(Warning::new(About::Scene, text));
    }
}
