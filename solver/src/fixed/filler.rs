//! The lattice filled with points, block by block along a Morton curve, and moved off the walls.

use aero_geometry::Vector;
use aero_geometry::parallel::prelude::*;

use super::cloud::{Cloud, Place};
use super::levels::Levels;
use super::plot::{Plot, off_the_walls};
use super::site::{Site, children};
use crate::lattice::displacement;

impl<const D: usize> Cloud<D> {
    /// The lattice, its cells split as `levels` say, each point displaced at random by up to `disorder` of a spacing
    /// along each axis.
    pub fn lattice(plot: &Plot<'_, D>, levels: &Levels<D>, disorder: f64) -> Self {
        Self::lattice_after(plot, levels, disorder, None)
    }

    /// The same; points that an `earlier` one of the same plot had are taken from there.
    pub fn lattice_after(
        plot: &Plot<'_, D>,
        levels: &Levels<D>,
        disorder: f64,
        earlier: Option<&Self>,
    ) -> Self {
        let mut cloud = Self::empty(plot);
        cloud.places = filled(plot, levels, disorder, earlier);
        cloud.number();
        cloud.paired(plot)
    }
}

/// Lattice cells along the edge of a block that is filled at one go.
const BLOCK: i32 = 16;

/// Distance from walls in spacings beyond which nothing there matters.
const FAR: f64 = 3.0;

/// The points of the lattice, its cells split as `levels` say, in their order; those that an `earlier` cloud had are taken from there.
pub fn filled<const D: usize>(
    plot: &Plot<'_, D>,
    levels: &Levels<D>,
    disorder: f64,
    earlier: Option<&Cloud<D>>,
) -> Vec<Place<D>> {
    let filler = Filler {
        plot,
        levels,
        disorder,
        earlier,
        corner: plot.corner,
        counts: plot.counts(),
    };
    let mut size = BLOCK;
    while size < filler.counts.iter().copied().max().unwrap_or(1) {
        size *= 2;
    }
    let mut blocks = Vec::new();
    filler.blocks([0; D], size, &mut blocks);
    let places: Vec<Vec<Place<D>>> = blocks
        .par_iter()
        .map(|&low| {
            let mut places = Vec::new();
            filler.fill(low, BLOCK, &mut places);
            places
        })
        .collect();
    places.concat()
}

/// Fills blocks of the lattice.
struct Filler<'a, const D: usize> {
    plot: &'a Plot<'a, D>,
    levels: &'a Levels<D>,
    disorder: f64,
    earlier: Option<&'a Cloud<D>>,
    corner: Vector<D>,
    counts: [i32; D],
}

impl<const D: usize> Filler<'_, D> {
    /// First cells of all blocks that meet the domain, along the curve.
    fn blocks(&self, low: [i32; D], size: i32, found: &mut Vec<[i32; D]>) {
        if (0..D).any(|k| low[k] >= self.counts[k]) {
            return;
        }
        if size == BLOCK {
            found.push(low);
            return;
        }
        for child in children(low, size / 2) {
            self.blocks(child, size / 2, found);
        }
    }

    /// The points of the lattice cells from `low`, `size` along each axis.
    fn fill(&self, low: [i32; D], size: i32, places: &mut Vec<Place<D>>) {
        if (0..D).any(|k| low[k] >= self.counts[k]) {
            return;
        }
        let dx = self.plot.spacing;
        if size == 1 {
            self.fill_cell(
                Site {
                    level: 0,
                    index: low,
                },
                places,
            );
            return;
        }
        let half = 0.5 * f64::from(size) * dx;
        let middle = Vector::from_fn(|k, _| self.corner[k] + f64::from(low[k]) * dx + half);
        let distance = self.plot.solids.distance(&middle);
        let radius = half * (D as f64).sqrt();
        if distance < -radius - dx {
            return;
        }
        let clear = distance - radius;
        if clear > FAR * dx {
            self.fill_clear(low, size, clear, places);
            return;
        }
        for child in children(low, size / 2) {
            self.fill(child, size / 2, places);
        }
    }

    /// The same where no wall is nearer than `clear`.
    fn fill_clear(&self, low: [i32; D], size: i32, clear: f64, places: &mut Vec<Place<D>>) {
        if (0..D).any(|k| low[k] >= self.counts[k]) {
            return;
        }
        if size > 1 {
            for child in children(low, size / 2) {
                self.fill_clear(child, size / 2, clear, places);
            }
            return;
        }
        self.leaf(
            Site {
                level: 0,
                index: low,
            },
            Some(clear),
            places,
        );
    }

    fn fill_cell(&self, site: Site<D>, places: &mut Vec<Place<D>>) {
        self.leaf(site, None, places);
    }

    /// The point of a cell, or those of the cells it is split into.
    fn leaf(&self, site: Site<D>, clear: Option<f64>, places: &mut Vec<Place<D>>) {
        if self.levels.is_split(&site) {
            for index in children(site.index.map(|i| 2 * i), 1) {
                self.leaf(
                    Site {
                        level: site.level + 1,
                        index,
                    },
                    clear,
                    places,
                );
            }
            return;
        }
        if let Some(earlier) = self.earlier
            && let Some(known) = earlier.at(&site)
            && !earlier.places[known].is_moved
        {
            places.push(earlier.places[known]);
            return;
        }
        let spacing = self.plot.spacing / f64::from(1 << site.level);
        let mut position =
            Vector::from_fn(|k, _| self.corner[k] + (f64::from(site.index[k]) + 0.5) * spacing);
        if self.plot.is_over_the_end(&position, spacing) {
            return;
        }
        let mut is_moved = false;
        if self.disorder > 0.0 {
            let index = site
                .index
                .map(|i| i64::from(i) + (i64::from(site.level) << 40));
            position += displacement(&index) * (self.disorder * spacing);
            is_moved = true;
        }
        let distance = match clear {
            Some(clear) => clear,
            None => match off_the_walls(self.plot, position, spacing) {
                Some((there, distance, moved)) => {
                    position = there;
                    is_moved |= moved;
                    distance
                }
                None => return,
            },
        };
        places.push(Place {
            position,
            spacing,
            distance,
            site: Some(site),
            is_moved,
        });
    }
}
