//! Area and centroid of an outline, exact for lines and arcs.

use super::piece::{Piece, cross};
use super::{Ends, Outline};
use crate::Vector;

/// Area by Green's theorem, `(1/2) ∮ (x dy - y dx)`; positive counter-clockwise. Exact for a chain
/// that is closed or that the axis `y = 0` closes.
pub(super) fn signed_area(pieces: &[Piece]) -> f64 {
    pieces
        .iter()
        .map(|piece| {
            let (a, b) = (piece.start(), piece.end());
            match piece {
                Piece::Line(_) => 0.5 * cross(&a, &b),
                Piece::Arc(arc) => {
                    let (c, r) = (arc.center(), arc.radius());
                    0.5 * (cross(&c, &(b - a)) + r * r * arc.sweep())
                }
            }
        })
        .sum()
}

/// First moments of area, `∮ (x^2/2) dy` and `-∮ (y^2/2) dx`.
fn first_moments(pieces: &[Piece]) -> Vector<2> {
    pieces
        .iter()
        .map(|piece| {
            let (a, b) = (piece.start(), piece.end());
            match piece {
                Piece::Line(_) => (a + b) * cross(&a, &b) / 6.0,
                Piece::Arc(arc) => {
                    // The sector between the centre and the arc, and the two triangles that join
                    // it to the origin, each with its own centroid.
                    let (c, r, sweep) = (arc.center(), arc.radius(), arc.sweep());
                    let (u, v) = ((a - c) / r, (b - c) / r);
                    let lever = Vector::<2>::new(v.y - u.y, u.x - v.x);
                    let sector = c * (0.5 * r * r * sweep) + lever * (r * r * r / 3.0);
                    sector + (a + c) * cross(&a, &c) / 6.0 + (c + b) * cross(&c, &b) / 6.0
                }
            }
        })
        .sum()
}

impl Outline {
    /// Area of the solid; `None` where it is endless.
    pub fn area(&self) -> Option<f64> {
        self.is_finite().then(|| signed_area(&self.pieces))
    }

    /// Centre of area; `None` where the solid is endless.
    pub fn centroid(&self) -> Option<Vector<2>> {
        self.is_finite()
            .then(|| first_moments(&self.pieces) / signed_area(&self.pieces))
    }

    fn is_finite(&self) -> bool {
        self.chains.iter().all(|chain| chain.ends != Ends::Endless)
    }
}
