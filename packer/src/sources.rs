//! Points with volumes, sorted for summing kernels over them.

use aero_geometry::kernel::{QuinticSpline, SUPPORT};
use aero_geometry::{Pencils, Vector};

use crate::mirror::Mirrors;

/// What contributes to a summed density: points and their volumes, with their images.
#[derive(Clone, Debug)]
pub(crate) struct Sources<const D: usize> {
    /// In the order of the pencils' slots.
    sorted: Vec<(Vector<D>, f64)>,
    pencils: Pencils<D>,
}

impl<const D: usize> Sources<D> {
    /// Sorts `points` and those of their images that are within `reach` of a mirror plane; sums
    /// up to `reach` from a point above the planes are complete.
    pub fn new(
        mirrors: &Mirrors,
        points: impl IntoIterator<Item = (Vector<D>, f64)>,
        reach: f64,
    ) -> Self {
        let mut position = Vec::new();
        let mut volume = Vec::new();
        for (point, v) in points {
            position.push(point);
            volume.push(v);
            mirrors.images_within(&point, reach, |_, image| {
                position.push(image);
                volume.push(v);
            });
        }
        let pencils = Pencils::new(&position, 0.5 * reach);
        let order = pencils.order().iter();
        let sorted = order
            .map(|&n| (position[n as usize], volume[n as usize]))
            .collect();
        Self { sorted, pencils }
    }

    /// `Σ V W` at a point.
    pub fn density(&self, point: &Vector<D>, smoothing: f64) -> f64 {
        let mut sum = 0.0;
        self.around(point, SUPPORT * smoothing, |volume, _, r| {
            sum += volume * QuinticSpline::<D>::value(r, smoothing);
        });
        sum
    }

    /// `Σ V ∇W` at a point.
    pub fn gradient(&self, point: &Vector<D>, smoothing: f64) -> Vector<D> {
        let mut sum = Vector::zeros();
        self.around(point, SUPPORT * smoothing, |volume, offset, r| {
            sum += volume * QuinticSpline::<D>::gradient_factor(r, smoothing) * offset;
        });
        sum
    }

    /// Distance to the nearest other point, at most `reach`.
    pub fn nearest(&self, point: &Vector<D>, reach: f64) -> f64 {
        let mut nearest = reach;
        let mut itself = 0;
        self.around(point, reach, |_, _, r| {
            if r > 0.0 {
                nearest = nearest.min(r);
            } else {
                itself += 1;
            }
        });
        if itself > 1 { 0.0 } else { nearest }
    }

    /// Calls `visit` with volume, offset and distance of every point nearer than `reach`.
    #[inline]
    fn around(&self, point: &Vector<D>, reach: f64, mut visit: impl FnMut(f64, &Vector<D>, f64)) {
        let (low, high) = (point.add_scalar(-reach), point.add_scalar(reach));
        self.pencils.for_each_run(&low, &high, |slots| {
            for (position, volume) in &self.sorted[slots] {
                let offset = point - position;
                let squared = offset.norm_squared();
                if squared < reach * reach {
                    visit(*volume, &offset, squared.sqrt());
                }
            }
        });
    }
}
