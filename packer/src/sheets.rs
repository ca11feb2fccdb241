//! Seeds on a level surface in space: lattice points projected onto it, with their number set right
//! by removing the densest and filling the sparsest places.

use std::collections::{HashMap, HashSet};

use aero_geometry::Vector;
use aero_geometry::kernel::SUPPORT;
use aero_geometry::parallel::prelude::*;

use crate::grid::Cell;
use crate::lattice::around;
use crate::level::project;
use crate::on_sheet::{OnSheet, Seed};
use crate::plan::Plan;
use crate::relax::{Relaxation, spread_on_sheet};
use crate::room::Room;

/// Evens out what projection and repair leave; a short smoothing length acts on single gaps.
const SPREADING: Relaxation = Relaxation {
    stage: "laying the layers",
    steps: 24,
    smoothing: 1.0,
    strength: 0.8,
    momentum: 0.6,
};

/// Width of the blocks whose counts are set right one by one, in spacings.
const BLOCK: f64 = 8.0;

/// Rounds of repairs before the rest is left to relaxation.
const MOST_REPAIRS: usize = 20;

/// A cell whose centre is beyond the surface is cut by it where more than this part of it is not.
const CUT: f64 = 0.01;

/// A site on a mirror plane whose level is farther from it than this, in spacings, leaves the plane.
const OFF_PLANE: f64 = 0.35;

/// Cosine between the normals of faces that are opposite.
const OPPOSITE: f64 = -0.5;

/// Sites nearer than this, in spacings, to the middle between two levels are taken to be on it: coordinates of meshes are rounded.
const TIE: f64 = 1e-3;

/// A place on a level, and the normal of the face above it.
type Seat<const D: usize> = (Vector<D>, Vector<D>);

/// Lays the sheets of one packing.
pub(crate) struct Sheets<'a, const D: usize> {
    /// Its frame.
    pub plan: &'a Plan<'a, D>,
}

