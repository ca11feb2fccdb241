//! A spheroid in a stream slower than sound along its length, or nearly so.

use std::f64::consts::PI;

/// Masses of gas that a spheroid takes along when it moves along its axis and across it, over that of its own volume, in a fluid that cannot be
/// compressed [Lamb 1932, Hydrodynamics, articles 114 and 373]; `fineness` is its length over its thickness, more than one.
pub fn added_masses(fineness: f64) -> [f64; 2] {
    let square = 1.0 - 1.0 / (fineness * fineness);
    let e = square.sqrt();
    let log = ((1.0 + e) / (1.0 - e)).ln();
    let along = 2.0 * (1.0 - square) / (e * square) * (0.5 * log - e);
    let across = 1.0 / square - (1.0 - square) / (2.0 * e * square) * log;
    [along, across].map(|part| part / (2.0 - part))
}

/// Pitching moment over dynamic pressure, frontal area and length, about the middle and nose up, at so many degrees:
/// `2 V sin a cos a (k2 - k1) / (S l)` [Munk 1924, NACA Report 184], with the masses of a spheroid that is finer by `1 / sqrt(1 - M^2)`
/// [Göthert 1940, NACA TM 1105]. Of first order in thickness where the gas is compressed. There is neither lift nor drag.
pub fn pitching_moment(fineness: f64, mach: f64, degrees: f64) -> f64 {
    let [along, across] = added_masses(fineness / (1.0 - mach * mach).sqrt());
    // Of a length of one.
    let radius = 0.5 / fineness;
    let (volume, front) = (2.0 / 3.0 * PI * radius * radius, PI * radius * radius);
    let (sine, cosine) = degrees.to_radians().sin_cos();
    2.0 * volume * sine * cosine * (across - along) / front
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `a0 = l int du / ((l^2 + u)^(3/2) (1 + u))` and `b0 = l int du / ((l^2 + u)^(1/2) (1 + u)^2)` from nothing on, the same article; half of a sphere's.
    #[test]
    fn masses_are_those_of_the_integrals() {
        const STEPS: u32 = 40_000;
        let integral = |of: &dyn Fn(f64) -> f64| -> f64 {
            let each = (0..STEPS).map(|n| {
                let s = (f64::from(n) + 0.5) / f64::from(STEPS);
                of(s / (1.0 - s)) / ((1.0 - s) * (1.0 - s))
            });
            each.sum::<f64>() / f64::from(STEPS)
        };
        for l in [1.000_1_f64, 1.5, 4.0, 10.0] {
            let parts: [&dyn Fn(f64) -> f64; 2] =
                [&|u| l / ((l * l + u).powf(1.5) * (1.0 + u)), &|u| {
                    l / ((l * l + u).sqrt() * (1.0 + u).powi(2))
                }];
            let [along, across] = parts.map(|part| {
                let whole = integral(part);
                whole / (2.0 - whole)
            });
            let [a, b] = added_masses(l);
            assert!(
                (a - along).abs() < 1e-4 && (b - across).abs() < 1e-4,
                "{l}: {a} {b}"
            );
        }
        assert!(
            added_masses(1.000_1)
                .iter()
                .all(|mass| (mass - 0.5).abs() < 1e-3)
        );
        // Lamb's table.
        let [along, across] = added_masses(3.99);
        assert!((along - 0.082).abs() < 1e-3 && (across - 0.860).abs() < 1e-3);
    }

    /// Of slender bodies `2 V a / (S l)`, compressed or not.
    #[test]
    fn moments_of_slender_spheroids_do_not_know_the_mach_number() {
        let slender = |mach| pitching_moment(200.0, mach, 1.0) / (4.0 / 3.0 * 1_f64.to_radians());
        assert!((slender(0.0) - 1.0).abs() < 1e-3 && (slender(0.8) - 1.0).abs() < 1e-3);
        assert!(pitching_moment(4.0, 0.8, 4.0) > pitching_moment(4.0, 0.0, 4.0));
    }
}
