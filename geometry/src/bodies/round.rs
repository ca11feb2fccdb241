//! Circles and rectangles, sharp or rounded, about the origin.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use crate::error::positive;
use crate::outline::{Outline, Piece};
use crate::{GeometryError, Vector};

/// A circle about the origin.
///
/// # Errors
/// A radius that is not above zero.
pub fn circle(radius: f64) -> Result<Outline, GeometryError> {
    let radius = positive("circle", "radius", radius)?;
    Outline::new(vec![vec![Piece::arc(
        Vector::<2>::zeros(),
        radius,
        0.0,
        TAU,
    )]])
}

/// A rectangle of `width` along x and `height` along y about the origin, its corners rounded by
/// `corner_radius`, which may be zero.
///
/// # Errors
/// Sides that are not above zero, a radius below zero or above half of the shorter side.
pub fn rectangle(width: f64, height: f64, corner_radius: f64) -> Result<Outline, GeometryError> {
    let body = "rectangle";
    let half = 0.5
        * Vector::<2>::new(
            positive(body, "width", width)?,
            positive(body, "height", height)?,
        );
    let radius = corner_radius;
    if !(radius >= 0.0 && radius <= half.min()) {
        return Err(GeometryError::dimension(
            body,
            format!(
                "corner radius is {radius}, but must be from 0 to {}, half of the shorter side",
                half.min()
            ),
        ));
    }
    let inner = half.add_scalar(-radius);
    let mut pieces = Vec::with_capacity(8);
    // Each turn: the straight side that leads up to a corner, then the corner's arc.
    let corners = [[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]];
    for (k, [sx, sy]) in corners.into_iter().enumerate() {
        let (side, other) = (k % 2, 1 - k % 2);
        let signs = Vector::<2>::new(sx, sy);
        let center = inner.component_mul(&signs);
        let mut arrive = center;
        arrive[side] = half[side] * signs[side];
        let mut leave = center;
        leave[other] = half[other] * signs[other];
        let mut depart = arrive;
        depart[other] = -arrive[other];
        if inner[other] > 0.0 {
            pieces.push(Piece::segment(depart, arrive));
        }
        if radius > 0.0 {
            let turn = [
                [0.0, FRAC_PI_2],
                [FRAC_PI_2, FRAC_PI_2],
                [PI, FRAC_PI_2],
                [-FRAC_PI_2, FRAC_PI_2],
            ][k];
            pieces.push(Piece::arc_between(center, radius, turn, [arrive, leave]));
        }
    }
    Outline::new(vec![pieces])
}
