//! What lies on the far side of a body: from a ghost straight through to the opposite face.

use aero_geometry::{Closest, Shape, Vector};

/// Two faces look apart where the cosine of the angle between their normals is below this: the tip that they
/// form is sharper than 60 degrees. Wider corners are corners, not thin parts.
const APART: f64 = -0.5;

/// The exit of a ray is found to this many spacings.
const TOLERANCE: f64 = 1e-3;

/// Steps of a ray; one along a wall takes many and finds no exit.
const RAY_STEPS: usize = 60;

/// A foot is found to this many spacings: what is seen from it decides by where it lies, and is to be its own mirror image where
/// the body is.
const FOOT_TOLERANCE: f64 = 1e-9;

/// Steps of the search for a foot; on a flat face one is enough.
const FOOT_STEPS: usize = 20;

/// How far above the face, in spacings, the search for a foot looks.
const LIFT: f64 = 0.5;

/// Depth, in spacings, at which an edge shows by its lack of solid below.
const PROBE: f64 = 0.05;

/// Part of the probe's depth that may be lacking: a bend of about ten degrees.
const LACKING: f64 = 0.02;

/// So far over the surface, in spacings, the way to it is known.
const OVER: f64 = 0.05;

/// So near, in spacings, to where the two faces of a part meet its tip begins, however slender the part is.
const TIP: f64 = 0.25;

/// The plane that touches a face at the foot of a point.
#[derive(Clone, Copy, Debug)]
pub struct Foot<const D: usize> {
    /// Point of the face nearest to the one asked for.
    pub point: Vector<D>,
    /// Unit normal there, into the gas.
    pub normal: Vector<D>,
    /// Number of the smooth part of the surface.
    pub face: u32,
}

impl<const D: usize> Foot<D> {
    /// Depth of `point` below the plane.
    pub fn depth(&self, point: &Vector<D>) -> f64 {
        (self.point - point).dot(&self.normal)
    }

    /// Mirror image of `point` in the plane.
    pub fn reflected(&self, point: &Vector<D>) -> Vector<D> {
        point + self.normal * (2.0 * self.depth(point))
    }

    /// Mirror image of the plane in another one.
    #[must_use]
    pub fn reflected_in(&self, plane: &Self) -> Self {
        let normal = self.normal - plane.normal * (2.0 * self.normal.dot(&plane.normal));
        Self {
            point: plane.reflected(&self.point),
            normal,
            face: self.face,
        }
    }
}

/// The faces on both sides of a ghost in a thin part.
#[derive(Clone, Copy, Debug)]
pub struct Across<const D: usize> {
    /// Number of the ghost in its body.
    pub ghost: usize,
    /// The face that it belongs to.
    pub near: Foot<D>,
    /// The opposite face, as the ray finds it.
    pub far: Foot<D>,
    /// True where `far` is the ghost's foot on the opposite face, which then is not too bent to have one.
    pub has_foot: bool,
    /// False for a ghost that belongs to a third face, at the end of the part: the gas before that one sees it.
    pub is_own: bool,
}

/// Looks from `point`, a depth below the surface whose normal is `normal`, through the body to the opposite
/// face; none where `point` lies deeper than `limit` below it or where the opposite side is no opposite face.
pub fn across<const D: usize>(
    shape: &dyn Shape<D>,
    (ghost, point, normal, depth): (usize, Vector<D>, Vector<D>, f64),
    limit: f64,
    spacing: f64,
) -> Option<Across<D>> {
    // A ray may be oblique to the far side.
    let exit = exit(shape, &point, &-normal, 2.0 * limit, TOLERANCE * spacing)?;
    let beyond = shape.closest(&exit);
    let guess = Foot::of(&beyond);
    if beyond.normal.dot(&normal) > APART || guess.depth(&point) > limit {
        return None;
    }
    let surface = point + normal * depth;
    let near = Foot {
        point: surface,
        normal,
        face: shape.closest(&(surface + normal * (PROBE * spacing))).face,
    };
    let found = foot_on(shape, &point, &guess, spacing);
    Some(Across {
        ghost,
        near,
        far: found.unwrap_or(guess),
        has_foot: found.is_some(),
        is_own: true,
    })
}

