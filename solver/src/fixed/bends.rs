//! Sharp bends of walls, and the cells around each.

use aero_geometry::Vector;

use super::bend::{Kink, Surroundings};
use super::bent_face::middle;
use super::brinks::brinks;
use super::cells::{Cells, Matrix};
use super::chain::Chain;
use super::face_list::Join;
use super::fan::farthest;
use super::net::Net;
use super::ridges::Ridges;
use super::seams::MIRROR;
use super::sight::Sight;
use super::walls::Wall;
use crate::problem::Problem;

impl<const D: usize> Net<D> {
    /// Finds the sharp bends of the walls of `cells`, and what lies around them.
    pub(super) fn add_bends(&mut self, cells: &Cells<D>, problem: &Problem<D>) {
        for (number, kink) in brinks(self, cells) {
            self.add_kink(number, kink);
        }
        match D {
            2 => self.add_bends_in_plane(cells, problem),
            3 => {
                let Some(ridges) = Ridges::of(self, cells, problem) else {
                    return;
                };
                let found = ridges.around(self, cells);
                for (block, bends) in self.blocks.iter_mut().zip(found) {
                    block.bends = bends;
                }
                self.add_crests(cells, &ridges);
            }
            _ => {}
        }
    }

    fn add_bends_in_plane(&mut self, cells: &Cells<D>, problem: &Problem<D>) {
        let mirrors = self.mirrors(cells);
        let chain = Chain::new(self, cells, &mirrors);
        let (mut bends, kinks) = (chain.bends(), chain.kinks());
        let (hollows, mut tips) = (chain.hollows(), chain.tips());
        let is_axisymmetric = problem.domain.is_axisymmetric();
        // What the stream leaves, as trailing edges, parts nothing.
        let stream = problem.free_stream.velocity;
        tips.retain(|tip| stream.dot(&tip.bends[0].before.into()) >= 0.0);
        let apexes = if is_axisymmetric {
            chain.apexes(&stream)
        } else {
            Vec::new()
        };
        for (number, kink) in kinks {
            self.add_kink(number, kink);
        }
        // On the side of a tip that turns away from the stream a fan stands.
        bends.extend(tips.iter().flat_map(|tip| tip.bends.clone()));
        self.add_roots(cells, hollows, tips, apexes, is_axisymmetric);
        if bends.is_empty() {
            return;
        }
        let places: Vec<Vector<D>> = bends.iter().map(|bend| bend.at.into()).collect();
        let is_nearest = |at: &Vector<D>, place: &Vector<D>, unit: f64| {
            let away = (place - at).norm() - 1e-6 * unit;
            places.iter().all(|other| (place - other).norm() > away)
        };
        let all = || self.blocks.iter().flat_map(|block| &block.walls);
        let sight = |bend| Sight::new(bend, all(), farthest::<D>());
        let sights: Vec<Sight<'_, D>> = bends.iter().map(sight).collect();
        for number in 0..self.blocks.len() {
            for ((bend, at), sight) in bends.iter().zip(&places).zip(&sights) {
                let is_own = |middle: &Vector<D>| {
                    middle.norm() / bend.unit < farthest::<D>()
                        && is_nearest(at, &(middle + at), bend.unit)
                };
                let block = &self.blocks[number];
                let is_face = |face: &Join| {
                    self.seen(&cells.points, at, face)
                        .is_some_and(|middle| is_own(&middle) && sight.reaches(&middle))
                };
                let around = Surroundings {
                    bends: vec![bend.clone()],
                    faces: numbers(&block.faces, is_face),
                    walls: numbers(&block.walls, |wall| {
                        is_own(&(wall.foot - at)) && sight.reaches_wall(wall)
                    }),
                };
                if !around.faces.is_empty() || !around.walls.is_empty() {
                    self.blocks[number].bends.push(around);
                }
            }
        }
    }

    /// The faces of cells on planes of symmetry as if they were walls.
    pub(super) fn mirrors(&self, cells: &Cells<D>) -> Vec<Wall<D>> {
        let sides = self.blocks.iter().flat_map(|block| &block.sides);
        let mirrors = sides.filter(|side| side.is_mirror());
        mirrors
            .map(|side| Wall {
                i: side.i,
                image: side.image,
                owner: MIRROR,
                facet: 0,
                curvature: Matrix::zeros(),
                foot: cells.points[side.i as usize] + Vector::from(side.way()),
                stick: None,
                push: 0.0,
                least_mach: 1.0,
            })
            .collect()
    }

    /// Gives a `kink` to the block of its wall, which is `number` of those of all blocks.
    fn add_kink(&mut self, number: usize, kink: Kink<D>) {
        let mut first = 0;
        for block in &mut self.blocks {
            let wall = number.wrapping_sub(first);
            if wall < block.walls.len() {
                block.kinks.push(Kink { wall, ..kink });
                return;
            }
            first += block.walls.len();
        }
    }

    /// The middle of a face as seen from a place; none of one to a periodic image, which lies elsewhere.
    pub(super) fn seen(
        &self,
        points: &[Vector<D>],
        from: &Vector<D>,
        face: &Join,
    ) -> Option<Vector<D>> {
        let shape = &self.face_shapes[face.shape as usize];
        let apart = Vector::<D>::from(shape.apart);
        let [first, second] = [face.i, face.j].map(|i| points[i as usize] - from);
        let is_there = (second - first - apart).norm() < 1e-6 * apart.norm();
        is_there.then(|| middle(&first, shape))
    }
}

/// The numbers of those that are wanted.
fn numbers<T>(all: &[T], is_wanted: impl Fn(&T) -> bool) -> Vec<u32> {
    let all = (0_u32..).zip(all);
    all.filter(|(_, one)| is_wanted(one))
        .map(|(number, _)| number)
        .collect()
}
