//! How gas faster than sound turns as it expands [Prandtl 1907, Meyer 1908; NACA Report 1135 (1953), eq. 171c].

use std::f64::consts::FRAC_PI_2;

/// Halvings after which an angle is known to the last bits.
const HALVINGS: u32 = 52;

/// Prandtl and Meyer's angle of `slope = sqrt(M^2 - 1)`: `nu = k atan(sqrt(M^2 - 1) / k) - atan(sqrt(M^2 - 1))`, where the `slowness`
/// `k = sqrt((gamma + 1) / (gamma - 1))`; radians.
pub fn angle(slope: f64, slowness: f64) -> f64 {
    slowness * (slope / slowness).atan() - slope.atan()
}

/// The `sqrt(M^2 - 1)` above `least` that has this angle.
pub fn slope_of(wanted: f64, least: f64, slowness: f64) -> f64 {
    let (mut low, mut high) = (least.atan(), FRAC_PI_2);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if angle(middle.tan(), slowness) < wanted {
            low = middle;
        } else {
            high = middle;
        }
    }
    low.tan()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// NACA Report 1135 (1953), table II, and back.
    #[test]
    fn angles_are_those_of_the_tables() {
        let slowness = 6.0_f64.sqrt();
        for (mach, degrees) in [(1.5_f64, 11.905), (2.0, 26.380), (3.0, 49.757)] {
            let slope = (mach * mach - 1.0).sqrt();
            let turned = angle(slope, slowness);
            assert!((turned.to_degrees() - degrees).abs() < 1e-3, "{turned}");
            assert!((slope_of(turned, 0.0, slowness) - slope).abs() < 1e-9);
        }
    }
}
