//! The quintic spline of smoothed particle hydrodynamics, support three smoothing lengths.
//!
//! Source: Monaghan, Rep. Prog. Phys. 68 (2005) 1703 (doi:10.1088/0034-4885/68/8/R01). Written anew
//! here, so that a slip in the solver's kernel cannot hide in its own check.

/// Distance over smoothing length where the kernel ends.
pub(super) const SUPPORT: f64 = 3.0;

/// The kernel at distance `q` smoothing lengths, times `h^D` and without its constant factor:
/// `(3-q)^5 - 6 (2-q)^5 + 15 (1-q)^5`, each bracket only while positive.
pub(super) fn quintic(q: f64) -> f64 {
    let term = |edge: f64| (edge - q).max(0.0).powi(5);
    term(3.0) - 6.0 * term(2.0) + 15.0 * term(1.0)
}

/// Minus the derivative of [`quintic`] over `q`, never negative.
pub(super) fn quintic_fall(q: f64) -> f64 {
    let term = |edge: f64| (edge - q).max(0.0).powi(4);
    5.0 * (term(3.0) - 6.0 * term(2.0) + 15.0 * term(1.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_integrals_are_the_published_normalisations() {
        let steps = 30_000;
        let dq = SUPPORT / f64::from(steps);
        let mut integral = [0.0; 3];
        for k in 0..steps {
            let q = (f64::from(k) + 0.5) * dq;
            integral[0] += 2.0 * quintic(q) * dq;
            integral[1] += std::f64::consts::TAU * q * quintic(q) * dq;
            integral[2] += 2.0 * std::f64::consts::TAU * q * q * quintic(q) * dq;
        }
        assert!((integral[0] - 120.0).abs() < 1e-5);
        assert!((integral[1] - 478.0 / 7.0 * std::f64::consts::PI).abs() < 1e-5);
        assert!((integral[2] - 120.0 * std::f64::consts::PI).abs() < 1e-5);
    }

    #[test]
    fn the_fall_is_minus_the_derivative() {
        for k in 0..30 {
            let q = 0.05 + 0.1 * f64::from(k);
            let slope = (quintic(q + 1e-6) - quintic(q - 1e-6)) / 2e-6;
            assert!((slope + quintic_fall(q)).abs() < 1e-5);
        }
    }
}
