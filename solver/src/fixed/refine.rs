//! Where points are added and taken away: around those that a flow marks, and where bodies are thin or bent.

use std::collections::HashMap;

use aero_geometry::Vector;

use super::cloud::{Cloud, Plot, Site};
use super::levels::{Levels, parent, parts};
use super::solids::Line;
use crate::walls::shape_operator;

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
    /// parts may be joined.
    pub fn heard<const D: usize>(
        &self,
        cloud: &Cloud<D>,
        levels: &Levels<D>,
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
            if levels.is_split(&site) && !self.is_wished(cloud, &site, wishes) {
                changed.join(&site);
            }
        }
        changed
    }

    /// Splits the cells of the site's own size around it.
    fn split_around<const D: usize>(&self, site: &Site<D>, levels: &mut Levels<D>) {
        let wide = 2 * self.around + 1;
        for code in 0..wide.pow(D as u32) {
            let index = std::array::from_fn(|k| {
                site.index[k] + code / wide.pow(k as u32) % wide - self.around
            });
            levels.split(&Site { index, ..*site });
        }
    }

    /// True where a point near one of the parts of a cell wants them split.
    fn is_wished<const D: usize>(&self, cloud: &Cloud<D>, site: &Site<D>, wishes: &[Wish]) -> bool {
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
            let cloud = Cloud::lattice(plot, &levels, 0.0);
            let mut wanted: Vec<Site<D>> = Vec::new();
            for place in &cloud.places {
                let Some(site) = place.site else {
                    continue;
                };
                let near = place.distance < self.reach * place.spacing;
                if site.level == level && near && self.asks(plot, &place.position, place.spacing) {
                    wanted.push(site);
                }
            }
            if wanted.is_empty() {
                break;
            }
            wanted.iter().for_each(|site| levels.split(site));
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
        let ends = [from, to].map(|end| plot.solids.height(&end, spacing));
        ends[0] < 0.0 && !plot.solids.crossings(&line, ends).is_empty()
    }
}
