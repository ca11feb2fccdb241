//! Cells from points: those of an undisturbed lattice as they are, all others cut out one by one.

use aero_geometry::Vector;
use rayon::prelude::*;

use super::cells::{Cells, Face, SideFace, WallFace, WallOwner};
use super::cloud::{Cloud, Plot, Site, steps};
use super::cut::Whole;
use super::folding::{folded_faces, folded_sides, folded_walls};
use super::merge::{Nodes, Target, given};
use super::part::Part;
use super::voronoi::{IN_BODY, Link, Voronoi};
use crate::problem::Side;
use crate::walls::curvature::shape_operator;

/// Faces smaller than this, in spacings to their power, are left out.
const SMALLEST: f64 = 1e-13;

/// What was found on the way.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Findings {
    /// Cells that were cut out one by one.
    pub cut: usize,
    /// Pieces behind thin parts that were given to a neighbour.
    pub given: usize,
    /// Pieces that nobody could take.
    pub lost: usize,
    /// Largest part of a cell's faces that did not close before its wall took it, in spacings to their power.
    pub open: f64,
}

/// A cell that was cut out.
#[derive(Clone, Debug)]
pub struct CutCell<const D: usize> {
    /// Its number.
    pub number: u32,
    /// Its neighbours.
    pub links: Vec<Link<D>>,
    /// Its pieces, its own first.
    pub parts: Vec<Part<D>>,
}

/// Builds cells.
#[derive(Debug)]
pub struct Builder<'a, const D: usize> {
    plot: Plot<'a, D>,
    cloud: &'a Cloud<D>,
    about_axis: bool,
    /// Which cells are boxes of the lattice.
    is_plain: Vec<bool>,
    keeps_rings: bool,
}

/// The faces of some cells.
#[derive(Clone, Debug, Default)]
struct Found<const D: usize> {
    faces: Vec<Face<D>>,
    walls: Vec<WallFace<D>>,
    sides: Vec<SideFace<D>>,
}

/// The cells of a cloud.
pub fn cells<const D: usize>(plot: &Plot<'_, D>, cloud: &Cloud<D>) -> (Cells<D>, Findings) {
    let builder = Builder::new(*plot, cloud);
    let positions = cloud.positions();
    let cut = builder.cut_cells(&positions);
    builder.assemble(positions, &cut)
}

impl<'a, const D: usize> Builder<'a, D> {
    /// Tells plain cells from others.
    pub fn new(plot: Plot<'a, D>, cloud: &'a Cloud<D>) -> Self {
        let mut builder = Self {
            plot,
            cloud,
            about_axis: plot.domain.is_axisymmetric(),
            is_plain: Vec::new(),
            keeps_rings: false,
        };
        builder.is_plain = (0..cloud.places.len())
            .into_par_iter()
            .map(|number| builder.is_plain_site(number))
            .collect();
        builder
    }

    /// True where a cell's neighbours are those of the lattice and no wall touches it.
    fn is_plain_site(&self, number: usize) -> bool {
        let place = &self.cloud.places[number];
        let Some(site) = place.site else {
            return false;
        };
        let radius = 0.5 * place.spacing * (D as f64).sqrt();
        if place.is_moved
            || place.distance <= radius * (1.0 + 1e-9)
            || self.cloud.is_near_loose(&site)
        {
            return false;
        }
        steps::<D>().all(|step| match self.beside(&site, &step) {
            Beside::Point(other) => !self.cloud.places[other].is_moved,
            Beside::Side => true,
            Beside::Nothing => false,
        })
    }

    fn beside(&self, site: &Site<D>, step: &[i32; D]) -> Beside {
        let mut index = site.index;
        for k in 0..D {
            index[k] += step[k];
            let count = self.cloud.counts[k] << site.level;
            if (0..count).contains(&index[k]) {
                continue;
            }
            if self.plot.domain.sides[k][0] != Side::Periodic {
                return Beside::Side;
            }
            let length = f64::from(self.cloud.counts[k]) * self.cloud.spacing;
            if (length - self.plot.domain.bounds.size()[k]).abs() > 1e-9 * self.cloud.spacing {
                return Beside::Nothing;
            }
            index[k] = index[k].rem_euclid(count);
        }
        let there = Site { index, ..*site };
        self.cloud.at(&there).map_or(Beside::Nothing, Beside::Point)
    }

    /// The same, with the pieces' outlines kept.
    #[must_use]
    pub fn keeping_rings(mut self) -> Self {
        self.keeps_rings = true;
        self
    }

    /// Which cells were cut.
    pub fn nodes(&self, cut: &[CutCell<D>]) -> Nodes {
        Nodes::new(&self.is_plain, cut)
    }

    /// True where a cell is a box of the lattice.
    pub fn is_plain(&self, number: usize) -> bool {
        self.is_plain[number]
    }

