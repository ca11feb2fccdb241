//! Where a stream parts: the height of the nose of a body between open sides. What flows above a nose and what flows below keeps
//! apart from there on, and the first row of particles beside a wall stays as far from it as it came. With rows that lie half a spacing off
//! the nose on either side a symmetric body has no lift, which was a fifth of the drag of a slender aerofoil a third of a spacing off,
//! and a plate at an incidence has its own, which was up to eight per cent less.

use aero_geometry::Vector;

use crate::problem::{Body, Domain, Problem};

/// Planes and boxes are told to this many spacings: round-off of scenes.
const EXACT: f64 = 1e-6;

/// Rows at least between two bodies that rows lie evenly between: they are at most a twentieth nearer or farther than a spacing then.
const ROWS: f64 = 10.0;

/// Steps of the search for a nose; each leaves of the way to it what the square of the sine of its half angle is.
const STEPS: usize = 200;

/// The place on `axis` beside which the rows of the gas of `problem` are to lie, see [`parted`]; none where the stream is not straight across
/// the axis.
pub fn parting<const D: usize>(problem: &Problem<D>, axis: usize) -> Option<f64> {
    let is_straight = problem.free_stream.velocity[axis] == 0.0;
    is_straight.then(|| parted(problem, axis)).flatten()
}

/// The place on `axis` at which bodies part the stream: a plane about which all of them are mirrored, or that of the foremost one, or its
/// nose; none where a side is closed.
pub fn parted<const D: usize>(problem: &Problem<D>, axis: usize) -> Option<f64> {
    let Domain { bounds, sides, .. } = &problem.domain;
    let velocity = &problem.free_stream.velocity;
    let is_free = sides[axis].iter().all(|side| side.is_open());
    let is_finite = |body: &&Body<D>| {
        let size = body.shape.bounds().size();
        size.iter().all(|edge| edge.is_finite())
    };
    let bodies: Vec<&Body<D>> = problem.bodies.iter().filter(is_finite).collect();
    if !is_free || bodies.is_empty() {
        return None;
    }
    let boxes = bodies.iter().map(|body| body.shape.bounds());
    let extent = boxes.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], body| {
        [low.min(body.min[axis]), high.max(body.max[axis])]
    });
    let middles = [[bounds.min[axis], bounds.max[axis]], extent].map(|[a, b]| 0.5 * (a + b));
    let own = bodies.iter().flat_map(|body| planes(body, axis));
    let mut candidates = middles.into_iter().chain(own);
    let has_images = |&plane: &f64| {
        let mut all = bodies.iter();
        all.all(|body| has_image(&bodies, body, (axis, plane), problem.resolution.lattice()))
    };
    candidates.find(has_images).or_else(|| {
        let along = velocity.iamax();
        let ahead =
            |body: &&&Body<D>| face(body, along, velocity[along]) * velocity[along].signum();
        let first = bodies.iter().min_by(|a, b| ahead(a).total_cmp(&ahead(b)))?;
        let plane = planes(first, axis).next();
        plane.or_else(|| {
            nose(
                first,
                (along, velocity[along]),
                problem.resolution.lattice(),
            )
            .map(|nose| nose[axis])
        })
    })
}

/// The two places on `axis` at which two bodies part the stream, where there are two such places, [`ROWS`] rows or more from each other; none
/// otherwise.
pub fn apart<const D: usize>(problem: &Problem<D>, axis: usize) -> Option<[f64; 2]> {
    let along = problem.free_stream.velocity.iamax();
    let stream = (along, problem.free_stream.velocity[along]);
    let mut places: Vec<f64> = Vec::new();
    for body in &problem.bodies {
        let plane = planes(body, axis).next();
        let place = plane
            .or_else(|| nose(body, stream, problem.resolution.lattice()).map(|nose| nose[axis]))?;
        if !places
            .iter()
            .any(|known| (known - place).abs() < EXACT * problem.resolution.lattice())
        {
            places.push(place);
        }
    }
    places.sort_by(f64::total_cmp);
    match places[..] {
        [low, high] if high - low >= ROWS * problem.resolution.lattice() => Some([low, high]),
        _ => None,
    }
}

/// Where a body begins along an axis in a stream of this speed along it.
fn face<const D: usize>(body: &Body<D>, along: usize, speed: f64) -> f64 {
    let bounds = body.shape.bounds();
    if speed < 0.0 {
        bounds.max[along]
    } else {
        bounds.min[along]
    }
}

/// The foremost point of a body in a stream along an axis, in the middle of a blunt face; none where nothing flows.
fn nose<const D: usize>(
    body: &Body<D>,
    (along, speed): (usize, f64),
    spacing: f64,
) -> Option<Vector<D>> {
    let bounds = body.shape.bounds();
    let face = face(body, along, speed);
    let mut place = 0.5 * (bounds.min + bounds.max);
    place[along] = face;
    for _ in 0..STEPS {
        let mut next = body.shape.closest(&place).point;
        next[along] = face;
        let step = (next - place).norm();
        place = next;
        if step < EXACT * spacing {
            break;
        }
    }
    (speed != 0.0).then_some(place)
}

/// The planes across `axis` about which a body is its own mirror image.
fn planes<const D: usize>(body: &Body<D>, axis: usize) -> impl Iterator<Item = f64> + use<D> {
    let all = body.shape.mirror_planes().into_iter();
    all.filter(move |&(k, _)| k == axis).map(|(_, plane)| plane)
}

