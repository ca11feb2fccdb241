//! The layers' cells cut up where they are not smooth: small pieces measure thin parts and edges.

use aero_geometry::Shape;
use aero_geometry::parallel::prelude::*;

use crate::grid::Cell;
use crate::mirror::Mirrors;
use crate::room::{Room, Side};

/// Edge of the pieces of parts that are too thin for their layers, in spacings.
const PIECE: f64 = 0.25;

/// Edge of the pieces on edges of the body that have room for its layers.
const EDGE_PIECE: f64 = 0.125;

/// Edge of the smallest pieces, where both faces of a part pass through one.
const SMALLEST_PIECE: f64 = 1.0 / 64.0;

/// Cells in which the layers are smooth stay whole, the others are halved; where ghosts have no room for layers, until the pieces
/// measure the part. Of a cell that a mirror plane halves, the pieces below it are the images of those above.
pub(crate) fn cut_up<const D: usize>(
    shape: &dyn Shape<D>,
    band: &[Cell<D>],
    mirrors: &Mirrors,
    (spacing, side): (f64, Side),
) -> Vec<Cell<D>> {
    band.par_iter()
        .flat_map_iter(|cell| {
            let mut done = Vec::new();
            if cell.room == Room::Clear {
                done.push(*cell);
                return done;
            }
            let halves = cell.halves(shape, spacing, side);
            let mut open: Vec<Cell<D>> =
                halves.filter(|half| mirrors.above(&half.centre)).collect();
            if side == Side::Fluid {
                return open;
            }
            while let Some(cell) = open.pop() {
                let reach = 0.5 * cell.step * (D as f64).sqrt();
                let is_coarse = cell.step > 1.01 * PIECE * spacing && cell.distance < reach;
                let is_thin = cell.full < usize::MAX;
                let smallest = if is_thin { SMALLEST_PIECE } else { EDGE_PIECE };
                let is_bent = || cell.step > 1.01 * smallest * spacing && cell.is_bent(shape);
                if is_thin && is_coarse || is_bent() {
                    open.extend(cell.parts(shape, spacing));
                } else {
                    done.push(cell);
                }
            }
            done
        })
        .collect()
}
