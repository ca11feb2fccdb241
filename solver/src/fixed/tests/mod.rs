//! Cells around all kinds of bodies: closed, as large as the gas, with walls as large as the bodies'.

use std::sync::Arc;

use aero_geometry::{Bounds, Shape, Vector};

use super::build::built;
use super::cells::{Cells, WallOwner};
use super::cloud::Cloud;
use super::levels::Levels;
use super::plot::Plot;
use super::solids::Solids;
use crate::problem::{Domain, Side};

mod adapting;
mod apart;
mod apexes;
mod bends;
mod brinks;
mod concave_bends;
mod crests;
mod far_away;
pub(super) mod flows;
mod jumps;
pub(crate) mod lattice;
mod outlets;
mod parted;
mod passing;
mod plane;
mod pockets;
pub(super) mod ridges;
mod room;
mod sheared;
mod sides;
mod sleep;
mod slow_streams;
mod space;
mod tips;
mod tubes;
mod vectors;
mod viscous;
mod wakes;
mod waves;

/// A box with open sides.
fn domain<const D: usize>(low: [f64; D], high: [f64; D]) -> Domain<D> {
    Domain {
        bounds: Bounds::new(Vector::from(low), Vector::from(high)),
        sides: [[Side::FreeStream; 2]; D],
        openings: Vec::new(),
    }
}

/// Cells of a scene and what they were made from.
struct Made<const D: usize> {
    cells: Cells<D>,
    cloud: Cloud<D>,
}

struct Scene<const D: usize> {
    domain: Domain<D>,
    solids: Solids<D>,
    spacing: f64,
    disorder: f64,
    /// How far the lattice begins off the corner of the domain, in spacings.
    off: f64,
}

impl<const D: usize> Scene<D> {
    fn new(domain: Domain<D>, bodies: Vec<Arc<dyn Shape<D>>>, spacing: f64) -> Self {
        Self {
            domain,
            solids: Solids::new(bodies, spacing),
            spacing,
            disorder: 0.0,
            off: 0.0,
        }
    }

    fn disordered(mut self, disorder: f64) -> Self {
        self.disorder = disorder;
        self
    }

    fn plot(&self) -> Plot<'_, D> {
        Plot {
            domain: &self.domain,
            solids: &self.solids,
            spacing: self.spacing,
            corner: self.domain.bounds.min.add_scalar(self.off * self.spacing),
        }
    }

    fn made(&self) -> Made<D> {
        self.made_with(&Levels::default())
    }

    fn made_with(&self, levels: &Levels<D>) -> Made<D> {
        let plot = self.plot();
        let cloud = Cloud::lattice(&plot, levels, self.disorder);
        let cells = built(&plot, &cloud).cells;
        Made { cells, cloud }
    }
}

impl<const D: usize> Made<D> {
    /// Largest open area, in the spacing of the cell to its power.
    fn open(&self, about_axis: bool) -> f64 {
        let sums = self.cells.open_areas(about_axis);
        let pairs = sums.iter().zip(&self.cloud.places);
        pairs.fold(0.0, |most: f64, (sum, place)| {
            most.max(sum.norm() / place.spacing.powi(D as i32 - 1))
        })
    }

    fn volume(&self) -> f64 {
        self.cells.volumes.iter().sum()
    }

    /// Sum of the areas of body walls, and the same of `A . n` with the body's own normal.
    fn wall_area(&self, solids: &Solids<D>) -> [f64; 2] {
        let mut sums = [0.0; 2];
        for wall in &self.cells.walls {
            if let WallOwner::Body(body) = wall.owner {
                let closest = solids.shape(body).closest(&wall.foot);
                sums[0] += wall.area.norm();
                sums[1] -= wall.area.dot(&closest.normal);
            }
        }
        sums
    }
}
