//! What the ghosts' summed density ought to be: the density of the exact layers, each spread evenly
//! over its middle level.
//!
//! Near the surface and at the deepest layer the kernel's support is not filled by ghosts, so "one"
//! is the wrong aim there. The right one is the sum over ideally placed ghosts, in the limit of
//! infinitely many per level. Ghosts that meet it on their side, and fluid on the other, add up to a
//! uniform density.

use aero_geometry::Vector;
use aero_geometry::kernel::{SMOOTHING_RATIO, SUPPORT};
use aero_geometry::parallel::prelude::*;

use crate::grid::Cell;
use crate::level::project;
use crate::plan::Plan;
use crate::room::Room;
use crate::sources::Sources;

/// Cells farther than this from the middle of their layer (in spacings) stay where they are: they
/// are in a tip that the middle does not reach.
const FARTHEST: f64 = 1.0;

/// Cuts the layers of `plan` into small pieces and moves each to the middle of its layer; what is
/// too thin for its layer stays in place; thin parts that belong to rows are given as the particles `rows`. The pieces of a cell that was cut up are
/// then joined.
pub(crate) fn ideal_layers<const D: usize>(
    plan: &Plan<'_, D>,
    rows: Vec<(Vector<D>, f64)>,
) -> Sources<D> {
    let spacing = plan.options.spacing;
    let blocks: Vec<&[Cell<D>]> = plan.cells().chunk_by(|a, b| a.index == b.index).collect();
    let mut pieces: Vec<(Vector<D>, f64)> = blocks
        .par_iter()
        .flat_map_iter(|cells| {
            let mut joined: Vec<(usize, Vector<D>, f64)> = Vec::new();
            for cell in *cells {
                for (layer, volume) in plan.parts(cell) {
                    if plan.leaves_to_rows(cell, layer) {
                        continue;
                    }
                    let place = place(plan, cell, layer);
                    match joined.iter_mut().find(|piece| piece.0 == layer) {
                        Some(piece) => {
                            piece.1 += volume * place;
                            piece.2 += volume;
                        }
                        None => joined.push((layer, volume * place, volume)),
                    }
                }
            }
            joined
                .into_iter()
                .map(|(_, moment, volume)| (moment / volume, volume))
        })
        .collect();
    pieces.extend(rows);
    Sources::new(&plan.mirrors, pieces, SUPPORT * SMOOTHING_RATIO * spacing)
}

/// The centre of a cell moved to the middle of a layer, if that is near.
fn place<const D: usize>(plan: &Plan<'_, D>, cell: &Cell<D>, layer: usize) -> Vector<D> {
    let spacing = plan.options.spacing;
    let level = plan.level(layer);
    let guess = cell.centre - (cell.distance - level) * cell.normal;
    match cell.room {
        _ if layer >= cell.full => cell.centre,
        Room::Clear => guess,
        Room::Ridge => project(plan.shape, &guess, level, 1e-3 * spacing)
            .filter(|p| (p - cell.centre).norm() < FARTHEST * spacing)
            .unwrap_or(cell.centre),
        Room::Thin => cell.centre,
    }
}
