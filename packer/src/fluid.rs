//! The fluid side: conforming layers outside the body and a shell that leads over into the lattice.

use aero_geometry::kernel::{SMOOTHING_RATIO, SUPPORT};
use aero_geometry::{Shape, Vector};

use crate::cloud::{Cloud, Lock};
use crate::grid::Cell;
use crate::lattice::{freeze_lattice, lattice_grid, lattice_planes};
use crate::mirror::Mirrors;
use crate::plan::{Plan, Side};
use crate::relax::relax;
use crate::schedule::FLUID_STEPS;
use crate::seeds::seed;
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
    let plan = Plan::new(shape, options, mirrors, Side::Fluid, margin)?;
    let (mut cloud, carry) = seed(&plan)?;

    let grid = lattice_grid(&plan.mirrors, &options.anchor, spacing);
    let from = options.fluid_layers as f64 * spacing;
    let sites = grid.band(
        shape,
        &plan.bounds,
        (from - 2.0 * spacing, begins + support),
        spacing,
    )?;
    let place = |cell: &Cell<D>| {
        plan.mirrors
            .snapped(grid.centre(&cell.index), 1e-6 * spacing)
    };
    let lattice: Vec<Vector<D>> = sites
        .iter()
        .filter(|cell| cell.distance > begins)
        .map(place)
        .collect();

    // The shell takes the sites farthest from the body, as many as its volume holds.
    let mut shell: Vec<&Cell<D>> = sites
        .iter()
        .filter(|cell| cell.distance <= begins)
        .collect();
    let weight = |cell: &Cell<D>| plan.mirrors.share(&place(cell));
    let wanted = carry
        + shell
            .iter()
            .map(|cell| weight(cell) * (1.0 - cell.fraction_below(from, spacing)))
            .sum::<f64>();
    shell.sort_by(|a, b| b.distance.total_cmp(&a.distance));
    let mut taken = 0.0;
    for cell in shell {
        taken += weight(cell);
        if taken > wanted + 0.5 {
            break;
        }
        cloud.push(
            place(cell),
            options.fluid_layers as u32,
            Lock::Free,
            plan.particle_volume(),
        );
    }

    let mut fixed: Vec<(Vector<D>, f64)> = lattice
        .iter()
        .map(|&point| (point, plan.particle_volume()))
        .collect();
    let ghost = ghosts
        .position
        .iter()
        .copied()
        .zip(ghosts.volume.iter().copied());
    fixed.extend(ghost.filter(|(point, _)| plan.mirrors.above(point)));
    for n in 0..cloud.len() {
        let near_region = options
            .region
            .is_none_or(|region| region.grown(spacing).contains(&cloud.position[n]));
        if !near_region {
            cloud.lock[n] = Lock::Frozen;
        } else if cloud.layer[n] > 0 {
            cloud.lock[n] = Lock::Free;
        }
    }
    freeze_lattice(&plan, &mut cloud, &fixed);
    for run in FLUID_STEPS {
        relax(&plan, &mut cloud, &fixed, None, run);
    }
    Ok(Fluid {
        plan,
        cloud,
        lattice,
    })
}
