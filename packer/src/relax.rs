//! Velocity-free relaxation: particles move down the gradient of the summed density, by bounded
//! steps, with a fixed number of them. No time step, hence the same result everywhere.

use aero_geometry::kernel::{QuinticSpline, SUPPORT};
use aero_geometry::{Pencils, Shape, Vector};
use rayon::prelude::*;

use crate::cloud::{Cloud, Lock};
use crate::level::project;
use crate::mirror::Mirrors;
use crate::plan::Plan;
use crate::target::Target;

/// Longest displacement in one step, in spacings.
const LONGEST_STEP: f64 = 0.15;

/// Nearest that a particle off a mirror plane may come to it, in spacings.
const PLANE_CLEARANCE: f64 = 0.35;

/// Steps between corrections of the drift off a level.
const STEPS_BETWEEN_PROJECTIONS: usize = 4;

/// Steps between new evaluations of the wanted gradient, which is smooth.
const STEPS_BETWEEN_TARGETS: usize = 1;

/// One run of relaxation.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Relaxation {
    /// Number of steps.
    pub steps: usize,
    /// Smoothing length, in spacings.
    pub smoothing: f64,
    /// Displacement per gradient of the number of particles per cell, in squared spacings.
    pub strength: f64,
}

/// Relaxes `cloud` until its summed density follows that of `target`; `fixed` particles push but
/// are not pushed. Both are counted in volumes, so the gradient is that of `Σ V W`.
pub(crate) fn relax<const D: usize>(
    plan: &Plan<'_, D>,
    cloud: &mut Cloud<D>,
    fixed: &[(Vector<D>, f64)],
    target: Option<&Target<D>>,
    run: Relaxation,
) {
    let (shape, mirrors) = (plan.shape, &plan.mirrors);
    let spacing = plan.options.spacing;
    let sizes = (spacing, plan.tolerance);
    let smoothing = run.smoothing * spacing;
    let reach = SUPPORT * smoothing;
    let mut pencils = Pencils::default();
    let mut wanted = vec![Vector::zeros(); cloud.len()];
    let mut normals = vec![Vector::zeros(); cloud.len()];
    for step in 0..run.steps {
        let (all, volumes) = sources(mirrors, cloud, fixed, reach);
        pencils.rebuild(&all, 0.5 * reach);
        let order = pencils.order();
        let sorted: Vec<(Vector<D>, f64)> = order
            .par_iter()
            .map(|&n| (all[n as usize], volumes[n as usize]))
            .collect();
        if let Some(target) = target
            && step % STEPS_BETWEEN_TARGETS == 0
        {
            wanted = cloud
                .position
                .par_iter()
                .map(|point| target.at(point, smoothing).1)
                .collect();
        }
        let settle = (step + 1) % STEPS_BETWEEN_PROJECTIONS == 0 || step + 1 == run.steps;
        if step % STEPS_BETWEEN_PROJECTIONS == 0 {
            normals = normals_of_locked(shape, cloud);
        }
        let moved: Vec<Vector<D>> = (0..cloud.len())
            .into_par_iter()
            .map(|n| {
                let point = cloud.position[n];
                if cloud.lock[n] == Lock::Frozen {
                    return point;
                }
                let mut slope = -wanted[n];
                let (low, high) = (point.add_scalar(-reach), point.add_scalar(reach));
                pencils.for_each_run(&low, &high, |slots| {
                    for (other, volume) in &sorted[slots] {
                        let offset = point - other;
                        let squared = offset.norm_squared();
                        if squared < reach * reach {
                            let r = squared.sqrt();
                            slope +=
                                volume * QuinticSpline::<D>::gradient_factor(r, smoothing) * offset;
                        }
                    }
                });
                let mut push = -run.strength * spacing * spacing * slope;
                push -= normals[n] * normals[n].dot(&push);
                let moved = confined(mirrors, &point, &push, spacing);
                match cloud.lock[n] {
                    Lock::Level(level) if settle => {
                        onto_level(shape, mirrors, &moved, level, sizes)
                            .filter(|on| (on - moved).norm() < spacing)
                            .unwrap_or(point)
                    }
                    _ => moved,
                }
            })
            .collect();
        cloud.position = moved;
    }
}

/// Everything that pushes: the particles, what is fixed, and the images of both near the planes.
fn sources<const D: usize>(
    mirrors: &Mirrors,
    cloud: &Cloud<D>,
    fixed: &[(Vector<D>, f64)],
    reach: f64,
) -> (Vec<Vector<D>>, Vec<f64>) {
    let own = cloud
        .position
        .iter()
        .copied()
        .zip(cloud.volume.iter().copied());
    let mut points = Vec::with_capacity(2 * cloud.len() + fixed.len());
    let mut volumes = Vec::with_capacity(2 * cloud.len() + fixed.len());
    for (point, volume) in own.chain(fixed.iter().copied()) {
        points.push(point);
        volumes.push(volume);
        mirrors.images_within(&point, reach, |_, image| {
            points.push(image);
            volumes.push(volume);
        });
    }
    (points, volumes)
}

