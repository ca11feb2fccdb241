//! The blunt wedge: a round nose with tangent flanks.

use std::f64::consts::{FRAC_PI_2, PI};

use crate::error::{angle_between, positive};
use crate::outline::{Outline, Piece};
use crate::{GeometryError, Vector};

/// A cylinder nose of `radius` about the origin, facing upstream (-x), with flat flanks tangent
/// to it that open by `half_angle` degrees on either side, cut off by a flat base `length` behind
/// the tip of the nose. An infinite length makes the flanks endless.
///
/// # Errors
/// A radius that is not above zero, an angle outside 0 to 90 degrees, a length too small for the
/// nose to be complete.
pub fn blunt_wedge(radius: f64, half_angle: f64, length: f64) -> Result<Outline, GeometryError> {
    let body = "blunt wedge";
    let radius = positive(body, "radius", radius)?;
    let angle = if half_angle == 0.0 {
        0.0
    } else {
        angle_between(body, "half-angle", half_angle, [0.0, 90.0])?
    };
    let (sin, cos) = angle.sin_cos();
    let shortest = radius * (1.0 - sin);
    if length.is_nan() || length <= shortest {
        return Err(GeometryError::dimension(
            body,
            format!("length is {length}, but the nose alone takes {shortest}"),
        ));
    }
    let upper = radius * Vector::<2>::new(-sin, cos);
    let lower = radius * Vector::<2>::new(-sin, -cos);
    let nose = Piece::arc_between(
        Vector::<2>::zeros(),
        radius,
        [FRAC_PI_2 + angle, PI - 2.0 * angle],
        [upper, lower],
    );
    if length.is_infinite() {
        return Outline::new(vec![vec![
            Piece::ray_to(upper, Vector::<2>::new(-cos, -sin)),
            nose,
            Piece::ray_from(lower, Vector::<2>::new(cos, -sin)),
        ]]);
    }
    let base = length - radius;
    let half_height = upper.y + (base - upper.x) * angle.tan();
    let (top, bottom) = (
        Vector::<2>::new(base, half_height),
        Vector::<2>::new(base, -half_height),
    );
    Outline::new(vec![vec![
        Piece::segment(top, upper),
        nose,
        Piece::segment(lower, bottom),
        Piece::segment(bottom, top),
    ]])
}
