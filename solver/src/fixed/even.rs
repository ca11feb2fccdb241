//! Where cells are even: each neighbour has one opposite that is as far away, as on a lattice. Slopes there are differences of means along a line,
//! and a march draws them out to third order.

use aero_geometry::parallel::prelude::*;

use super::drawing::{Drawing, drawing};
use super::net::{BLOCK, Block, FaceShape, Net};
use crate::problem::Problem;

/// Part of the cube of a cell's reach that is left of what opposite neighbours cancel, up to which all of them have one.
const ROUNDING: f64 = 1e-9;

/// What the neighbours of a cell add up to.
#[derive(Clone, Copy, Debug)]
struct Around<const D: usize> {
    /// `sum w |d|^2 d`.
    odd: [f64; D],
    /// `sum w |d|^3`.
    size: f64,
}

impl<const D: usize> Around<D> {
    const NOTHING: Self = Self {
        odd: [0.0; D],
        size: 0.0,
    };

    fn add(&mut self, weight: f64, apart: impl Fn(usize) -> f64) {
        let square: f64 = (0..D).map(|k| apart(k) * apart(k)).sum();
        for (k, odd) in self.odd.iter_mut().enumerate() {
            *odd += weight * square * apart(k);
        }
        self.size += weight.abs() * square * square.sqrt();
    }

    fn is_even(&self) -> bool {
        let is_level = |odd: &f64| odd.abs() <= ROUNDING * self.size;
        self.odd.iter().all(is_level)
    }
}

impl<const D: usize> Net<D> {
    /// Finds the faces between two even cells, where the `problem` has any use for them.
    pub(super) fn find_even_faces(&mut self, problem: &Problem<D>) {
        if drawing(problem, false) != Drawing::Waves {
            return;
        }
        let cells: Vec<Vec<bool>> = self.blocks.par_iter().map(|b| self.even_cells(b)).collect();
        let is_even = |i: u32| cells[i as usize / BLOCK][i as usize % BLOCK];
        let Self {
            blocks,
            face_shapes,
            ..
        } = self;
        // Number of the even look of each.
        let mut even = vec![None; face_shapes.len()];
        for face in blocks.iter_mut().flat_map(|block| &mut block.faces) {
            if is_even(face.i) && is_even(face.j) {
                let known = face.shape as usize;
                face.shape = *even[known].get_or_insert_with(|| {
                    face_shapes.push(FaceShape {
                        evenness: 1.0,
                        ..face_shapes[known]
                    });
                    face_shapes.len() as u32 - 1
                });
            }
        }
    }

    fn even_cells(&self, block: &Block<D>) -> Vec<bool> {
        let start = block.cells.start;
        let mut around = vec![Around::<D>::NOTHING; block.cells.len()];
        for face in &block.faces {
            let shape = &self.face_shapes[face.shape as usize];
            for (i, sign) in [(face.i, 1.0), (face.j, -1.0)] {
                if let Some(around) = around.get_mut((i as usize).wrapping_sub(start)) {
                    around.add(shape.weight, |k| sign * shape.apart[k]);
                }
            }
        }
        let walls = block.walls.iter().map(|wall| (wall.i, &wall.image));
        let known = block.sides.iter().filter(|side| side.beyond.is_known());
        let sides = known.map(|side| (side.i, &side.image));
        for (i, image) in walls.chain(sides) {
            let apart = 2.0 * image.distance;
            around[i as usize - start].add(image.share / apart, |k| apart * image.normal[k]);
        }
        around.iter().map(Around::is_even).collect()
    }
}