/// True of a body that is its own mirror image, or has its like beyond the plane.
fn has_image<const D: usize>(
    bodies: &[&Body<D>],
    body: &Body<D>,
    (axis, plane): (usize, f64),
    spacing: f64,
) -> bool {
    let near = |a: f64, b: f64| (a - b).abs() < EXACT * spacing;
    let own = body.shape.bounds();
    let is_like = |other: &&&Body<D>| {
        let other = other.shape.bounds();
        (0..D).all(|k| {
            let [low, high] = if k == axis {
                [2.0 * plane - other.max[k], 2.0 * plane - other.min[k]]
            } else {
                [other.min[k], other.max[k]]
            };
            near(own.min[k], low) && near(own.max[k], high)
        })
    };
    let mut others = bodies.iter().filter(|other| !std::ptr::eq(**other, body));
    planes(body, axis).any(|own| near(own, plane)) || others.any(|other| is_like(&other))
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use aero_geometry::{Placed, Placement, Shape, Vector, bodies};

    use super::*;
    use crate::problem::Side;
    use crate::sides::Rows;

    /// Diamonds of these half heights in a stream, their noses at these places.
    fn flight(noses: &[([f64; 2], [f64; 2])]) -> Problem<2> {
        let mut problem = crate::tests::cube::<2>(20, Side::FreeStream);
        problem.free_stream.velocity[0] = 2.0;
        problem.domain.sides[0] = [Side::Inlet, Side::Outlet];
        for &(nose, [below, above]) in noses {
            let points = [[0.0, 0.0], [0.3, -below], [0.6, 0.0], [0.3, above]];
            let diamond = bodies::polygon(&points.map(Vector::<2>::from)).expect("a diamond");
            let place = Placement::default().moved(Vector::<2>::from(nose));
            let shape: Arc<dyn Shape<2>> = Arc::new(Placed::new(diamond, place));
            problem.bodies.push(crate::tests::slip_body(shape));
        }
        problem
    }

    const EVEN: [f64; 2] = [0.1, 0.1];

    fn is_beside(rows: &Rows<2>, plane: f64) -> bool {
        let steps = (plane - rows.position(&[0, 0], &Vector::zeros())[1]) / rows.pitch(1);
        ((steps - 0.5) - (steps - 0.5).round()).abs() < 1e-6
    }

    #[test]
    fn rows_lie_beside_the_plane_of_a_body_wherever_that_is() {
        for off in [0.0, 0.021, 0.036, 0.05, 0.087] {
            let rows = Rows::new(&flight(&[([0.6, 1.0 + off], EVEN)]));
            assert!(is_beside(&rows, 1.0 + off), "{off}");
            assert!(rows.position(&[0, 0], &Vector::zeros())[1] < 0.05 + 1e-9);
        }
    }

    #[test]
    fn rows_are_mirrored_about_the_plane_between_two_bodies() {
        let pair = flight(&[([0.6, 0.613], EVEN), ([0.6, 1.38], EVEN)]);
        assert!(is_beside(&Rows::new(&pair), 0.5 * (0.613 + 1.38)));
        let leaning = [([0.6, 0.613], [0.02, 0.1]), ([0.6, 1.38], [0.1, 0.02])];
        assert!(is_beside(
            &Rows::new(&flight(&leaning)),
            0.5 * (0.613 + 1.38)
        ));
    }

    #[test]
    fn rows_lie_beside_the_planes_of_two_bodies() {
        for high in [1.58, 1.61, 1.644] {
            let pair = flight(&[([0.6, 0.413], EVEN), ([0.7, high], EVEN)]);
            let rows = Rows::new(&pair);
            assert!(is_beside(&rows, 0.413) && is_beside(&rows, high), "{high}");
            assert!((rows.pitch(1) / pair.resolution.lattice() - 1.0).abs() < 0.05);
        }
        // Too near to each other: the foremost has them.
        let near = flight(&[([0.6, 0.613], EVEN), ([0.7, 0.84], EVEN)]);
        assert!(is_beside(&Rows::new(&near), 0.613));
        assert_eq!(Rows::new(&near).pitch(1), near.resolution.lattice());
    }

    #[test]
    fn of_bodies_that_are_no_images_the_foremost_has_the_rows_beside_its_plane_or_its_nose() {
        let odd = [([0.6, 1.313], [0.05, 0.1]), ([0.5, 0.622], EVEN)];
        assert!(is_beside(&Rows::new(&flight(&odd)), 0.622));
        let behind = [([0.6, 1.313], [0.05, 0.1]), ([0.7, 0.622], EVEN)];
        assert!(is_beside(&Rows::new(&flight(&behind)), 1.313));
    }

    #[test]
    fn a_stream_through_the_plane_and_bodies_that_never_end_leave_the_rows_where_they_are() {
        let mut inclined = flight(&[([0.6, 1.031], EVEN)]);
        inclined.free_stream.velocity[1] = 0.1;
        assert_eq!(parting(&inclined, 1), None);
        let mut endless = flight(&[([0.6, 1.031], EVEN)]);
        let corner = bodies::compression_corner(0.3, 20.0);
        endless.bodies[0].shape = Arc::new(corner.expect("a corner"));
        assert_eq!(parting(&endless, 1), None);
    }
}
