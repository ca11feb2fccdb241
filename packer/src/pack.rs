//! The packing, from the body to the report.

use std::time::Instant;

use aero_geometry::parallel::prelude::*;
use aero_geometry::{Mirrored, Shape};

use crate::cloud::{Cloud, Lock};
use crate::cover::mend;
use crate::finish::Finished;
use crate::flawless::freeze_on_lattice;
use crate::fluid::{lattice_begins, pack_fluid};
use crate::gaps::open_gaps;
use crate::limits::{self, check_loss};
use crate::midway;
use crate::mirror::{Mirrors, cutting_mirrors};
use crate::plan::Plan;
use crate::quality::Quality;
use crate::relax::{relax, relax_thin};
use crate::room::Side;
use crate::schedule::{ghost_steps, thin_steps};
use crate::seeds::seed;
use crate::sources::Sources;
use crate::surface::samples;
use crate::target::ideal_layers;
use crate::thin::fill_thin;
use crate::{About, PackError, PackOptions, Packing, Warning};

/// The rounded number of ghosts may miss their exact volume by this part; beyond it they share the
/// exact volume.
const VOLUME_TOLERANCE: f64 = 5e-4;

/// Distance between samples of the surface, in spacings: eight to a particle.
const SAMPLES: f64 = 0.35;

/// Largest correction of a ghost's volume.
const LARGEST_CORRECTION: f64 = 0.1;

/// See [`crate::pack`].
pub fn pack<const D: usize>(
    shape: &dyn Shape<D>,
    options: &PackOptions<D>,
) -> Result<Packing<D>, PackError> {
    options.check()?;
    let cuts = cutting_mirrors(shape, options);
    if cuts.is_empty() {
        return pack_whole(shape, options);
    }
    pack_whole(&Mirrored::new(shape, cuts), options)
}

/// Packs a body that no mirror cuts but about its own planes.
fn pack_whole<const D: usize>(
    shape: &dyn Shape<D>,
    options: &PackOptions<D>,
) -> Result<Packing<D>, PackError> {
    let start = Instant::now();
    let watch = &options.watch;
    watch.begin("finding the layers");
    let mut plan = Plan::new(shape, options, &Mirrors::of(shape), Side::Ghosts, 2.0)?;
    let (mut cloud, _) = seed(&plan);
    let surface = samples(shape, &plan.bounds, SAMPLES * options.spacing);
    let layers = cloud.len();
    let thinnest = midway::lay(&plan, &mut cloud, &surface)?;
    let rows = cloud.particles().skip(layers).collect();
    let target = ideal_layers(&plan, rows);
    if D == 2 {
        let placed = Sources::new(&plan.mirrors, cloud.particles(), plan.support());
        let left = plan.thin_volume();
        fill_thin(&plan, &mut cloud, left, &placed, |points, smoothing| {
            target.densities(points, smoothing)
        });
    }
    plan.keep_wall_cells();
    settle(&plan, &mut cloud, &target);
    let strays = leave_out_strays(&plan, &mut cloud);
    mend(&plan, &mut cloud, &surface);
    let merged = open_gaps(&plan, &mut cloud);

    watch.begin("measuring");
    let finished = Finished::new(&plan, &cloud);
    let kept = finished.kept(&plan);
    if kept.is_empty() {
        return Err(PackError::Empty);
    }
    let quality = Quality {
        plan: &plan,
        ghosts: &finished,
        kept: &kept,
    };
    let mut packing = Packing {
        ghosts: finished.only(&kept),
        report: quality.of_ghosts(&target, &surface, thinnest),
        ..Packing::default()
    };
    check_loss(&packing.report, options.allow_loss)?;
    let over = limits::warnings(&packing.report);
    packing.report.warnings.extend(over);
    if strays > 0 {
        packing.report.warnings.push(Warning::new(
            About::Surface,
            format!(
                "left out {strays} ghosts that found no place inside of the body: its surface is broken near them"
            ),
        ));
    }
    if merged > 0 {
        packing.report.warnings.push(Warning::new(
            About::Gap,
            format!(
                "merged {merged} ghosts with others nearer than half a spacing, for want of room"
            ),
        ));
    }
    if options.fluid_layers > 0 {
        watch.begin("finding the fluid's layers");
        let fluid = pack_fluid(shape, options, &finished.all)?;
        let all_fluid = Finished::new(&fluid.plan, &fluid.cloud);
        watch.begin("measuring");
        packing.fluid = all_fluid.only(&all_fluid.kept(&fluid.plan));
        packing.lattice_begins = Some(lattice_begins(options));
        packing.report.fluid = packing.fluid.position.len();
        quality.of_both(&all_fluid.all, &fluid, &mut packing.report);
    }
    packing.report.wall_seconds = start.elapsed().as_secs_f64();
    Ok(packing)
}

