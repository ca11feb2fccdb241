//! Bodies that overlap.

use aero_geometry::Vector;
use aero_packer::{About, Warning};
use aero_solver::problem::{Body, Problem};

use super::{Check, place};

/// Points looked at along each axis of what the boxes of two bodies share.
const ACROSS: usize = 24;

/// Deeper than this, in spacings, in both is an overlap.
const DEEP: f64 = 0.5;

/// Looks at each pair of bodies.
pub(super) fn look<const D: usize>(problem: &Problem<D>, found: &mut Check) {
    for (number, body) in problem.bodies.iter().enumerate() {
        for other in &problem.bodies[..number] {
            let Some(point) = shared(problem, body, other) else {
                continue;
            };
            let [a, b] = [&other.name, &body.name];
            if body.motion.is_moving() || other.motion.is_moving() {
                found.refusals.push(format!(
                    "bodies `{a}` and `{b}`: pass through one another near {} and move: ghosts of both would \
                     fill the same place; move them apart, or make one body of them",
                    place(&point)
                ));
            } else {
                found.warnings.push(Warning::new(About::Scene, format!(
                    "bodies `{a}` and `{b}` overlap near {}: they count as one solid, and each has the load on what is \
                     left of its own surface",
                    place(&point)
                )));
            }
        }
    }
}

/// A point deep in both.
fn shared<const D: usize>(problem: &Problem<D>, a: &Body<D>, b: &Body<D>) -> Option<Vector<D>> {
    let bounds = a.shape.bounds().intersection(&b.shape.bounds());
    let bounds = bounds.intersection(&problem.domain.bounds);
    if bounds.is_empty() {
        return None;
    }
    let deepest = -DEEP * problem.resolution.lattice();
    (0..ACROSS.pow(D as u32)).find_map(|number| {
        let mut rest = number;
        let point = Vector::<D>::from_fn(|k, _| {
            let part = ((rest % ACROSS) as f64 + 0.5) / ACROSS as f64;
            rest /= ACROSS;
            bounds.min[k] + part * bounds.size()[k]
        });
        let is_in = |body: &Body<D>| body.shape.signed_distance(&point) < deepest;
        (is_in(a) && is_in(b)).then_some(point)
    })
}
