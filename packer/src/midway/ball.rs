//! How thick a body is at a place of its surface: the largest ball inside that touches it there, and the way straight through.

use aero_geometry::{Shape, Vector};

/// A ball is as large as it can be to this part of its radius.
const EXACT: f64 = 1e-3;

/// Balls shrink to their size in two to four steps.
const SHRINKS: usize = 16;

/// Steps of a climb.
const CLIMBS: usize = 16;

/// First step of a climb, in spacings.
const FIRST_CLIMB: f64 = 0.25;

/// A climb ends where its steps are this small, in spacings.
const LAST_CLIMB: f64 = 0.01;

/// Radius of the largest ball that touches the surface at `foot` from inside, of radius `largest` at most: it shrinks until no
/// part of the surface is inside of it [Ma, Bae & Choi 2012, Vis. Comput. 28, 7].
pub(super) fn ball<const D: usize>(
    shape: &dyn Shape<D>,
    (foot, normal): (Vector<D>, Vector<D>),
    largest: f64,
) -> f64 {
    let mut radius = largest;
    for _ in 0..SHRINKS {
        let centre = foot - radius * normal;
        let seen = shape.closest(&centre);
        let is_free = seen.distance < 0.0 && -seen.distance >= radius * (1.0 - EXACT);
        let chord = foot - seen.point;
        let height = chord.dot(&normal);
        if is_free || height <= 0.0 {
            break;
        }
        // The ball through both places that touches the surface at the first.
        let smaller = 0.5 * chord.norm_squared() / height;
        if smaller >= radius * (1.0 - EXACT) {
            break;
        }
        radius = smaller;
    }
    radius
}

/// Centre and radius of the ball around the deepest place that is reached from `start`, on the surface or inside, by going away from the nearest surface as long as that
/// does not lead nearer to another: from the rim of a plate to its middle, but not up a wedge.
pub(super) fn climbed<const D: usize>(
    shape: &dyn Shape<D>,
    start: &Vector<D>,
    (spacing, largest): (f64, f64),
) -> (Vector<D>, f64) {
    let mut step = FIRST_CLIMB * spacing;
    let mut here = *start;
    let mut seen = shape.closest(&here);
    for _ in 0..CLIMBS {
        if step < LAST_CLIMB * spacing || -seen.distance >= largest {
            break;
        }
        let next = here - step * seen.normal;
        let there = shape.closest(&next);
        if there.distance <= seen.distance + 1e-6 * step {
            (here, seen) = (next, there);
        } else {
            step *= 0.5;
        }
    }
    let radius = ball(shape, (seen.point, seen.normal), largest);
    (seen.point - radius * seen.normal, radius)
}

/// How far below the surface, in spacings, a chord begins that is told at once: by more than round-off.
const JUST_BELOW: f64 = 1e-6;

/// And how far one that is found step by step.
const BELOW: f64 = 0.02;

/// The end of a chord is found to this many spacings.
const AT_THE_END: f64 = 1e-3;

/// Steps along a chord; one along a wall takes many and is taken for long.
const CHORD_STEPS: usize = 48;

/// Length of the way from a place of the surface straight through the body; none where it is longer than `longest`.
pub(crate) fn chord<const D: usize>(
    shape: &dyn Shape<D>,
    (point, normal): (&Vector<D>, &Vector<D>),
    longest: f64,
    spacing: f64,
) -> Option<f64> {
    let inside = point - JUST_BELOW * spacing * normal;
    if let Some(way) = shape.way_out(&inside, &-normal) {
        let whole = way.max(AT_THE_END * spacing);
        return (whole < longest).then_some(whole);
    }
    let mut travelled = BELOW * spacing;
    for _ in 0..CHORD_STEPS {
        let room = -shape.signed_distance(&(point - travelled * normal));
        travelled += room;
        if travelled >= longest {
            return None;
        }
        if room < AT_THE_END * spacing {
            return Some(travelled.max(AT_THE_END * spacing));
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use aero_geometry::bodies;

    use super::*;

    #[test]
    fn a_ball_in_a_plate_is_as_wide_as_the_plate_from_its_rim_too() {
        let plate = bodies::cuboid([20.0, 20.0, 0.6]).expect("a plate");
        for start in [
            Vector::<3>::new(3.0, 1.0, 0.3),
            Vector::<3>::new(10.0, 1.0, 0.1),
            Vector::<3>::new(10.0, 10.0, 0.29),
        ] {
            let (centre, found) = climbed(&plate, &start, (1.0, 2.0));
            assert!((found - 0.3).abs() < 1e-3, "{found}");
            assert!(centre[2].abs() < 1e-3, "{centre}");
        }
    }

    #[test]
    fn the_ball_at_the_tip_of_a_cone_stays_there() {
        let cone = bodies::cone(15.0, 10.0).expect("a cone");
        let start = Vector::<3>::new(1.0, 15_f64.to_radians().tan(), 0.0);
        let (_, found) = climbed(&cone, &start, (1.0, 2.0));
        assert!(found < 0.35, "{found}");
    }
}