/// Lets the ghosts settle: all but the wall layer and those on the lattice may leave their level.
fn settle<const D: usize>(plan: &Plan<'_, D>, cloud: &mut Cloud<D>, target: &Sources<D>) {
    for n in 0..cloud.len() {
        if cloud.layer[n] > 0 && matches!(cloud.lock[n], Lock::Level(_)) {
            cloud.lock[n] = Lock::Free;
        }
    }
    freeze_on_lattice(plan, cloud);
    share_volume(plan, cloud);
    relax_thin(plan, cloud, &[], Some(target), thin_steps::<D>());
    for run in ghost_steps::<D>() {
        relax(plan, cloud, &[], Some(target), run);
    }
}

/// Removes ghosts that relaxation has pushed through a broken surface; says how many.
fn leave_out_strays<const D: usize>(plan: &Plan<'_, D>, cloud: &mut Cloud<D>) -> usize {
    let before = cloud.len();
    let slack = 1e-9 * plan.options.spacing;
    let inside: Vec<bool> = cloud
        .position
        .par_iter()
        .map(|point| plan.shape.signed_distance(point) <= slack)
        .collect();
    if inside.iter().all(|&is| is) {
        return 0;
    }
    let mut is_inside = inside.into_iter();
    cloud.retain(|_| is_inside.next().unwrap_or(true));
    before - cloud.len()
}

/// Gives the ghosts off the lattice the shell's exact volume, where the rounding of their number
/// shows: a small body has few, and a symmetric one a multiple of two, four or eight.
fn share_volume<const D: usize>(plan: &Plan<'_, D>, cloud: &mut Cloud<D>) {
    let (total, mut movable) = volumes(plan, cloud);
    let missing = plan.shell_volume - total;
    if missing.abs() < VOLUME_TOLERANCE * total {
        return;
    }
    if missing.abs() > LARGEST_CORRECTION * movable && missing.abs() > 0.01 * limits::VOLUME * total
    {
        // The lattice does not fit into the body, and too few stand off it to make up for that.
        thaw(plan, cloud);
        movable = volumes(plan, cloud).1;
    }
    if missing.abs() > LARGEST_CORRECTION * movable {
        return;
    }
    for (volume, lock) in cloud.volume.iter_mut().zip(&cloud.lock) {
        if !matches!(lock, Lock::Frozen | Lock::Row) {
            *volume *= 1.0 + missing / movable;
        }
    }
}

/// Volume of all ghosts in the packed part of space, and of those off the lattice and off rows.
fn volumes<const D: usize>(plan: &Plan<'_, D>, cloud: &Cloud<D>) -> (f64, f64) {
    let (mut total, mut movable) = (0.0, 0.0);
    for n in 0..cloud.len() {
        let volume = cloud.volume[n] * plan.part_in_region(&cloud.position[n]);
        total += volume;
        if !matches!(cloud.lock[n], Lock::Frozen | Lock::Row) {
            movable += volume;
        }
    }
    (total, movable)
}

/// Lets go of the ghosts on the lattice.
fn thaw<const D: usize>(plan: &Plan<'_, D>, cloud: &mut Cloud<D>) {
    for (lock, &layer) in cloud.lock.iter_mut().zip(&cloud.layer) {
        if *lock == Lock::Frozen {
            *lock = match layer {
                0 => Lock::Level(plan.level(0)),
                _ => Lock::Free,
            };
        }
    }
}
