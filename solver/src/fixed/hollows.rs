//! Sharp concave bends of walls in the plane, and the cells around each.

use std::collections::{BTreeMap, HashMap};

use aero_geometry::Vector;

use super::attached::FARTHEST;
use super::bend::Bend;
use super::bent_face::middle;
use super::cells::{Cells, RADIAL};
use super::hollow::{Hollow, HollowFace, HollowWall, Piece, Plan};
use super::net::Net;
use super::sight::Sight;

/// Cosine of the elevation of a shock over the wall before its bend, at least.
const STEEPEST: f64 = 0.17;

impl<const D: usize> Net<D> {
    /// Finds what lies around sharp concave `bends`. Shocks of several may come by the same place, fans as well: which of them stands there is
    /// for the gas to say.
    pub(super) fn add_hollows(
        &mut self,
        cells: &Cells<D>,
        bends: Vec<Bend<D>>,
        is_axisymmetric: bool,
    ) {
        let around = |middle: &Vector<D>| if is_axisymmetric { middle[RADIAL] } else { 1.0 };
        for bend in bends {
            let walls = self.blocks.iter().flat_map(|block| &block.walls);
            let sight = Sight::new(&bend, walls, FARTHEST);
            let at = Vector::from(bend.at);
            let is_own = |place: &Vector<D>| {
                let away = place.norm();
                away < FARTHEST * bend.unit
                    && place.dot(&bend.before.into()) > STEEPEST * away - bend.unit
                    && sight.reaches(place)
            };
            let plans: HashMap<u32, Plan<D>> = self
                .pieces(cells, &at, is_own, around)
                .into_iter()
                .filter_map(|(i, pieces)| {
                    let point = cells.points[i as usize] - at;
                    Some((i, Plan::new(point, pieces)?))
                })
                .collect();
            for number in 0..self.blocks.len() {
                let hollow = self.hollow(number, &bend, &plans, cells, around);
                if !hollow.cells.is_empty() {
                    self.blocks[number].hollows.push(hollow);
                }
            }
        }
    }

    /// The outlines of all cells whose point is wanted, as seen from a place. Faces go `around` an axis by so much.
    fn pieces(
        &self,
        cells: &Cells<D>,
        at: &Vector<D>,
        is_wanted: impl Fn(&Vector<D>) -> bool,
        around: impl Fn(&Vector<D>) -> f64,
    ) -> BTreeMap<u32, Vec<Piece<D>>> {
        let wanted: Vec<bool> = cells
            .points
            .iter()
            .map(|point| is_wanted(&(point - at)))
            .collect();
        let mut pieces: BTreeMap<u32, Vec<Piece<D>>> = BTreeMap::new();
        for block in &self.blocks {
            for face in &block.faces {
                let shape = &self.face_shapes[face.shape as usize];
                let normal = Vector::from(shape.area) / shape.size;
                // A face between two blocks stands in both.
                let apart = Vector::from(shape.apart);
                for (i, back, way) in [(face.i, 0.0, 1.0), (face.j, 1.0, -1.0)] {
                    if wanted[i as usize] && block.cells.contains(&(i as usize)) {
                        let first = cells.points[i as usize] - at - apart * back;
                        let middle = middle(&first, shape);
                        let length = shape.size / around(&(middle + at));
                        let piece = Piece::new(&middle, &(normal * way), length);
                        pieces.entry(i).or_default().push(piece);
                    }
                }
            }
            let walls = block
                .walls
                .iter()
                .map(|wall| (wall.i, wall.foot, &wall.image));
            let sides = block.sides.iter().map(|side| {
                let foot = cells.points[side.i as usize] + Vector::from(side.way());
                (side.i, foot, &side.image)
            });
            for (i, foot, image) in walls.chain(sides) {
                if wanted[i as usize] {
                    let normal = Vector::from(image.normal);
                    let piece = Piece::new(&(foot - at), &normal, image.share);
                    pieces.entry(i).or_default().push(piece);
                }
            }
        }
        pieces
    }

    /// What of a block lies around a bend, whose cells have these `plans`. Faces go `around` an axis by so much.
    fn hollow(
        &self,
        number: usize,
        bend: &Bend<D>,
        plans: &HashMap<u32, Plan<D>>,
        cells: &Cells<D>,
        around: impl Fn(&Vector<D>) -> f64,
    ) -> Hollow<D> {
        let block = &self.blocks[number];
        let at = Vector::from(bend.at);
        let mut hollow = Hollow {
            bend: bend.clone(),
            cells: Vec::new(),
            faces: Vec::new(),
            walls: Vec::new(),
            mirrors: Vec::new(),
        };
        let mut numbers: HashMap<u32, u32> = HashMap::new();
        let mut place = |i: u32, all: &mut Vec<Plan<D>>| {
            let plan = plans.get(&i)?;
            Some(*numbers.entry(i).or_insert_with(|| {
                all.push(plan.clone());
                (all.len() - 1) as u32
            }))
        };
        for (number, face) in (0..).zip(&block.faces) {
            let Some(seen) = self.seen(&cells.points, &at, face) else {
                continue;
            };
            if !plans.contains_key(&face.i) || !plans.contains_key(&face.j) {
                continue;
            }
            let shape = &self.face_shapes[face.shape as usize];
            let normal = Vector::from(shape.area) / shape.size;
            let length = shape.size / around(&(seen + at));
            if let [Some(first), Some(second)] =
                [face.i, face.j].map(|i| place(i, &mut hollow.cells))
            {
                hollow.faces.push(HollowFace {
                    number,
                    cells: [first, second],
                    piece: Piece::new(&seen, &normal, length),
                    away: seen.norm() / bend.unit,
                });
            }
        }
        let mut walls = |i: u32, number: u32, foot: &Vector<D>, normal: &[f64; D]| {
            let normal = Vector::from(*normal);
            let off = |way: &[f64; D]| normal.dot(&Vector::from(*way)).abs();
            Some(HollowWall {
                number,
                cell: place(i, &mut hollow.cells)?,
                away: (foot - at).norm() / bend.unit,
                is_behind: off(&bend.along) < off(&bend.before),
            })
        };
        hollow.walls = (0..)
            .zip(&block.walls)
            .filter_map(|(number, wall)| walls(wall.i, number, &wall.foot, &wall.image.normal))
            .collect();
        hollow.mirrors = (0..)
            .zip(&block.sides)
            .filter(|(_, side)| side.is_mirror())
            .filter_map(|(number, side)| {
                let foot = cells.points[side.i as usize] + Vector::from(side.way());
                walls(side.i, number, &foot, &side.image.normal)
            })
            .collect();
        hollow
    }
}