/// As [`across`] for a ghost of the face in which a thin part ends: looks along `normal`, that of the part beside it, both ways.
pub fn across_end<const D: usize>(
    shape: &dyn Shape<D>,
    (ghost, point, normal): (usize, Vector<D>, Vector<D>),
    limit: f64,
    spacing: f64,
) -> Option<Across<D>> {
    let foot = |way: Vector<D>| {
        let exit = exit(shape, &point, &way, limit, TOLERANCE * spacing)?;
        let seen = shape.closest(&exit);
        let found = foot_on(shape, &point, &Foot::of(&seen), spacing)?;
        (found.normal.dot(&way) > -APART).then_some(found)
    };
    let (near, far) = (foot(normal)?, foot(-normal)?);
    (near.depth(&point) + far.depth(&point) <= limit).then_some(Across {
        ghost,
        near,
        far,
        has_foot: true,
        is_own: false,
    })
}

/// Where the ray from `from` leaves the body; steps as long as the distance to the surface never leave it.
fn exit<const D: usize>(
    shape: &dyn Shape<D>,
    from: &Vector<D>,
    direction: &Vector<D>,
    limit: f64,
    tolerance: f64,
) -> Option<Vector<D>> {
    // The first step, from next to the wall, must not take the near face for the far one.
    let mut travelled = 0.0;
    for _ in 0..RAY_STEPS {
        let here = from + direction * travelled;
        let room = -shape.signed_distance(&here);
        if room < tolerance && travelled > 0.0 {
            return Some(here);
        }
        travelled += room.max(tolerance);
        if travelled > limit {
            return None;
        }
    }
    None
}

/// The foot of `point` on the face that `guess` touches nearby: where the nearest point of the surface, seen from
/// above it on the line from `point`, lies on that line. None where the face is so bent that `point` lies beyond
/// its centre of curvature, or at an edge.
pub fn foot_on<const D: usize>(
    shape: &dyn Shape<D>,
    point: &Vector<D>,
    guess: &Foot<D>,
    spacing: f64,
) -> Option<Foot<D>> {
    let lift = LIFT * spacing;
    let mut direction = guess.normal;
    let mut depth = guess.depth(point);
    let mut found = None;
    for _ in 0..FOOT_STEPS {
        let above = point + direction * (depth + lift);
        let seen = shape.closest(&above);
        if seen.distance <= 0.0 || seen.normal.dot(&guess.normal) < -APART {
            return None;
        }
        let arm = seen.point - point;
        // On a mesh the normal is that of the smooth surface that it stands for, and leans on its long facets.
        direction = (above - seen.point) / seen.distance;
        depth = arm.dot(&direction);
        let off = (arm - direction * depth).norm();
        if off < TOLERANCE * spacing {
            found = Some(seen);
        }
        if off < FOOT_TOLERANCE * spacing {
            break;
        }
    }
    let seen = found?;
    (!is_edge(shape, &seen, spacing)).then(|| Foot::of(&seen))
}

/// The point of the surface closest to `point`, with the way from it to `point` for a normal where that is known: over an edge between
/// two facets of a mesh it lies between their normals, while rounding decides which of them the mesh tells of.
pub fn beneath<const D: usize>(
    shape: &dyn Shape<D>,
    point: &Vector<D>,
    spacing: f64,
) -> Closest<D> {
    let mut seen = shape.closest(point);
    if seen.distance > OVER * spacing {
        seen.normal = (point - seen.point) / seen.distance;
    }
    seen
}

