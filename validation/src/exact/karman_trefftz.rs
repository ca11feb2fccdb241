//! Aerofoils of Kármán and Trefftz in a stream far slower than sound: a circle that a map bends, and with it the flow around it.
//!
//! [von Kármán & Trefftz 1918; Milne-Thomson 1958, Theoretical Aerodynamics, 4th ed., 7.3; for gas Glauert 1928, Proc. R. Soc. A 118, 113-119]

use std::f64::consts::PI;

/// A symmetric aerofoil with a chord of one, its leading edge at the origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct KarmanTrefftz {
    /// Radius of the circle, whose middle is as far behind as it goes beyond one.
    radius: f64,
    /// Power of the map, `2 - angle / pi`.
    power: f64,
}

impl KarmanTrefftz {
    /// That of the circle about `-eccentricity` through 1, with this angle (radians) at the trailing edge.
    pub fn new(eccentricity: f64, trailing_edge: f64) -> Self {
        Self {
            radius: 1.0 + eccentricity,
            power: 2.0 - trailing_edge / PI,
        }
    }

    /// Where the circle's point at `angle` (radians) from the trailing edge goes, in units of the circle's.
    fn mapped(&self, angle: f64) -> [f64; 2] {
        let (sine, cosine) = angle.sin_cos();
        let [x, y] = [self.radius * (cosine - 1.0) + 1.0, self.radius * sine];
        // (z - n) / (z + n) = ((c - 1) / (c + 1))^n, with the logarithm of the quotient.
        let away = (x - 1.0).hypot(y);
        if away < 1e-12 {
            return [self.power, 0.0];
        }
        let size = (away / (x + 1.0).hypot(y)).powf(self.power);
        let turn = self.power * (y.atan2(x - 1.0) - y.atan2(x + 1.0));
        let [a, b] = [size * turn.cos(), size * turn.sin()];
        // z = n (1 + w) / (1 - w)
        let below = (1.0 - a).powi(2) + b * b;
        [
            self.power * (1.0 - a * a - b * b) / below,
            self.power * 2.0 * b / below,
        ]
    }

    /// Length of what the map makes of the circle.
    fn length(&self) -> f64 {
        self.power - self.mapped(PI)[0]
    }

    /// `count` points of the outline, counterclockwise from the trailing edge.
    pub fn outline(&self, count: usize) -> Vec<[f64; 2]> {
        let length = self.length();
        let points = (0..count).map(|k| {
            let [x, y] = self.mapped(2.0 * PI * k as f64 / count as f64);
            [(x - self.power) / length + 1.0, y / length]
        });
        points.collect()
    }

    /// Lift coefficient at an incidence (radians), at a Mach number well below one: that of the incompressible flow, `8 pi R sin(a)`
    /// over the chord, over `sqrt(1 - M^2)`.
    pub fn lift_coefficient(&self, incidence: f64, mach: f64) -> f64 {
        8.0 * PI * self.radius * incidence.sin() / (self.length() * (1.0 - mach * mach).sqrt())
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    /// Joukowski's: `z = c + 1 / c`, a chord of `4 (1 + e^2 / (1 + 2 e))`.
    #[test]
    fn without_an_angle_it_is_joukowskis() {
        let eccentricity = 0.1;
        let aerofoil = KarmanTrefftz::new(eccentricity, 0.0);
        let chord = 4.0 * (1.0 + eccentricity * eccentricity / (1.0 + 2.0 * eccentricity));
        assert_relative_eq!(aerofoil.length(), chord, max_relative = 1e-12);
        let (sine, cosine) = 1.1_f64.sin_cos();
        let [x, y] = [1.1 * (cosine - 1.0) + 1.0, 1.1 * sine];
        let square = x * x + y * y;
        let [u, v] = aerofoil.mapped(1.1);
        assert_relative_eq!(u, x + x / square, max_relative = 1e-12);
        assert_relative_eq!(v, y - y / square, max_relative = 1e-12);
    }

    #[test]
    fn the_edges_meet_at_the_angle() {
        let angle = 10_f64.to_radians();
        let outline = KarmanTrefftz::new(0.08, angle).outline(100_000);
        let [tail, above] = [outline[0], outline[20]];
        assert_relative_eq!(tail[0], 1.0, max_relative = 1e-12);
        let slope = (above[1] - tail[1]) / (tail[0] - above[0]);
        assert_relative_eq!(2.0 * slope.atan(), angle, max_relative = 0.01);
        let below = outline[outline.len() - 20];
        assert_relative_eq!(below[1], -above[1], max_relative = 1e-9);
    }

    /// A flat plate has `2 pi sin(a)`; thickness and Mach number add to it.
    #[test]
    fn lift_is_that_of_a_plate_and_more() {
        let plate = KarmanTrefftz::new(0.0, 0.0).lift_coefficient(0.03, 0.0);
        assert_relative_eq!(plate, 2.0 * PI * 0.03_f64.sin(), max_relative = 1e-12);
        let aerofoil = KarmanTrefftz::new(0.08, 10_f64.to_radians());
        let lift = aerofoil.lift_coefficient(2_f64.to_radians(), 0.2);
        assert_relative_eq!(lift, 0.24704, max_relative = 1e-4);
    }
}
