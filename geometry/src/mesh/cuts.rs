//! A triangle cut up along the lines in which others cross it or lie on it, into convex pieces that
//! none of them enters.

use super::triangle::normal;
use crate::Vector;

/// Pieces of one triangle at most: one that is crossed everywhere is not cut further.
const MOST: usize = 50_000;

/// The corners of a triangle.
pub(super) type Corners = [Vector<3>; 3];

/// The corners of a convex polygon, in turn.
pub(super) type Polygon = Vec<Vector<3>>;

/// A straight cut, from one point to another.
pub(super) type Cut = [Vector<3>; 2];

/// How another triangle lies to one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Meeting {
    /// They have no line in common.
    Apart,
    /// They cross, or one stands on the other.
    Crossing,
    /// They lie in one plane and face the same way, or opposite ways.
    Flush { alike: bool },
}

/// Adds the lines in which `other` meets the plane of `own`; they may lie beside `own`.
pub(super) fn cuts(
    own: &Corners,
    other: &Corners,
    tolerance: f64,
    found: &mut Vec<Cut>,
) -> Meeting {
    let up = normal(own);
    if up == Vector::<3>::zeros() {
        return Meeting::Apart;
    }
    let height = other.map(|v| (v - own[0]).dot(&up));
    let on = height.map(|h| h.abs() <= tolerance);
    if on == [true; 3] {
        found.extend((0..3).map(|k| [other[k], other[(k + 1) % 3]]));
        let alike = normal(other).dot(&up) > 0.0;
        return Meeting::Flush { alike };
    }
    let mut ends = Vec::with_capacity(2);
    for k in 0..3 {
        let next = (k + 1) % 3;
        if on[k] {
            ends.push(other[k]);
        } else if !on[next] && height[k] * height[next] < 0.0 {
            let part = height[k] / (height[k] - height[next]);
            ends.push(other[k] + part * (other[next] - other[k]));
        }
    }
    match ends[..] {
        [from, to] if (to - from).norm() > tolerance => {
            found.push([from, to]);
            Meeting::Crossing
        }
        _ => Meeting::Apart,
    }
}

/// True where a cut passes through the inside of the triangle.
pub(super) fn is_cut(own: &Corners, cuts: &[Cut], tolerance: f64) -> bool {
    let up = normal(own);
    cuts.iter()
        .any(|cut| split(own, cut, &up, tolerance).is_some())
}

/// The convex pieces of the triangle that no cut enters.
pub(super) fn pieces(own: &Corners, cuts: Vec<Cut>, tolerance: f64) -> Vec<Polygon> {
    let up = normal(own);
    let mut done = Vec::new();
    let mut open = vec![(own.to_vec(), cuts)];
    while let Some((polygon, mut cuts)) = open.pop() {
        let mut halves = None;
        while halves.is_none() && !cuts.is_empty() && done.len() + open.len() < MOST {
            // Cuts come in the order of space: the middle one parts the others best.
            let cut = cuts.swap_remove(cuts.len() / 2);
            halves = split(&polygon, &cut, &up, tolerance).map(|halves| (halves, cut));
        }
        let Some(([left, right], [from, to])) = halves else {
            done.push(polygon);
            continue;
        };
        let across = up.cross(&(to - from)).normalize();
        let beside = |cut: &Cut, side: f64| {
            let farthest = |v: &Vector<3>| side * (v - from).dot(&across);
            cut.iter().any(|v| farthest(v) > tolerance)
        };
        let of_side = |side| cuts.iter().copied().filter(move |cut| beside(cut, side));
        let (of_left, of_right) = (of_side(1.0).collect(), of_side(-1.0).collect());
        open.push((left, of_left));
        open.push((right, of_right));
    }
    done
}

