//! Vectors of any width round as plain numbers do: the bits are the same.

use std::sync::Arc;

use aero_geometry::bodies;

use super::flows::stream;
use crate::fixed::FixedSimulation;
use crate::problem::{Side, WallKind};
use crate::vectors::avx2;

/// The state of all cells after some steps of a stream over a corner below a wall, in these vectors.
fn bits(arch: pulp::Arch, is_settled: bool) -> Vec<u64> {
    let corner = Arc::new(bodies::expansion_corner(0.0, 15.0).expect("a corner"));
    let mut problem = stream(1.4, [[-0.3, -0.4], [0.6, 0.5]], 0.05, vec![corner]);
    problem.domain.sides[1] = [
        Side::Body,
        Side::Wall {
            kind: WallKind::Slip,
            velocity: 0.0,
            acceleration: 0.0,
        },
    ];
    let mut flow = FixedSimulation::new(problem).expect("the problem is sound");
    flow.arch = arch;
    for _ in 0..8 {
        if is_settled {
            flow.settle_step().expect("the flow is tame");
        } else {
            flow.step(f64::INFINITY).expect("the flow is tame");
        }
    }
    let states = flow.columns.states.iter();
    let numbers = states.flat_map(|state| {
        let [u, v] = state.velocity;
        [state.density, u, v, state.pressure]
    });
    numbers.map(f64::to_bits).collect()
}

#[test]
fn vectors_of_any_width_give_the_same_bits() {
    for is_settled in [false, true] {
        let plain = bits(pulp::Arch::Scalar, is_settled);
        assert!(plain == bits(avx2().unwrap_or_default(), is_settled));
    }
}
