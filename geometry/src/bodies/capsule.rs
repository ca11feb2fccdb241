//! Entry capsules: a spherical heat shield, a rounded shoulder, an aft cone and a rounded apex,
//! each tangent to the next.

use std::f64::consts::{FRAC_PI_2, PI};

use crate::error::positive;
use crate::outline::Piece;
use crate::outline::piece::unit;
use crate::{GeometryError, Revolution, Vector};

/// The constants of a capsule, heat shield upstream with its middle at the origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Capsule {
    /// Largest radius of the body, at the shoulder.
    pub radius: f64,
    /// Length from the middle of the heat shield to the apex.
    pub length: f64,
    /// Radius of the heat shield's sphere.
    pub shield_radius: f64,
    /// Radius of the apex.
    pub apex_radius: f64,
    /// Radius of the shoulder's rounding.
    pub shoulder_radius: f64,
}

impl Capsule {
    /// The Apollo command module, metres (Moss, Glass & Greene, "DSMC simulations of Apollo
    /// capsule aerodynamics for hypersonic rarefied conditions", AIAA 2006-3577).
    pub fn apollo() -> Self {
        Self {
            radius: 1.9558,
            length: 3.4306,
            shield_radius: 4.6939,
            apex_radius: 0.2311,
            shoulder_radius: 0.1956,
        }
    }

    /// The body.
    ///
    /// # Errors
    /// Constants that leave no room for one of the parts.
    pub fn body(&self) -> Result<Revolution, GeometryError> {
        let kind = "capsule";
        let radius = positive(kind, "radius", self.radius)?;
        let length = positive(kind, "length", self.length)?;
        let shield = positive(kind, "shield radius", self.shield_radius)?;
        let apex = positive(kind, "apex radius", self.apex_radius)?;
        let shoulder = positive(kind, "shoulder radius", self.shoulder_radius)?;
        let height = radius - shoulder;
        if height <= 0.0 || shield - shoulder <= height {
            return Err(GeometryError::dimension(
                kind,
                format!(
                    "the shoulder radius, {shoulder}, must be below the largest radius, {radius}, \
                     and that below the shield radius, {shield}"
                ),
            ));
        }
        // The shoulder's circle touches the shield's from inside.
        let shield_center = Vector::<2>::new(shield, 0.0);
        let inner = shield - shoulder;
        let shoulder_center =
            Vector::<2>::new(shield - (inner * inner - height * height).sqrt(), height);
        let apex_center = Vector::<2>::new(length - apex, 0.0);
        // The cone's line touches both circles from outside: its normal leans from the line of
        // centres by the difference of the radii.
        let axis = apex_center - shoulder_center;
        let lean = (apex - shoulder) / axis.norm();
        let cone_angle = (-axis.y).atan2(axis.x) - lean.clamp(-1.0, 1.0).asin();
        if axis.x <= 0.0 || lean.abs() >= 1.0 || cone_angle <= 0.0 {
            return Err(GeometryError::dimension(
                kind,
                format!("the length, {length}, leaves no room for the aft cone"),
            ));
        }
        let normal_angle = FRAC_PI_2 - cone_angle;
        let normal = unit(normal_angle);
        let outward = (shoulder_center - shield_center) / inner;
        let shield_angle = outward.y.atan2(outward.x);
        let tip = Vector::<2>::new(length, 0.0);
        let cone_end = apex_center + apex * normal;
        let cone_start = shoulder_center + shoulder * normal;
        let shield_edge = shield_center + shield * outward;
        Revolution::new(vec![
            Piece::arc_between(apex_center, apex, [0.0, normal_angle], [tip, cone_end]),
            Piece::segment(cone_end, cone_start),
            Piece::arc_between(
                shoulder_center,
                shoulder,
                [normal_angle, shield_angle - normal_angle],
                [cone_start, shield_edge],
            ),
            Piece::arc_between(
                shield_center,
                shield,
                [shield_angle, PI - shield_angle],
                [shield_edge, Vector::<2>::zeros()],
            ),
        ])
    }
}
