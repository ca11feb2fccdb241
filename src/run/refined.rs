//! Points that were to be added where the flow asks for them, and a flow that asked for none.

use aero_packer::{About, Warning};
use aero_solver::Flow;
use aero_solver::method::Refine;

/// What there is to say of the points of `flow`, which may be added where it changes.
pub(super) fn warnings<const D: usize>(flow: &Flow<D>) -> Vec<Warning> {
    let problem = flow.problem();
    let Some(points) = problem.method.fixed() else {
        return Vec::new();
    };
    let counts = flow.points_per_level();
    let finest = counts.iter().rposition(|&count| count > 0).unwrap_or(0);
    if flow.has_refined() || finest >= usize::from(points.refine.of_flow()) {
        return Vec::new();
    }
    let spacing = problem.resolution.lattice() / f64::from(1_u32 << finest);
    let text = unrefined(points.refine, spacing);
    vec![Warning::new(About::Scene, text)]
}

/// Of a flow that has no points added, whose finest are `spacing` apart.
fn unrefined(refine: Refine, spacing: f64) -> String {
    format!(
        "`scheme.refine = {refine}` was asked for, and no point has a smaller spacing than {spacing}: the flow changes too little from cell to cell to get \
         any added; for a finer solution take a smaller `spacing`"
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_asked_for_is_told_as_it_is_written() {
        let apart = Refine::Apart {
            flow: 3,
            bodies: 1,
            bends: 2,
        };
        for (refine, words) in [
            (Refine::Levels(4), "`scheme.refine = 4` was"),
            (
                apart,
                "`scheme.refine = { flow = 3, bodies = 1, bends = 2 }` was",
            ),
            (Refine::Points(9), "`scheme.refine = { points = 9 }` was"),
        ] {
            let told = unrefined(refine, 0.1);
            assert!(
                told.contains(words) && told.contains("spacing than 0.1:"),
                "{told}"
            );
        }
    }
}
