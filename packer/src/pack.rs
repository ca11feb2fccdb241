//! The packing, from the body to the report.

use std::time::Instant;

use aero_geometry::{Shape, Vector};
use rayon::prelude::*;

use crate::cloud::{Cloud, Lock};
use crate::fluid::{lattice_begins, pack_fluid};
use crate::lattice::freeze_on_lattice;
use crate::mirror::{Mirrors, flip};
use crate::plan::{Plan, Side};
use crate::quality::Quality;
use crate::relax::{relax, relax_thin};
use crate::schedule::{THIN_STEPS, ghost_steps};
use crate::seeds::seed;
use crate::sources::Sources;
use crate::target::ideal_layers;
use crate::thin::fill_thin;
use crate::{Ghosts, PackError, PackOptions, Packing};

/// Packs ghosts into `shape` and, if asked, conforming fluid around it.
pub fn pack<const D: usize>(
    shape: &dyn Shape<D>,
    options: &PackOptions<D>,
) -> Result<Packing<D>, PackError> {
    let start = Instant::now();
    options.check()?;
    let plan = Plan::new(shape, options, Mirrors::of(shape), Side::Ghosts, 2.0)?;
    let (mut cloud, left) = seed(&plan)?;
    let target = ideal_layers(&plan);
    let placed = Sources::new(&plan.mirrors, cloud.particles(), plan.support());
    fill_thin(&plan, &mut cloud, left, &placed, |points, smoothing| {
        target.densities(points, smoothing)
    });
    relax_ghosts(&plan, &mut cloud, &target);
    let everywhere = with_surface(&plan, &cloud);
    let ghosts = clipped(&plan, &everywhere);
    if ghosts.position.is_empty() {
        return Err(PackError::Empty);
    }
    let mut packing = Packing {
        ghosts,
        ..Packing::default()
    };
    let quality = Quality {
        plan: &plan,
        ghosts: &everywhere,
    };
    packing.report = quality.of_ghosts(&packing.ghosts, &target);
    if options.fluid_layers > 0 {
        let fluid = pack_fluid(shape, options, &everywhere)?;
        let all_fluid = with_surface(&fluid.plan, &fluid.cloud);
        packing.fluid = clipped(&fluid.plan, &all_fluid);
        packing.lattice_begins = Some(lattice_begins(options));
        packing.report.fluid = packing.fluid.position.len();
        quality.of_both(&all_fluid, &fluid, &mut packing.report);
    }
    packing.report.wall_seconds = start.elapsed().as_secs_f64();
    Ok(packing)
}

/// Lets the ghosts settle: all but the wall layer and those on the lattice may leave their level.
fn relax_ghosts<const D: usize>(plan: &Plan<'_, D>, cloud: &mut Cloud<D>, target: &Sources<D>) {
    for n in 0..cloud.len() {
        if cloud.layer[n] > 0 && cloud.lock[n] != Lock::Thin {
            cloud.lock[n] = Lock::Free;
        }
    }
    freeze_on_lattice(plan, cloud);
    relax_thin(plan, cloud, &[], Some(target), THIN_STEPS);
    for run in ghost_steps::<D>() {
        relax(plan, cloud, &[], Some(target), run);
    }
}

/// All particles, images included, with distance and normal.
fn with_surface<const D: usize>(plan: &Plan<'_, D>, cloud: &Cloud<D>) -> Ghosts<D> {
    let surface: Vec<_> = cloud
        .position
        .par_iter()
        .map(|point| plan.shape.closest(point))
        .collect();
    let mut all = Ghosts::default();
    let mut add = |n: usize, position: Vector<D>, flips: u32| {
        all.position.push(position);
        all.normal.push(flip(&surface[n].normal, flips));
        all.distance.push(surface[n].distance);
        all.volume.push(cloud.volume[n]);
        all.layer.push(cloud.layer[n]);
        // An image may lie on another smooth part of the surface than its original.
        let face = if flips == 0 {
            surface[n].face
        } else {
            plan.shape.closest(&position).face
        };
        all.face.push(face);
    };
    for n in 0..cloud.len() {
        let position = cloud.position[n];
        add(n, position, 0);
        plan.mirrors
            .images(&position, |flips, image| add(n, image, flips));
    }
    all
}

/// What lies inside the region.
fn clipped<const D: usize>(plan: &Plan<'_, D>, all: &Ghosts<D>) -> Ghosts<D> {
    let mut kept = Ghosts::default();
    for n in 0..all.position.len() {
        if plan.keeps(&all.position[n]) {
            kept.position.push(all.position[n]);
            kept.normal.push(all.normal[n]);
            kept.distance.push(all.distance[n]);
            kept.volume.push(all.volume[n]);
            kept.layer.push(all.layer[n]);
            kept.face.push(all.face[n]);
        }
    }
    kept
}
