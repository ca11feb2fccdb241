//! A quantity that is known at places around a point: how it rises there, by the plane of least squares through it.

use aero_geometry::Vector;

use crate::records::Matrix;

/// Part of the places' spread that is added to it in every direction: in those where there is none the quantity is even.
const LEVEL: f64 = 1e-6;

/// How far the value may lie beyond all that are known, as a part of their range.
const BEYOND: f64 = 0.5;

/// A positive value stays so: this part of the least one is left.
const LEAST: f64 = 0.5;

/// Sums over the places.
#[derive(Clone, Copy, Debug)]
pub struct Fit<const D: usize> {
    weight: f64,
    value: f64,
    arm: Vector<D>,
    product: Vector<D>,
    spread: Matrix<D>,
    range: [f64; 2],
}

impl<const D: usize> Fit<D> {
    /// Nothing known.
    pub fn new() -> Self {
        Self {
            weight: 0.0,
            value: 0.0,
            arm: Vector::zeros(),
            product: Vector::zeros(),
            spread: Matrix::zeros(),
            range: [f64::INFINITY, f64::NEG_INFINITY],
        }
    }

    /// Adds a `value` at `arm` from the point.
    pub fn add(&mut self, weight: f64, arm: &Vector<D>, value: f64) {
        self.weight += weight;
        self.value += weight * value;
        self.arm += arm * weight;
        self.product += arm * (weight * value);
        self.spread += arm * arm.transpose() * weight;
        self.range = [self.range[0].min(value), self.range[1].max(value)];
    }

    /// How fast it rises; not at all where too little is known.
    pub fn slope(&self) -> Vector<D> {
        if self.weight <= 0.0 {
            return Vector::zeros();
        }
        let arm = self.arm / self.weight;
        let spread = self.spread / self.weight - arm * arm.transpose();
        let product = self.product / self.weight - arm * (self.value / self.weight);
        let level = Matrix::<D>::identity() * (LEVEL * spread.trace());
        let inverse = (spread + level).try_inverse();
        inverse.map_or_else(Vector::zeros, |inverse| inverse * product)
    }

    /// `value`, brought back to near the range of what is known and of `own`.
    pub fn bounded(&self, own: f64, value: f64) -> f64 {
        let [low, high] = [self.range[0].min(own), self.range[1].max(own)];
        let beyond = BEYOND * (high - low);
        let least = (low - beyond).max(LEAST * low);
        value.max(least).min(high + beyond)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Places on one side of the point, unevenly.
    fn places() -> impl Iterator<Item = Vector<3>> {
        (0..60_u32).map(|n| {
            let part = |k: u32| f64::from(n * k % 59) / 59.0;
            Vector::<3>::new(part(7), part(13) - 0.4, part(29) - 0.6)
        })
    }

    #[test]
    fn what_is_linear_is_had_exactly() {
        let slope = Vector::<3>::new(0.8, -0.3, 0.1);
        let mut fit = Fit::new();
        for arm in places() {
            fit.add(1.0 - arm.norm() * 0.2, &arm, 2.0 + slope.dot(&arm));
        }
        assert!((fit.slope() - slope).norm() < 1e-4, "{}", fit.slope());
    }

    #[test]
    fn in_a_plane_the_slope_across_it_is_none() {
        let mut fit = Fit::new();
        for mut arm in places() {
            arm[0] = 0.0;
            fit.add(1.0, &arm, 1.0 + 0.5 * arm[1]);
        }
        let error = fit.slope() - Vector::<3>::y() * 0.5;
        assert!(error.norm() < 1e-4, "{error}");
        assert_eq!(Fit::<2>::new().slope(), Vector::<2>::zeros());
    }

    #[test]
    fn a_value_is_neither_far_beyond_all_known_nor_negative() {
        let mut fit = Fit::<1>::new();
        fit.add(1.0, &Vector::<1>::new(1.0), 0.1);
        fit.add(1.0, &Vector::<1>::new(1.1), 10.0);
        assert_eq!(fit.bounded(1.0, -90.0), 0.05);
        assert_eq!(fit.bounded(1.0, 5.0), 5.0);
        assert!((fit.bounded(1.0, 90.0) - 14.95).abs() < 1e-12);
    }
}
