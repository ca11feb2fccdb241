//! Which coordinate planes an outline is symmetric about.

use std::f64::consts::TAU;

use super::Outline;
use super::piece::Piece;
use crate::{Bounds, Vector};

/// Mirror images that lie this close, relative to the outline's size, are the same.
const SAME: f64 = 1e-10;

/// The planes `(axis, position)`, through the middle of the finite part, that map the outline
/// onto itself.
pub(super) fn mirrors(outline: &Outline, extent: &Bounds<2>) -> Vec<(usize, f64)> {
    let middle = 0.5 * (extent.min + extent.max);
    (0..2)
        .map(|axis| {
            let snapped = if middle[axis].abs() < SAME * outline.size {
                0.0
            } else {
                middle[axis]
            };
            (axis, snapped)
        })
        .filter(|&(axis, position)| {
            outline
                .pieces
                .iter()
                .all(|piece| has_image(outline, piece, axis, position))
        })
        .collect()
}

fn has_image(outline: &Outline, piece: &Piece, axis: usize, position: f64) -> bool {
    let tolerance = SAME * outline.size;
    let image = piece.mirrored((axis, position));
    let [from, to] = image.range();
    let probe = match (from.is_finite(), to.is_finite()) {
        (true, true) => 0.5 * (from + to),
        (true, false) => from + outline.size,
        (false, true) => to - outline.size,
        (false, false) => 0.0,
    };
    let (other, _) = outline.nearest(&image.point(probe));
    same(&image, &outline.pieces[other], tolerance)
}

fn same(a: &Piece, b: &Piece, tolerance: f64) -> bool {
    let same_point = |p: &Vector<2>, q: &Vector<2>| {
        p.iter()
            .zip(q.iter())
            .all(|(a, b)| a == b || (a - b).abs() <= tolerance)
    };
    let same_ends = same_point(&a.start(), &b.start()) && same_point(&a.end(), &b.end());
    match (a, b) {
        (Piece::Line(a), Piece::Line(b)) => {
            // The directions tell rays apart whose ends at infinity look alike.
            same_ends && (a.direction() - b.direction()).norm() <= SAME
        }
        (Piece::Arc(a), Piece::Arc(b)) => {
            let whole = a.sweep().abs() >= TAU;
            same_point(&a.center(), &b.center())
                && (a.radius() - b.radius()).abs() <= tolerance
                && (a.sweep() - b.sweep()).abs() <= SAME
                && (whole || same_ends)
        }
        _ => false,
    }
}
