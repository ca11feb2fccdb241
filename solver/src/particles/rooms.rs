//! Gas next to bodies starts in the room that they leave it. Where the surface cuts cells of the lattice, a particle stands for all the gas
//! that it is the nearest to see, and in its middle: otherwise a first row that stands up to one and a half spacings off the wall, where
//! half a spacing is meant, would begin as a gap.

use std::collections::HashMap;

use aero_geometry::parallel::prelude::*;
use aero_geometry::{Closest, Vector};
use foldhash::fast::FixedState;

use crate::lattice;
use crate::problem::Problem;
use crate::scheme::Volume;
use crate::sides::Rows;

/// Blocks along each axis of a cell, in the plane and in space: surfaces are plane within each.
const BLOCKS: [i64; 2] = [8, 2];

/// Places along each axis of a block at which it is asked whether gas is there.
const PLACES: i64 = 2;

/// The nearest that the middle of a room may lie to a body, in spacings.
const NEAREST: f64 = 0.25;

/// A body this near, in spacings, stands in the way.
const TOUCHING: f64 = 1e-6;

/// Steps of a look from one place to another.
const STEPS: usize = 32;

/// What there is at a place of the lattice.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// A particle of the gas in the domain.
    Particle,
    /// None, but it is within the domain.
    Empty,
    /// It is not within the domain.
    Beyond,
}

/// What a particle of the lattice stands for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Room<const D: usize> {
    /// Over a cell of the lattice.
    pub share: f64,
    /// From the place in the lattice to the middle of the room.
    pub offset: Vector<D>,
}

/// The rooms that differ from a cell, by place in the lattice.
#[derive(Debug, Default)]
pub struct Rooms<const D: usize>(HashMap<[i64; D], Room<D>, FixedState>);

impl<const D: usize> Rooms<D> {
    /// Of the lattice from `first` to before `last`, with what there is at its `places`.
    pub fn new(
        problem: &Problem<D>,
        rows: &Rows<D>,
        [first, last]: [[i64; D]; 2],
        places: &[Place],
    ) -> Self {
        if !are_sought(problem) {
            return Self::default();
        }
        let cutter = Cutter {
            problem,
            rows,
            first,
            last,
            places,
        };
        let numbers = 0..places.len();
        let parts: Vec<_> = numbers
            .into_par_iter()
            .map(|number| cutter.parts(&lattice::at(first, last, number)))
            .collect();
        let mut sums = HashMap::<_, (f64, Vector<D>), FixedState>::default();
        for part in parts.into_iter().flatten() {
            let sum = sums.entry(part.taker).or_insert((0.0, Vector::zeros()));
            sum.0 += part.share;
            sum.1 += part.moment;
        }
        let rooms = sums.into_iter().filter_map(|(index, (share, moment))| {
            let offset = moment / share;
            let middle = cutter.middle(&index) + offset;
            let least = NEAREST * problem.resolution.at(&middle);
            let is_clear = problem.clearance(&middle) >= least;
            let offset = if is_clear { offset } else { Vector::zeros() };
            let is_cell = share == 1.0 && offset.amax() < TOUCHING * rows.pitch(0);
            (!is_cell).then_some((index, Room { share, offset }))
        });
        Self(rooms.collect())
    }

    /// That of the particle at a place.
    pub fn at(&self, index: &[i64; D]) -> Room<D> {
        let cell = Room {
            share: 1.0,
            offset: Vector::zeros(),
        };
        self.0.get(index).copied().unwrap_or(cell)
    }
}

/// True where rooms count: particles may have unequal masses, and no body brings its own gas.
fn are_sought<const D: usize>(problem: &Problem<D>) -> bool {
    let are_bare = problem
        .bodies
        .iter()
        .all(|body| body.packed_fluid.is_none());
    are_bare && !problem.bodies.is_empty() && problem.scheme.operators.volume == Volume::OfDensity
}

/// Of a cell: what goes to one particle, as a share of the cell and its moment about the particle's place.
struct Part<const D: usize> {
    taker: [i64; D],
    share: f64,
    moment: Vector<D>,
}

/// A piece of a cell.
struct Block<const D: usize> {
    centre: Vector<D>,
    /// From there to its corners.
    reach: f64,
    /// No surface is nearer to the centre; negative within a body.
    clear: f64,
    /// Of each body near, the closest.
    surfaces: Vec<Closest<D>>,
}

/// Cuts cells of the lattice at bodies.
struct Cutter<'a, const D: usize> {
    problem: &'a Problem<D>,
    rows: &'a Rows<D>,
    first: [i64; D],
    last: [i64; D],
    places: &'a [Place],
}

