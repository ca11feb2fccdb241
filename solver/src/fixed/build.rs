//! Cells from points: those of an undisturbed lattice as they are, all others cut out one by one.

use aero_geometry::Vector;
use aero_geometry::parallel::prelude::*;

use super::cells::Cells;
use super::cloud::{Cloud, NOBODY};
use super::cut_cell::CutCell;
use super::levels::parts;
use super::merge::Nodes;
use super::part::Part;
use super::plot::Plot;
use super::site::{Site, steps};
use super::voronoi::Voronoi;
use super::whole::Whole;
use crate::problem::Side;

/// Cells of a cloud, and what cells of the next one may take over.
#[derive(Clone, Debug)]
pub struct Built<const D: usize> {
    /// The cells.
    pub cells: Cells<D>,
    /// Those that were cut out one by one.
    pub cut: Vec<CutCell<D>>,
    /// Which cell of the earlier cloud each is the same as; [`NOBODY`] where it is new.
    pub same: Vec<u32>,
}

/// Builds cells.
#[derive(Debug)]
pub struct Builder<'a, const D: usize> {
    pub(super) plot: Plot<'a, D>,
    pub(super) cloud: &'a Cloud<D>,
    pub(super) about_axis: bool,
    /// Which cells are boxes of the lattice.
    pub(super) is_plain: Vec<bool>,
    keeps_rings: bool,
}

/// The cells of a cloud, with what the next cloud may take over.
pub fn built<const D: usize>(plot: &Plot<'_, D>, cloud: &Cloud<D>) -> Built<D> {
    let builder = Builder::new(*plot, cloud);
    let positions = cloud.positions();
    let cut = builder.cut_cells(&positions);
    let same = vec![NOBODY; positions.len()];
    let cells = builder.assemble(positions, &cut);
    Built { cells, cut, same }
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

    pub(super) fn beside(&self, site: &Site<D>, step: &[i32; D]) -> Beside {
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
        match self.cloud.at(&there) {
            Some(other) => Beside::Point(other),
            None if self.is_over_the_end(&there) => Beside::Side,
            None => Beside::Nothing,
        }
    }

    /// True of a cell without a point, and without parts that have any, whose middle lies beyond a side or close before it.
    fn is_over_the_end(&self, site: &Site<D>) -> bool {
        let spacing = self.cloud.spacing / f64::from(1 << site.level);
        let corner = &self.cloud.corner;
        let middle = Vector::from_fn(|k, _| corner[k] + (f64::from(site.index[k]) + 0.5) * spacing);
        self.plot.is_over_the_end(&middle, spacing)
            && parts(site).all(|part| self.cloud.at(&part).is_none())
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
        let (mut low, mut high) = (Vector::repeat(-half), Vector::repeat(half));
        if let Some(site) = place.site {
            for k in 0..D {
                if self.plot.domain.sides[k][0] == Side::Periodic {
                    continue;
                }
                let bounds = &self.plot.domain.bounds;
                let [start, end] = [bounds.min[k], bounds.max[k]].map(|at| at - place.position[k]);
                // The first and the last cells end at the sides, wherever those are.
                let differ = |a: f64, b: f64| (a - b).abs() > 1e-9 * place.spacing;
                let ends = |way: i32| {
                    let step = std::array::from_fn(|axis| if axis == k { way } else { 0 });
                    matches!(self.beside(&site, &step), Beside::Side)
                };
                if differ(start, -half) && -start < 2.0 * place.spacing && ends(-1) {
                    low[k] = start;
                }
                if differ(end, half) && end < 2.0 * place.spacing && ends(1) {
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

    pub(super) fn cut_cell(&self, voronoi: &Voronoi<'_, D>, number: usize) -> CutCell<D> {
        self.cut_with(voronoi, number, self.keeps_rings)
    }

    /// The cell, with its outlines where these are to be kept.
    pub(super) fn cut_with(
        &self,
        voronoi: &Voronoi<'_, D>,
        number: usize,
        keeps_rings: bool,
    ) -> CutCell<D> {
        let (cell, mut links) = voronoi.cell(number);
        links.shrink_to_fit();
        let place = &self.cloud.places[number];
        let whole = Whole {
            cell: &cell,
            point: &place.position,
            unit: place.spacing,
            about_axis: self.about_axis,
            keeps_rings,
        };
        let mut parts = if place.distance > cell.reach_squared().sqrt() * (1.0 + 1e-9) {
            vec![whole.uncut()]
        } else {
            whole.parts(self.plot.solids)
        };
        parts.iter_mut().for_each(Part::shrink_to_fit);
        CutCell {
            number: number as u32,
            links,
            parts,
            reach: 2.0 * cell.reach_squared().sqrt(),
        }
    }
}

/// What is next to a lattice cell.
pub(super) enum Beside {
    /// A point.
    Point(usize),
    /// The end of the domain.
    Side,
    /// Neither.
    Nothing,
}
