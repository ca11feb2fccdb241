//! What points are made for, and how far from walls they stand.

use aero_geometry::Vector;

use super::solids::Solids;
use crate::problem::{Domain, Problem, Side};
use crate::sides::parted;

/// Least distance from walls in spacings: points nearer than that are moved there.
pub const LEAST_DISTANCE: f64 = 0.3;

/// Least distance of points from the sides, in spacings.
const LEAST_TO_SIDE: f64 = 0.25;

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
    /// Lattice cells along each axis, as many as it takes to cover the domain: the last ones may have no points of their own, but have them once
    /// they are split.
    pub fn counts(&self) -> [i32; D] {
        /// Cells are told from none by this part of one.
        const EXACT: f64 = 1e-6;
        let size = self.domain.bounds.max - self.corner;
        std::array::from_fn(|k| {
            let cells = size[k] / self.spacing;
            let whole = if self.domain.sides[k][0] == Side::Periodic {
                cells.round()
            } else {
                (cells - EXACT).ceil()
            };
            (whole as i32).max(1)
        })
    }

    /// True of a point beyond a side that is not a side of lattice cells, or close before it: its neighbour's cell ends at the side then.
    pub fn is_over_the_end(&self, position: &Vector<D>, spacing: f64) -> bool {
        let domain = self.domain;
        (0..D).any(|k| {
            let least = LEAST_TO_SIDE * spacing;
            let within = domain.bounds.min[k] + least..=domain.bounds.max[k] - least;
            domain.sides[k][1] != Side::Periodic && !within.contains(&position[k])
        })
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

/// First corner of the lattice: that of the domain, moved by up to half a spacing across the stream where faces of cells come to lie so in the
/// plane at which a body parts it. Cells that lie one way above a sharp nose and another way below would give a symmetric body
/// lift, a third of a slender aerofoil's drag.
pub fn corner<const D: usize>(problem: &Problem<D>) -> Vector<D> {
    /// Planes are told to this many spacings.
    const EXACT: f64 = 1e-6;
    let (spacing, domain) = (problem.resolution.lattice(), &problem.domain);
    let velocity = &problem.free_stream.velocity;
    let is_along = |axis: usize| velocity[axis] != 0.0 && axis == velocity.iamax();
    let may_split = problem
        .method
        .fixed()
        .is_some_and(|points| points.refine.levels() > 0);
    let mut corner = domain.bounds.min;
    for axis in (0..D).filter(|&axis| !is_along(axis)) {
        let Some(plane) = parted(problem, axis) else {
            continue;
        };
        let off = (plane - corner[axis]) / spacing;
        let off = off - off.round();
        if off > EXACT && may_split {
            // Cells that are split end at the sides, too, if the lattice covers all of the domain.
            corner[axis] += (off - 1.0) * spacing;
        } else if off.abs() > EXACT {
            corner[axis] += off * spacing;
        }
    }
    corner
}
