//! Walls that end at a blunt edge in their cell or the next: the sides of a body at the rim of its base.
//!
//! Gas faster than sound slides along such a wall to its very end as if nothing were to come, and presses on it as in the cells before; the cell that
//! holds the rim holds gas that has turned round it as well, and slopes next to it see that.

use std::collections::HashMap;

use aero_geometry::Vector;

use super::bend::Kink;
use super::cells::Cells;
use super::fan::STEEPEST;
use super::net::Net;
use super::walls::Wall;

/// Cosine between walls that go on as one another.
const ALIKE: f64 = 0.9;

/// Cosine between the way to the rim and the way from a cell before it, at least.
const BEFORE: f64 = 0.5;

/// Cells back along the wall that are looked at.
const STEPS: usize = 4;

/// Walls that are a smaller part of a face of their cell are what rounding leaves.
const SLIVER: f64 = 1e-6;

/// Walls by their cells, and the faces between these.
struct Brinks<'a, const D: usize> {
    walls: Vec<&'a Wall<D>>,
    of_cell: HashMap<u32, Vec<usize>>,
    beside: HashMap<u32, Vec<(u32, Vector<D>)>>,
    /// Of each wall the directions to the edges that it ends at.
    ways: Vec<Vec<Vector<D>>>,
}

/// Normal of a wall, into the gas.
fn outward<const D: usize>(wall: &Wall<D>) -> Vector<D> {
    -Vector::from(wall.image.normal)
}

/// True of walls of a body between which it has an edge that no gas follows.
fn part<const D: usize>(one: &Wall<D>, other: &Wall<D>) -> bool {
    let arm = other.foot - one.foot;
    let (a, b) = (outward(one), outward(other));
    one.owner == other.owner && a.dot(&b) < STEEPEST.cos() && arm.dot(&a) < 0.0 && arm.dot(&b) > 0.0
}

/// The walls before blunt edges of `cells`, by their numbers among those of all blocks of the `net`.
pub fn brinks<const D: usize>(net: &Net<D>, cells: &Cells<D>) -> Vec<(usize, Kink<D>)> {
    let walls: Vec<&Wall<D>> = net.blocks.iter().flat_map(|block| &block.walls).collect();
    let mut of_cell: HashMap<u32, Vec<usize>> = HashMap::new();
    for (number, wall) in walls.iter().enumerate() {
        let face = net
            .cell(wall.i as usize)
            .volume
            .powf((D as f64 - 1.0) / D as f64);
        if wall.image.share > SLIVER * face {
            of_cell.entry(wall.i).or_default().push(number);
        }
    }
    let mut beside: HashMap<u32, Vec<(u32, Vector<D>)>> = HashMap::new();
    for face in cells.faces.iter() {
        if of_cell.contains_key(&face.i) && of_cell.contains_key(&face.j) {
            beside.entry(face.i).or_default().push((face.j, face.apart));
            beside
                .entry(face.j)
                .or_default()
                .push((face.i, -face.apart));
        }
    }
    let mut brinks = Brinks {
        walls,
        of_cell,
        beside,
        ways: Vec::new(),
    };
    brinks.ways = (0..brinks.walls.len())
        .map(|wall| brinks.ways_out(wall))
        .collect();
    let mut found = Vec::new();
    for (number, ways) in brinks.ways.iter().enumerate() {
        for before in ways {
            if let Some(donor) = brinks.donor(number, before) {
                let kink = Kink {
                    wall: number,
                    donor: donor.i,
                    pressed: Some(*donor),
                    before: (*before).into(),
                    edge: [0.0; D],
                    along: None,
                };
                found.push((number, kink));
            }
        }
    }
    found
}

impl<const D: usize> Brinks<'_, D> {
    /// Cells with walls that a cell has faces to, and the way to each.
    fn beside(&self, cell: u32) -> impl Iterator<Item = &(u32, Vector<D>)> {
        self.beside.get(&cell).into_iter().flatten()
    }

    /// Directions along a wall to the edges between it and others in its cell and beside that.
    fn ways_out(&self, number: usize) -> Vec<Vector<D>> {
        let wall = self.walls[number];
        let normal = outward(wall);
        let near = self.beside(wall.i).map(|(cell, _)| cell);
        let cells = std::iter::once(&wall.i).chain(near);
        let others = cells.filter_map(|cell| self.of_cell.get(cell)).flatten();
        let mut ways: Vec<Vector<D>> = Vec::new();
        for &other in others {
            let other = self.walls[other];
            if !part(wall, other) {
                continue;
            }
            let beyond = outward(other);
            let way = (beyond - normal * normal.dot(&beyond)).try_normalize(0.0);
            let is_new = |way: &Vector<D>| ways.iter().all(|known| known.dot(way) < ALIKE);
            ways.extend(way.filter(is_new));
        }
        ways
    }

    /// The last wall on the way along one that ends `before` it which does not.
    fn donor(&self, number: usize, before: &Vector<D>) -> Option<&Wall<D>> {
        let mut here = number;
        for _ in 0..STEPS {
            here = self.back(here, before)?;
            if self.ways[here].iter().all(|way| way.dot(before) < BEFORE) {
                return Some(self.walls[here]);
            }
        }
        None
    }

    /// The wall that goes on as this one in the cell straight `before` its own.
    fn back(&self, number: usize, before: &Vector<D>) -> Option<usize> {
        let wall = self.walls[number];
        let mut best = None;
        let mut most = BEFORE;
        for (cell, apart) in self.beside(wall.i) {
            let alike = |other: &usize| {
                let other = self.walls[*other];
                let facing = outward(other).dot(&outward(wall));
                if other.owner == wall.owner {
                    facing
                } else {
                    -1.0
                }
            };
            let own = self.of_cell[cell].iter().copied();
            let next = own.max_by(|a, b| alike(a).total_cmp(&alike(b)));
            let straight = -apart.dot(before) / apart.norm();
            if let Some(next) = next.filter(|next| alike(next) > ALIKE && straight > most) {
                (best, most) = (Some(next), straight);
            }
        }
        best
    }
}
