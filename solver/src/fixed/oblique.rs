//! Oblique shocks: by how much a stream that is faster than sound may turn through one, and what is behind it.

/// The largest angle by which an oblique shock turns gas of this square of the Mach number [NACA Report 1135 (1953), eqs 138 and 168].
pub fn largest_turn(mach_square: f64, gamma: f64) -> f64 {
    if mach_square <= 1.0 {
        return 0.0;
    }
    let m = mach_square;
    let root = ((gamma + 1.0) * ((gamma + 1.0) * m * m + 8.0 * (gamma - 1.0) * m + 16.0)).sqrt();
    let sine_square = ((gamma + 1.0) * m - 4.0 + root) / (4.0 * gamma * m);
    let across = m * sine_square - 1.0;
    let cotangent = (1.0 / sine_square - 1.0).sqrt();
    (2.0 * cotangent * across / (m * (gamma + 1.0 - 2.0 * sine_square) + 2.0)).atan()
}

/// Elevation, above the way of the gas in front, of the weak shock that turns it by `turn`, radians, where one does
/// [NACA Report 1135 (1953), eq. 150, solved for the cosine of three times an angle].
pub fn weak_shock(mach_square: f64, gamma: f64, turn: f64) -> Option<f64> {
    let m = mach_square;
    let tangent = turn.tan();
    let a = 1.0 + 0.5 * (gamma - 1.0) * m;
    let b = 1.0 + 0.5 * (gamma + 1.0) * m;
    let square = (m - 1.0).powi(2) - 3.0 * a * b * tangent * tangent;
    if m <= 1.0 || turn <= 0.0 || square <= 0.0 {
        return None;
    }
    let root = square.sqrt();
    let c = 1.0 + 0.5 * (gamma - 1.0) * m + 0.25 * (gamma + 1.0) * m * m;
    let cosine = ((m - 1.0).powi(3) - 9.0 * a * c * tangent * tangent) / (square * root);
    if cosine.abs() > 1.0 {
        return None;
    }
    let third = (4.0 * std::f64::consts::PI + cosine.acos()) / 3.0;
    Some(((m - 1.0 + 2.0 * root * third.cos()) / (3.0 * a * tangent)).atan())
}

/// Density and pressure behind a shock over those in front, by the square of the Mach number straight across it
/// [NACA Report 1135 (1953), eqs 93 and 94].
pub fn ratios(across_square: f64, gamma: f64) -> [f64; 2] {
    let m = across_square;
    [
        (gamma + 1.0) * m / ((gamma - 1.0) * m + 2.0),
        1.0 + 2.0 * gamma / (gamma + 1.0) * (m - 1.0),
    ]
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    /// NACA Report 1135 (1953), chart 2 and its equations: 22.97 degrees at Mach 2, 34.07 at Mach 3, 41.12 at Mach 5.
    #[test]
    fn a_shock_turns_gas_as_far_as_the_tables_say() {
        for (mach, degrees) in [(2.0_f64, 22.974), (3.0, 34.073), (5.0, 41.118)] {
            let found = largest_turn(mach * mach, 1.4).to_degrees();
            assert_relative_eq!(found, degrees, epsilon = 2e-3);
        }
        assert_eq!(largest_turn(0.9, 1.4), 0.0);
    }

    /// The turn of a shock at an elevation [NACA Report 1135 (1953), eq. 138], and none beyond the largest.
    #[test]
    fn a_weak_shock_turns_gas_as_far_as_asked() {
        for gamma in [1.2, 1.4, 5.0 / 3.0] {
            for mach_square in [1.2_f64, 2.0, 6.25, 25.0, 400.0] {
                let largest = largest_turn(mach_square, gamma);
                for part in [0.01, 0.3, 0.7, 0.999] {
                    let elevation: f64 = weak_shock(mach_square, gamma, part * largest).unwrap();
                    let across = mach_square * elevation.sin().powi(2);
                    let other = mach_square * (gamma + (2.0 * elevation).cos()) + 2.0;
                    let turn = (2.0 / elevation.tan() * (across - 1.0) / other).atan();
                    assert_relative_eq!(turn, part * largest, max_relative = 1e-6);
                    assert!(across > 1.0);
                }
                assert!(weak_shock(mach_square, gamma, 1.001 * largest).is_none());
            }
        }
        assert!(weak_shock(0.9, 1.4, 0.1).is_none() && weak_shock(4.0, 1.4, -0.1).is_none());
    }

    /// NACA Report 1135 (1953), table II: Mach 2 straight into a shock.
    #[test]
    fn gas_behind_a_shock_is_as_the_tables_say() {
        let [density, pressure] = ratios(4.0, 1.4);
        assert_relative_eq!(density, 2.667, epsilon = 5e-4);
        assert_relative_eq!(pressure, 4.500, epsilon = 5e-4);
    }
}
