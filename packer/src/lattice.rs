//! The regular lattice of the undisturbed fluid: which particles sit on it, and which of its sites
//! stay when a body is packed into it.

use std::collections::HashSet;

use aero_geometry::Vector;

use crate::cloud::{Cloud, Lock};
use crate::grid::Grid;
use crate::mirror::Mirrors;
use crate::plan::{Plan, Side};

/// A particle this near to a lattice site, in spacings, sits on it.
const ON_SITE: f64 = 1e-9;

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

/// Freezes the particles that continue the lattice without a flaw: they sit on sites, as do all
/// their neighbours, so a gas at rest beside them feels no more than round-off.
pub(crate) fn freeze_lattice<const D: usize>(
    plan: &Plan<'_, D>,
    cloud: &mut Cloud<D>,
    fixed: &[(Vector<D>, f64)],
) {
    let grid = Grid {
        origin: plan.options.anchor,
        step: plan.options.spacing,
    };
    let mut occupied: HashSet<[i64; D]> = HashSet::new();
    let own: Vec<Option<[i64; D]>> = cloud.position.iter().map(|p| site(&grid, p)).collect();
    occupied.extend(own.iter().flatten());
    let reach = 3.0 * grid.step;
    let add = |occupied: &mut HashSet<[i64; D]>, point: &Vector<D>| {
        occupied.extend(site(&grid, point));
        plan.mirrors.images_within(point, reach, |_, image| {
            occupied.extend(site(&grid, &image));
        });
    };
    for point in cloud.position.iter().chain(fixed.iter().map(|(p, _)| p)) {
        add(&mut occupied, point);
    }
    for (n, place) in own.iter().enumerate() {
        let Some(place) = place else { continue };
        let whole = neighbours(*place)
            .all(|other| occupied.contains(&other) || !required(plan, &grid.centre(&other)));
        if whole {
            cloud.lock[n] = Lock::Frozen;
            cloud.position[n] = grid.centre(place);
        }
    }
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

/// Sites that touch a site, itself included.
fn neighbours<const D: usize>(place: [i64; D]) -> impl Iterator<Item = [i64; D]> {
    (0..3_usize.pow(D as u32)).map(move |code| {
        std::array::from_fn(|k| place[k] + (code / 3_usize.pow(k as u32) % 3) as i64 - 1)
    })
}

/// True where a flawless lattice has a particle: inside the layers, or anywhere for the fluid, whose
/// other side is packed already.
fn required<const D: usize>(plan: &Plan<'_, D>, point: &Vector<D>) -> bool {
    if !plan.inside(point) {
        return false;
    }
    if plan.side == Side::Fluid {
        return true;
    }
    let depth = -plan.shape.signed_distance(point);
    depth > 0.0 && depth < plan.layers as f64 * plan.options.spacing
}