impl<const D: usize> Sheets<'_, D> {
    /// Particles on the middle of `layer`, as many in each block of space as its volume there holds,
    /// up to rounding, which is carried from block to block.
    pub fn seeds(&self, layer: usize, wanted: &BlockVolumes<D>, carry: &mut f64) -> Vec<Vector<D>> {
        let level = self.plan.level(layer);
        // Of two sites as near to a flat level, one on either side, it is always the deeper one, whatever round-off says.
        let low = level - (0.5 + TIE) * self.step();
        let perfect = self.perfect(level);
        let mut points: Vec<Seed<D>> = self
            .plan
            .band
            .par_iter()
            .filter(|cell| cell.distance >= low && cell.distance < low + self.step())
            .filter(|cell| layer < cell.full)
            .flat_map_iter(|cell| {
                let own = self.seat(cell.centre, cell, level);
                [own, self.seat_across(cell, level, own)]
                    .into_iter()
                    .flatten()
                    .map(|(place, normal)| Seed {
                        place,
                        normal,
                        block: block_at(self.plan, &place),
                        fixed: perfect.contains(&cell.index),
                    })
            })
            .collect();
        let start = *carry;
        for round in 0..MOST_REPAIRS {
            *carry = start;
            let unfinished = self.repair(&mut points, level, wanted, carry);
            if unfinished.is_empty() {
                break;
            }
            if round + 1 == MOST_REPAIRS / 2 {
                // Where the lattice has no place for the number asked for, it is not the best packing.
                for seed in points
                    .iter_mut()
                    .filter(|seed| unfinished.contains(&seed.block))
                {
                    seed.fixed = false;
                }
            }
        }
        spread_on_sheet(self.plan, &mut points, level, SPREADING);
        points.into_iter().map(|seed| seed.place).collect()
    }

    /// Where a site of `cell`, or a place beside it, comes to lie on a level, and the normal of the face above it.
    fn seat(&self, from: Vector<D>, cell: &Cell<D>, level: f64) -> Option<Seat<D>> {
        let (place, normal) = if cell.room == Room::Clear {
            let place = from - (cell.distance - level) * cell.normal;
            (place, cell.normal)
        } else {
            let normal = self.plan.shape.closest(&from).normal;
            (
                project(self.plan.shape, &from, level, self.plan.tolerance)?,
                normal,
            )
        };
        let place = self.keep_on_planes(place, &cell.centre);
        ((place - cell.centre).norm() < 1.01 * self.step()).then_some((place, normal))
    }

    /// A site mid-way between two opposite faces has a place on either's level: the one that it has not got yet. About a mirror plane that
    /// is the image.
    fn seat_across(&self, cell: &Cell<D>, level: f64, own: Option<Seat<D>>) -> Option<Seat<D>> {
        if cell.room == Room::Clear {
            return None;
        }
        let beyond = cell.centre - TIE * self.step() * cell.normal.scale(1.0_f64.copysign(-level));
        let (place, normal) = self.seat(beyond, cell, level)?;
        let is_other = own.is_none_or(|(own, _)| (own - place).norm() > OFF_PLANE * self.step());
        (normal.dot(&cell.normal) < OPPOSITE && is_other).then_some((place, normal))
    }

    fn step(&self) -> f64 {
        self.plan.grid.step
    }

    /// Lattice cells on the middle of their layer whose neighbours in the body are so too: there the
    /// lattice itself is the best packing.
    fn perfect(&self, level: f64) -> HashSet<[i64; D]> {
        let exact = |cell: &Cell<D>| {
            let layer = cell.distance.abs() / self.step() - 0.5;
            (layer - layer.round()).abs() < 1e-9
        };
        // A cell beyond the surface that the surface cuts is as bad: the body ends between two sites.
        let is_cut = |cell: &Cell<D>| {
            let inside = cell.fraction_below(0.0);
            let on_this_side = if level < 0.0 { inside } else { 1.0 - inside };
            on_this_side > CUT
        };
        let flaws: HashSet<[i64; D]> = self
            .plan
            .band
            .iter()
            .filter(|cell| {
                if cell.distance * level > 0.0 {
                    !exact(cell)
                } else {
                    is_cut(cell)
                }
            })
            .map(|cell| cell.index)
            .collect();
        self.plan
            .band
            .par_iter()
            .filter(|cell| (cell.distance - level).abs() < 1e-9 * self.step())
            .filter(|cell| around(cell.index, 1).all(|other| !flaws.contains(&other)))
            .map(|cell| cell.index)
            .collect()
    }

    /// One round of removing and adding seeds; gives the blocks in which something is left to do. Neighbours
    /// are not touched in the same round, for what was known of them is out of date.
    fn repair(
        &self,
        points: &mut Vec<Seed<D>>,
        level: f64,
        wanted: &BlockVolumes<D>,
        carry: &mut f64,
    ) -> HashSet<[i64; D]> {
        let places: Vec<Vector<D>> = points.iter().map(|seed| seed.place).collect();
        let sheet = OnSheet::new(&self.plan.mirrors, &places, SUPPORT * self.step());
        let mut crowds: HashMap<[i64; D], Vec<(f64, usize, Vector<D>)>> = HashMap::new();
        let sums: Vec<(f64, Vector<D>)> = places
            .par_iter()
            .map(|place| sheet.sum(place, self.step()))
            .collect();
        for (n, (density, slope)) in sums.into_iter().enumerate() {
            let crowd = crowds.entry(points[n].block).or_default();
            crowd.push((density, n, -slope));
        }
        let mut touched = Touched::new(self.step());
        let mut gone = vec![false; points.len()];
        let mut added = Vec::new();
        let mut unfinished = HashSet::new();
        let lent = wanted.lent_by_the_empty(|block| crowds.get(block).map_or(0, Vec::len));
        for (block, volume) in wanted.in_order() {
            let Some(mut crowd) = crowds.remove(block) else {
                continue;
            };
            crowd.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
            let share = |n: usize| self.plan.mirrors.share(&places[n]);
            let mut have: f64 = crowd.iter().map(|&(_, n, _)| share(n)).sum();
            if crowd.iter().all(|&(_, n, _)| points[n].fixed) {
                continue;
            }
            let goal = volume + lent.get(block).copied().unwrap_or(0.0) + *carry;
            for &(_, n, _) in crowd.iter().rev() {
                if have - goal <= 0.5 * share(n) {
                    break;
                }
                if !points[n].fixed && touched.claim(&places[n]) {
                    gone[n] = true;
                    have -= share(n);
                }
            }
            for &(_, n, away) in &crowd {
                if goal - have <= 0.5 {
                    break;
                }
                if points[n].fixed {
                    continue;
                }
                let seen = (&places[n], &points[n].normal);
                if let Some(place) = self.beside(seen, &away, level, &sheet)
                    && touched.claim(&place)
                {
                    added.push(Seed {
                        place,
                        normal: self.plan.shape.closest(&place).normal,
                        block: *block,
                        fixed: false,
                    });
                    have += 1.0;
                }
            }
            *carry = goal - have;
            if carry.abs() > 0.5 {
                unfinished.insert(*block);
            }
            // Only rounding is passed on: what one block has no place for would crowd the next.
            *carry = carry.clamp(-1.0, 1.0);
        }
        let mut n = 0;
        points.retain(|_| {
            n += 1;
            !gone[n - 1]
        });
        points.extend(added);
        unfinished
    }

    /// A free place on the sheet beside a lonely seed with its normal: away from its neighbours or, where the sheet ends
    /// there, in the widest gap around it.
    fn beside(
        &self,
        (place, normal): (&Vector<D>, &Vector<D>),
        away: &Vector<D>,
        level: f64,
        sheet: &OnSheet<D>,
    ) -> Option<Vector<D>> {
        let step = self.step();
        let planes = self.plan.mirrors.planes();
        let at = |direction: &Vector<D>| {
            let guess = place + 0.7 * step * direction;
            let place = project(self.plan.shape, &guess, level, self.plan.tolerance)?;
            let above = planes.iter().all(|&(axis, p)| place[axis] > p);
            let gap = sheet.nearest(&place, step);
            (above && gap > 0.4 * step && self.plan.may_stand(&place, level))
                .then_some((place, gap))
        };
        let along_axis = || Vector::from_fn(|k, _| if k == 0 { 1.0 } else { 0.0 });
        let away = away.try_normalize(1e-9).unwrap_or_else(along_axis);
        if let Some((found, _)) = at(&away) {
            return Some(found);
        }
        around([0; D], 1)
            .map(|offset| Vector::from_fn(|k, _| offset[k] as f64))
            .filter_map(|offset: Vector<D>| {
                (offset - normal.dot(&offset) * normal).try_normalize(0.5)
            })
            .filter_map(|direction| at(&direction))
            .reduce(|best, next| if next.1 > best.1 { next } else { best })
            .map(|(found, _)| found)
    }

    /// Keeps a projected point on the planes on which it started, and on its side of the others. From a plane mid-way between two faces it
    /// goes to one of them, and its image to the other.
    fn keep_on_planes(&self, mut point: Vector<D>, start: &Vector<D>) -> Vector<D> {
        for &(axis, position) in self.plan.mirrors.planes() {
            let height = point[axis] - position;
            let is_between = height.abs() > OFF_PLANE * self.step();
            if start[axis] == position && is_between {
                point[axis] = position + height.abs();
            } else if start[axis] == position || height < 0.0 {
                point[axis] = position;
            }
        }
        point
    }
}

