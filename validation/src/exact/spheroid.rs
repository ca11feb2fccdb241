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

    /// Lamb's table: 0.5, 0.5 of the sphere; 0.209, 0.702 at twice as long as thick; 0.082, 0.860 at four times.
    #[test]
    fn masses_are_those_of_the_table() {
        for (fineness, along, across) in [
            (1.000_1, 0.5, 0.5),
            (2.0, 0.209, 0.702),
            (3.99, 0.082, 0.860),
            (9.97, 0.021, 0.960),
        ] {
            let [a, b] = added_masses(fineness);
            assert!(
                (a - along).abs() < 1e-3 && (b - across).abs() < 1e-3,
                "{fineness}: {a} {b}"
            );
        }
    }

    /// Of slender bodies `2 V a / (S l)`, compressed or not.
    #[test]
    fn moments_of_slender_spheroids_do_not_know_the_mach_number() {
        let slender = |mach| pitching_moment(200.0, mach, 1.0) / (4.0 / 3.0 * 1_f64.to_radians());
        assert!((slender(0.0) - 1.0).abs() < 1e-3 && (slender(0.8) - 1.0).abs() < 1e-3);
        assert!(pitching_moment(4.0, 0.8, 4.0) > pitching_moment(4.0, 0.0, 4.0));
    }
}
