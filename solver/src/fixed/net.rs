//! Cells and faces as the march reads them: blocks of cells that lie close together, each with all of its faces.
//!
//! A face between two blocks stands in both, so that each block sums up its own cells alone, in an order that no number of threads
//! changes. Faces and cells of a lattice are alike: what they look like stands once in a table.

use std::ops::Range;

use aero_geometry::Vector;

use super::bend::{Kink, Surroundings};
use super::beyond::Beyond;
use super::cells::{Cells, Matrix, RADIAL, WallOwner};
use super::face_list::{Face, Join};
use super::image::Image;
use super::root::Root;
use super::sides::Side;
use super::walls::Wall;

/// Cells of a block.
pub const BLOCK: usize = 128;

/// Among cells of a block, a bit for each.
pub type Among = u128;

/// The cell of a block that is the `k`th in it.
pub const fn one_of(k: usize) -> Among {
    1 << k
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
    /// One where both cells are even, see [`super::even`]; zero elsewhere, and where nobody asks.
    pub evenness: f64,
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
    pub faces: Vec<Join>,
    /// Walls of these cells.
    pub walls: Vec<Wall<D>>,
    /// Sides of these cells.
    pub sides: Vec<Side<D>>,
    /// What lies around sharp convex bends of walls.
    pub bends: Vec<Surroundings<D>>,
    /// What lies around sharp concave bends and tips, hollows and leading edges in space.
    pub roots: Vec<Root<D>>,
    /// Walls ahead of sharp concave bends and of blunt edges.
    pub kinks: Vec<Kink<D>>,
    /// What other blocks have at most two faces away.
    pub nearby: Vec<Near>,
}

/// The cells of another block that lie near one.
#[derive(Clone, Copy, Debug)]
pub struct Near {
    /// The other block.
    pub block: u32,
    /// Which of its cells.
    pub cells: Among,
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
                    roots: Vec::new(),
                    kinks: Vec::new(),
                    nearby: Vec::new(),
                })
                .collect(),
            shape_of: Vec::with_capacity(count),
            cell_shapes: Vec::new(),
            face_shapes: Vec::new(),
            lost: cells.lost,
        };
        let radius = |place: f64| if is_axisymmetric { place } else { 1.0 };
        net.add_faces(cells, is_axisymmetric);
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
        net.add_cell_shapes(cells, is_axisymmetric);
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
        for face in cells.faces.iter() {
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

    fn add_faces(&mut self, cells: &Cells<D>, is_axisymmetric: bool) {
        let looks = cells.faces.looks();
        self.face_shapes = (looks.iter())
            .map(|look| FaceShape {
                area: look.area.into(),
                apart: look.apart.into(),
                skew: look.skew.into(),
                size: look.area.norm(),
                weight: f64::NAN,
                evenness: 0.0,
            })
            .collect();
        let mut counts = vec![0; self.blocks.len()];
        for face in cells.faces.joins() {
            face.blocks().for_each(|block| counts[block] += 1);
        }
        for (block, count) in self.blocks.iter_mut().zip(counts) {
            block.faces.reserve_exact(count);
        }
        for &face in cells.faces.joins() {
            let known = &mut self.face_shapes[face.shape as usize].weight;
            if known.is_nan() {
                let face = face.in_full(looks);
                *known = weight(&cells.points, &face, is_axisymmetric);
            }
            for block in face.blocks() {
                self.blocks[block].faces.push(face);
            }
        }
    }

    /// What lies at most two faces away from each block.
    fn find_nearby(&mut self) {
        let block_of = |i: u32| i / BLOCK as u32;
        // Cells with faces to other blocks than their own, and those blocks.
        let mut beside: Vec<[u32; 2]> = Vec::new();
        for (number, block) in (0..).zip(&self.blocks) {
            for face in &block.faces {
                match [face.i, face.j].map(block_of) {
                    [first, second] if first == second => {}
                    [first, second] if first == number => beside.push([face.i, second]),
                    [first, _] => beside.push([face.j, first]),
                }
            }
        }
        beside.sort_unstable();
        beside.dedup();
        // Blocks, and the cells that lie around them.
        let mut around: Vec<[u32; 2]> = beside.iter().map(|&[cell, block]| [block, cell]).collect();
        for block in &self.blocks {
            let first = |i: usize| beside.partition_point(|[cell, _]| (*cell as usize) < i);
            let own = &beside[first(block.cells.start)..first(block.cells.end)];
            for face in &block.faces {
                for [i, j] in [[face.i, face.j], [face.j, face.i]] {
                    let first = own.partition_point(|[cell, _]| *cell < i);
                    let next = own[first..].iter().take_while(|[cell, _]| *cell == i);
                    around.extend(
                        next.filter(|[_, next]| block_of(j) != *next)
                            .map(|[_, next]| [*next, j]),
                    );
                }
            }
        }
        around.sort_unstable();
        around.dedup();
        let nearby = around.chunk_by(|[a, i], [b, j]| a == b && block_of(*i) == block_of(*j));
        for near in nearby {
            let [block, first] = near[0];
            let cells = near.iter().map(|&[_, i]| one_of(i as usize % BLOCK));
            self.blocks[block as usize].nearby.push(Near {
                block: block_of(first),
                cells: cells.fold(0, |all, one| all | one),
            });
        }
    }
}

impl Join {
    /// The blocks that a face stands in.
    fn blocks(&self) -> impl Iterator<Item = usize> + use<> {
        let [first, second] = [self.i, self.j].map(|i| i as usize / BLOCK);
        [first]
            .into_iter()
            .chain((second != first).then_some(second))
    }
}

/// Weight of a `face` in gradients. What counts is how near a cell is, not how far around the axis it goes: the ring next to the axis would not
/// feel its own image.
pub fn weight<const D: usize>(points: &[Vector<D>], face: &Face<D>, about_axis: bool) -> f64 {
    let weight = face.area.norm() / face.apart.norm();
    if about_axis {
        let middle = points[face.i as usize] + face.apart * 0.5;
        weight / middle[RADIAL.min(D - 1)]
    } else {
        weight
    }
}
