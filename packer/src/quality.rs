//! Measures how good a packing is.

use aero_geometry::Pencils;
use rayon::prelude::*;

use crate::plan::Plan;
use crate::{Ghosts, PackReport};

/// All that the report holds but the time taken.
pub(crate) fn report<const D: usize>(plan: &Plan<'_, D>, ghosts: &Ghosts<D>) -> PackReport {
    let spacing = plan.options.spacing;
    let mut layer_counts = vec![0; plan.options.layers];
    for &layer in &ghosts.layer {
        layer_counts[layer as usize] += 1;
    }
    let exact = plan.shell_volume();
    let packed: f64 = ghosts.volume.iter().sum();
    let wall = ghosts.distance.iter().zip(&ghosts.layer);
    let wall_offset_max = wall
        .filter(|&(_, &layer)| layer == 0)
        .map(|(distance, _)| (distance + 0.5 * spacing).abs() / spacing)
        .fold(0.0, f64::max);
    PackReport {
        spacing,
        ghosts: ghosts.position.len(),
        layer_counts,
        shell_volume_error_percent: 100.0 * (packed - exact).abs() / exact,
        wall_offset_max,
        min_gap: smallest_gap(&ghosts.position, spacing),
        ..PackReport::default()
    }
}

/// Smallest distance between two points, in spacings; at most two.
fn smallest_gap<const D: usize>(points: &[aero_geometry::Vector<D>], spacing: f64) -> f64 {
    let reach = 2.0 * spacing;
    let pencils = Pencils::new(points, reach);
    points
        .par_iter()
        .enumerate()
        .map(|(n, point)| {
            let mut smallest = reach;
            let (low, high) = (point.add_scalar(-reach), point.add_scalar(reach));
            pencils.for_each_run(&low, &high, |run| {
                for &m in &pencils.order()[run] {
                    if m as usize != n {
                        smallest = smallest.min((points[m as usize] - point).norm());
                    }
                }
            });
            smallest
        })
        .reduce(|| reach, f64::min)
        / spacing
}
