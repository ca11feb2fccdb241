//! Sphere, cone and round-nosed rod about the x axis.

use std::f64::consts::{FRAC_PI_2, PI};

use crate::error::{angle_between, positive};
use crate::outline::Piece;
use crate::{GeometryError, Revolution, Vector};

/// A sphere about the origin.
///
/// # Errors
/// A radius that is not above zero.
pub fn sphere(radius: f64) -> Result<Revolution, GeometryError> {
    let radius = positive("sphere", "radius", radius)?;
    let ends = [
        Vector::<2>::new(radius, 0.0),
        Vector::<2>::new(-radius, 0.0),
    ];
    Revolution::new(vec![Piece::arc_between(
        Vector::<2>::zeros(),
        radius,
        [0.0, PI],
        ends,
    )])
}

/// A cone with its tip at the origin, facing upstream (-x), that opens by `half_angle` degrees
/// and ends in a flat base at `x = length`.
///
/// # Errors
/// An angle outside 0 to 90 degrees, a length that is not above zero.
pub fn cone(half_angle: f64, length: f64) -> Result<Revolution, GeometryError> {
    let angle = angle_between("cone", "half-angle", half_angle, [0.0, 90.0])?;
    let length = positive("cone", "length", length)?;
    let rim = Vector::<2>::new(length, length * angle.tan());
    Revolution::new(vec![
        Piece::segment(Vector::<2>::new(length, 0.0), rim),
        Piece::segment(rim, Vector::<2>::zeros()),
    ])
}

/// A rod of `radius` with a hemispherical nose about the origin, facing upstream (-x), and a flat
/// base `length` behind the tip of the nose.
///
/// # Errors
/// A radius that is not above zero, a length below or equal to the radius.
pub fn round_rod(radius: f64, length: f64) -> Result<Revolution, GeometryError> {
    let body = "round rod";
    let radius = positive(body, "radius", radius)?;
    if !(length.is_finite() && length > radius) {
        return Err(GeometryError::dimension(
            body,
            format!("length is {length}, but must exceed the radius, {radius}"),
        ));
    }
    let base = length - radius;
    let (rim, shoulder) = (
        Vector::<2>::new(base, radius),
        Vector::<2>::new(0.0, radius),
    );
    let nose = [shoulder, Vector::<2>::new(-radius, 0.0)];
    Revolution::new(vec![
        Piece::segment(Vector::<2>::new(base, 0.0), rim),
        Piece::segment(rim, shoulder),
        Piece::arc_between(Vector::<2>::zeros(), radius, [FRAC_PI_2, FRAC_PI_2], nose),
    ])
}
