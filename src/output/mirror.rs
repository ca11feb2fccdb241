//! The other half of a flow with mirrors.

use std::collections::HashSet;
use std::sync::Arc;

use aero_solver::frame::{CellFrame, CellPiece, Frame, Look, PanelFrame};

/// Planes across an axis, `(axis, place)`, that what is written is mirrored at.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mirrors(pub Vec<(usize, f64)>);

fn place(mut point: [f64; 3], axis: usize, face: f64) -> [f64; 3] {
    point[axis] = 2.0 * face - point[axis];
    point
}

fn direction(mut vector: [f64; 3], axis: usize) -> [f64; 3] {
    vector[axis] = -vector[axis];
    vector
}

/// `values`, and each once more as `image` has it.
fn twice<T: Clone>(values: &mut Vec<T>, image: impl Fn(&T) -> T) {
    let images: Vec<T> = values.iter().map(image).collect();
    values.extend(images);
}

impl Mirrors {
    /// Particles or points with their images, which go on counting `id` where those end; and the cells of points, of whose images
    /// the same holds.
    pub fn apply(&self, frame: &mut Frame, cells: Option<&mut Arc<CellFrame>>) {
        if self.0.is_empty() {
            return;
        }
        let mut pieces = cells.map(Arc::make_mut);
        if let Some(cells) = &mut pieces {
            let shown: HashSet<u64> = frame.id.iter().copied().collect();
            cells
                .pieces
                .retain(|piece| shown.contains(&u64::from(piece.cell)));
        }
        for &(axis, face) in &self.0 {
            let count = frame.id.iter().max().map_or(0, |most| most + 1);
            twice(&mut frame.position, |x| place(*x, axis, face));
            twice(&mut frame.velocity, |u| direction(*u, axis));
            twice(&mut frame.id, |id| id + count);
            twice(&mut frame.kind, |kind| *kind);
            twice(&mut frame.extra.second, |second| *second);
            for column in [
                &mut frame.density,
                &mut frame.pressure,
                &mut frame.energy,
                &mut frame.mach,
                &mut frame.smoothing_length,
                &mut frame.volume,
                &mut frame.extra.spacing,
            ] {
                twice(column, |value| *value);
            }
            if let Some(cells) = &mut pieces {
                twice(&mut cells.pieces, |piece| CellPiece {
                    cell: piece.cell + count as u32,
                    look: look(&piece.look, axis, face),
                });
            }
        }
    }

    /// Surfaces with their images.
    pub fn surface(&self, surface: &mut PanelFrame) {
        for &(axis, face) in &self.0 {
            let mut images: Vec<[f64; 3]> = surface
                .points
                .iter()
                .map(|x| place(*x, axis, face))
                .collect();
            // Seen from without they go round as their originals do.
            for corners in images.chunks_mut(surface.corners.max(1)) {
                corners.reverse();
            }
            surface.points.extend(images);
            twice(&mut surface.normal, |n| direction(*n, axis));
            twice(&mut surface.friction, |f| direction(*f, axis));
            twice(&mut surface.body, |body| *body);
            for column in [
                &mut surface.area,
                &mut surface.pressure,
                &mut surface.pressure_coefficient,
                &mut surface.mach,
                &mut surface.heat.flux,
                &mut surface.heat.temperature,
            ] {
                twice(column, |value| *value);
            }
        }
    }
}

fn look(look: &Look, axis: usize, face: f64) -> Look {
    match look {
        Look::Block([low, high]) => {
            let (mut a, mut b) = (place(*low, axis, face), place(*high, axis, face));
            std::mem::swap(&mut a[axis], &mut b[axis]);
            Look::Block([a, b])
        }
        Look::Rings(rings) => {
            let ring =
                |ring: &Vec<[f64; 3]>| ring.iter().rev().map(|x| place(*x, axis, face)).collect();
            Look::Rings(rings.iter().map(ring).collect())
        }
    }
}
