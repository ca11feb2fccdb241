//! The points: a lattice with its cells split where asked, moved off the walls.
//!
//! Points stand in the order of a Morton curve, so that runs of them are compact (Morton 1966).

use std::collections::{HashMap, HashSet};

use aero_geometry::Vector;
use aero_geometry::parallel::prelude::*;
use foldhash::fast::FixedState;

use super::plot::Plot;
use super::site::{Site, steps};

/// No point.
pub const NOBODY: u32 = u32::MAX;

/// One point.
#[derive(Clone, Copy, Debug)]
pub struct Place<const D: usize> {
    /// Where it is.
    pub position: Vector<D>,
    /// Spacing of the points here.
    pub spacing: f64,
    /// Distance from the nearest wall, or a lower bound where that is far.
    pub distance: f64,
    /// Where its lattice cell is.
    pub site: Option<Site<D>>,
    /// True where it is not in the middle of that cell.
    pub is_moved: bool,
}

/// The points of a scene.
#[derive(Clone, Debug)]
pub struct Cloud<const D: usize> {
    /// Spacing of the lattice that is not split.
    pub spacing: f64,
    /// Lattice cells along each axis.
    pub counts: [i32; D],
    /// First corner of the lattice.
    pub corner: Vector<D>,
    /// The points.
    pub places: Vec<Place<D>>,
    /// Points of the lattice that is not split, by cell, the last axis fastest.
    coarse: Vec<u32>,
    /// Points of the finer ones.
    fine: HashMap<Site<D>, u32, FixedState>,
    /// Lattice cells next to points that are on no lattice.
    loose: HashSet<[i32; D]>,
}

impl<const D: usize> Cloud<D> {
    pub(super) fn empty(plot: &Plot<'_, D>) -> Self {
        Self {
            spacing: plot.spacing,
            counts: plot.counts(),
            corner: plot.corner,
            places: Vec::new(),
            coarse: Vec::new(),
            fine: HashMap::default(),
            loose: HashSet::new(),
        }
    }

    /// Positions of the points.
    pub fn positions(&self) -> Vec<Vector<D>> {
        self.places.par_iter().map(|place| place.position).collect()
    }

    /// The point of a lattice cell that is not split further.
    pub fn at(&self, site: &Site<D>) -> Option<usize> {
        let found = if site.level == 0 {
            *self.coarse.get(self.cell_number(&site.index)?)?
        } else {
            *self.fine.get(site)?
        };
        (found != NOBODY).then_some(found as usize)
    }

    /// True where a point on no lattice is in the cell of the coarsest lattice that holds this site, or next to it.
    pub fn is_near_loose(&self, site: &Site<D>) -> bool {
        !self.loose.is_empty() && self.loose.contains(&site.index.map(|i| i >> site.level))
    }

    fn cell_number(&self, index: &[i32; D]) -> Option<usize> {
        let mut number = 0;
        for k in 0..D {
            if index[k] < 0 || index[k] >= self.counts[k] {
                return None;
            }
            number = number * self.counts[k] as usize + index[k] as usize;
        }
        Some(number)
    }

    pub(super) fn number(&mut self) {
        let total = self.counts.iter().map(|&n| n as usize).product();
        self.coarse = vec![NOBODY; total];
        self.fine.clear();
        self.loose.clear();
        for (number, place) in self.places.iter().enumerate() {
            match &place.site {
                Some(site) if site.level == 0 => {
                    if let Some(cell) = self.cell_number(&site.index) {
                        self.coarse[cell] = number as u32;
                    }
                }
                Some(site) => {
                    self.fine.insert(*site, number as u32);
                }
                None => {
                    let home: [i32; D] = std::array::from_fn(|k| {
                        ((place.position[k] - self.corner[k]) / self.spacing).floor() as i32
                    });
                    for step in steps::<D>() {
                        let cell = std::array::from_fn(|k| home[k] + step[k]);
                        self.loose.insert(cell);
                    }
                }
            }
        }
    }
}
