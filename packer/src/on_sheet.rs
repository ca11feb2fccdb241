//! Points on one level surface, whose density is per area.

use aero_geometry::kernel::{QuinticSpline, SUPPORT};
use aero_geometry::{Pencils, Vector};

use crate::mirror::Mirrors;

/// A seed on a sheet.
pub(crate) struct Seed<const D: usize> {
    /// Where it lies.
    pub place: Vector<D>,
    /// Normal of the sheet there, or near there.
    pub normal: Vector<D>,
    /// Block of space for which it counts.
    pub block: [i64; D],
    /// True where the lattice itself is the best packing.
    pub fixed: bool,
}

/// Points of one sheet, whose density is per area.
pub(crate) struct OnSheet<const D: usize> {
    points: Vec<Vector<D>>,
    /// Number of each, images beyond the points themselves.
    numbers: Vec<u32>,
    pencils: Pencils<D>,
}

impl<const D: usize> OnSheet<D> {
    /// The points and those of their images that are within `reach` of a mirror plane.
    pub fn new(mirrors: &Mirrors, points: &[Vector<D>], reach: f64) -> Self {
        let mut all = points.to_vec();
        for point in points {
            mirrors.images_within(point, reach, |_, image| all.push(image));
        }
        let pencils = Pencils::new(&all, 0.5 * reach);
        Self {
            numbers: pencils.order().to_vec(),
            points: pencils.order().iter().map(|&n| all[n as usize]).collect(),
            pencils,
        }
    }

    /// Distance to the nearest point, at most `reach`.
    pub fn nearest(&self, centre: &Vector<D>, reach: f64) -> f64 {
        let mut nearest = reach;
        let (low, high) = (centre.add_scalar(-reach), centre.add_scalar(reach));
        self.pencils.for_each_run(&low, &high, |slots| {
            for point in &self.points[slots] {
                nearest = nearest.min((centre - point).norm());
            }
        });
        nearest
    }

    /// `Σ (1 - r / reach) e` over the points nearer than `reach` to point `n`, `e` the direction away
    /// from each. Of two points at one place, the earlier goes one way and the later the other.
    pub fn crowding(&self, n: usize, centre: &Vector<D>, reach: f64) -> Vector<D> {
        let mut sum = Vector::zeros();
        let (low, high) = (centre.add_scalar(-reach), centre.add_scalar(reach));
        self.pencils.for_each_run(&low, &high, |slots| {
            for slot in slots {
                let offset = centre - self.points[slot];
                let r = offset.norm();
                let other = self.numbers[slot] as usize;
                if r >= reach || other == n {
                    continue;
                }
                if r > 1e-6 * reach {
                    sum += (1.0 - r / reach) / r * offset;
                } else {
                    let sign = if n < other { 1.0 } else { -1.0 };
                    sum += Vector::from_fn(|k, _| sign / (k as f64 + 1.5));
                }
            }
        });
        sum
    }

    /// Number of points per area, and its gradient, with the kernel of the plane.
    pub fn sum(&self, centre: &Vector<D>, smoothing: f64) -> (f64, Vector<D>) {
        let reach = SUPPORT * smoothing;
        let mut density = 0.0;
        let mut slope = Vector::zeros();
        let (low, high) = (centre.add_scalar(-reach), centre.add_scalar(reach));
        self.pencils.for_each_run(&low, &high, |slots| {
            for point in &self.points[slots] {
                let offset = centre - point;
                let r = offset.norm();
                if r < reach {
                    density += QuinticSpline::<2>::value(r, smoothing);
                    slope += QuinticSpline::<2>::gradient_factor(r, smoothing) * offset;
                }
            }
        });
        (density, slope)
    }
}
