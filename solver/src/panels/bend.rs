//! Gas presses a round wall with more than its pressure.
//!
//! Its kernels reach over the wall's horizon: more than half of a kernel about a place on a convex wall is gas, by `e`, what lies between
//! the surface and the plane that touches it there, and the force per area of an even pressure `p` is `p (1 + 2 e)`: 1 + 0.4 / R where the
//! wall bends in one direction with a radius of R spacings, twice that on a sphere; on a hollow wall it is less by as much. It is the
//! tension of a layer of gas that feels fewer neighbours along the wall than elsewhere, as that of a liquid's surface raises the pressure
//! in a drop, and it comes to nothing all around a body in gas at rest. It is no pressure.

use aero_geometry::kernel::{QuinticSpline, SUPPORT};
use aero_geometry::parallel::prelude::*;
use aero_geometry::{Pencils, Vector};

use super::seen::Seen;

/// Part of a kernel between the surface and the plane that touches it at each of the `panels`, which `grid` sorts; negative where the
/// surface is hollow. The kernel of a panel is as wide as `reach` says, none where no gas is; those of images count as nothing.
pub fn bends<const D: usize>(
    panels: &[Seen<D>],
    grid: &Pencils<D>,
    reach: impl Fn(&Seen<D>) -> Option<f64> + Sync,
) -> Vec<f64> {
    let bend = |at: &Seen<D>| {
        let reach = reach(at).filter(|_| !at.is_image)?;
        let mut beyond = 0.0;
        grid.for_each_run_near(&at.centre, &at.centre, reach, |run| {
            let run = grid.order()[run].iter().map(|&n| &panels[n as usize]);
            beyond += run.map(|other| between(at, other, reach)).sum::<f64>();
        });
        Some(beyond)
    };
    panels
        .par_iter()
        .map(|at| bend(at).unwrap_or(0.0))
        .collect()
}

/// The part of it over `other`.
fn between<const D: usize>(at: &Seen<D>, other: &Seen<D>, reach: f64) -> f64 {
    if !at.bends_on_to(other) {
        return 0.0;
    }
    let arm: Vector<D> = other.centre - at.centre;
    let kernel = QuinticSpline::<D>::value(arm.norm(), reach / SUPPORT);
    -arm.dot(&at.normal) * at.normal.dot(&other.normal) * other.size * kernel
}
