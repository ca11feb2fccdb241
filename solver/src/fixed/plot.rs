//! What points are made for, and how far from walls they stand.

use aero_geometry::Vector;

use super::solids::Solids;
use crate::problem::Domain;

/// Least distance from walls in spacings: points nearer than that are moved there.
pub const LEAST_DISTANCE: f64 = 0.3;

/// What a cloud is made for.
#[derive(Clone, Copy, Debug)]
pub struct Plot<'a, const D: usize> {
    /// Box of the flow.
    pub domain: &'a Domain<D>,
    /// Bodies in it.
    pub solids: &'a Solids<D>,
    /// Spacing of the lattice.
    pub spacing: f64,
    /// First corner of the lattice, less than a spacing from that of the domain: the first and the last cells end at the sides.
    pub corner: Vector<D>,
}

impl<const D: usize> Plot<'_, D> {
    /// Lattice cells along each axis.
    pub fn counts(&self) -> [i32; D] {
        let size = self.domain.bounds.max - self.corner;
        std::array::from_fn(|k| ((size[k] / self.spacing).round() as i32).max(1))
    }
}

/// A point moved to the least distance from the walls: where it is then, how far from them, and whether it was moved. None
/// where it is in a body.
pub fn off_the_walls<const D: usize>(
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
