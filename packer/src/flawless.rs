//! Where a packed body continues the lattice of the undisturbed fluid: which ghosts sit on it, and which of its sites stay when a
//! body is packed into it.

use std::collections::{HashMap, HashSet};

use aero_geometry::Vector;
use aero_geometry::parallel::prelude::*;

use crate::Ghosts;
use crate::cloud::{Cloud, Lock};
use crate::grid::{Cell, Grid};
use crate::lattice::{ON_SITE, around, cell_of, corners, site};
use crate::plan::Plan;

/// Steps along each axis in which a flaw of the lattice near the surface counts.
const FLAWLESS_REACH: i64 = 3;

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

/// True where a flawless lattice has a ghost: inside the layers.
fn required<const D: usize>(plan: &Plan<'_, D>, point: &Vector<D>) -> bool {
    let depth = -plan.shape.signed_distance(point);
    plan.inside(point) && depth > 0.0 && depth < plan.layers as f64 * plan.options.spacing
}
