//! The convergent-divergent nozzle of Back, Massier & Gier (1965): a duct whose walls are lines
//! and arcs.

use std::f64::consts::{FRAC_PI_2, PI};

use crate::error::{angle_between, positive};
use crate::outline::piece::unit;
use crate::outline::{Outline, Piece};
use crate::{GeometryError, Vector};

/// A planar duct, symmetric about `y = 0`, throat at `x = 0`: a straight inlet, an arc that turns
/// the wall inwards, an arc through the throat, and a straight divergence without end. The walls
/// are endlessly thick.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nozzle {
    /// Half-height of the straight inlet.
    pub inlet: f64,
    /// Half-height of the throat.
    pub throat: f64,
    /// Radius of the arc that begins the contraction.
    pub contraction_radius: f64,
    /// Radius of the arc through the throat.
    pub throat_radius: f64,
    /// Half-angle of the divergence, degrees.
    pub divergence: f64,
}

/// The points where the upper wall's pieces meet, and the contraction's steepest angle.
struct Joints {
    contraction_center: Vector<2>,
    throat_center: Vector<2>,
    /// Direction from the first centre to the second, radians from the x axis.
    axis: f64,
    divergence: f64,
}

impl Nozzle {
    /// The nozzle of Back, Massier & Gier, "Comparison of measured and predicted flows through
    /// conical supersonic nozzles, with emphasis on the transonic region", AIAA Journal 3 (1965)
    /// 1606, as the examples of the Eilmer flow solver set it up; inches. There the contraction
    /// begins with an arc about the axis, of the inlet's own half-height.
    pub fn back() -> Self {
        Self {
            inlet: 1.5955,
            throat: 0.775,
            contraction_radius: 1.5955,
            throat_radius: 1.55,
            divergence: 15.0,
        }
    }

    fn joints(&self) -> Result<Joints, GeometryError> {
        let body = "nozzle";
        let inlet = positive(body, "inlet half-height", self.inlet)?;
        let throat = positive(body, "throat half-height", self.throat)?;
        let first = positive(body, "contraction radius", self.contraction_radius)?;
        let second = positive(body, "throat radius", self.throat_radius)?;
        let divergence = angle_between(body, "divergence", self.divergence, [0.0, 90.0])?;
        let narrowing = inlet - throat;
        if narrowing <= 0.0 || narrowing >= first + second {
            return Err(GeometryError::dimension(
                body,
                format!(
                    "the inlet must be wider than the throat by less than both radii together, \
                     {}, but {inlet} and {throat} differ by {narrowing}",
                    first + second
                ),
            ));
        }
        let rise = first + second - narrowing;
        let base = ((first + second).powi(2) - rise * rise).sqrt();
        Ok(Joints {
            contraction_center: Vector::<2>::new(-base, inlet - first),
            throat_center: Vector::<2>::new(0.0, throat + second),
            axis: rise.atan2(base),
            divergence,
        })
    }

    /// The upper wall alone; with a symmetry plane at `y = 0` it makes half of the duct.
    ///
    /// # Errors
    /// Dimensions that make no nozzle.
    pub fn upper_wall(&self) -> Result<Outline, GeometryError> {
        Outline::new(vec![self.upper()?])
    }

    /// Both walls.
    ///
    /// # Errors
    /// Dimensions that make no nozzle.
    pub fn walls(&self) -> Result<Outline, GeometryError> {
        let upper = self.upper()?;
        let lower = upper.iter().rev().map(|p| p.mirrored((1, 0.0))).collect();
        Outline::new(vec![upper, lower])
    }

    fn upper(&self) -> Result<Vec<Piece>, GeometryError> {
        let joints = self.joints()?;
        let start = Vector::<2>::new(joints.contraction_center.x, self.inlet);
        let inflection = joints.contraction_center + self.contraction_radius * unit(joints.axis);
        let tangent = unit(joints.divergence);
        let end =
            joints.throat_center + self.throat_radius * Vector::<2>::new(tangent.y, -tangent.x);
        Ok(vec![
            Piece::ray_to(start, Vector::<2>::new(1.0, 0.0)),
            Piece::arc_between(
                joints.contraction_center,
                self.contraction_radius,
                [FRAC_PI_2, joints.axis - FRAC_PI_2],
                [start, inflection],
            ),
            Piece::arc_between(
                joints.throat_center,
                self.throat_radius,
                [
                    joints.axis + PI,
                    FRAC_PI_2 - joints.axis + joints.divergence,
                ],
                [inflection, end],
            ),
            Piece::ray_from(end, tangent),
        ])
    }

    /// Half-height of the duct at `x`.
    ///
    /// # Errors
    /// Dimensions that make no nozzle.
    pub fn half_height(&self, x: f64) -> Result<f64, GeometryError> {
        let joints = self.joints()?;
        let (first, second) = (joints.contraction_center, joints.throat_center);
        let inflection = first.x + self.contraction_radius * joints.axis.cos();
        let end = self.throat_radius * joints.divergence.sin();
        Ok(if x <= first.x {
            self.inlet
        } else if x <= inflection {
            first.y + (self.contraction_radius.powi(2) - (x - first.x).powi(2)).sqrt()
        } else if x <= end {
            second.y - (self.throat_radius.powi(2) - x * x).sqrt()
        } else {
            let start = second.y - self.throat_radius * joints.divergence.cos();
            start + (x - end) * joints.divergence.tan()
        })
    }
}
