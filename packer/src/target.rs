//! What the ghosts' summed density ought to be: the density of the exact layers, each spread evenly
//! over its middle level.
//!
//! Near the surface and at the deepest layer the kernel's support is not filled by ghosts, so "one"
//! is the wrong aim there. The right one is the sum over ideally placed ghosts, in the limit of
//! infinitely many per level. Ghosts that meet it on their side, and fluid on the other, add up to a
//! uniform density.

use aero_geometry::kernel::{QuinticSpline, SUPPORT};
use aero_geometry::{Pencils, Vector};
use rayon::prelude::*;

use crate::level::project;
use crate::plan::Plan;

/// Cells farther than this from the middle of their layer (in spacings) stay where they are: they
/// are in a tip that the middle does not reach.
const FARTHEST: f64 = 1.0;

/// The layers as many small pieces.
pub(crate) struct Target<const D: usize> {
    position: Vec<Vector<D>>,
    volume: Vec<f64>,
    pencils: Pencils<D>,
}

impl<const D: usize> Target<D> {
    /// Cuts the ghost layers of `plan` into pieces and moves each to the middle of its layer.
    pub fn of_layers(plan: &Plan<'_, D>) -> Self {
        let spacing = plan.options.spacing;
        let pieces: Vec<(Vector<D>, f64)> = plan
            .band
            .par_iter()
            .flat_map_iter(|cell| {
                let centre = plan.fine.centre(&cell.index);
                plan.parts(cell)
                    .map(|(layer, volume)| {
                        let level = plan.level(layer);
                        let guess = centre - (cell.distance - level) * cell.normal;
                        let place = project(plan.shape, &guess, level, 1e-3 * spacing)
                            .filter(|p| (p - centre).norm() < FARTHEST * spacing)
                            .unwrap_or(centre);
                        (place, volume)
                    })
                    .collect::<Vec<_>>()
            })
            .collect();
        let own: Vec<Vector<D>> = pieces.iter().map(|piece| piece.0).collect();
        let mut volume: Vec<f64> = pieces.iter().map(|piece| piece.1).collect();
        let reach = 2.0 * SUPPORT * spacing;
        let mut position = own.clone();
        for (n, point) in own.iter().enumerate() {
            plan.mirrors.images_within(point, reach, |_, image| {
                position.push(image);
                volume.push(volume[n]);
            });
        }
        let pencils = Pencils::new(&position, 1.5 * spacing);
        let order = pencils.order();
        Self {
            position: order.iter().map(|&n| position[n as usize]).collect(),
            volume: order.iter().map(|&n| volume[n as usize]).collect(),
            pencils,
        }
    }

    /// The ideal sum `Σ V W` at a point, and its gradient.
    pub fn at(&self, point: &Vector<D>, smoothing: f64) -> (f64, Vector<D>) {
        let mut sum = 0.0;
        let mut gradient = Vector::zeros();
        let reach = SUPPORT * smoothing;
        let (low, high) = (point.add_scalar(-reach), point.add_scalar(reach));
        self.pencils.for_each_run(&low, &high, |run| {
            for n in run {
                let offset = point - self.position[n];
                let r = offset.norm();
                if r < reach {
                    sum += self.volume[n] * QuinticSpline::<D>::value(r, smoothing);
                    gradient +=
                        self.volume[n] * QuinticSpline::<D>::gradient_factor(r, smoothing) * offset;
                }
            }
        });
        (sum, gradient)
    }
}
