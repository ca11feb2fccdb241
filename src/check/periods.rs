//! Bodies that cross a periodic side: what lies beyond comes in at the other side as a body of its own alone.

use aero_geometry::Vector;
use aero_solver::panels::{Panel, Panels};
use aero_solver::problem::{Body, Problem};

use super::{Check, place, shortened, side_name};

/// Less than this, in spacings, is on a side, and on a surface.
const ON_IT: f64 = 0.02;

/// Corners of panels that a side has cut lie this near to it, in spacings.
const CUT: f64 = 1e-6;

/// Looks at each body at rest that goes on beyond one of two periodic sides. One that goes on beyond both is a wall along them.
pub(super) fn look<const D: usize>(problem: &Problem<D>, panels: &Panels<D>, found: &mut Check) {
    let domain = &problem.domain;
    let sides = domain.each_side();
    for (axis, end, ..) in sides.filter(|(_, _, side, _)| side.is_periodic()) {
        let period = domain.bounds.size()[axis] * [1.0, -1.0][end];
        for (number, body) in problem.bodies.iter().enumerate() {
            if body.motion.is_moving() || !goes_on(problem, body, axis, end) {
                continue;
            }
            if goes_on(problem, body, axis, 1 - end) {
                continue;
            }
            let own = panels.all().iter().filter(|p| p.owner as usize == number);
            let mut crossed = own.flat_map(|panel| cut(problem, panel, axis, end));
            let lacks_copy = |place: &Vector<D>| {
                let mut copy = *place;
                copy[axis] += period;
                let mut shapes = problem.bodies.iter().map(|body| &body.shape);
                shapes.all(|shape| {
                    shape.signed_distance(&copy) > ON_IT * problem.resolution.lattice()
                })
            };
            if let Some(point) = crossed.find(lacks_copy) {
                let mut shift = Vector::<D>::zeros();
                shift[axis] = shortened(period);
                let shift: Vec<String> = shift.iter().map(|x| format!("{x:?}")).collect();
                found.refusals.push(format!(
                    "body `{}`: crosses the periodic side `{}` near {}, and what lies beyond does not come in at `{}`; add a copy of the body \
                     that is moved by [{}], or move body or domain so that it does not cross",
                    body.name,
                    side_name(axis, end),
                    place(&point),
                    side_name(axis, 1 - end),
                    shift.join(", ")
                ));
            }
        }
    }
}

/// True of a body that reaches beyond a side.
fn goes_on<const D: usize>(problem: &Problem<D>, body: &Body<D>, axis: usize, end: usize) -> bool {
    let extent = body.shape.bounds();
    let reaches = |corner: &Vector<D>| {
        problem.domain.depth_within(axis, end, corner) < -ON_IT * problem.resolution.lattice()
    };
    reaches(&extent.min) || reaches(&extent.max)
}

/// Corners of a panel in the domain where a side has cut it.
fn cut<'a, const D: usize>(
    problem: &'a Problem<D>,
    panel: &'a Panel<D>,
    axis: usize,
    end: usize,
) -> impl Iterator<Item = Vector<D>> + 'a {
    let domain = &problem.domain;
    let is_inside = domain.bounds.contains(&panel.centre);
    let corners = panel.corners.iter().filter(move |_| is_inside);
    corners.copied().filter(move |corner| {
        domain.depth_within(axis, end, corner).abs() < CUT * problem.resolution.lattice()
    })
}
