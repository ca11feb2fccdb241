//! Faces, walls and sides of all cells put together, closed, and their volumes.

use aero_geometry::Vector;
use aero_geometry::parallel::prelude::*;

use super::build::{Beside, Builder};
use super::cells::{Cells, Rings, SideFace, WallFace, WallOwner};
use super::cloud::NOBODY;
use super::cut_cell::CutCell;
use super::face_list::{FaceFiller, ordered, settled};
use super::folding::{folded_sides, folded_walls};
use super::merge::{Nodes, Target, given};
use super::voronoi::IN_BODY;
use crate::problem::Side;
use crate::walls::curvature::shape_operator;

/// Faces smaller than this, in spacings to their power, are left out.
const SMALLEST: f64 = 1e-13;

/// The faces of some cells.
#[derive(Clone, Debug, Default)]
struct Found<const D: usize> {
    faces: FaceFiller<D>,
    walls: Vec<WallFace<D>>,
    sides: Vec<SideFace<D>>,
}

impl<const D: usize> Found<D> {
    /// Adds what is found `of` each of so many cells, in their order.
    fn add(&mut self, count: usize, of: impl Fn(usize, &mut Self) + Sync) {
        /// Cells that one thread looks at, one after another.
        const CHUNK: usize = 4096;
        /// Chunks that are kept until they are added.
        const CHUNKS: usize = 64;
        for first in (0..count).step_by(CHUNKS * CHUNK) {
            let last = count.min(first + CHUNKS * CHUNK);
            let starts: Vec<usize> = (first..last).step_by(CHUNK).collect();
            let chunks = starts.par_iter().map(|&start| {
                let mut found = Self::default();
                for number in start..last.min(start + CHUNK) {
                    of(number, &mut found);
                }
                found
            });
            for found in chunks.collect::<Vec<Self>>() {
                self.faces.append(&found.faces.list());
                self.walls.extend(found.walls);
                self.sides.extend(found.sides);
            }
        }
    }
}