/// The block of a place.
fn block_at<const D: usize>(plan: &Plan<'_, D>, place: &Vector<D>) -> [i64; D] {
    let width = BLOCK * plan.grid.step;
    std::array::from_fn(|k| ((place[k] - plan.grid.origin[k]) / width).floor() as i64)
}

/// How many particles of one layer each block of space holds: a piece of the layer counts where its middle is.
pub(crate) struct BlockVolumes<const D: usize> {
    order: Vec<[i64; D]>,
    volume: HashMap<[i64; D], f64>,
}

impl<const D: usize> BlockVolumes<D> {
    /// Sums the roomy cells of `plan` for every layer.
    pub fn of_layers(plan: &Plan<'_, D>) -> Vec<Self> {
        let mut layers: Vec<Self> = (0..plan.layers)
            .map(|_| Self {
                order: Vec::new(),
                volume: HashMap::new(),
            })
            .collect();
        for cell in plan.cells() {
            for (layer, volume) in plan.parts(cell).filter(|part| part.0 < cell.full) {
                let off = cell.distance - plan.level(layer);
                let block = block_at(plan, &(cell.centre - off * cell.normal));
                let blocks = &mut layers[layer];
                let sum = blocks.volume.entry(block).or_insert_with(|| {
                    blocks.order.push(block);
                    0.0
                });
                *sum += plan.part_above(cell) * volume / plan.particle_volume();
            }
        }
        layers
    }

    /// What blocks without a seed leave to the fullest of their neighbours.
    fn lent_by_the_empty(&self, seeds: impl Fn(&[i64; D]) -> usize) -> HashMap<[i64; D], f64> {
        let mut lent = HashMap::new();
        for (block, volume) in self.in_order().filter(|entry| seeds(entry.0) == 0) {
            let fullest = around(*block, 1)
                .filter(|other| seeds(other) > 0 && self.volume.contains_key(other))
                .reduce(|a, b| if seeds(&b) > seeds(&a) { b } else { a });
            if let Some(other) = fullest {
                *lent.entry(other).or_insert(0.0) += volume;
            }
        }
        lent
    }

    /// All blocks, neighbours mostly one after the other.
    fn in_order(&self) -> impl Iterator<Item = (&[i64; D], f64)> {
        self.order.iter().map(|block| (block, self.volume[block]))
    }
}

/// Places that a round of repairs has changed.
pub(crate) struct Touched<const D: usize> {
    width: f64,
    cells: HashSet<[i64; D]>,
}

impl<const D: usize> Touched<D> {
    pub fn new(width: f64) -> Self {
        Self {
            width,
            cells: HashSet::new(),
        }
    }

    /// Marks a place, unless one beside it is marked.
    pub fn claim(&mut self, place: &Vector<D>) -> bool {
        let cell: [i64; D] = std::array::from_fn(|k| (place[k] / self.width).floor() as i64);
        if around(cell, 1).any(|other| self.cells.contains(&other)) {
            return false;
        }
        self.cells.insert(cell);
        true
    }
}
