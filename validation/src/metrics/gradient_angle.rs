//! Shock angle from the particles of steepest density, as published for compressible SPH wedges.
//!
//! Particles with `|grad rho| > 0.6 max |grad rho|` and a straight line through them by least
//! squares of `y` on `x`. Source: Villodi & Ramachandran, "Improved solid boundary treatment for
//! compressible smooth particle hydrodynamics", eq. 36 (<https://gitlab.com/pypr/compressible-sph-bc>).
//! Kept to compare with the published angles, which it makes 0.3 to 0.9 per cent low; the half-jump
//! fit of [`shock_line`](super::shock_line) has no such bias.

use super::least_squares::{Row, fit};
use super::{MetricError, same_length};

/// The publication's share of the largest gradient.
pub const SHARE: f64 = 0.6;

/// The line through the particles of steepest density.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GradientAngle {
    /// Angle from the x axis, radians.
    pub angle: f64,
    /// Height of the line at `x = 0`.
    pub intercept: f64,
    /// Number of particles that the line runs through.
    pub marked: usize,
}

/// Fits the line through the particles whose density gradient exceeds `share` of the largest.
///
/// Give only the gas, not walls or buffers: one wild gradient there sets the threshold for all.
pub fn gradient_angle(
    positions: &[[f64; 3]],
    gradients: &[[f64; 3]],
    share: f64,
) -> Result<GradientAngle, MetricError> {
    same_length("gradients", gradients, positions.len())?;
    let size: Vec<f64> = gradients
        .iter()
        .map(|g| g.iter().map(|v| v * v).sum::<f64>().sqrt())
        .collect();
    let largest = size.iter().copied().fold(0.0, f64::max);
    let rows: Vec<Row<2>> = positions
        .iter()
        .zip(&size)
        .filter(|(_, size)| **size > share * largest)
        .map(|(p, _)| Row {
            terms: [1.0, p[0]],
            value: p[1],
        })
        .collect();
    let line = fit(&rows).ok_or(MetricError::TooFew {
        what: "particles of steep density at different x",
        found: rows.len(),
        needed: 2,
        remedy: "lower the share of the largest gradient",
    })?;
    Ok(GradientAngle {
        angle: line.x[1].atan(),
        intercept: line.x[0],
        marked: rows.len(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::metrics::gradient::{Cloud, gradient};
    use crate::metrics::testing::{Wedge, wedge};

    #[test]
    fn the_angle_of_a_clean_shock_is_near_and_uses_only_its_particles() {
        let flow = Wedge {
            beta: 29.801_f64.to_radians(),
            ramp: 20_f64.to_radians(),
            ratio: 3.3154,
            spacing: 1.0 / 16.0,
            noise: 0.0,
        };
        let (positions, density) = wedge(&flow);
        let mass = flow.spacing * flow.spacing;
        let volume: Vec<f64> = density.iter().map(|rho| mass / rho).collect();
        let smoothing_length: Vec<f64> = volume.iter().map(|v| 1.5 * v.sqrt()).collect();
        let cloud = Cloud {
            position: &positions,
            volume: &volume,
            smoothing_length: &smoothing_length,
            dimension: 2,
        };
        let gradients = gradient(&cloud, &density).unwrap();
        let line = gradient_angle(&positions, &gradients, SHARE).unwrap();
        assert!((line.angle.to_degrees() - 29.801).abs() < 0.5, "{line:?}");
        assert!(
            line.marked > 30 && line.marked < positions.len() / 10,
            "{line:?}"
        );
    }

    #[test]
    fn a_field_without_gradients_is_refused() {
        let error = gradient_angle(&[[0.0; 3]; 4], &[[0.0; 3]; 4], SHARE).unwrap_err();
        assert!(error.to_string().contains("steep density"), "{error}");
    }
}
