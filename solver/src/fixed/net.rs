//! Cells and faces as the march reads them: blocks of cells that lie close together, each with all of its faces.
//!
//! A face between two blocks stands in both, so that each block sums up its own cells alone, in an order that no number of threads
//! changes. Faces and cells of a lattice are alike: what they look like stands once in a table.

use std::collections::HashMap;
use std::hash::Hash;
use std::ops::Range;

use aero_geometry::Vector;
use foldhash::fast::FixedState;

use super::bend::{Kink, Surroundings};
use super::beyond::Beyond;
use super::cells::{Cells, Matrix, RADIAL, WallOwner};
use super::image::Image;
use super::sides::Side;
use super::walls::Wall;

/// Cells of a block.
pub const BLOCK: usize = 512;

/// A face between two cells.
#[derive(Clone, Copy, Debug)]
pub struct Face {
    /// First cell.
    pub i: u32,
    /// Second cell.
    pub j: u32,
    /// Its number in [`Net::face_shapes`].
    pub shape: u32,
}

/// What a face looks like.
#[derive(Clone, Copy, Debug)]
pub struct FaceShape<const D: usize> {
    /// Area times the unit normal, from the first to the second cell.
    pub area: [f64; D],
    /// From the first to the second cell.
    pub apart: [f64; D],
    /// From halfway between both points to the face's middle.
    pub skew: [f64; D],
    /// Area.
    pub size: f64,
    /// Area over distance, in the plane of rings the length of the face there: weight in the cells' gradients.
    pub weight: f64,
}

/// What a cell looks like.
#[derive(Clone, Copy, Debug)]
pub struct CellShape<const D: usize> {
    /// Volume.
    pub volume: f64,
    /// Inverse of the sum of `weight d d^T` over its faces.
    pub inverse: Matrix<D>,
    /// Sum of the areas out of the cell along the radius: the plane area of the cell about an axis, zero otherwise.
    pub hoop: f64,
}

/// Cells next to each other, with their faces.
#[derive(Clone, Debug)]
pub struct Block<const D: usize> {
    /// Cells.
    pub cells: Range<usize>,
    /// Faces of these cells, in fixed order.
    pub faces: Vec<Face>,
    /// Walls of these cells.
    pub walls: Vec<Wall<D>>,
    /// Sides of these cells.
    pub sides: Vec<Side<D>>,
    /// What lies around sharp bends of walls.
    pub bends: Vec<Surroundings<D>>,
    /// Walls ahead of sharp concave bends and of blunt edges.
    pub kinks: Vec<Kink<D>>,
    /// Blocks with cells at most two faces away, this one among them.
    pub nearby: Vec<u32>,
}

/// All cells and faces.
#[derive(Clone, Debug)]
pub struct Net<const D: usize> {
    /// Blocks, in the order of their cells.
    pub blocks: Vec<Block<D>>,
    /// Number in `cell_shapes`, cell by cell.
    pub shape_of: Vec<u32>,
    /// What cells look like.
    pub cell_shapes: Vec<CellShape<D>>,
    /// What faces look like.
    pub face_shapes: Vec<FaceShape<D>>,
    /// Pieces of cells that nobody could take.
    pub lost: usize,
}

impl<const D: usize> Net<D> {
    /// The net of `cells`; `beyond` is what is beyond each face on a side; and whether there is an axis.
    ///
    /// # Errors
    /// A cell without volume, or more cells than there are numbers for.
    pub fn new(
        cells: &Cells<D>,
        beyond: &[Beyond<D>],
        owner: impl Fn(WallOwner) -> u32,
        is_axisymmetric: bool,
    ) -> Result<Self, String> {
        let count = cells.points.len();
        if let Some(i) = cells
            .volumes
            .iter()
            .position(|v| !(*v > 0.0 && v.is_finite()))
        {
            return Err(format!(
                "the cell at {:?} has the volume {}; move the body or change `spacing` a little",
                cells.points[i].as_slice(),
                cells.volumes[i]
            ));
        }
        let mut net = Self {
            blocks: (0..count)
                .step_by(BLOCK)
                .map(|start| Block {
                    cells: start..(start + BLOCK).min(count),
                    faces: Vec::new(),
                    walls: Vec::new(),
                    sides: Vec::new(),
                    bends: Vec::new(),
                    kinks: Vec::new(),
                    nearby: Vec::new(),
                })
                .collect(),
            shape_of: Vec::with_capacity(count),
            cell_shapes: Vec::new(),
            face_shapes: Vec::new(),
            lost: cells.lost,
        };
        // What counts is how near a cell is, not how far around the axis it goes: the ring next to the axis would not feel its own image.
        let radius = |place: f64| if is_axisymmetric { place } else { 1.0 };
        let weights: Vec<f64> = cells
            .faces
            .iter()
            .map(|face| {
                let middle = cells.points[face.i as usize] + face.apart * 0.5;
                face.area.norm() / face.apart.norm() / radius(middle[RADIAL.min(D - 1)])
            })
            .collect();
        net.add_faces(cells, &weights);
        for wall in &cells.walls {
            let foot = wall.foot[RADIAL.min(D - 1)];
            let mut wall = Wall::new(wall, &cells.points[wall.i as usize], owner(wall.owner));
            wall.image = wall.image.at_radius(radius(foot));
            net.blocks[wall.i as usize / BLOCK].walls.push(wall);
        }
        for (face, &beyond) in cells.sides.iter().zip(beyond) {
            let mut side = Side::new(face, &cells.points[face.i as usize], beyond);
            if is_axisymmetric {
                side = side.at_radius(face.centre[RADIAL]);
            }
            net.blocks[side.i as usize / BLOCK].sides.push(side);
        }
        if is_axisymmetric {
            net.add_axis(cells);
        }
        net.add_cell_shapes(cells, &weights, is_axisymmetric);
        net.find_nearby();
        Ok(net)
    }

