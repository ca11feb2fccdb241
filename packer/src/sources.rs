//! Points with volumes, sorted for summing kernels over them.

use std::ops::Range;

use aero_geometry::kernel::SUPPORT;
use aero_geometry::parallel::prelude::*;
use aero_geometry::{Pencils, Vector};
use pulp::Arch;

use crate::lanes::{CLUSTER, Factor, KernelSum, Lanes};
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

    /// `Σ V W` at each point.
    pub fn densities(&self, points: &[Vector<D>], smoothing: f64) -> Vec<f64> {
        self.near_each(points, SUPPORT * smoothing, |cluster, runs| {
            self.summed(cluster, runs, smoothing, Factor::Value).0
        })
    }

    /// `Σ V ∇W` at each point.
    pub fn gradients(&self, points: &[Vector<D>], smoothing: f64) -> Vec<Vector<D>> {
        self.near_each(points, SUPPORT * smoothing, |cluster, runs| {
            let (_, moment) = self.summed(cluster, runs, smoothing, Factor::Slope);
            std::array::from_fn(|l| Vector::from_fn(|k, _| moment[k][l]))
        })
    }

    /// `Σ V (1 - r / reach) e` over the sources nearer than `reach`, where `e` is the direction away
    /// from the source.
    pub fn crowding(&self, points: &[Vector<D>], reach: f64) -> Vec<Vector<D>> {
        self.near_each(points, reach, |cluster, runs| {
            let (_, moment) = self.summed(cluster, runs, reach / SUPPORT, Factor::Closeness);
            std::array::from_fn(|l| Vector::from_fn(|k, _| moment[k][l]))
        })
    }

    /// Distance from each point to the nearest source, at most `reach`. If the points are `among`
    /// the sources, one source at the very place of a point is the point itself.
    pub fn nearest(&self, points: &[Vector<D>], reach: f64, among: bool) -> Vec<f64> {
        self.near_each(points, reach, |cluster, runs| {
            cluster.map(|point| {
                let mut nearest = reach;
                let mut itself = among;
                for (source, _) in runs.iter().flat_map(|run| &self.sorted[run.clone()]) {
                    let r = (point - source).norm();
                    if r == 0.0 && itself {
                        itself = false;
                    } else {
                        nearest = nearest.min(r);
                    }
                }
                nearest
            })
        })
    }

    fn summed(
        &self,
        cluster: &[Vector<D>; CLUSTER],
        runs: &[Range<usize>],
        smoothing: f64,
        factor: Factor,
    ) -> (Lanes, [Lanes; D]) {
        Arch::new().dispatch(KernelSum {
            sorted: &self.sorted,
            runs,
            position: std::array::from_fn(|k| cluster.map(|point| point[k])),
            smoothing,
            factor,
        })
    }

    /// Evaluates `answers` for clusters of points and runs of sources that hold all nearer than
    /// `reach`. Neighbours in the sorted order share a search; a cluster that is not full repeats
    /// its last point.
    fn near_each<T: Send>(
        &self,
        points: &[Vector<D>],
        reach: f64,
        answers: impl Fn(&[Vector<D>; CLUSTER], &[Range<usize>]) -> [T; CLUSTER] + Sync,
    ) -> Vec<T> {
        let order = Pencils::new(points, 0.5 * reach);
        let mut all: Vec<(u32, T)> = order
            .order()
            .par_chunks(CLUSTER)
            .flat_map_iter(|numbers| {
                let mut runs = Vec::new();
                let last = numbers.len() - 1;
                let cluster: [Vector<D>; CLUSTER] =
                    std::array::from_fn(|l| points[numbers[l.min(last)] as usize]);
                let low = cluster.iter().fold(cluster[0], |low, point| low.inf(point));
                let high = cluster
                    .iter()
                    .fold(cluster[0], |high, point| high.sup(point));
                self.pencils.for_each_run(
                    &low.add_scalar(-reach),
                    &high.add_scalar(reach),
                    |slots| runs.push(slots),
                );
                let answers = answers(&cluster, &runs);
                numbers.iter().copied().zip(answers)
            })
            .collect();
        all.sort_unstable_by_key(|&(n, _)| n);
        all.into_iter().map(|(_, answer)| answer).collect()
    }
}

#[cfg(test)]
mod tests {
    use aero_geometry::kernel::QuinticSpline;

    use super::*;

    #[test]
    fn sums_in_lanes_equal_sums_term_by_term() {
        let mut seed = 5_u64;
        let mut next = || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (seed >> 11) as f64 / (1_u64 << 53) as f64
        };
        let points: Vec<Vector<3>> = (0..300).map(|_| Vector::from_fn(|_, _| next())).collect();
        let volumes: Vec<f64> = (0..300).map(|_| next()).collect();
        let pairs = points.iter().copied().zip(volumes.iter().copied());
        let h = 0.1;
        let sources = Sources::new(&Mirrors::default(), pairs, SUPPORT * h);
        let densities = sources.densities(&points, h);
        let gradients = sources.gradients(&points, h);
        for (n, point) in points.iter().enumerate() {
            let mut density = 0.0;
            let mut gradient = Vector::<3>::zeros();
            for (other, volume) in points.iter().zip(&volumes) {
                let offset = point - other;
                density += volume * QuinticSpline::<3>::value(offset.norm(), h);
                gradient += volume * QuinticSpline::<3>::gradient_factor(offset.norm(), h) * offset;
            }
            assert!((densities[n] - density).abs() < 1e-12 * density.abs());
            assert!((gradients[n] - gradient).norm() < 1e-10 * density / h);
        }
    }
}
