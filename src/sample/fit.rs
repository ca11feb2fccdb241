//! A plane fitted to values around a place.

use aero_geometry::Vector;
use nalgebra::{Cholesky, SMatrix};

/// What is found at a place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Found<const D: usize, const N: usize> {
    /// Values of the plane there.
    pub values: [f64; N],
    /// Their slopes.
    pub slopes: [Vector<D>; N],
    /// Weighted means of what lies around.
    pub means: [f64; N],
    /// They are those of a plane, not of the mean alone.
    pub is_plane: bool,
    /// Width of the weights, in the mean of squares.
    pub width: f64,
}

/// Sums of `a + b . d` fitted by least squares to the values at offsets `d` from a place, each with its weight [Lancaster &
/// Salkauskas 1981]. Linear values are met to round-off, whatever the arrangement.
#[derive(Clone, Debug)]
pub(super) struct Fit<const D: usize, const N: usize> {
    weight: f64,
    /// Of the offsets.
    first: Vector<D>,
    /// Of their products.
    second: SMatrix<f64, D, D>,
    /// What values are counted from: round-off of large ones stays small.
    base: [f64; N],
    values: [f64; N],
    /// Of values times offsets.
    mixed: [Vector<D>; N],
    /// Of the squares of the widths.
    widths: f64,
}

impl<const D: usize, const N: usize> Fit<D, N> {
    pub(super) fn new() -> Self {
        Self {
            weight: 0.0,
            first: Vector::zeros(),
            second: SMatrix::zeros(),
            base: [0.0; N],
            values: [0.0; N],
            mixed: [Vector::zeros(); N],
            widths: 0.0,
        }
    }

    /// Adds values at an offset from the place; they count within about `width`.
    pub(super) fn add(&mut self, weight: f64, offset: &Vector<D>, values: &[f64; N], width: f64) {
        if self.weight == 0.0 {
            self.base = *values;
        }
        self.weight += weight;
        self.widths += weight * width * width;
        self.first += offset * weight;
        self.second += offset * offset.transpose() * weight;
        for n in 0..N {
            let value = weight * (values[n] - self.base[n]);
            self.values[n] += value;
            self.mixed[n] += offset * value;
        }
    }

    /// The plane, or the mean where what lies around is on one spot or in one line; none where nothing is.
    pub(super) fn solved(&self) -> Option<Found<D, N>> {
        /// Less spread than this, in squares of the width, is none.
        const SPREAD: f64 = 0.01;
        if self.weight <= 0.0 {
            return None;
        }
        let part = 1.0 / self.weight;
        let middle = self.first * part;
        let spread = self.second * part - middle * middle.transpose();
        let means: [f64; N] = std::array::from_fn(|n| self.values[n] * part);
        let mut found = Found {
            values: std::array::from_fn(|n| self.base[n] + means[n]),
            slopes: [Vector::zeros(); N],
            means: std::array::from_fn(|n| self.base[n] + means[n]),
            is_plane: false,
            width: (self.widths * part).sqrt(),
        };
        let least = SPREAD * self.widths * part;
        // The product of all that is left over at each pivot is the determinant.
        let solver = Cholesky::new(spread).filter(|solver| {
            let pivots = solver.l_dirty().diagonal();
            pivots.iter().all(|pivot| pivot * pivot >= least)
        });
        let Some(solver) = solver else {
            return Some(found);
        };
        found.is_plane = true;
        for n in 0..N {
            let slope = solver.solve(&(self.mixed[n] * part - middle * means[n]));
            found.slopes[n] = slope;
            found.values[n] = self.base[n] + means[n] - slope.dot(&middle);
        }
        Some(found)
    }
}
