//! Sharp concave bends of walls and tips in the plane, and the cells around each.

use std::collections::{BTreeMap, HashMap};

use aero_geometry::Vector;

use super::attached::farthest;
use super::bend::{Bend, Tip};
use super::bent_face::middle;
use super::cells::{Cells, RADIAL};
use super::net::Net;
use super::outline_piece::Piece;
use super::root::{Plan, Root, RootFace, RootWall};
use super::sight::Sight;
use super::state::dot;

/// Cosine of the elevation of a shock over the wall before its bend, at least.
const STEEPEST: f64 = 0.17;

/// So far before its bend, in spacings, is the next cell ahead of the one that holds it, at most.
pub const BEFORE: f64 = 2.0;

/// How many times as far from its tip as what happens on a cone its shock feels it, at most.
const FELT_BY: f64 = 6.0;

/// True of a place, as seen from a bend, where a shock that is rooted there may run through a cell or through one next to it.
pub fn may_hold<const D: usize>(bend: &Bend<D>, place: &Vector<D>) -> bool {
    place.dot(&bend.before.into()) > STEEPEST * place.norm() - BEFORE * bend.unit
}

impl<const D: usize> Net<D> {
    /// Finds what lies around sharp concave `bends`, around `tips`, and around `apexes`, the tips of cones. Shocks of several may come by the same place, fans as well: which of them
    /// stands there is for the gas to say.
    pub(super) fn add_roots(
        &mut self,
        cells: &Cells<D>,
        bends: Vec<Bend<D>>,
        tips: Vec<Tip<D>>,
        apexes: Vec<(Bend<D>, f64)>,
        is_axisymmetric: bool,
    ) {
        let around = |middle: &Vector<D>| if is_axisymmetric { middle[RADIAL] } else { 1.0 };
        let alone = |bend: Bend<D>, apex| (bend.clone(), vec![bend], apex);
        let concave = bends.into_iter().map(|bend| alone(bend, None));
        let tips = tips
            .into_iter()
            .map(|tip| (tip.around, tip.bends.into(), None));
        let apexes = apexes
            .into_iter()
            .map(|(bend, straight)| alone(bend, Some(straight)));
        let places = concave.chain(tips).chain(apexes);
        for (number, (around_it, bends, apex)) in (0..).zip(places) {
            let walls = self.blocks.iter().flat_map(|block| &block.walls);
            let sight = Sight::new(&around_it, walls, farthest::<D>());
            let bend = &bends[0];
            let at = Vector::from(bend.at);
            // What happens on a cone is felt at its shock some times as far from the tip.
            let most = apex.map_or(f64::INFINITY, |straight| FELT_BY * straight);
            let most = most.min(farthest::<D>()) * bend.unit;
            let is_own = |place: &Vector<D>| {
                let away = place.norm();
                away < most && may_hold(bend, place) && sight.reaches(place)
            };
            let plans: HashMap<u32, Plan<D>> = self
                .pieces(cells, &at, is_own, around)
                .into_iter()
                .filter_map(|(i, pieces)| {
                    let point = cells.points[i as usize] - at;
                    Some((i, Plan::new(i, point, pieces)?))
                })
                .collect();
            for block in 0..self.blocks.len() {
                let mut root = self.root(block, &bends, &plans, cells, around);
                root.number = number;
                root.apex = apex;
                if !root.cells.is_empty() {
                    self.blocks[block].roots.push(root);
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

    /// What of a block lies around the place of `bends`, whose cells have these `plans`. Faces go `around` an axis by so much.
    fn root(
        &self,
        number: usize,
        bends: &[Bend<D>],
        plans: &HashMap<u32, Plan<D>>,
        cells: &Cells<D>,
        around: impl Fn(&Vector<D>) -> f64,
    ) -> Root<D> {
        let block = &self.blocks[number];
        let (at, unit) = (Vector::from(bends[0].at), bends[0].unit);
        let mut root = Root {
            number: 0,
            bends: bends.to_vec(),
            apex: None,
            cells: Vec::new(),
            whereabouts: ([0.0; D], 0.0),
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
            let piece = Piece::new(&seen, &normal, length);
            if let [Some(first), Some(second)] = [face.i, face.j].map(|i| place(i, &mut root.cells))
                && let Some(facet) = root.cells[first as usize].number(&piece)
            {
                root.faces.push(RootFace {
                    number,
                    cells: [first, second],
                    facet,
                    away: seen.norm() / unit,
                });
            }
        }
        let mut walls = |i: u32, number: u32, foot: &Vector<D>, normal: &[f64; D]| {
            Some(RootWall {
                number,
                cell: place(i, &mut root.cells)?,
                away: (foot - at).norm() / unit,
                behind: goes_on_as(bends, normal),
            })
        };
        root.walls = (0..)
            .zip(&block.walls)
            .filter_map(|(number, wall)| walls(wall.i, number, &wall.foot, &wall.image.normal))
            .collect();
        root.mirrors = (0..)
            .zip(&block.sides)
            .filter(|(_, side)| side.is_mirror() && bends.len() == 1)
            .filter_map(|(number, side)| {
                let foot = cells.points[side.i as usize] + Vector::from(side.way());
                walls(side.i, number, &foot, &side.image.normal)
            })
            .collect();
        root.located()
    }
}

/// Number of the wall behind one of the `bends` that a wall with this `normal`, out of its cell, goes on as; none of that before.
fn goes_on_as<const D: usize>(bends: &[Bend<D>], normal: &[f64; D]) -> Option<u8> {
    let off = |way: &[f64; D]| dot(normal, way).abs();
    if let [bend] = bends {
        return (off(&bend.along) < off(&bend.before)).then_some(0);
    }
    let from = |bend: &Bend<D>| dot(normal, &bend.up);
    let each = (0..).zip(bends);
    each.min_by(|(_, a), (_, b)| from(a).total_cmp(&from(b)))
        .map(|(number, _)| number)
}
