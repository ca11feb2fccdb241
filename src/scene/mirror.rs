//! What a scene with mirrors must satisfy: the stream goes along them, and so do the bodies that they cut.

use aero_geometry::Bounds;

use super::vector::side_key;
use aero_solver::problem::{AXES, Domain, Motion, Side, State};

use super::error::SceneError;

/// A part of the stream that round-off leaves across a mirror.
const ROUND_OFF: f64 = 1e-9;

/// Part of the stream from which on it goes at the mirror, or away from it, rather than along: gas that two halves run into one another with, or part
/// with.
const AT_IT: f64 = 0.71;

/// Part of a body's length that rounding may put beyond a mirror.
const ROUNDED: f64 = 1e-9;

/// Refuses a body that a mirror cuts and that moves through it: what is beyond it would go the other way.
pub(super) fn check_motion<const D: usize>(
    name: &str,
    domain: &Domain<D>,
    extent: &Bounds<D>,
    motion: &Motion<D>,
) -> Result<(), SceneError> {
    let crossed = domain.each_side().find(|&(axis, _, side, plane)| {
        let slack = ROUNDED * extent.size().norm();
        let is_cut = extent.min[axis] < plane - slack && plane + slack < extent.max[axis];
        side == Side::Symmetry && is_cut && !motion.keeps(axis)
    });
    let Some((axis, end, ..)) = crossed else {
        return Ok(());
    };
    let side = side_key(axis, end);
    let letter = AXES[axis];
    let turning = if D == 2 {
        "not turn".to_owned()
    } else {
        format!("turn about {letter} alone")
    };
    Err(SceneError::value(
        format!("body.{name}.motion"),
        format!(
            "goes through the mirror at {side}, which cuts the body: its other half would go the other way, and part from it or run into it; let it \
             move along the mirror ({letter} of `velocity` and `acceleration` 0) and {turning}, or give the domain and the body both sides of \
             the plane"
        ),
    ))
}

/// Refuses a mirror that the free stream goes along and through, where the gas starts in it or it comes in somewhere.
pub(super) fn check<const D: usize>(
    domain: &Domain<D>,
    free_stream: &State<D>,
    starts_in_it: bool,
) -> Result<(), SceneError> {
    if !starts_in_it && !comes_in(domain) {
        return Ok(());
    }
    let velocity = &free_stream.velocity;
    let [least, most] = [ROUND_OFF, AT_IT].map(|part| part * velocity.norm());
    for (k, letter) in AXES.into_iter().enumerate().take(D) {
        for end in 0..2 {
            let through = velocity[k].abs();
            if domain.sides[k][end] == Side::Symmetry && through > least && through < most {
                return Err(SceneError::value(
                    side_key(k, end),
                    format!(
                        "is a mirror, but the free stream goes through it at a speed of {:.4} along {letter}; make it \"free-stream\", with a \
                         domain and bodies on both sides of it, or turn the stream along it (free_stream.direction, incidence, sideslip)",
                        velocity[k]
                    ),
                ));
            }
        }
    }
    Ok(())
}

/// True where gas of the free stream comes in, by a side or a part of one.
fn comes_in<const D: usize>(domain: &Domain<D>) -> bool {
    let has_gas_of_its_own = |axis: usize, end: usize| {
        domain.openings.iter().any(|opening| {
            (opening.axis, opening.end) == (axis, end)
                && opening.part.is_none()
                && opening.given.is_some()
        })
    };
    let by_a_side = (0..D)
        .any(|k| (0..2).any(|end| domain.sides[k][end].lets_in() && !has_gas_of_its_own(k, end)));
    by_a_side
        || domain.openings.iter().any(|opening| {
            opening.part.is_some() && opening.given.is_none() && opening.side.lets_in()
        })
}

#[cfg(test)]
mod tests {
    use aero_geometry::Vector;
    use aero_solver::problem::Turning;
    use nalgebra::Vector3;

    use super::*;

    fn refusal(velocity: [f64; 2], y_max: Side, starts_in_it: bool) -> Option<String> {
        let domain = Domain {
            bounds: Bounds::new(Vector::<2>::zeros(), Vector::<2>::new(1.0, 1.0)),
            sides: [[Side::Outlet; 2], [Side::Symmetry, y_max]],
            openings: Vec::new(),
        };
        let stream = State {
            density: 1.0,
            velocity: Vector::<2>::from(velocity),
            pressure: 1.0,
        };
        let found = check(&domain, &stream, starts_in_it);
        found.err().map(|error| error.to_string())
    }

    #[test]
    fn a_stream_through_a_mirror_is_refused_where_it_is_in_the_domain() {
        let through = [1.0, 0.1];
        for refused in [
            refusal(through, Side::FreeStream, false),
            refusal(through, Side::WALL, true),
        ] {
            let refused = refused.expect("a refusal");
            assert!(refused.contains("y_min") && refused.contains("is a mirror"));
        }
        assert_eq!(refusal(through, Side::WALL, false), None);
        assert_eq!(refusal([1.0, 1e-12], Side::FreeStream, true), None);
        // Gas that meets its image, or parts from it.
        for speed in [-0.6, 0.6] {
            assert_eq!(refusal([0.0, speed], Side::FreeStream, true), None);
        }
    }

    #[test]
    fn a_body_that_a_mirror_cuts_moves_along_it() {
        let domain = Domain {
            bounds: Bounds::new(Vector::<3>::zeros(), Vector::<3>::new(1.0, 1.0, 1.0)),
            sides: [
                [Side::Outlet; 2],
                [Side::Outlet; 2],
                [Side::Symmetry, Side::Outlet],
            ],
            openings: Vec::new(),
        };
        let refusal = |velocity: [f64; 3], rate: [f64; 3], lowest: f64| {
            let extent = Bounds::new(
                Vector::<3>::new(0.2, 0.2, lowest),
                Vector::<3>::new(0.6, 0.6, 0.3),
            );
            let motion = Motion {
                velocity: velocity.into(),
                acceleration: Vector::<3>::zeros(),
                turning: Turning::Steady(Vector3::from(rate)),
                pivot: Vector::<3>::zeros(),
                free: None,
            };
            let found = check_motion("wing", &domain, &extent, &motion);
            found.err().map(|error| error.to_string())
        };
        let (still, up) = ([0.0; 3], [0.0, 0.0, 1.0]);
        let through = refusal(up, still, -0.3).expect("a refusal");
        for word in ["body.wing.motion", "z_min", "z of `velocity`"] {
            assert!(through.contains(word), "{through}");
        }
        assert!(refusal(still, [1.0, 0.0, 0.0], -0.3).is_some());
        assert_eq!(refusal([1.0, 1.0, 0.0], up, -0.3), None);
        // Two bodies that part, and one that comes to the mirror.
        assert_eq!(refusal(up, still, 0.0), None);
        assert_eq!(refusal(up, still, 0.1), None);
    }
}