impl<const D: usize> Cutter<'_, D> {
    fn middle(&self, index: &[i64; D]) -> Vector<D> {
        self.rows.position(index, &Vector::zeros())
    }

    /// Half the diagonal of a cell that is cut in so many along each axis.
    fn reach(&self, cuts: i64) -> f64 {
        let sides = (0..D).map(|axis| self.rows.pitch(axis) / cuts as f64);
        0.5 * sides.map(|side| side * side).sum::<f64>().sqrt()
    }

    fn at(&self, index: &[i64; D]) -> Place {
        let number = lattice::number(self.first, self.last, index);
        number.map_or(Place::Beyond, |number| self.places[number])
    }

    /// What of the cell at `index` is gas, by the particle that it goes to; nothing of a cell far from all bodies.
    fn parts(&self, index: &[i64; D]) -> Vec<Part<D>> {
        if self.at(index) == Place::Beyond {
            return Vec::new();
        }
        let middle = self.middle(index);
        let cell = self.reach(1);
        let near = self.problem.near(&middle, 4.0 * cell);
        let clear = least(&near);
        if clear < -cell || clear > 4.0 * cell {
            return Vec::new();
        }
        if clear > cell {
            let whole = Part {
                taker: *index,
                share: 1.0,
                moment: Vector::zeros(),
            };
            let has_own = self.at(index) == Place::Particle;
            return if has_own { vec![whole] } else { Vec::new() };
        }
        let around = self.around(index);
        if around.is_empty() {
            return Vec::new();
        }
        let blocks = BLOCKS[usize::from(D > 2)];
        let share = ((blocks * PLACES) as f64).powi(-(D as i32));
        let mut parts = Vec::<Part<D>>::new();
        for corner in lattice::points([0; D], [blocks; D]) {
            let block = self.block(self.place(&middle, corner, blocks), self.reach(blocks));
            if block.clear < -block.reach {
                continue;
            }
            for step in lattice::points([0; D], [PLACES; D]) {
                let corner = std::array::from_fn(|k| corner[k] * PLACES + step[k]);
                let place = self.place(&middle, corner, blocks * PLACES);
                let height = self.height(&place, &block);
                if height <= 0.0 {
                    continue;
                }
                let takers = self.takers(&around, &place, height);
                let share = share / takers.len().max(1) as f64;
                for (taker, away) in takers {
                    let moment = away * share;
                    if let Some(part) = parts.iter_mut().find(|part| part.taker == taker) {
                        part.share += share;
                        part.moment += moment;
                    } else {
                        parts.push(Part {
                            taker,
                            share,
                            moment,
                        });
                    }
                }
            }
        }
        parts
    }

    /// The block about a `centre`, whose corners are within `reach`.
    fn block(&self, centre: Vector<D>, reach: f64) -> Block<D> {
        let far = 4.0 * self.reach(1);
        let surfaces = self.problem.near(&centre, far);
        Block {
            centre,
            reach,
            clear: least(&surfaces).min(far),
            surfaces,
        }
    }

    /// A height of a place in a block that no surface is nearer than: above the planes of those that cut the block, but where a body is
    /// seen from within, as a corner shows one of its faces alone there.
    fn height(&self, place: &Vector<D>, block: &Block<D>) -> f64 {
        if block.clear > block.reach {
            return block.clear - (place - block.centre).norm();
        }
        if block.clear < 0.0 {
            return self.problem.clearance(place);
        }
        let cuts = block.surfaces.iter().filter(|s| s.distance <= block.reach);
        let heights = cuts.map(|cut| cut.normal.dot(&(place - cut.point)));
        heights.fold(f64::INFINITY, f64::min)
    }

    /// Middle of the piece at `corner` of a cell cut in so many along each axis.
    fn place(&self, middle: &Vector<D>, corner: [i64; D], cuts: i64) -> Vector<D> {
        Vector::from_fn(|k, _| {
            middle[k] + ((corner[k] as f64 + 0.5) / cuts as f64 - 0.5) * self.rows.pitch(k)
        })
    }

    /// Particles that gas of the cell at `index` may go to: its own, and those around it.
    fn around(&self, index: &[i64; D]) -> Vec<[i64; D]> {
        let around = lattice::points([-1; D], [2; D]);
        around
            .map(|step| std::array::from_fn(|k| index[k] + step[k]))
            .filter(|place| self.at(place) == Place::Particle)
            .collect()
    }

    /// Who of those `around` takes the gas at `place`, `height` above all surfaces, with the way there from each: the nearest that sees
    /// it; all that are as near, for symmetry's sake.
    fn takers(
        &self,
        around: &[[i64; D]],
        place: &Vector<D>,
        height: f64,
    ) -> Vec<([i64; D], Vector<D>)> {
        let mut takers: Vec<_> = around
            .iter()
            .map(|taker| (*taker, place - self.middle(taker)))
            .collect();
        takers.sort_by(|a, b| a.1.norm_squared().total_cmp(&b.1.norm_squared()));
        let touching = TOUCHING * self.rows.pitch(0);
        let mut found: Vec<([i64; D], Vector<D>)> = Vec::new();
        for (taker, away) in takers {
            if found
                .first()
                .is_some_and(|(_, least)| away.norm() > least.norm() + touching)
            {
                break;
            }
            if self.problem.sees(place, height, &away) {
                found.push((taker, away));
            }
        }
        found
    }
}

/// How far the nearest of these surfaces is; negative within a body, endless without any.
fn least<const D: usize>(surfaces: &[Closest<D>]) -> f64 {
    let distances = surfaces.iter().map(|surface| surface.distance);
    distances.fold(f64::INFINITY, f64::min)
}

impl<const D: usize> Problem<D> {
    /// The surfaces within `reach` of a place, or around it.
    fn near(&self, place: &Vector<D>, reach: f64) -> Vec<Closest<D>> {
        let bodies = self.bodies.iter();
        let near = bodies.filter(|body| body.shape.bounds().grown(reach).contains(place));
        near.map(|body| body.shape.closest(place))
            .filter(|surface| surface.distance <= reach)
            .collect()
    }

    /// How far a place is from the nearest body, if that is a few spacings; negative within one.
    fn clearance(&self, place: &Vector<D>) -> f64 {
        least(&self.near(place, 4.0 * self.resolution.at(place)))
    }

    /// True where no body stands between a `place` at a known `height` and where it lies `away` from.
    fn sees(&self, place: &Vector<D>, height: f64, away: &Vector<D>) -> bool {
        let length = away.norm();
        let touching = TOUCHING * self.resolution.at(place);
        // No body is within a ball about where the look has come to.
        let mut seen = height;
        for _ in 0..STEPS {
            if seen >= length {
                return true;
            }
            let clear = self.clearance(&(place - away * (seen / length)));
            if clear < touching {
                return false;
            }
            seen += clear;
        }
        false
    }
}
