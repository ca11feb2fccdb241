//! What cells look like, once for all that are alike.

use std::collections::HashMap;
use std::hash::Hash;

use aero_geometry::Vector;
use foldhash::fast::FixedState;

use super::cells::{Cells, Matrix, RADIAL};
use super::net::{CellShape, Net, weight};

impl<const D: usize> Net<D> {
    /// Says what the cells look like, by their faces, walls and sides, which are there.
    pub(super) fn add_cell_shapes(&mut self, cells: &Cells<D>, is_axisymmetric: bool) {
        let mut shapes = Table::default();
        let radial = |area: &Vector<D>| if is_axisymmetric { area[RADIAL] } else { 0.0 };
        for block in &self.blocks {
            let start = block.cells.start;
            let mut moments = vec![Matrix::<D>::zeros(); block.cells.len()];
            let mut hoops = vec![0.0; block.cells.len()];
            for face in &block.faces {
                let face = face.in_full(cells.faces.looks());
                let weight = weight(&cells.points, &face, is_axisymmetric);
                let moment = face.apart * face.apart.transpose() * weight;
                for (i, sign) in [(face.i, 1.0), (face.j, -1.0)] {
                    if block.cells.contains(&(i as usize)) {
                        moments[i as usize - start] += moment;
                        hoops[i as usize - start] += sign * radial(&face.area);
                    }
                }
            }
            for wall in &block.walls {
                moments[wall.i as usize - start] += wall.image.moment();
                hoops[wall.i as usize - start] += radial(&wall.image.area());
            }
            for side in &block.sides {
                if side.beyond.is_known() {
                    moments[side.i as usize - start] += side.image.moment();
                }
                hoops[side.i as usize - start] += radial(&side.image.area());
            }
            for ((i, moment), hoop) in block.cells.clone().zip(&moments).zip(hoops) {
                let volume = cells.volumes[i];
                let rows = moment
                    .column_iter()
                    .map(|column| bits(&column.into_owned()));
                let mut key = ([[0; D]; D], [volume, hoop].map(f64::to_bits));
                for (row, bits) in key.0.iter_mut().zip(rows) {
                    *row = bits;
                }
                let shape = shapes.number(key, || {
                    self.cell_shapes.push(CellShape {
                        volume,
                        inverse: inverse(moment),
                        hoop,
                    });
                });
                self.shape_of.push(shape);
            }
        }
    }
}

/// The inverse of a moment; in directions without any neighbour the cell has no gradient.
fn inverse<const D: usize>(moment: &Matrix<D>) -> Matrix<D> {
    /// Least over mean eigenvalue, below which all neighbours lie in a plane.
    const FLAT: f64 = 1e-9;
    let mean = moment.trace() / D as f64;
    let inverse = moment.try_inverse();
    match inverse {
        Some(inverse) if 1.0 / (inverse.trace() * mean) > FLAT => inverse,
        _ => (moment + Matrix::identity() * (FLAT * mean))
            .try_inverse()
            .unwrap_or_else(Matrix::zeros),
    }
}

fn bits<const D: usize>(vector: &Vector<D>) -> [u64; D] {
    std::array::from_fn(|k| vector[k].to_bits())
}

/// Numbers for what is alike.
struct Table<K>(HashMap<K, u32, FixedState>);

impl<K> Default for Table<K> {
    fn default() -> Self {
        Self(HashMap::default())
    }
}

impl<K: Eq + Hash> Table<K> {
    fn number(&mut self, key: K, add: impl FnOnce()) -> u32 {
        let next = self.0.len() as u32;
        *self.0.entry(key).or_insert_with(|| {
            add();
            next
        })
    }
}
