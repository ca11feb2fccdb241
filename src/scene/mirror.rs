//! What a scene with mirrors must satisfy: the stream goes along them.

use super::vector::side_key;
use aero_solver::problem::{AXES, Domain, Side, State};

use super::error::SceneError;

/// A part of the stream that round-off leaves across a mirror.
const ROUND_OFF: f64 = 1e-9;

/// Part of the stream from which on it goes at the mirror, or away from it, rather than along: gas that two halves run into one another with, or part
/// with.
const AT_IT: f64 = 0.71;

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
    use aero_geometry::{Bounds, Vector};

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
}