/// The parts of a convex polygon on the left and on the right of the line of a cut; nothing where the
/// cut does not enter it.
fn split(
    polygon: &[Vector<3>],
    [from, to]: &Cut,
    up: &Vector<3>,
    tolerance: f64,
) -> Option<[Polygon; 2]> {
    let along = (to - from).try_normalize(0.0)?;
    let across = up.cross(&along);
    let side: Vec<f64> = polygon.iter().map(|v| (v - from).dot(&across)).collect();
    let most = side.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let least = side.iter().copied().fold(f64::INFINITY, f64::min);
    if most <= tolerance || least >= -tolerance {
        return None;
    }
    let (mut left, mut right, mut on_line) = (Vec::new(), Vec::new(), Vec::new());
    for (k, v) in polygon.iter().enumerate() {
        let next = (k + 1) % polygon.len();
        if side[k].abs() <= tolerance {
            left.push(*v);
            right.push(*v);
            on_line.push(*v);
            continue;
        }
        if side[k] > 0.0 { &mut left } else { &mut right }.push(*v);
        if side[next].abs() > tolerance && side[k] * side[next] < 0.0 {
            let crossing = v + side[k] / (side[k] - side[next]) * (polygon[next] - v);
            left.push(crossing);
            right.push(crossing);
            on_line.push(crossing);
        }
    }
    // How much of the cut is inside of the polygon.
    let place = |v: &Vector<3>| (v - from).dot(&along);
    let places = || on_line.iter().map(place);
    let begin = places().fold(f64::INFINITY, f64::min).max(0.0);
    let end = places()
        .fold(f64::NEG_INFINITY, f64::max)
        .min((to - from).norm());
    (end - begin > tolerance).then_some([left, right])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(x: f64, y: f64, z: f64) -> Vector<3> {
        Vector::<3>::new(x, y, z)
    }

    fn floor() -> Corners {
        [at(0.0, 0.0, 0.0), at(1.0, 0.0, 0.0), at(0.0, 1.0, 0.0)]
    }

    fn area(polygon: &[Vector<3>]) -> f64 {
        (2..polygon.len())
            .map(|k| {
                let (u, v) = (polygon[k - 1] - polygon[0], polygon[k] - polygon[0]);
                0.5 * u.cross(&v).z
            })
            .sum()
    }

    #[test]
    fn pieces_share_the_area_of_the_triangle() {
        let mut found = Vec::new();
        for k in 0..7 {
            let x = 0.1 + 0.1 * f64::from(k);
            let wall = [at(x, -1.0, -1.0), at(x, 0.3, 1.0), at(x + 0.1, 2.0, -1.0)];
            assert_eq!(cuts(&floor(), &wall, 1e-9, &mut found), Meeting::Crossing);
        }
        let tile = [at(0.2, 0.1, 0.0), at(0.1, 0.2, 0.0), at(0.2, 0.2, 0.0)];
        let meeting = cuts(&floor(), &tile, 1e-9, &mut found);
        assert_eq!(meeting, Meeting::Flush { alike: false });
        let pieces = pieces(&floor(), found, 1e-9);
        assert!(pieces.len() > 10, "{}", pieces.len());
        let whole: f64 = pieces.iter().map(|piece| area(piece)).sum();
        assert!((whole - 0.5).abs() < 1e-12, "{whole}");
        assert!(pieces.iter().all(|piece| area(piece) > 0.0));
    }

    #[test]
    fn neighbours_across_an_edge_or_a_corner_cut_nothing() {
        let [a, b, c] = floor();
        for other in [
            [b, a, at(0.3, 0.2, 1.0)],
            [a, at(-1.0, 0.0, 1.0), at(0.0, -1.0, 1.0)],
            [b, a, at(0.3, -1.0, 0.0)],
            [c, b, at(1.0, 1.0, 0.0)],
        ] {
            let mut found = Vec::new();
            cuts(&floor(), &other, 1e-9, &mut found);
            assert!(!is_cut(&floor(), &found, 1e-9), "{other:?}");
        }
    }

    #[test]
    fn a_wall_that_ends_inside_cuts_only_where_it_stands() {
        let wall = [at(0.2, 0.2, 0.0), at(0.2, 0.4, 0.0), at(0.2, 0.3, 1.0)];
        let mut found = Vec::new();
        assert_eq!(cuts(&floor(), &wall, 1e-9, &mut found), Meeting::Crossing);
        assert!(is_cut(&floor(), &found, 1e-9));
        let beside = [at(0.2, 0.9, 0.0), at(0.2, 1.4, 0.0), at(0.2, 1.0, 1.0)];
        found.clear();
        cuts(&floor(), &beside, 1e-9, &mut found);
        assert!(!is_cut(&floor(), &found, 1e-9));
    }
}