/// Normals of particles that move on a level; zero for the others.
fn normals_of_locked<const D: usize>(shape: &dyn Shape<D>, cloud: &Cloud<D>) -> Vec<Vector<D>> {
    (0..cloud.len())
        .into_par_iter()
        .map(|n| match cloud.lock[n] {
            Lock::Level(_) => shape.closest(&cloud.position[n]).normal,
            Lock::Free | Lock::Frozen => Vector::zeros(),
        })
        .collect()
}

/// Spreads points evenly on the sheet `distance = level`, each seeing the others of its sheet only.
pub(crate) fn spread_on_sheet<const D: usize>(
    shape: &dyn Shape<D>,
    mirrors: &Mirrors,
    points: &mut [Vector<D>],
    level: f64,
    (spacing, tolerance): (f64, f64),
    run: Relaxation,
) {
    let mut normals: Vec<Vector<D>> = points.par_iter().map(|p| shape.closest(p).normal).collect();
    let smoothing = run.smoothing * spacing;
    let mut pencils = Pencils::default();
    for step in 0..run.steps {
        let all = with_images(mirrors, points, SUPPORT * smoothing);
        pencils.rebuild(&all, 0.5 * SUPPORT * smoothing);
        let settle = (step + 1) % STEPS_BETWEEN_PROJECTIONS == 0 || step + 1 == run.steps;
        let moved: Vec<(Vector<D>, Vector<D>)> = points
            .par_iter()
            .zip(&normals)
            .map(|(point, normal)| {
                let mut push = Vector::zeros();
                sum_around(
                    &pencils,
                    &all,
                    point,
                    SUPPORT * smoothing,
                    |_, offset, r| {
                        push -= QuinticSpline::<2>::gradient_factor(r, smoothing) * offset;
                    },
                );
                push *= run.strength * spacing.powi(4);
                push -= normal * normal.dot(&push);
                let target = confined(mirrors, point, &push, spacing);
                if !settle {
                    return (target, *normal);
                }
                match onto_level(shape, mirrors, &target, level, (spacing, tolerance)) {
                    Some(on) if (on - target).norm() < spacing => (on, shape.closest(&on).normal),
                    _ => (*point, *normal),
                }
            })
            .collect();
        for (n, (point, normal)) in moved.into_iter().enumerate() {
            points[n] = point;
            normals[n] = normal;
        }
    }
}

/// The points and those of their images that are within `reach` of a mirror plane.
pub(crate) fn with_images<const D: usize>(
    mirrors: &Mirrors,
    points: &[Vector<D>],
    reach: f64,
) -> Vec<Vector<D>> {
    let mut all = points.to_vec();
    for point in points {
        mirrors.images_within(point, reach, |_, image| all.push(image));
    }
    all
}

/// Calls `visit` with number, offset and distance of every point nearer than `reach`.
pub(crate) fn sum_around<const D: usize>(
    pencils: &Pencils<D>,
    points: &[Vector<D>],
    centre: &Vector<D>,
    reach: f64,
    mut visit: impl FnMut(usize, &Vector<D>, f64),
) {
    let (low, high) = (centre.add_scalar(-reach), centre.add_scalar(reach));
    pencils.for_each_run(&low, &high, |run| {
        for &n in &pencils.order()[run] {
            let offset = centre - points[n as usize];
            let squared = offset.norm_squared();
            if squared < reach * reach {
                visit(n as usize, &offset, squared.sqrt());
            }
        }
    });
}

/// The nearest place on a level that respects the mirror planes.
fn onto_level<const D: usize>(
    shape: &dyn Shape<D>,
    mirrors: &Mirrors,
    point: &Vector<D>,
    level: f64,
    (spacing, tolerance): (f64, f64),
) -> Option<Vector<D>> {
    let mut position = *point;
    // Where the level meets a plane at an angle the two conditions are met in turns.
    for _ in 0..20 {
        let on = project(shape, &position, level, tolerance)?;
        position = confined(mirrors, point, &(on - point), spacing);
        if (position - on).norm() <= tolerance {
            return Some(on);
        }
    }
    Some(position)
}

/// `point` displaced by at most the longest step, staying on the mirror planes on which it lies and
/// clear of the others.
fn confined<const D: usize>(
    mirrors: &Mirrors,
    point: &Vector<D>,
    push: &Vector<D>,
    spacing: f64,
) -> Vector<D> {
    let length = push.norm();
    let longest = LONGEST_STEP * spacing;
    let mut moved = point
        + push
            * if length > longest {
                longest / length
            } else {
                1.0
            };
    for &(axis, position) in mirrors.planes() {
        moved[axis] = if point[axis] == position {
            position
        } else {
            moved[axis].max(position + (PLANE_CLEARANCE * spacing).min(point[axis] - position))
        };
    }
    moved
}
