//! Where points are added and taken away: around those that a flow marks, and where bodies are thin or bent.

use std::collections::HashMap;

use aero_geometry::Vector;
use rayon::prelude::*;

use super::cloud::{Cloud, Plot, Site, children};
use super::levels::{Levels, parent, parts};
use super::solids::Line;
use crate::walls::curvature::shape_operator;

/// What is to be done about a point's cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wish {
    /// Join it with those it was split from, if they wish so too.
    Join,
    /// Leave it as it is.
    Keep,
    /// Split it.
    Split,
}

/// How the lattice follows what is wished.
#[derive(Clone, Copy, Debug)]
pub struct Adaption {
    /// How often a cell may be split.
    pub most: u8,
    /// Cells around a marked one that are split with it, in cells of its own size.
    pub around: i32,
}

impl Adaption {
    /// The levels after the wishes of all points of a cloud are heard: splits first, then joins of cells all of whose
    /// parts may be joined, but for those that `kept` has split.
    pub fn heard<const D: usize>(
        &self,
        cloud: &Cloud<D>,
        levels: &Levels<D>,
        kept: &Levels<D>,
        wishes: &[Wish],
    ) -> Levels<D> {
        let mut changed = levels.clone();
        let mut joins: HashMap<Site<D>, usize> = HashMap::new();
        for (place, wish) in cloud.places.iter().zip(wishes) {
            let Some(site) = place.site else {
                continue;
            };
            match wish {
                Wish::Split if site.level < self.most => self.split_around(&site, &mut changed),
                Wish::Join if site.level > 0 => *joins.entry(parent(&site)).or_default() += 1,
                _ => {}
            }
        }
        let mut joins: Vec<Site<D>> = joins
            .into_iter()
            .filter(|(site, count)| {
                *count == parts(site).filter(|part| cloud.at(part).is_some()).count()
            })
            .map(|(site, _)| site)
            .collect();
        joins.sort_by_key(|site| (std::cmp::Reverse(site.level), site.index));
        for site in joins {
            // What was split just now stays so.
            let may_go = levels.is_split(&site) && !kept.is_split(&site);
            if may_go && !self.is_wished(cloud, &site, wishes) {
                changed.join(&site);
            }
        }
        changed
    }

    /// Splits the cells of the site's own size around it.
    fn split_around<const D: usize>(self, site: &Site<D>, levels: &mut Levels<D>) {
        let wide = 2 * self.around + 1;
        for code in 0..wide.pow(D as u32) {
            let index = std::array::from_fn(|k| {
                site.index[k] + code / wide.pow(k as u32) % wide - self.around
            });
            levels.split(&Site { index, ..*site });
        }
    }

    /// True where a point near one of the parts of a cell wants them split.
    fn is_wished<const D: usize>(self, cloud: &Cloud<D>, site: &Site<D>, wishes: &[Wish]) -> bool {
        let wide = 2 * self.around + 1;
        parts(site).any(|part| {
            (0..wide.pow(D as u32)).any(|code| {
                let index = std::array::from_fn(|k| {
                    part.index[k] + code / wide.pow(k as u32) % wide - self.around
                });
                let found = cloud.at(&Site { index, ..part });
                found.is_some_and(|number| wishes[number] == Wish::Split)
            })
        })
    }
}

/// What bodies ask of the spacing of the points around them.
#[derive(Clone, Copy, Debug)]
pub struct BodyNeeds {
    /// How often a cell may be split.
    pub most: u8,
    /// Points across the thickness of a part.
    pub across: f64,
    /// Points along the radius of a bend.
    pub radius: f64,
    /// Distance from the wall, in spacings, up to which that holds.
    pub reach: f64,
}

impl BodyNeeds {
    /// The levels that the bodies ask for before the first step.
    pub fn levels<const D: usize>(&self, plot: &Plot<'_, D>) -> Levels<D> {
        let mut levels = Levels::default();
        for level in 0..self.most {
            let grid = Grid::new(plot);
            let near = grid.near_walls(&levels, level, self.reach);
            let wanted: Vec<Site<D>> = near
                .into_par_iter()
                .filter(|site| self.asks(plot, &grid.middle(site), grid.spacing(site)))
                .collect();
            if wanted.is_empty() {
                break;
            }
            for site in &wanted {
                levels.split(site);
            }
        }
        levels
    }

    fn asks<const D: usize>(&self, plot: &Plot<'_, D>, point: &Vector<D>, spacing: f64) -> bool {
        let Some((body, closest)) = plot.solids.closest(point) else {
            return false;
        };
        let bend = if D > 1 {
            shape_operator(plot.solids.shape(body), point, 0.5 * spacing).norm()
        } else {
            0.0
        };
        if bend * self.radius * spacing > 1.0 {
            return true;
        }
        let from = closest.point - closest.normal * (1e-3 * spacing);
        let to = closest.point - closest.normal * (self.across * spacing);
        let line = Line {
            from,
            to,
            unit: spacing,
        };
        let ends = [from, to].map(|end| plot.solids.height(&end));
        ends[0] < 0.0 && !plot.solids.crossings(&line, ends).is_empty()
    }
}

/// The lattice, cells in bodies included: they too may hold gas near their corners.
struct Grid<'a, const D: usize> {
    plot: &'a Plot<'a, D>,
    counts: [i32; D],
}

impl<'a, const D: usize> Grid<'a, D> {
    fn new(plot: &'a Plot<'a, D>) -> Self {
        let counts = plot.counts();
        Self { plot, counts }
    }

    fn spacing(&self, site: &Site<D>) -> f64 {
        self.plot.spacing / f64::from(1 << site.level)
    }

    fn middle(&self, site: &Site<D>) -> Vector<D> {
        let spacing = self.spacing(site);
        let corner = &self.plot.domain.bounds.min;
        Vector::from_fn(|k, _| corner[k] + (f64::from(site.index[k]) + 0.5) * spacing)
    }

    /// Cells of a level, not split further, whose middle is within `reach` of their size of a wall.
    fn near_walls(&self, levels: &Levels<D>, level: u8, reach: f64) -> Vec<Site<D>> {
        let mut found = Vec::new();
        let mut size = 1;
        while size < self.counts.iter().copied().max().unwrap_or(1) {
            size *= 2;
        }
        let mut open = vec![([0; D], size)];
        while let Some((low, size)) = open.pop() {
            if (0..D).any(|k| low[k] >= self.counts[k]) {
                continue;
            }
            let half = 0.5 * f64::from(size) * self.plot.spacing;
            let corner = &self.plot.domain.bounds.min;
            let middle =
                Vector::from_fn(|k, _| corner[k] + f64::from(low[k]) * self.plot.spacing + half);
            let radius = half * (D as f64).sqrt() + reach * self.plot.spacing;
            if self.plot.solids.distance(&middle).abs() > radius {
                continue;
            }
            if size > 1 {
                open.extend(children(low, size / 2).map(|child| (child, size / 2)));
                continue;
            }
            let site = Site {
                level: 0,
                index: low,
            };
            self.descend(levels, &site, level, reach, &mut found);
        }
        found
    }

    fn descend(
        &self,
        levels: &Levels<D>,
        site: &Site<D>,
        level: u8,
        reach: f64,
        found: &mut Vec<Site<D>>,
    ) {
        if levels.is_split(site) {
            for part in parts(site) {
                self.descend(levels, &part, level, reach, found);
            }
        } else if site.level == level {
            let distance = self.plot.solids.distance(&self.middle(site)).abs();
            if distance < reach * self.spacing(site) {
                found.push(*site);
            }
        }
    }
}
