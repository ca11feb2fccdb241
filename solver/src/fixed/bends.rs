//! Sharp bends of walls in the plane, and the cells around each.

use aero_geometry::Vector;

use super::bend::{BentFace, BentWall, Surroundings, turned};
use super::cells::Cells;
use super::chain::Chain;
use super::fan::FARTHEST;
use super::kink::Kink;
use super::net::{Face, Net};

impl<const D: usize> Net<D> {
    /// Finds the sharp bends of the walls of `cells`, in the plane, and what lies around them.
    pub(super) fn add_bends(&mut self, cells: &Cells<D>) {
        if D != 2 {
            return;
        }
        let chain = Chain::new(self, cells);
        let (bends, kinks) = (chain.bends(), chain.kinks());
        for (number, kink) in kinks {
            self.add_kink(number, kink);
        }
        if bends.is_empty() {
            return;
        }
        let places: Vec<Vector<D>> = bends.iter().map(|bend| bend.at.into()).collect();
        let is_nearest = |at: &Vector<D>, place: &Vector<D>, unit: f64| {
            let away = (place - at).norm() - 1e-6 * unit;
            places.iter().all(|other| (place - other).norm() > away)
        };
        for number in 0..self.blocks.len() {
            for (bend, at) in bends.iter().zip(&places) {
                let away = |middle: &Vector<D>| {
                    let away = middle.norm() / bend.unit;
                    let is_own = || is_nearest(at, &(middle + at), bend.unit);
                    (away < FARTHEST && is_own()).then_some(away)
                };
                let block = &self.blocks[number];
                let faces = block.faces.iter();
                let faces = faces.enumerate().filter_map(|(number, face)| {
                    let seen = self.bent_face(cells, at, face, away)?;
                    Some(BentFace {
                        face: number,
                        ..seen
                    })
                });
                let walls = block.walls.iter().enumerate().filter_map(|(wall, known)| {
                    let middle = known.foot - at;
                    Some(BentWall {
                        wall,
                        point: (cells.points[known.i as usize] - at).into(),
                        middle: middle.into(),
                        away: away(&middle)?,
                    })
                });
                let around = Surroundings {
                    bend: *bend,
                    faces: faces.collect(),
                    walls: walls.collect(),
                };
                if !around.faces.is_empty() || !around.walls.is_empty() {
                    self.blocks[number].bends.push(around);
                }
            }
        }
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

    /// A face as seen from the bend `at`, where it counts.
    fn bent_face(
        &self,
        cells: &Cells<D>,
        at: &Vector<D>,
        face: &Face,
        away: impl Fn(&Vector<D>) -> Option<f64>,
    ) -> Option<BentFace<D>> {
        let shape = &self.face_shapes[face.shape as usize];
        let apart = Vector::<D>::from(shape.apart);
        let [first, second] = [face.i, face.j].map(|i| cells.points[i as usize] - at);
        let middle = first + apart * 0.5 + Vector::from(shape.skew);
        let away = away(&middle)?;
        // Faces to periodic images lie elsewhere.
        let is_there = (second - first - apart).norm() < 1e-6 * apart.norm();
        if !is_there {
            return None;
        }
        let normal = shape.area.map(|part| part / shape.size);
        let length = shape.weight * apart.norm();
        let half = turned(&normal.into()) * (0.5 * length);
        Some(BentFace {
            face: 0,
            points: [first.into(), second.into()],
            middle: middle.into(),
            half: half.into(),
            normal,
            size: shape.size,
            away,
        })
    }
}
