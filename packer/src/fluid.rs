//! The fluid side: conforming layers outside the body and a shell that leads over into the lattice.

use std::collections::HashSet;

use aero_geometry::kernel::{SMOOTHING_RATIO, SUPPORT};
use aero_geometry::{Shape, Vector};

use crate::cloud::{Cloud, Lock};
use crate::flawless::Flawless;
use crate::grid::Cell;
use crate::lattice::{lattice_grid, lattice_planes};
use crate::mirror::Mirrors;
use crate::plan::Plan;
use crate::relax::{relax, relax_thin};
use crate::room::Side;
use crate::schedule::{fluid_steps, thin_steps};
use crate::seeds::seed;
use crate::sources::Sources;
use crate::thin::fill_thin;
use crate::{Ghosts, PackError, PackOptions};

/// Thickness of the shell between conforming layers and lattice, in spacings. Not a whole or half
/// number, so that no site of a lattice along the wall is at its edge.
const BLEND: f64 = 4.25;

/// The packed fluid.
pub(crate) struct Fluid<'a, const D: usize> {
    /// Frame in which it was packed.
    pub plan: Plan<'a, D>,
    /// Conforming layers and the shell around them.
    pub cloud: Cloud<D>,
    /// The lattice sites next to the shell.
    pub lattice: Vec<Vector<D>>,
}

/// Signed distance up to which packed fluid replaces the lattice.
pub(crate) fn lattice_begins<const D: usize>(options: &PackOptions<D>) -> f64 {
    (options.fluid_layers as f64 + BLEND) * options.spacing
}

/// Packs the fluid around a body whose ghosts lie fixed.
pub(crate) fn pack_fluid<'a, const D: usize>(
    shape: &'a dyn Shape<D>,
    options: &'a PackOptions<D>,
    ghosts: &Ghosts<D>,
) -> Result<Fluid<'a, D>, PackError> {
    let spacing = options.spacing;
    let mirrors = lattice_planes(&Mirrors::of(shape), &options.anchor, spacing);
    let support = SUPPORT * SMOOTHING_RATIO * spacing;
    let begins = lattice_begins(options);
    let margin = (begins + support) / spacing + 1.0;
    let plan = Plan::new(shape, options, &mirrors, Side::Fluid, margin)?;
    let (mut cloud, left) = seed(&plan);

    let grid = lattice_grid(&plan.mirrors, &options.anchor, spacing);
    let (sites, _) = grid.band(shape, &plan.bounds, (0.0, begins + support), spacing)?;
    let flawless = Flawless::new(&plan, grid, &sites, ghosts);
    let place = |cell: &Cell<D>| {
        plan.mirrors
            .snapped(grid.centre(&cell.index), 1e-6 * spacing)
    };
    let lattice: Vec<Vector<D>> = sites
        .iter()
        .filter(|cell| cell.distance > begins)
        .map(place)
        .collect();
    let near: Vec<&Cell<D>> = sites
        .iter()
        .filter(|cell| cell.distance > 0.0 && cell.distance <= begins)
        .collect();
    let (kept, shell): (Vec<&Cell<D>>, Vec<&Cell<D>>) =
        near.into_iter().partition(|cell| flawless.at(cell));
    let kept_homes: HashSet<[i64; D]> = kept.iter().map(|cell| cell.index).collect();
    cloud.retain(|point| !kept_homes.contains(&flawless.home(point)));

    // The shell takes the sites beyond the layers, and of those cut by the layers' end the part
    // that its volume holds, spread evenly: rounding is handed on to the next cell.
    let end = options.fluid_layers as f64 * spacing;
    let volume = plan.particle_volume();
    let thin = plan.has_thin_cells();
    let mut carry = if thin { 0.0 } else { left / volume };
    for cell in shell {
        let site = place(cell);
        let share = plan.mirrors.share(&site);
        carry += share * (1.0 - cell.fraction_below(end));
        if carry >= 0.5 * share {
            carry -= share;
            cloud.push(site, options.fluid_layers as u32, Lock::Free, volume);
        }
    }
    for cell in kept {
        let layer = (cell.distance / spacing)
            .floor()
            .min(options.fluid_layers as f64);
        cloud.push(place(cell), layer as u32, Lock::Frozen, volume);
    }

    let mut fixed: Vec<(Vector<D>, f64)> = lattice.iter().map(|&point| (point, volume)).collect();
    let ghost = ghosts
        .position
        .iter()
        .copied()
        .zip(ghosts.volume.iter().copied());
    fixed.extend(ghost.filter(|(point, _)| plan.mirrors.above(point)));
    if thin {
        let placed = cloud.particles().chain(fixed.iter().copied());
        let placed = Sources::new(&plan.mirrors, placed, support);
        fill_thin(&plan, &mut cloud, left, &placed, |points, _| {
            vec![1.0; points.len()]
        });
    }
    for n in 0..cloud.len() {
        let near_region = options
            .region
            .is_none_or(|region| region.grown(spacing).contains(&cloud.position[n]));
        if !near_region {
            cloud.lock[n] = Lock::Frozen;
        } else if cloud.layer[n] > 0 && matches!(cloud.lock[n], Lock::Level(_)) {
            cloud.lock[n] = Lock::Free;
        }
    }
    relax_thin(&plan, &mut cloud, &fixed, None, thin_steps::<D>());
    for run in fluid_steps::<D>() {
        relax(&plan, &mut cloud, &fixed, None, run);
    }
    Ok(Fluid {
        plan,
        cloud,
        lattice,
    })
}