    /// The box of a plain cell, from its point.
    pub fn block(&self, number: usize) -> [Vector<D>; 2] {
        let place = &self.cloud.places[number];
        let half = 0.5 * place.spacing;
        let (low, mut high) = (Vector::repeat(-half), Vector::repeat(half));
        if let Some(site) = place.site {
            for k in 0..D {
                let last = (self.cloud.counts[k] << site.level) - 1;
                let end = self.plot.domain.bounds.max[k] - place.position[k];
                // The last cells end at the side, wherever that is.
                let ends_there = site.index[k] == last
                    && self.plot.domain.sides[k][0] != Side::Periodic
                    && (end - half).abs() > 1e-9 * place.spacing;
                if ends_there {
                    high[k] = end;
                }
            }
        }
        [low, high]
    }

    /// All cells that are not plain, in order.
    pub fn cut_cells(&self, positions: &[Vector<D>]) -> Vec<CutCell<D>> {
        let voronoi = Voronoi::new(self.plot, self.cloud, positions);
        let numbers: Vec<usize> = (0..self.is_plain.len())
            .filter(|&number| !self.is_plain[number])
            .collect();
        numbers
            .par_iter()
            .map(|&number| self.cut_cell(&voronoi, number))
            .collect()
    }

    fn cut_cell(&self, voronoi: &Voronoi<'_, D>, number: usize) -> CutCell<D> {
        let (cell, links) = voronoi.cell(number);
        let place = &self.cloud.places[number];
        let whole = Whole {
            cell: &cell,
            point: &place.position,
            unit: place.spacing,
            about_axis: self.about_axis,
            keeps_rings: self.keeps_rings,
        };
        let parts = if place.distance > cell.reach_squared().sqrt() * (1.0 + 1e-9) {
            vec![whole.uncut()]
        } else {
            whole.parts(self.plot.solids)
        };
        CutCell {
            number: number as u32,
            links,
            parts,
        }
    }

    fn assemble(&self, positions: Vec<Vector<D>>, cut: &[CutCell<D>]) -> (Cells<D>, Findings) {
        const CHUNK: usize = 4096;
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
        let starts: Vec<usize> = (0..positions.len()).step_by(CHUNK).collect();
        let plain: Vec<Found<D>> = starts
            .par_iter()
            .map(|&first| {
                let mut found = Found::default();
                for number in first..(first + CHUNK).min(positions.len()) {
                    if self.is_plain[number] {
                        self.plain_faces(number, &mut found);
                    }
                }
                found
            })
            .collect();
        let of_cut: Vec<Found<D>> = (0..cut.len())
            .collect::<Vec<_>>()
            .par_chunks(CHUNK)
            .map(|chunk| {
                let mut found = Found::default();
                for &k in chunk {
                    self.cut_faces(k, cut, &nodes, &targets.of_parts, &mut found);
                }
                found
            })
            .collect();
        let mut all = Found::default();
        for found in plain.into_iter().chain(of_cut) {
            all.faces.extend(found.faces);
            all.walls.extend(found.walls);
            all.sides.extend(found.sides);
        }
        let mut cells = Cells {
            points: positions,
            volumes,
            faces: folded_faces(all.faces, self.plot.spacing),
            walls: folded_walls(all.walls),
            sides: folded_sides(all.sides),
        };
        let mut findings = Findings {
            cut: cut.len(),
            given: targets.given,
            lost: targets.lost,
            open: 0.0,
        };
        findings.open = self.close(&mut cells);
        self.bend(&mut cells);
        (cells, findings)
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
                        found
                            .faces
                            .push(ordered(number as u32, other as u32, area, apart));
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
                            found
                                .faces
                                .push(ordered(target.cell, beyond.cell, face.area, apart));
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
        match self.plot.domain.sides[axis][end] {
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

    /// Lets the walls take what rounding left open; says how much that was at most.
    fn close(&self, cells: &mut Cells<D>) -> f64 {
        let sums = cells.open_areas(self.about_axis);
        let mut most = 0.0_f64;
        let mut largest: Vec<Option<usize>> = vec![None; cells.points.len()];
        for (number, wall) in cells.walls.iter().enumerate() {
            let known = &mut largest[wall.i as usize];
            let larger = known.is_none_or(|k| wall.area.norm() > cells.walls[k].area.norm());
            if larger {
                *known = Some(number);
            }
        }
        for (i, sum) in sums.iter().enumerate() {
            let unit = self.cloud.places[i].spacing.powi(D as i32 - 1);
            most = most.max(sum.norm() / unit);
            if let Some(wall) = largest[i] {
                cells.walls[wall].area -= sum;
            }
        }
        most
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

/// What is next to a lattice cell.
enum Beside {
    /// A point.
    Point(usize),
    /// The end of the domain.
    Side,
    /// Neither.
    Nothing,
}

fn ordered<const D: usize>(i: u32, j: u32, area: Vector<D>, apart: Vector<D>) -> Face<D> {
    if i < j {
        Face { i, j, area, apart }
    } else {
        Face {
            i: j,
            j: i,
            area: -area,
            apart: -apart,
        }
    }
}
