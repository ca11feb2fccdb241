//! Finding where pieces of an outline cross, touch or overlap.

use super::piece::{Arc, Line, Piece, cross};
use crate::Vector;

/// A point that both pieces share, apart from within `near` of the points in `allowed`.
pub(crate) fn meeting(
    a: &Piece,
    b: &Piece,
    allowed: &[Vector<2>],
    tolerance: f64,
) -> Option<Vector<2>> {
    let mut points: [Option<Vector<2>>; 4] = [None; 4];
    match (a, b) {
        (Piece::Line(a), Piece::Line(b)) => points[0] = line_line(a, b, tolerance),
        (Piece::Line(line), Piece::Arc(arc)) | (Piece::Arc(arc), Piece::Line(line)) => {
            points[..2].copy_from_slice(&line_arc(line, arc, tolerance));
        }
        (Piece::Arc(a), Piece::Arc(b)) => points = arc_arc(a, b, tolerance),
    }
    // Tangent curves part quadratically: their computed meeting is as uncertain as a square root.
    let near = 1e3 * tolerance;
    points
        .into_iter()
        .flatten()
        .find(|point| allowed.iter().all(|joint| (point - joint).norm() > near))
}

fn within(line: &Line, s: f64, tolerance: f64) -> bool {
    let [from, to] = Piece::Line(*line).range();
    s >= from - tolerance && s <= to + tolerance
}

fn line_line(a: &Line, b: &Line, tolerance: f64) -> Option<Vector<2>> {
    let offset = b.origin() - a.origin();
    let sine = cross(&a.direction(), &b.direction());
    if sine.abs() < 1e-12 {
        if cross(&a.direction(), &offset).abs() > tolerance {
            return None;
        }
        return overlap(a, b, tolerance);
    }
    let s = cross(&offset, &b.direction()) / sine;
    let t = cross(&offset, &a.direction()) / sine;
    (within(a, s, tolerance) && within(b, t, tolerance)).then(|| a.origin() + s * a.direction())
}

/// The middle of the stretch that two lines on the same carrier share.
fn overlap(a: &Line, b: &Line, tolerance: f64) -> Option<Vector<2>> {
    let shift = (b.origin() - a.origin()).dot(&a.direction());
    let along = b.direction().dot(&a.direction()).signum();
    let [a0, a1] = Piece::Line(*a).range();
    let [b0, b1] = Piece::Line(*b).range().map(|s| shift + along * s);
    let (low, high) = (a0.max(b0.min(b1)), a1.min(b0.max(b1)));
    if high - low <= tolerance {
        return None;
    }
    let s = match (low.is_finite(), high.is_finite()) {
        (true, true) => 0.5 * (low + high),
        (true, false) => low + 1e4 * tolerance,
        (false, true) => high - 1e4 * tolerance,
        (false, false) => 0.0,
    };
    Some(a.origin() + s * a.direction())
}

fn on_arc(arc: &Arc, point: &Vector<2>, tolerance: f64) -> bool {
    let piece = Piece::Arc(*arc);
    (point - piece.start()).norm() <= tolerance
        || (point - piece.end()).norm() <= tolerance
        || arc.spans(&((point - arc.center()) / arc.radius()))
}

fn line_arc(line: &Line, arc: &Arc, tolerance: f64) -> [Option<Vector<2>>; 2] {
    let middle = (arc.center() - line.origin()).dot(&line.direction());
    let height = cross(&line.direction(), &(arc.center() - line.origin())).abs();
    if height > arc.radius() + tolerance {
        return [None; 2];
    }
    let half = (arc.radius() * arc.radius() - height * height)
        .max(0.0)
        .sqrt();
    [middle - half, middle + half].map(|s| {
        let point = line.origin() + s * line.direction();
        (within(line, s, tolerance) && on_arc(arc, &point, tolerance)).then_some(point)
    })
}

fn arc_arc(a: &Arc, b: &Arc, tolerance: f64) -> [Option<Vector<2>>; 4] {
    let axis = b.center() - a.center();
    let distance = axis.norm();
    let (ra, rb) = (a.radius(), b.radius());
    if distance > ra + rb + tolerance || distance < (ra - rb).abs() - tolerance {
        return [None; 4];
    }
    if distance <= tolerance {
        return shared_stretch(a, b, tolerance);
    }
    let axis = axis / distance;
    let along = 0.5 * (distance + (ra - rb) * (ra + rb) / distance);
    let up = (ra * ra - along * along).max(0.0).sqrt();
    let across = Vector::<2>::new(-axis.y, axis.x);
    let test = |side: f64| {
        let point = a.center() + along * axis + side * up * across;
        (on_arc(a, &point, tolerance) && on_arc(b, &point, tolerance)).then_some(point)
    };
    [test(-1.0), test(1.0), None, None]
}

/// Points of `a` on `b` and of `b` on `a`, for arcs of one circle: ends and middles suffice.
fn shared_stretch(a: &Arc, b: &Arc, tolerance: f64) -> [Option<Vector<2>>; 4] {
    let inner = |arc: &Arc, other: &Arc, part: f64| {
        let piece = Piece::Arc(*arc);
        let point = piece.point(part * piece.length());
        on_arc(other, &point, tolerance).then_some(point)
    };
    // Just off the ends, so that arcs which only follow each other do not count.
    [
        inner(a, b, 0.5),
        inner(b, a, 0.5),
        inner(a, b, 0.01),
        inner(b, a, 0.01),
    ]
}
