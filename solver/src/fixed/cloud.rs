//! The points: a lattice with its cells split where asked, moved off the walls, or points supplied by hand.
//!
//! Points stand in the order of a Morton curve, so that runs of them are compact (Morton 1966).

use std::collections::{HashMap, HashSet};

use aero_geometry::Vector;
use foldhash::fast::FixedState;
use rayon::prelude::*;

use super::levels::Levels;
use super::solids::Solids;
use crate::lattice::displacement;
use crate::problem::Domain;

/// Least distance from walls in spacings: points nearer than that are moved there.
pub const LEAST_DISTANCE: f64 = 0.3;

/// Lattice cells along the edge of a block that is filled at one go.
const BLOCK: i32 = 16;

/// Distance from walls in spacings beyond which nothing there matters.
const FAR: f64 = 3.0;

/// No point.
pub const NOBODY: u32 = u32::MAX;

/// Place of a point on the lattice: level of splitting and index on the lattice of that level.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Site<const D: usize> {
    /// How often its cell was split.
    pub level: u8,
    /// Index on the lattice of its level.
    pub index: [i32; D],
}

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

/// What a cloud is made for.
#[derive(Clone, Copy, Debug)]
pub struct Plot<'a, const D: usize> {
    /// Box of the flow.
    pub domain: &'a Domain<D>,
    /// Bodies in it.
    pub solids: &'a Solids<D>,
    /// Spacing of the lattice.
    pub spacing: f64,
}

impl<const D: usize> Plot<'_, D> {
    /// Lattice cells along each axis.
    pub fn counts(&self) -> [i32; D] {
        let size = self.domain.bounds.size();
        std::array::from_fn(|k| ((size[k] / self.spacing).round() as i32).max(1))
    }
}

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
        let filler = Filler {
            plot,
            levels,
            disorder,
            earlier,
            corner: cloud.corner,
            counts: cloud.counts,
        };
        let mut size = BLOCK;
        while size < cloud.counts.iter().copied().max().unwrap_or(1) {
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
        cloud.places = places.concat();
        cloud.number();
        cloud
    }

    /// Points supplied by hand, each with the spacing around it; those in bodies or outside of the domain are left out.
    pub fn of_points(plot: &Plot<'_, D>, points: &[(Vector<D>, f64)]) -> Self {
        let mut cloud = Self::empty(plot);
        cloud.places = points
            .par_iter()
            .filter_map(|&(position, spacing)| loose(plot, position, spacing))
            .collect();
        cloud.sort();
        cloud.number();
        cloud
    }

    /// The same cloud with `points` in place of all lattice points for which `keep` does not hold.
    #[must_use]
    pub fn with_points(
        mut self,
        plot: &Plot<'_, D>,
        points: &[Vector<D>],
        keep: impl Fn(&Place<D>) -> bool,
    ) -> Self {
        self.places.retain(keep);
        let spacing = plot.spacing;
        self.places
            .extend(points.iter().filter_map(|&p| loose(plot, p, spacing)));
        self.sort();
        self.number();
        self
    }

    fn empty(plot: &Plot<'_, D>) -> Self {
        Self {
            spacing: plot.spacing,
            counts: plot.counts(),
            corner: plot.domain.bounds.min,
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

    fn number(&mut self) {
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

    /// Sorts the points along a Morton curve.
    fn sort(&mut self) {
        let fine = self
            .places
            .iter()
            .fold(self.spacing, |least, place| least.min(place.spacing));
        let bits = 63 / D as u32;
        let key = |place: &Place<D>| {
            let cell: [u64; D] = std::array::from_fn(|k| {
                ((place.position[k] - self.corner[k]) / fine).max(0.0) as u64
            });
            let mut code = 0_u64;
            for bit in (0..bits).rev() {
                for axis in cell {
                    code = code << 1 | axis >> bit & 1;
                }
            }
            code
        };
        self.places.par_sort_by_cached_key(key);
    }
}

/// All steps from a lattice cell to itself and to those around it.
pub fn steps<const D: usize>() -> impl Iterator<Item = [i32; D]> {
    (0..3_i32.pow(D as u32)).map(|code| std::array::from_fn(|k| code / 3_i32.pow(k as u32) % 3 - 1))
}

/// A point on no lattice, off the walls.
fn loose<const D: usize>(
    plot: &Plot<'_, D>,
    position: Vector<D>,
    spacing: f64,
) -> Option<Place<D>> {
    if !plot.domain.bounds.contains(&position) {
        return None;
    }
    let (position, distance, _) = off_the_walls(plot, position, spacing)?;
    Some(Place {
        position,
        spacing,
        distance,
        site: None,
        is_moved: true,
    })
}

/// A point moved to the least distance from the walls: where it is then, how far from them, and whether it was moved. None
/// where it is in a body.
fn off_the_walls<const D: usize>(
    plot: &Plot<'_, D>,
    mut position: Vector<D>,
    spacing: f64,
) -> Option<(Vector<D>, f64, bool)> {
    const TRIES: usize = 4;
    let Some((_, mut closest)) = plot.solids.closest(&position) else {
        return Some((position, f64::INFINITY, false));
    };
    if closest.distance <= 1e-6 * spacing {
        return None;
    }
    let least = LEAST_DISTANCE * spacing;
    let mut is_moved = false;
    for _ in 0..TRIES {
        if closest.distance >= least * (1.0 - 1e-9) {
            break;
        }
        let moved = position + closest.normal * (least - closest.distance);
        // Between two walls, or next to a side, there may be no room.
        let Some((_, there)) = plot.solids.closest(&moved) else {
            break;
        };
        if there.distance <= closest.distance || !plot.domain.bounds.contains(&moved) {
            break;
        }
        (position, closest, is_moved) = (moved, there, true);
    }
    Some((position, closest.distance, is_moved))
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
        {
            places.push(earlier.places[known]);
            return;
        }
        let spacing = self.plot.spacing / f64::from(1 << site.level);
        let mut position =
            Vector::from_fn(|k, _| self.corner[k] + (f64::from(site.index[k]) + 0.5) * spacing);
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

/// First cells of the parts of a block, each `half` wide, along the curve.
pub fn children<const D: usize>(low: [i32; D], half: i32) -> impl Iterator<Item = [i32; D]> {
    (0..1_usize << D)
        .map(move |n| std::array::from_fn(|k| low[k] + half * (n >> (D - 1 - k) & 1) as i32))
}
