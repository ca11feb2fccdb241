//! Where points are added and taken away: around those that a flow marks, and where bodies are thin or bent.

use std::collections::HashMap;

use aero_geometry::Vector;
use aero_geometry::parallel::prelude::*;
use foldhash::fast::FixedState;

use super::cloud::Cloud;
use super::levels::{Levels, Sites, parent, parts};
use super::plot::Plot;
use super::site::{Site, children};
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
    /// Cells around the parts of a marked one that are split with it, in cells of the parts' size.
    pub around: i32,
}

impl Adaption {
    /// The levels after the wishes of all points of a cloud are heard: splits first, then joins of cells all of whose
    /// parts may be joined, but for those that `kept` has split.
    pub fn heard<const D: usize>(
        self,
        cloud: &Cloud<D>,
        levels: &Levels<D>,
        kept: &Levels<D>,
        wishes: &[Wish],
    ) -> Levels<D> {
        let mut changed = levels.clone();
        let mut asked = Sites::default();
        let mut joins: HashMap<Site<D>, usize, FixedState> = HashMap::default();
        for (place, wish) in cloud.places.iter().zip(wishes) {
            let Some(site) = place.site else {
                continue;
            };
            match wish {
                Wish::Split if self.most > 0 => self.ask(&site, levels, &mut asked),
                Wish::Join if site.level > 0 => *joins.entry(parent(&site)).or_default() += 1,
                _ => {}
            }
        }
        for site in &asked {
            changed.split(site);
        }
        let mut joins: Vec<Site<D>> = joins
            .into_iter()
            .filter(|(site, count)| {
                *count == parts(site).filter(|part| cloud.at(part).is_some()).count()
            })
            .map(|(site, _)| site)
            .filter(|site| levels.is_split(site) && !kept.is_split(site) && !asked.contains(site))
            .collect();
        joins.sort_by_key(|site| (std::cmp::Reverse(site.level), site.index));
        for site in joins {
            changed.join(&site);
        }
        changed
    }

    /// True where all cells that `wishes` ask for, within `around` of the marked ones, are there already.
    pub fn is_served<const D: usize>(
        self,
        cloud: &Cloud<D>,
        levels: &Levels<D>,
        wishes: &[Wish],
        around: i32,
    ) -> bool {
        let closer = Self { around, ..self };
        let mut asked = Sites::default();
        for (place, wish) in cloud.places.iter().zip(wishes) {
            if let (Some(site), Wish::Split) = (place.site, wish) {
                closer.ask(&site, levels, &mut asked);
            }
        }
        asked.iter().all(|site| levels.is_split(site))
    }

    /// Asks for cells half the size of a site's in it and around it, or of its own size where it may not be split.
    fn ask<const D: usize>(self, site: &Site<D>, levels: &Levels<D>, asked: &mut Sites<D>) {
        let level = (site.level + 1).min(self.most);
        let fold = level - site.level;
        // The cells that are split for it.
        let mut low = site.index;
        let mut counts = [0; D];
        let mut total = 1;
        for k in 0..D {
            let first = (site.index[k] << fold) - self.around;
            let last = ((site.index[k] + 1) << fold) - 1 + self.around;
            low[k] = first >> 1;
            counts[k] = (last >> 1) - low[k] + 1;
            total *= counts[k];
        }
        for mut code in 0..total {
            let mut index = low;
            for k in 0..D {
                index[k] += code % counts[k];
                code /= counts[k];
            }
            let split = Site {
                level: level - 1,
                index,
            };
            asked.extend(levels.inside(&split));
        }
    }
}

/// What bodies ask of the spacing of the points around them.
#[derive(Clone, Copy, Debug)]
pub struct BodyNeeds {
    /// How often a cell may be split where a part is thin.
    pub most: u8,
    /// The same where one is bent.
    pub most_of_bends: u8,
    /// Points across the thickness of a part.
    pub across: f64,
    /// Points along the radius of a bend.
    pub radius: f64,
    /// Distance from the wall, in spacings, up to which that holds.
    pub reach: f64,
}

impl BodyNeeds {
    /// The levels that the bodies ask for before the first step.
    ///
    /// # Errors
    /// About how many points they would make, more than there is `room` for.
    pub fn levels<const D: usize>(
        &self,
        plot: &Plot<'_, D>,
        room: Option<u64>,
    ) -> Result<Levels<D>, u64> {
        let lattice: u64 = plot.counts().iter().map(|&count| count as u64).product();
        let mut levels = Levels::on(plot);
        for level in 0..self.most.max(self.most_of_bends) {
            let grid = Grid::new(plot);
            let near = grid.near_walls(&levels, level, self.reach);
            let wanted: Vec<Site<D>> = near
                .into_par_iter()
                .filter(|site| self.asks(&grid, site))
                .collect();
            if wanted.is_empty() {
                break;
            }
            for site in &wanted {
                levels.split(site);
            }
            let count = lattice + levels.added() as u64;
            if room.is_some_and(|room| count > room) {
                return Err(count);
            }
        }
        Ok(levels)
    }

    /// The same with one halving less.
    #[must_use]
    pub fn less(self) -> Self {
        Self {
            most: self.most.saturating_sub(1),
            most_of_bends: self.most_of_bends.saturating_sub(1),
            ..self
        }
    }

    /// True where the nearest wall asks for less than the size of the cell; of cells that are large beside a body, whose middle may be far from what
    /// asks, where it does so of a part.
    fn asks<const D: usize>(&self, grid: &Grid<'_, D>, site: &Site<D>) -> bool {
        self.asks_from_middle(grid, site)
            || grid.spacing(site) > grid.shown
                && parts(site).any(|part| grid.is_near(&part, self.reach) && self.asks(grid, &part))
    }

    fn asks_from_middle<const D: usize>(&self, grid: &Grid<'_, D>, site: &Site<D>) -> bool {
        let (plot, point, spacing) = (grid.plot, grid.middle(site), grid.spacing(site));
        let Some((body, closest)) = plot.solids.closest(&point) else {
            return false;
        };
        if D > 1 && site.level < self.most_of_bends {
            let bend = shape_operator(plot.solids.shape(body), &point, 0.5 * spacing).norm();
            if bend * self.radius * spacing > 1.0 {
                return true;
            }
        }
        if site.level >= self.most {
            return false;
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
    /// Cells of this size show where the smallest body is.
    shown: f64,
}

impl<'a, const D: usize> Grid<'a, D> {
    fn new(plot: &'a Plot<'a, D>) -> Self {
        /// Of the longest edge of a body's box.
        const SHOWN: f64 = 1.0 / 16.0;
        Self {
            plot,
            counts: plot.counts(),
            shown: SHOWN * plot.solids.smallest(),
        }
    }

    fn spacing(&self, site: &Site<D>) -> f64 {
        self.plot.spacing / f64::from(1 << site.level)
    }

    fn middle(&self, site: &Site<D>) -> Vector<D> {
        let spacing = self.spacing(site);
        let corner = &self.plot.corner;
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
            let corner = &self.plot.corner;
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
        } else if site.level == level && self.is_near(site, reach) {
            found.push(*site);
        }
    }

    /// True of a cell whose middle is within `reach` of its size of a wall.
    fn is_near(&self, site: &Site<D>, reach: f64) -> bool {
        self.plot.solids.distance(&self.middle(site)).abs() < reach * self.spacing(site)
    }
}
