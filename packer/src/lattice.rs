//! The regular lattice of the undisturbed fluid: which particles sit on it, and which of its sites
//! stay when a body is packed into it.

use std::collections::{HashMap, HashSet};

use aero_geometry::Vector;
use rayon::prelude::*;

use crate::Ghosts;
use crate::cloud::{Cloud, Lock};
use crate::grid::{Cell, Grid};
use crate::mirror::Mirrors;
use crate::plan::Plan;

/// A particle this near to a lattice site, in spacings, sits on it.
const ON_SITE: f64 = 1e-9;

/// Steps along each axis in which a flaw of the lattice near the surface counts.
const FLAWLESS_REACH: i64 = 3;

/// The planes of `mirrors` about which the lattice is symmetric too: those through sites or half
/// way between them.
pub(crate) fn lattice_planes<const D: usize>(
    mirrors: &Mirrors,
    anchor: &Vector<D>,
    spacing: f64,
) -> Mirrors {
    mirrors.only(|axis, position| {
        let half_steps = 2.0 * (position - anchor[axis]) / spacing;
        (half_steps - half_steps.round()).abs() < 1e-6
    })
}

/// The lattice as a grid whose cells' centres are the sites, shifted by less than half a spacing
/// where a mirror plane does not fit it.
pub(crate) fn lattice_grid<const D: usize>(
    mirrors: &Mirrors,
    anchor: &Vector<D>,
    spacing: f64,
) -> Grid<D> {
    let mut origin = *anchor;
    for &(axis, position) in mirrors.planes() {
        let half_steps = 2.0 * (position - anchor[axis]) / spacing;
        let through_site = (half_steps - half_steps.round()).abs() < 1e-6
            && half_steps.round().rem_euclid(2.0) == 1.0;
        origin[axis] = position - if through_site { 0.5 * spacing } else { 0.0 };
    }
    Grid {
        origin,
        step: spacing,
    }
}

/// Freezes the ghosts that continue the lattice without a flaw: they sit on sites, as do all their
/// neighbours, so a gas at rest beside them feels no more than round-off.
pub(crate) fn freeze_on_lattice<const D: usize>(plan: &Plan<'_, D>, cloud: &mut Cloud<D>) {
    let grid = Grid {
        origin: plan.options.anchor,
        step: plan.options.spacing,
    };
    let mut occupied: HashSet<[i64; D]> = HashSet::new();
    for point in &cloud.position {
        occupied.extend(site(&grid, point));
        plan.mirrors
            .images_within(point, 3.0 * grid.step, |_, image| {
                occupied.extend(site(&grid, &image));
            });
    }
    for n in 0..cloud.len() {
        let Some(place) = site(&grid, &cloud.position[n]) else {
            continue;
        };
        if cloud.lock[n] == Lock::Row {
            continue;
        }
        let whole = around(place, 1)
            .all(|other| occupied.contains(&other) || !required(plan, &grid.centre(&other)));
        if whole {
            cloud.lock[n] = Lock::Frozen;
            cloud.position[n] = grid.centre(&place);
        }
    }
}

/// The surface as the lattice sees it: where body and ghosts fill whole cells, the lattice continues
/// through the surface without a flaw, and fluid needs no packing.
pub(crate) struct Flawless<const D: usize> {
    grid: Grid<D>,
    /// Sites next to the surface around which nothing is amiss.
    near: HashSet<[i64; D]>,
}

impl<const D: usize> Flawless<D> {
    /// Looks at the lattice around every site of `sites` within a spacing of the surface.
    pub fn new(plan: &Plan<'_, D>, grid: Grid<D>, sites: &[Cell<D>], ghosts: &Ghosts<D>) -> Self {
        let step = grid.step;
        let occupied: HashSet<[i64; D]> = ghosts
            .position
            .iter()
            .filter_map(|p| site(&grid, p))
            .collect();
        let outside: HashMap<[i64; D], f64> = sites
            .iter()
            .filter(|cell| cell.distance > 0.0)
            .map(|cell| (cell.index, cell.distance))
            .collect();
        let whole = |cell: &[i64; D], distance: f64| {
            distance > step
                || corners(*cell)
                    .all(|c| plan.shape.signed_distance(&grid.corner(&c)) > -ON_SITE * step)
        };
        let fine = |place: &[i64; D]| {
            let centre = plan.mirrors.folded(grid.centre(place));
            let home = cell_of(&grid, &centre);
            if occupied.contains(place) || !plan.inside(&centre) {
                return true;
            }
            match outside.get(&home) {
                Some(&distance) => whole(&home, distance),
                None => plan.shape.signed_distance(&centre) < -(plan.options.layers as f64) * step,
            }
        };
        let near: Vec<&Cell<D>> = sites
            .iter()
            .filter(|cell| cell.distance > 0.0 && cell.distance < step)
            .collect();
        let near = near
            .par_iter()
            .filter(|cell| whole(&cell.index, cell.distance))
            .filter(|cell| around(cell.index, FLAWLESS_REACH).all(|place| fine(&place)))
            .map(|cell| cell.index)
            .collect();
        Self { grid, near }
    }

    /// True where the lattice continues into the surface below `cell`.
    pub fn at(&self, cell: &Cell<D>) -> bool {
        let above_foot = (0.5 * self.grid.step - cell.distance) * cell.normal;
        self.near.contains(&cell_of(
            &self.grid,
            &(self.grid.centre(&cell.index) + above_foot),
        ))
    }

    /// Cell of the lattice in which a point lies.
    pub fn home(&self, point: &Vector<D>) -> [i64; D] {
        cell_of(&self.grid, point)
    }
}

fn cell_of<const D: usize>(grid: &Grid<D>, point: &Vector<D>) -> [i64; D] {
    std::array::from_fn(|k| ((point[k] - grid.origin[k]) / grid.step + ON_SITE).floor() as i64)
}

/// Corners of a cell, by number.
fn corners<const D: usize>(cell: [i64; D]) -> impl Iterator<Item = [i64; D]> {
    (0..1_usize << D).map(move |n| std::array::from_fn(|k| cell[k] + (n >> k & 1) as i64))
}

/// The lattice site at a point.
fn site<const D: usize>(grid: &Grid<D>, point: &Vector<D>) -> Option<[i64; D]> {
    let mut place = [0; D];
    for k in 0..D {
        let exact = (point[k] - grid.origin[k]) / grid.step - 0.5;
        if (exact - exact.round()).abs() > ON_SITE {
            return None;
        }
        place[k] = exact.round() as i64;
    }
    Some(place)
}

/// Sites up to `reach` steps away along each axis, the site itself included.
pub(crate) fn around<const D: usize>(
    place: [i64; D],
    reach: i64,
) -> impl Iterator<Item = [i64; D]> {
    let wide = 2 * reach + 1;
    (0..wide.pow(D as u32)).map(move |code| {
        std::array::from_fn(|k| place[k] + code / wide.pow(k as u32) % wide - reach)
    })
}

/// True where a flawless lattice has a ghost: inside the layers.
fn required<const D: usize>(plan: &Plan<'_, D>, point: &Vector<D>) -> bool {
    let depth = -plan.shape.signed_distance(point);
    plan.inside(point) && depth > 0.0 && depth < plan.layers as f64 * plan.options.spacing
}