/// True where the closest point lies on an edge: the solid below it is shallower than below a smooth surface, and that not because it
/// is thin there. A slender part is thinner than the probe far from its tip, and still has two faces.
pub fn is_edge<const D: usize>(shape: &dyn Shape<D>, seen: &Closest<D>, spacing: f64) -> bool {
    let depth = PROBE * spacing;
    let below = shape.closest(&(seen.point - seen.normal * depth));
    if below.distance <= -depth * (1.0 - LACKING) {
        return false;
    }
    // Both faces lean towards where they meet by what their normals have in common.
    let thickness = depth - below.distance;
    let lean = (seen.normal + below.normal).norm();
    below.normal.dot(&seen.normal) > APART || thickness <= lean * TIP * spacing
}

impl<const D: usize> Foot<D> {
    /// Where a point was seen to be closest.
    pub fn of(seen: &Closest<D>) -> Self {
        Self {
            point: seen.point,
            normal: seen.normal,
            face: seen.face,
        }
    }
}

#[cfg(test)]
mod tests {
    use aero_geometry::{Mesh, bodies};

    use super::*;

    /// A wedge of this half angle, degrees, from the origin on, ten long.
    fn wedge(half_angle: f64) -> impl Shape<2> {
        let half = 10.0 * half_angle.to_radians().tan();
        let points = [[0.0, 0.0], [10.0, -half], [10.0, half]];
        bodies::polygon(&points.map(Vector::<2>::from)).unwrap()
    }

    /// What a place `along` the upper face of the wedge and half a spacing above it sees.
    fn is_tip(half_angle: f64, along: f64) -> bool {
        let shape = wedge(half_angle);
        let (sine, cosine) = half_angle.to_radians().sin_cos();
        let above = Vector::<2>::new(along * cosine - 0.5 * sine, along * sine + 0.5 * cosine);
        let seen = shape.closest(&above);
        assert!((seen.distance - 0.5).abs() < 1e-9, "{seen:?}");
        is_edge(&shape, &seen, 1.0)
    }

    #[test]
    fn over_an_edge_between_two_facets_the_way_to_it_is_seen() {
        let facets = bodies::cone(15.0, 1.0).unwrap().tessellate(24);
        let shape = Mesh::from_facets(facets).unwrap();
        let straight = Vector::<3>::new(
            -15.0_f64.to_radians().sin(),
            15.0_f64.to_radians().cos(),
            0.0,
        );
        let edge = Vector::<3>::new(0.5, 0.5 * 15.0_f64.to_radians().tan(), 0.0);
        for aside in [-1e-9, 0.0, 1e-9] {
            let above = edge + straight * 0.1 + Vector::<3>::z() * aside;
            let seen = beneath(&shape, &above, 0.1);
            assert!((seen.normal - straight).norm() < 1e-6, "{aside}: {seen:?}");
        }
    }

    /// A plate of 0.3 spacings with edges of seven is thinner than the probe over two spacings at its tips.
    #[test]
    fn a_tip_is_a_quarter_of_a_spacing_long_however_slender() {
        for half_angle in [0.1, 1.2, 5.0] {
            for (along, expected) in [(0.01, true), (0.24, true), (0.26, false), (2.0, false)] {
                let found = is_tip(half_angle, along);
                assert_eq!(
                    found, expected,
                    "{half_angle} degrees, {along} from the tip"
                );
            }
        }
    }

    #[test]
    fn a_blunt_tip_is_as_long_as_the_probe_lacks_solid() {
        for half_angle in [15.0, 25.0] {
            let length = PROBE / f64::to_radians(half_angle).tan();
            assert!(is_tip(half_angle, 0.9 * length) && !is_tip(half_angle, 1.1 * length));
        }
    }

    #[test]
    fn what_is_ahead_of_a_tip_sees_an_edge() {
        for half_angle in [0.1, 1.2, 15.0, 45.0] {
            let shape = wedge(half_angle);
            // All around as far as the planes across both faces.
            for part in [-0.99, -0.6, 0.0, 0.3, 0.99] {
                let angle = std::f64::consts::PI - part * (90.0 - half_angle).to_radians();
                let ahead = Vector::<2>::new(angle.cos(), angle.sin()) * 0.4;
                let seen = shape.closest(&ahead);
                assert!(is_edge(&shape, &seen, 1.0), "{half_angle} degrees, {part}");
            }
        }
    }
}
