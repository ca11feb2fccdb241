//! Seeds on a level surface in space: lattice points projected onto it, with their number set right
//! by removing the densest and filling the sparsest places.

use aero_geometry::kernel::SUPPORT;
use aero_geometry::{Shape, Vector};
use rayon::prelude::*;

use crate::grid::{Cell, Grid};
use crate::level::project;
use crate::mirror::Mirrors;
use crate::relax::{OnSheet, Relaxation, spread_on_sheet};
use crate::thin::fits;

/// Evens out what projection and repair leave; a short smoothing length acts on single gaps.
const SPREADING: Relaxation = Relaxation {
    steps: 24,
    smoothing: 1.0,
    strength: 0.8,
};

/// The lattice that seeds come from, and the body.
pub(crate) struct Sheets<'a, const D: usize> {
    /// The body.
    pub shape: &'a dyn Shape<D>,
    /// Its mirror planes.
    pub mirrors: &'a Mirrors,
    /// Lattice of cells of one spacing.
    pub grid: Grid<D>,
    /// The cells near the surface.
    pub band: &'a [Cell<D>],
    /// How exactly a point has to meet its level.
    pub tolerance: f64,
}

impl<const D: usize> Sheets<'_, D> {
    /// Particles on the sheet `distance = level`, as many as `wanted` up to rounding; a particle on
    /// a mirror plane counts one half for each plane.
    pub fn seeds(&self, layer: usize, level: f64, wanted: f64) -> Vec<Vector<D>> {
        let half = 0.5 * self.grid.step;
        let mut points: Vec<Vector<D>> = self
            .band
            .par_iter()
            .filter(|cell| cell.distance >= level - half && cell.distance < level + half)
            .filter(|cell| {
                let centre = self.grid.centre(&cell.index);
                let seen = (&centre, cell.distance, &cell.normal);
                fits(self.shape, seen, layer, self.grid.step)
            })
            .filter_map(|cell| {
                let centre = self
                    .mirrors
                    .snapped(self.grid.centre(&cell.index), 1e-6 * self.grid.step);
                let point = project(self.shape, &centre, level, self.tolerance)?;
                ((point - centre).norm() < 1.01 * self.grid.step)
                    .then(|| self.keep_on_planes(point, &centre))
            })
            .collect();
        for _ in 0..40 {
            let surplus = points.iter().map(|p| self.mirrors.share(p)).sum::<f64>() - wanted;
            if surplus.abs() <= 0.5 {
                break;
            }
            if surplus > 0.0 {
                self.thin_out(&mut points, surplus);
            } else if !self.fill_up(&mut points, -surplus, level) {
                break;
            }
        }
        let sizes = (self.grid.step, self.tolerance);
        spread_on_sheet(
            self.shape,
            self.mirrors,
            &mut points,
            level,
            sizes,
            SPREADING,
        );
        points
    }

    /// Keeps a projected point on the planes on which it started, and on its side of the others.
    fn keep_on_planes(&self, mut point: Vector<D>, start: &Vector<D>) -> Vector<D> {
        for &(axis, position) in self.mirrors.planes() {
            if start[axis] == position || point[axis] < position {
                point[axis] = position;
            }
        }
        point
    }

    /// Removes up to `surplus` of the densest points, no two of them neighbours.
    fn thin_out(&self, points: &mut Vec<Vector<D>>, surplus: f64) {
        let ranked = self.ranked(points);
        let mut left = surplus;
        let mut removed: Vec<Vector<D>> = Vec::new();
        let mut gone = vec![false; points.len()];
        for &(n, _) in ranked.iter().rev() {
            let weight = self.mirrors.share(&points[n]);
            if left < weight - 0.5 || left <= 0.5 || removed.len() > points.len() / 8 {
                break;
            }
            if self.clear_of(&removed, &points[n]) {
                gone[n] = true;
                removed.push(points[n]);
                left -= weight;
            }
        }
        let mut n = 0;
        points.retain(|_| {
            n += 1;
            !gone[n - 1]
        });
    }

    /// Adds up to `missing` points beside the loneliest ones; false where none could be added.
    fn fill_up(&self, points: &mut Vec<Vector<D>>, missing: f64, level: f64) -> bool {
        let ranked = self.ranked(points);
        let mut left = missing;
        let mut added: Vec<Vector<D>> = Vec::new();
        for &(n, away) in &ranked {
            if left <= 0.5 || added.len() > points.len() / 8 {
                break;
            }
            let away = if away.norm() > 1e-9 {
                away.normalize()
            } else {
                Vector::from_fn(|k, _| if k == 0 { 1.0 } else { 0.0 })
            };
            let guess = points[n] + 0.7 * self.grid.step * away;
            let Some(point) = project(self.shape, &guess, level, self.tolerance) else {
                continue;
            };
            let above = self
                .mirrors
                .planes()
                .iter()
                .all(|&(axis, p)| point[axis] > p);
            let free = points
                .iter()
                .all(|p| (p - point).norm() > 0.4 * self.grid.step);
            if above && free && self.clear_of(&added, &point) {
                added.push(point);
                left -= 1.0;
            }
        }
        points.extend(&added);
        !added.is_empty()
    }

    fn clear_of(&self, others: &[Vector<D>], point: &Vector<D>) -> bool {
        let reach = 2.0 * self.grid.step;
        others.iter().all(|other| (other - point).norm() > reach)
    }

    /// Points from the loneliest to the densest, each with the direction away from its neighbours.
    fn ranked(&self, points: &[Vector<D>]) -> Vec<(usize, Vector<D>)> {
        let step = self.grid.step;
        let sheet = OnSheet::new(self.mirrors, points, SUPPORT * step);
        let mut ranked: Vec<(usize, f64, Vector<D>)> = points
            .par_iter()
            .enumerate()
            .map(|(n, point)| {
                let (density, slope) = sheet.sum(point, step);
                (n, density, -slope)
            })
            .collect();
        ranked.sort_by(|a, b| a.1.total_cmp(&b.1).then(a.0.cmp(&b.0)));
        ranked.into_iter().map(|(n, _, away)| (n, away)).collect()
    }
}
