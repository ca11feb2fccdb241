//! Bodies of revolution about the x axis, exact: every query is reduced to the meridian plane.

mod rims;

use std::f64::consts::{PI, TAU};

use crate::outline::Piece;
use crate::{Bounds, Closest, Crease, GeometryError, Outline, Shape, Vector};

/// The solid that a curve in the half plane `(x, r)`, `r >= 0`, sweeps about the x axis.
#[derive(Clone, Debug)]
pub struct Revolution {
    /// The curve; its second coordinate is the distance from the axis.
    meridian: Outline,
}

impl Revolution {
    /// The body whose meridian is `pieces`: from the axis to the axis, or closed beside it (a
    /// ring). The order of travel does not matter.
    ///
    /// # Errors
    /// Pieces that make no meridian: open ends off the axis, crossings, parts below the axis.
    pub fn new(pieces: Vec<Piece>) -> Result<Self, GeometryError> {
        Ok(Self {
            meridian: Outline::meridian(pieces)?,
        })
    }

    /// The meridian curve in `(x, r)`, travelled from the downstream end with the solid to the
    /// left.
    pub fn meridian(&self) -> &Outline {
        &self.meridian
    }

    /// The section of the body by a plane through its axis, as a body of the plane.
    ///
    /// # Errors
    /// None that a meridian has not been checked for already.
    pub fn section(&self) -> Result<Outline, GeometryError> {
        let upper = self.meridian.pieces();
        let lower = upper.iter().rev().map(|piece| piece.mirrored((1, 0.0)));
        let closes_on_the_axis = upper[0].start().y == 0.0;
        if closes_on_the_axis {
            Outline::new(vec![upper.iter().copied().chain(lower).collect()])
        } else {
            Outline::new(vec![upper.to_vec(), lower.collect()])
        }
    }

    /// Volume by Pappus: `π ∮ r^2 dx` along the meridian.
    pub fn volume(&self) -> f64 {
        -PI * self
            .meridian
            .pieces()
            .iter()
            .map(square_moment)
            .sum::<f64>()
    }

    /// Area of the surface, `2 π ∫ r ds`.
    pub fn surface_area(&self) -> f64 {
        TAU * self.meridian.pieces().iter().map(moment).sum::<f64>()
    }
}

/// `∫ r^2 dx` along a piece.
fn square_moment(piece: &Piece) -> f64 {
    let (a, b) = (piece.start(), piece.end());
    match piece {
        Piece::Line(_) => (b.x - a.x) * (a.y * a.y + a.y * b.y + b.y * b.y) / 3.0,
        Piece::Arc(arc) => {
            let (radius, height) = (arc.radius(), arc.center().y);
            let (first, last) = (arc.start_angle(), arc.start_angle() + arc.sweep());
            let sine = first.cos() - last.cos();
            let sine_squared =
                0.5 * (last - first) - 0.25 * ((2.0 * last).sin() - (2.0 * first).sin());
            let primitive = |angle: f64| angle.cos().powi(3) / 3.0 - angle.cos();
            let sine_cubed = primitive(last) - primitive(first);
            -radius
                * (height * height * sine
                    + 2.0 * height * radius * sine_squared
                    + radius * radius * sine_cubed)
        }
    }
}

/// `∫ r ds` along a piece.
fn moment(piece: &Piece) -> f64 {
    match piece {
        Piece::Line(_) => 0.5 * piece.length() * (piece.start().y + piece.end().y),
        Piece::Arc(arc) => {
            let (first, last) = (arc.start_angle(), arc.start_angle() + arc.sweep());
            let integral =
                arc.center().y * (last - first) + arc.radius() * (first.cos() - last.cos());
            arc.radius() * integral * arc.sweep().signum()
        }
    }
}

impl Shape<3> for Revolution {
    fn bounds(&self) -> Bounds<3> {
        let Bounds { min, max } = self.meridian.bounds();
        Bounds::new(
            Vector::<3>::new(min.x, -max.y, -max.y),
            Vector::<3>::new(max.x, max.y, max.y),
        )
    }

    fn closest(&self, p: &Vector<3>) -> Closest<3> {
        let radius = p.y.hypot(p.z);
        // On the axis every meridian plane is as near as any other.
        let (cos, sin) = if radius > 0.0 {
            (p.y / radius, p.z / radius)
        } else {
            (1.0, 0.0)
        };
        let flat = self.meridian.closest(&Vector::<2>::new(p.x, radius));
        let turned = |v: &Vector<2>| Vector::<3>::new(v.x, v.y * cos, v.y * sin);
        Closest {
            point: turned(&flat.point),
            distance: flat.distance,
            normal: turned(&flat.normal),
            face: flat.face,
        }
    }

    fn mirror_planes(&self) -> Vec<(usize, f64)> {
        let across = self.meridian.mirror_planes();
        across
            .into_iter()
            .filter(|&(axis, _)| axis == 0)
            .chain([(1, 0.0), (2, 0.0)])
            .collect()
    }

    fn facets(&self, size: f64, region: &Bounds<3>) -> Vec<[Vector<3>; 3]> {
        crate::tessellate::cover(self, size, region)
    }

    fn creases(&self, size: f64, region: &Bounds<3>) -> Vec<Crease<3>> {
        self.rims(size, region)
    }

    fn measure(&self) -> Option<f64> {
        Some(self.volume())
    }
}
