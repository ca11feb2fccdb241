//! The circular-arc aerofoil.

use std::f64::consts::FRAC_PI_2;

use crate::error::positive;
use crate::outline::{Outline, Piece};
use crate::{GeometryError, Vector};

/// A symmetric aerofoil of two circular arcs, leading edge at the origin, chord along x, with
/// the largest thickness `thickness_ratio * chord`.
///
/// # Errors
/// A chord that is not above zero, a thickness ratio outside 0 to 1.
pub fn biconvex(chord: f64, thickness_ratio: f64) -> Result<Outline, GeometryError> {
    let body = "biconvex aerofoil";
    let chord = positive(body, "chord", chord)?;
    if !(thickness_ratio > 0.0 && thickness_ratio < 1.0) {
        return Err(GeometryError::dimension(
            body,
            format!("thickness ratio is {thickness_ratio}, but must be between 0 and 1"),
        ));
    }
    let (half_chord, sagitta) = (0.5 * chord, 0.5 * thickness_ratio * chord);
    let radius = (half_chord * half_chord + sagitta * sagitta) / (2.0 * sagitta);
    let depth = radius - sagitta;
    let half_angle = half_chord.atan2(depth);
    let (nose, tail) = (Vector::<2>::zeros(), Vector::<2>::new(chord, 0.0));
    let arc = |side: f64, middle: f64, ends| {
        Piece::arc_between(
            Vector::<2>::new(half_chord, -side * depth),
            radius,
            [middle - half_angle, 2.0 * half_angle],
            ends,
        )
    };
    Outline::new(vec![vec![
        arc(1.0, FRAC_PI_2, [tail, nose]),
        arc(-1.0, -FRAC_PI_2, [nose, tail]),
    ]])
}
