//! Endless walls: a plane, corners and a step, each with the solid below.

use crate::error::{angle_between, finite, positive};
use crate::outline::{Outline, Piece};
use crate::{GeometryError, Vector};

/// Upstream, the way in which walls with the solid below are travelled.
fn upstream() -> Vector<2> {
    Vector::<2>::new(-1.0, 0.0)
}

/// The half space below `y = height`.
///
/// # Errors
/// A height that is not finite.
pub fn wall(height: f64) -> Result<Outline, GeometryError> {
    let point = Vector::<2>::new(0.0, finite("wall", "height", height)?);
    Outline::new(vec![vec![Piece::whole_line(point, upstream())]])
}

/// A wall `y = 0` up to `x = corner`, then a ramp that rises by `angle` degrees without end.
///
/// # Errors
/// An angle outside 0 to 90 degrees.
pub fn compression_corner(corner: f64, angle: f64) -> Result<Outline, GeometryError> {
    let body = "compression corner";
    let corner = finite(body, "corner", corner)?;
    let angle = angle_between(body, "angle", angle, [0.0, 90.0])?;
    bend(corner, angle)
}

/// A wall `y = 0` up to `x = corner`, then a ramp that falls by `angle` degrees without end.
///
/// # Errors
/// An angle outside 0 to 90 degrees.
pub fn expansion_corner(corner: f64, angle: f64) -> Result<Outline, GeometryError> {
    let body = "expansion corner";
    let corner = finite(body, "corner", corner)?;
    let angle = angle_between(body, "angle", angle, [0.0, 90.0])?;
    bend(corner, -angle)
}

fn bend(corner: f64, angle: f64) -> Result<Outline, GeometryError> {
    let corner = Vector::<2>::new(corner, 0.0);
    let down_ramp = -Vector::<2>::new(angle.cos(), angle.sin());
    Outline::new(vec![vec![
        Piece::ray_to(corner, down_ramp),
        Piece::ray_from(corner, upstream()),
    ]])
}

/// A wall `y = 0` up to `x = foot`, where it steps up to `y = height` and runs on without end.
///
/// # Errors
/// A height that is not above zero.
pub fn forward_step(foot: f64, height: f64) -> Result<Outline, GeometryError> {
    let body = "forward step";
    let foot = finite(body, "foot", foot)?;
    let height = positive(body, "height", height)?;
    let (top, bottom) = (Vector::<2>::new(foot, height), Vector::<2>::new(foot, 0.0));
    Outline::new(vec![vec![
        Piece::ray_to(top, upstream()),
        Piece::segment(top, bottom),
        Piece::ray_from(bottom, upstream()),
    ]])
}
