//! The regular lattice of the undisturbed fluid: its cells and sites.

use aero_geometry::Vector;

use crate::grid::Grid;
use crate::mirror::Mirrors;

/// A particle this near to a lattice site, in spacings, sits on it.
pub(crate) const ON_SITE: f64 = 1e-9;

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

/// The cell in which a point lies.
pub(crate) fn cell_of<const D: usize>(grid: &Grid<D>, point: &Vector<D>) -> [i64; D] {
    std::array::from_fn(|k| ((point[k] - grid.origin[k]) / grid.step + ON_SITE).floor() as i64)
}

/// Corners of a cell, by number.
pub(crate) fn corners<const D: usize>(cell: [i64; D]) -> impl Iterator<Item = [i64; D]> {
    (0..1_usize << D).map(move |n| std::array::from_fn(|k| cell[k] + (n >> k & 1) as i64))
}

/// The lattice site at a point.
pub(crate) fn site<const D: usize>(grid: &Grid<D>, point: &Vector<D>) -> Option<[i64; D]> {
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
