//! Which lattice cells are split, and how often: a tree of cells, next to each of which none is split twice more.

use std::collections::HashSet;

use super::cloud::{Site, children, steps};

/// The cells that are split.
#[derive(Clone, Debug, Default)]
pub struct Levels<const D: usize> {
    split: HashSet<Site<D>>,
}

impl<const D: usize> Levels<D> {
    /// True where a cell is split in 2, 4 or 8.
    pub fn is_split(&self, site: &Site<D>) -> bool {
        !self.split.is_empty() && self.split.contains(site)
    }

    /// True where no cell is.
    pub fn is_empty(&self) -> bool {
        self.split.is_empty()
    }

    /// Splits a cell, and before it those around it that are larger: neighbours differ by one level at most.
    pub fn split(&mut self, site: &Site<D>) {
        if self.split.contains(site) {
            return;
        }
        if site.level > 0 {
            for step in steps::<D>() {
                let beside = Site {
                    level: site.level,
                    index: std::array::from_fn(|k| site.index[k] + step[k]),
                };
                self.split(&parent(&beside));
            }
        }
        self.split.insert(*site);
    }

    /// Takes a split back, if none of its parts is split and no neighbour needs it; says whether it was.
    pub fn join(&mut self, site: &Site<D>) -> bool {
        if !self.split.contains(site) || parts(site).any(|part| self.split.contains(&part)) {
            return false;
        }
        // A split cell of the parts' level beside this one would be twice finer than what is left.
        let beside = parts(site).any(|part| {
            steps::<D>().any(|step| {
                let index = std::array::from_fn(|k| part.index[k] + step[k]);
                self.split.contains(&Site { index, ..part })
            })
        });
        !beside && self.split.remove(site)
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
pub fn parts<const D: usize>(site: &Site<D>) -> impl Iterator<Item = Site<D>> {
    let level = site.level + 1;
    children(site.index.map(|i| 2 * i), 1).map(move |index| Site { level, index })
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
        assert!(levels.join(&site));
        assert!(levels.join(&Site {
            level: 1,
            index: [7, 7]
        }));
    }
}