    /// Cells.
    pub fn len(&self) -> usize {
        self.shape_of.len()
    }

    /// What cell `i` looks like.
    #[inline]
    pub fn cell(&self, i: usize) -> &CellShape<D> {
        &self.cell_shapes[self.shape_of[i] as usize]
    }

    /// Gives the cells on the axis their images behind it, for the gradients: what is left of a cell's sides in the plane of rings lies on
    /// the axis.
    fn add_axis(&mut self, cells: &Cells<D>) {
        /// Least part of a cell's width that has to lie on the axis.
        const LEAST: f64 = 0.05;
        let mut lengths = vec![0.0; cells.points.len()];
        for face in &cells.faces {
            let middle = cells.points[face.i as usize][RADIAL] + 0.5 * face.apart[RADIAL];
            let length = face.area[RADIAL] / middle;
            lengths[face.i as usize] += length;
            lengths[face.j as usize] -= length;
        }
        for block in &self.blocks {
            let walls = block.walls.iter().map(|wall| (wall.i, &wall.image));
            let sides = block.sides.iter().map(|side| (side.i, &side.image));
            for (i, image) in walls.chain(sides) {
                lengths[i as usize] += image.share * image.normal[RADIAL];
            }
        }
        for (i, length) in lengths.into_iter().enumerate() {
            let distance = cells.points[i][RADIAL];
            let width = (cells.volumes[i] / distance).sqrt();
            if distance < width && length > LEAST * width {
                self.blocks[i / BLOCK].sides.push(Side {
                    i: i as u32,
                    image: Image::behind_axis(length, distance),
                    aside: [0.0; D],
                    beyond: Beyond::Mirror,
                });
            }
        }
    }

    fn add_faces(&mut self, cells: &Cells<D>, weights: &[f64]) {
        let mut shapes = Table::default();
        for (face, weight) in cells.faces.iter().zip(weights) {
            let size = face.area.norm();
            let key = [&face.area, &face.apart, &face.skew].map(bits);
            let shape = shapes.number(key, || {
                self.face_shapes.push(FaceShape {
                    area: face.area.into(),
                    apart: face.apart.into(),
                    skew: face.skew.into(),
                    size,
                    weight: *weight,
                });
            });
            let face = Face {
                i: face.i,
                j: face.j,
                shape,
            };
            let (first, second) = (face.i as usize / BLOCK, face.j as usize / BLOCK);
            self.blocks[first].faces.push(face);
            if second != first {
                self.blocks[second].faces.push(face);
            }
        }
    }

    fn add_cell_shapes(&mut self, cells: &Cells<D>, weights: &[f64], is_axisymmetric: bool) {
        let mut moments = vec![Matrix::<D>::zeros(); cells.points.len()];
        let mut hoops = vec![0.0; cells.points.len()];
        let radial = |area: &Vector<D>| if is_axisymmetric { area[RADIAL] } else { 0.0 };
        for (face, weight) in cells.faces.iter().zip(weights) {
            let moment = face.apart * face.apart.transpose() * *weight;
            moments[face.i as usize] += moment;
            moments[face.j as usize] += moment;
            hoops[face.i as usize] += radial(&face.area);
            hoops[face.j as usize] -= radial(&face.area);
        }
        for block in &self.blocks {
            for wall in &block.walls {
                moments[wall.i as usize] += wall.image.moment();
                hoops[wall.i as usize] += radial(&wall.image.area());
            }
            for side in &block.sides {
                if side.beyond.is_known() {
                    moments[side.i as usize] += side.image.moment();
                }
                hoops[side.i as usize] += radial(&side.image.area());
            }
        }
        let mut shapes = Table::default();
        for (i, (moment, hoop)) in moments.iter().zip(hoops).enumerate() {
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

    /// Blocks at most two faces away.
    fn find_nearby(&mut self) {
        let mut around: Vec<Vec<u32>> = vec![Vec::new(); self.len()];
        for block in &self.blocks {
            for face in &block.faces {
                let [first, second] = [face.i, face.j].map(|i| i / BLOCK as u32);
                if first != second {
                    around[face.i as usize].push(second);
                    around[face.j as usize].push(first);
                }
            }
        }
        let mut nearby: Vec<Vec<u32>> = (0..self.blocks.len()).map(|b| vec![b as u32]).collect();
        for (block, near) in self.blocks.iter().zip(&mut nearby) {
            for face in &block.faces {
                for i in [face.i, face.j] {
                    near.push(i / BLOCK as u32);
                    near.extend(&around[i as usize]);
                }
            }
            near.sort_unstable();
            near.dedup();
        }
        for (block, nearby) in self.blocks.iter_mut().zip(nearby) {
            block.nearby = nearby;
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