impl<const D: usize> Builder<'_, D> {
    /// All cells, those that were `cut` among them.
    pub(super) fn assemble(&self, positions: Vec<Vector<D>>, cut: &[CutCell<D>]) -> Cells<D> {
        let nodes = Nodes::new(&self.is_plain, cut);
        let targets = given(&nodes, cut);
        let mut volumes: Vec<f64> = (0..positions.len())
            .into_par_iter()
            .map(|number| {
                if self.is_plain[number] {
                    self.plain_volume(number)
                } else {
                    0.0
                }
            })
            .collect();
        for (cell, targets) in cut.iter().zip(&targets.of_parts) {
            for (part, target) in cell.parts.iter().zip(targets) {
                if let Some(target) = target {
                    volumes[target.cell as usize] += part.volume;
                }
            }
        }
        let mut all = Found::default();
        all.add(positions.len(), |number, found| {
            if self.is_plain[number] {
                self.plain_faces(number, found);
            }
        });
        all.add(cut.len(), |k, found| {
            self.cut_faces(k, cut, &nodes, &targets.of_parts, found);
        });
        let mut cells = Cells {
            points: positions,
            volumes,
            faces: all.faces.list().folded(self.plot.spacing),
            walls: folded_walls(all.walls, self.about_axis),
            sides: folded_sides(all.sides),
            cornered: Rings::new(),
            lost: targets.lost,
            open: 0.0,
        };
        cells.cornered = self.cornered(&cells.points, cut, &targets.of_parts);
        self.close(&mut cells);
        debug_assert!(cells.open < 1e-6, "faces leave a hole");
        self.bend(&mut cells);
        cells
    }

    fn radius(&self, number: usize, offset: f64) -> f64 {
        if self.about_axis {
            // Rounding must not give the axis an area.
            let radius = self.cloud.places[number].position[1] + offset;
            if radius.abs() < 1e-12 * self.plot.spacing {
                0.0
            } else {
                radius
            }
        } else {
            1.0
        }
    }

    fn plain_volume(&self, number: usize) -> f64 {
        let [low, high] = self.block(number);
        let middle = if D > 1 {
            0.5 * (low[D.min(2) - 1] + high[D.min(2) - 1])
        } else {
            0.0
        };
        (high - low).product() * self.radius(number, middle)
    }

    fn plain_faces(&self, number: usize, found: &mut Found<D>) {
        let [low, high] = self.block(number);
        let place = &self.cloud.places[number];
        let Some(site) = place.site else {
            return;
        };
        for axis in 0..D {
            for end in 0..2 {
                let mut step = [0; D];
                step[axis] = 2 * end - 1;
                let sign = f64::from(step[axis]);
                let mut centre = (low + high) * 0.5;
                centre[axis] = if end == 0 { low[axis] } else { high[axis] };
                let mut size: f64 = 1.0;
                for k in (0..D).filter(|&k| k != axis) {
                    size *= high[k] - low[k];
                }
                let mut area = Vector::<D>::zeros();
                area[axis] = sign * size * self.radius(number, if D > 1 { centre[1] } else { 0.0 });
                match self.beside(&site, &step) {
                    Beside::Point(other) => {
                        if other == number || self.is_plain[other] && end == 0 {
                            continue;
                        }
                        let mut apart = Vector::<D>::zeros();
                        apart[axis] = sign * place.spacing;
                        // The last cells before a side may be wider than the others.
                        let mut skew = centre;
                        skew[axis] = 0.0;
                        let skew = settled(skew, place.spacing);
                        let ends = (number as u32, other as u32);
                        found.faces.push(&ordered(ends, area, apart, skew));
                    }
                    _ => self.add_side(number as u32, (axis, end as usize), area, centre, found),
                }
            }
        }
    }

    fn cut_faces(
        &self,
        k: usize,
        cut: &[CutCell<D>],
        nodes: &Nodes,
        targets: &[Vec<Option<Target<D>>>],
        found: &mut Found<D>,
    ) {
        let cell = &cut[k];
        let unit = self.cloud.places[cell.number as usize].spacing;
        let least = SMALLEST * unit.powi(D as i32 - 1);
        for (part, target) in cell.parts.iter().zip(&targets[k]) {
            let Some(target) = target else {
                continue;
            };
            let origin = self.cloud.places[cell.number as usize].position;
            for wall in &part.walls {
                if wall.area.norm() > least {
                    found.walls.push(WallFace {
                        i: target.cell,
                        area: wall.area,
                        owner: WallOwner::Body(wall.body),
                        curvature: nalgebra::SMatrix::zeros(),
                        foot: origin + wall.centre,
                        facet: wall.facet,
                    });
                }
            }
            for face in &part.faces {
                if face.area.norm() <= least {
                    continue;
                }
                if face.label == IN_BODY {
                    self.add_open(target.cell, face.area, origin + face.centre, found);
                    continue;
                }
                let Some(number) = (face.label as usize).checked_sub(2 * D) else {
                    let side = (face.label as usize / 2, face.label as usize % 2);
                    let shift = origin - self.cloud.places[target.cell as usize].position;
                    self.add_side(target.cell, side, face.area, face.centre + shift, found);
                    continue;
                };
                let link = &cell.links[number];
                if link.to == cell.number || nodes.is_plain(link.to) {
                    continue;
                }
                let Some((other, piece)) = nodes.across(cut, k, face) else {
                    continue;
                };
                match &targets[other][piece] {
                    Some(beyond) => {
                        let apart = link.apart + beyond.offset - target.offset;
                        let same = beyond.cell == target.cell && apart.norm() < 1e-6 * unit;
                        if cell.number < link.to && !same {
                            let skew = face.centre - target.offset - apart * 0.5;
                            let skew = settled(skew, unit);
                            let ends = (target.cell, beyond.cell);
                            let joined = ordered(ends, face.area, apart, skew);
                            found.faces.push(&joined);
                        }
                    }
                    None => self.add_open(target.cell, face.area, origin + face.centre, found),
                }
            }
        }
    }

    fn add_side(
        &self,
        i: u32,
        (axis, end): (usize, usize),
        area: Vector<D>,
        centre: Vector<D>,
        found: &mut Found<D>,
    ) {
        let centre = self.cloud.places[i as usize].position + centre;
        if area.norm() <= SMALLEST * self.plot.spacing.powi(D as i32 - 1) * 1e-3 {
            return;
        }
        let (axis8, end8) = (axis as u8, end as u8);
        match self.plot.domain.side_at(axis, end, &centre) {
            Side::Wall { .. } | Side::Body => found.walls.push(WallFace {
                i,
                area,
                owner: WallOwner::Side {
                    axis: axis8,
                    end: end8,
                },
                curvature: nalgebra::SMatrix::zeros(),
                foot: centre,
                facet: 0,
            }),
            _ => found.sides.push(SideFace {
                i,
                area,
                axis: axis8,
                end: end8,
                centre,
            }),
        }
    }

    /// A face with nothing beyond it, which only a pocket without points has: a wall of the nearest body.
    fn add_open(&self, i: u32, area: Vector<D>, centre: Vector<D>, found: &mut Found<D>) {
        let (body, facet) = self
            .plot
            .solids
            .closest(&centre)
            .map_or((0, 0), |(body, closest)| (body, closest.face));
        found.walls.push(WallFace {
            i,
            area,
            owner: WallOwner::Body(body),
            curvature: nalgebra::SMatrix::zeros(),
            foot: centre,
            facet,
        });
    }

    /// Lets the walls take what rounding left open.
    fn close(&self, cells: &mut Cells<D>) {
        let sums = cells.open_areas(self.about_axis);
        let mut largest = vec![NOBODY; cells.points.len()];
        for (number, wall) in (0..).zip(&cells.walls) {
            let known = &mut largest[wall.i as usize];
            let before = cells.walls.get(*known as usize);
            if before.is_none_or(|before| wall.area.norm() > before.area.norm()) {
                *known = number;
            }
        }
        for (i, sum) in sums.iter().enumerate() {
            let unit = self.cloud.places[i].spacing.powi(D as i32 - 1);
            cells.open = cells.open.max(sum.norm() / unit);
            if let Some(wall) = cells.walls.get_mut(largest[i] as usize) {
                wall.area -= sum;
            }
        }
    }

    /// Says how the walls bend.
    fn bend(&self, cells: &mut Cells<D>) {
        if D == 1 {
            return;
        }
        cells.walls.par_iter_mut().for_each(|wall| {
            if let WallOwner::Body(body) = wall.owner
                && !self.plot.solids.is_empty()
            {
                let reach = self.cloud.places[wall.i as usize].spacing;
                let lifted = wall.foot - wall.area.normalize() * (0.1 * reach);
                wall.curvature = shape_operator(self.plot.solids.shape(body), &lifted, reach);
            }
        });
    }
}
