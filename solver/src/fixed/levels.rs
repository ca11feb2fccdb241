//! Which lattice cells are split, and how often: a tree of cells, next to each of which none is split twice more.

use std::collections::HashSet;

use foldhash::fast::FixedState;

use super::plot::Plot;
use super::site::{Site, children, steps};
use crate::problem::Side;

/// Sites, found quickly and in the same way in every run.
pub type Sites<const D: usize> = HashSet<Site<D>, FixedState>;

/// The cells that are split.
#[derive(Clone, Debug)]
pub struct Levels<const D: usize> {
    split: Sites<D>,
    /// Cells of the lattice along each axis; none where it has no ends.
    counts: Option<[i32; D]>,
    /// Axes along which the lattice begins anew where it ends.
    is_periodic: [bool; D],
}

impl<const D: usize> Default for Levels<D> {
    fn default() -> Self {
        Self {
            split: Sites::default(),
            counts: None,
            is_periodic: [false; D],
        }
    }
}

impl<const D: usize> Levels<D> {
    /// Nothing split yet on the lattice of `plot`.
    pub fn on(plot: &Plot<'_, D>) -> Self {
        let sides = &plot.domain.sides;
        Self {
            split: Sites::default(),
            counts: Some(plot.counts()),
            is_periodic: std::array::from_fn(|k| sides[k][0] == Side::Periodic),
        }
    }

    /// True where a cell is split in 2, 4 or 8.
    pub fn is_split(&self, site: &Site<D>) -> bool {
        !self.split.is_empty() && self.split.contains(site)
    }

    /// How many cells are split.
    pub fn len(&self) -> usize {
        self.split.len()
    }

    /// By how many cells all of their parts are more than what they were split from.
    pub fn added(&self) -> usize {
        ((1 << D) - 1) * self.split.len()
    }

    /// The site, or the one that a periodic lattice has in its place; none beyond the ends.
    pub fn inside(&self, site: &Site<D>) -> Option<Site<D>> {
        let Some(counts) = self.counts else {
            return Some(*site);
        };
        let mut inside = *site;
        for k in 0..D {
            let count = counts[k] << site.level;
            if self.is_periodic[k] {
                inside.index[k] = inside.index[k].rem_euclid(count);
            } else if !(0..count).contains(&inside.index[k]) {
                return None;
            }
        }
        Some(inside)
    }

    /// Splits a cell, and before it those around it that are larger: neighbours differ by one level at most. Cells beyond the ends of
    /// the lattice are none.
    pub fn split(&mut self, site: &Site<D>) {
        let Some(site) = self.inside(site) else {
            return;
        };
        if self.split.contains(&site) {
            return;
        }
        if site.level > 0 {
            for step in steps::<D>() {
                self.split(&parent(&beside(&site, &step)));
            }
        }
        self.split.insert(site);
    }

    /// Takes a split back, if none of its parts is split and no neighbour needs it; says whether it was.
    pub fn join(&mut self, site: &Site<D>) -> bool {
        if !self.split.contains(site) || parts(site).any(|part| self.split.contains(&part)) {
            return false;
        }
        // A split cell of the parts' level beside this one would be twice finer than what is left.
        let is_needed = parts(site).any(|part| {
            steps::<D>().any(|step| {
                let there = self.inside(&beside(&part, &step));
                there.is_some_and(|there| self.split.contains(&there))
            })
        });
        !is_needed && self.split.remove(site)
    }

    /// All that is split, as numbers: level and index of each, in order.
    pub fn numbers(&self) -> Vec<i32> {
        let mut sites: Vec<&Site<D>> = self.split.iter().collect();
        sites.sort_by_key(|site| (site.level, site.index));
        let each = sites.into_iter();
        each.flat_map(|site| [i32::from(site.level)].into_iter().chain(site.index))
            .collect()
    }

    /// The same lattice with what [`Self::numbers`] told split.
    #[must_use]
    pub fn with_numbers(mut self, numbers: &[i32]) -> Self {
        let sites = numbers.chunks_exact(D + 1).map(|numbers| Site {
            level: numbers[0] as u8,
            index: std::array::from_fn(|k| numbers[k + 1]),
        });
        self.split.extend(sites);
        self
    }
}

impl<const D: usize> PartialEq for Levels<D> {
    fn eq(&self, other: &Self) -> bool {
        self.split == other.split
    }
}

/// The cell of which `site` is a part.
pub fn parent<const D: usize>(site: &Site<D>) -> Site<D> {
    Site {
        level: site.level - 1,
        index: site.index.map(|i| i >> 1),
    }
}

/// The parts of a cell.
pub fn parts<const D: usize>(site: &Site<D>) -> impl Iterator<Item = Site<D>> + use<D> {
    let level = site.level + 1;
    children(site.index.map(|i| 2 * i), 1).map(move |index| Site { level, index })
}

fn beside<const D: usize>(site: &Site<D>, step: &[i32; D]) -> Site<D> {
    let mut there = *site;
    for k in 0..D {
        there.index[k] += step[k];
    }
    there
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn neighbours_differ_by_one_level() {
        let mut levels = Levels::<2>::default();
        let site = Site {
            level: 2,
            index: [16, 16],
        };
        levels.split(&site);
        assert!(levels.is_split(&Site {
            level: 1,
            index: [7, 7]
        }));
        assert!(levels.is_split(&Site {
            level: 0,
            index: [3, 4]
        }));
        assert!(!levels.join(&Site {
            level: 1,
            index: [7, 7]
        }));
        let known = Levels::default().with_numbers(&levels.numbers());
        assert_eq!(known, levels);
        assert!(levels.join(&site));
        assert!(levels.join(&Site {
            level: 1,
            index: [7, 7]
        }));
        assert_ne!(known, levels);
    }

    #[test]
    fn a_periodic_lattice_begins_where_it_ends_and_others_do_not() {
        let mut levels = Levels::<2> {
            counts: Some([4, 4]),
            is_periodic: [true, false],
            ..Levels::default()
        };
        levels.split(&Site {
            level: 1,
            index: [0, 0],
        });
        let at = |index| Site { level: 0, index };
        assert!(levels.is_split(&at([3, 0])) && levels.is_split(&at([0, 0])));
        assert!(!levels.is_split(&at([-1, 0])) && !levels.is_split(&at([0, -1])));
        // One cell beyond the seam needs it.
        assert!(!levels.join(&at([3, 0])));
    }
}
