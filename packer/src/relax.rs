//! Velocity-free relaxation: particles move down the gradient of the summed density, by bounded
//! steps, with a fixed number of them. No time step, hence the same result everywhere.

use aero_geometry::kernel::SUPPORT;
use aero_geometry::parallel::prelude::*;
use aero_geometry::{Shape, Vector};

use crate::cloud::{Cloud, Lock};
use crate::mirror::Mirrors;
use crate::on_sheet::{OnSheet, Seed};
use crate::plan::Plan;
use crate::sources::Sources;

/// Longest displacement in one step, in spacings.
const LONGEST_STEP: f64 = 0.15;

/// Nearest that a particle off a mirror plane may come to it, in spacings.
const PLANE_CLEARANCE: f64 = 0.35;

/// Below this distance, in spacings, two particles are pushed apart: the kernel's gradient vanishes
/// at its centre and would let a pair stay together. Above the smallest gap aimed at, 0.7, because
/// the push sets in softly.
const CROWDED: f64 = 0.75;

/// Displacement, in spacings, of a particle that sits on another one.
const REPULSION: f64 = 0.2;

/// Particles in thin parts keep this part of the wall layer's distance from the surface.
const CLEARANCE: f64 = 0.3;

/// Steps between corrections of the drift off a level.
const STEPS_BETWEEN_PROJECTIONS: usize = 4;

/// Drift off a level, in spacings, that one step along the gradient makes up for.
const SMALL_DRIFT: f64 = 0.05;

/// Newton's method gives up after this many steps: there is no such place.
const MOST_NEWTON_STEPS: usize = 30;

/// Steps between new evaluations of the wanted gradient, which is smooth, in the plane and in space.
const STEPS_BETWEEN_TARGETS: [usize; 2] = [1, 5];

/// Part of the steps, the last ones, without momentum: what still swings comes to rest.
const RESTING: f64 = 0.3;

/// Place and normal of a particle after a step, and its place again where that is known to be on its level, or inside.
type Moved<const D: usize> = (Vector<D>, Vector<D>, Option<Vector<D>>);

/// One run of relaxation.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Relaxation {
    /// Its name, for those who watch.
    pub stage: &'static str,
    /// Number of steps.
    pub steps: usize,
    /// Smoothing length, in spacings.
    pub smoothing: f64,
    /// Displacement per gradient of the number of particles per cell, in squared spacings.
    pub strength: f64,
    /// Part of the last displacement that goes on into the next [Polyak 1964, USSR Comput. Math. Math. Phys. 4, 1: the heavy ball]: long
    /// waves are evened out in few steps.
    pub momentum: f64,
}

impl Relaxation {
    fn momentum_at(&self, step: usize) -> f64 {
        if (step as f64) < (1.0 - RESTING) * self.steps as f64 {
            self.momentum
        } else {
            0.0
        }
    }
}

/// Relaxes `cloud` until its summed density follows that of `target`; `fixed` particles push but
/// are not pushed. Both are counted in volumes, so the gradient is that of `Σ V W`.
pub(crate) fn relax<const D: usize>(
    plan: &Plan<'_, D>,
    cloud: &mut Cloud<D>,
    fixed: &[(Vector<D>, f64)],
    target: Option<&Sources<D>>,
    run: Relaxation,
) {
    let (shape, mirrors) = (plan.shape, &plan.mirrors);
    let spacing = plan.options.spacing;
    let sizes = (spacing, plan.tolerance);
    let smoothing = run.smoothing * spacing;
    let reach = SUPPORT * smoothing;
    let mut wanted = vec![Vector::zeros(); cloud.len()];
    let mut normals = normals_of_locked(shape, cloud);
    // Where each was last on its level, or inside: a level may end, and what drifts past its end returns.
    let mut homes = cloud.position.clone();
    let mut swings = vec![Vector::zeros(); cloud.len()];
    for step in 0..run.steps {
        plan.options.watch.show(run.stage, step, run.steps);
        let everything = cloud.particles().chain(fixed.iter().copied());
        let sources = Sources::new(mirrors, everything, reach);
        if let Some(target) = target
            && step % STEPS_BETWEEN_TARGETS[D - 2] == 0
        {
            wanted = target.gradients(&cloud.position, smoothing);
        }
        let slopes = sources.gradients(&cloud.position, smoothing);
        let crowding = sources.crowding(&cloud.position, CROWDED * spacing);
        let settle = Settle::at(step, run.steps);
        let momentum = run.momentum_at(step);
        let moved: Vec<Moved<D>> = (0..cloud.len())
            .into_par_iter()
            .map(|n| {
                let point = cloud.position[n];
                if matches!(cloud.lock[n], Lock::Frozen | Lock::Row) {
                    return (point, normals[n], None);
                }
                let slope = slopes[n] - wanted[n];
                let mut push = -run.strength * spacing * spacing * slope;
                push += REPULSION * spacing / plan.particle_volume() * crowding[n];
                push += momentum * swings[n];
                push -= normals[n] * normals[n].dot(&push);
                let moved = displaced(mirrors, &point, &push, spacing);
                match cloud.lock[n] {
                    Lock::Level(level) => {
                        settle.onto(plan, &moved, (&homes[n], &normals[n]), level)
                    }
                    Lock::Thin if settle != Settle::Not => {
                        let nearest = CLEARANCE * plan.level(0);
                        let distance = shape.signed_distance(&moved);
                        let inside = if distance * nearest.signum() < nearest.abs() {
                            let on = onto_level(shape, mirrors, &moved, nearest, sizes);
                            // There may be no such place: next to corners and edges.
                            on.unwrap_or_else(|| plan.on_side(&point, &homes[n]))
                        } else {
                            moved
                        };
                        (inside, normals[n], Some(inside))
                    }
                    // Those next to the wall layer must not slip through it.
                    Lock::Free if settle != Settle::Not && cloud.layer[n] == 1 => {
                        let nearest = plan.level(0);
                        let distance = shape.signed_distance(&moved);
                        let is_near = distance * nearest.signum() < nearest.abs();
                        let may_not = is_near || !plan.may_stand(&moved, plan.level(1));
                        let place = if may_not {
                            plan.on_side(&point, &homes[n])
                        } else {
                            moved
                        };
                        (place, normals[n], Some(place))
                    }
                    Lock::Free if settle == Settle::Exactly => {
                        (plan.on_side(&moved, &homes[n]), normals[n], None)
                    }
                    _ => (moved, normals[n], None),
                }
            })
            .collect();
        for (n, (place, normal, home)) in moved.into_iter().enumerate() {
            swings[n] = place - cloud.position[n];
            (cloud.position[n], normals[n]) = (place, normal);
            homes[n] = home.unwrap_or(homes[n]);
        }
    }
}

/// Whether particles are brought back onto their level after a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Settle {
    Not,
    Nearly,
    Exactly,
}

impl Settle {
    fn at(step: usize, steps: usize) -> Self {
        if step + 1 == steps {
            Self::Exactly
        } else if (step + 1).is_multiple_of(STEPS_BETWEEN_PROJECTIONS) {
            Self::Nearly
        } else {
            Self::Not
        }
    }

    /// Place and normal of a particle on a level that has moved to `moved`; `last` are its last place on the level and the
    /// normal before the step.
    fn onto<const D: usize>(
        self,
        plan: &Plan<'_, D>,
        moved: &Vector<D>,
        (home, normal): (&Vector<D>, &Vector<D>),
        level: f64,
    ) -> Moved<D> {
        let spacing = plan.options.spacing;
        if self == Self::Not {
            return (*moved, *normal, None);
        }
        if self == Self::Nearly {
            // One search is enough for a small drift over a smooth surface.
            let closest = plan.shape.closest(moved);
            let drift = closest.distance - level;
            if drift.abs() < SMALL_DRIFT * spacing {
                let on = moved - drift * closest.normal;
                let on = clear_of_planes(&plan.mirrors, moved, on, spacing);
                if !plan.may_stand(&on, level) {
                    return (*home, *normal, None);
                }
                return (on, closest.normal, Some(on));
            }
        }
        onto_level(
            plan.shape,
            &plan.mirrors,
            moved,
            level,
            (spacing, plan.tolerance),
        )
        .filter(|on| (on - moved).norm() < spacing && plan.may_stand(on, level))
        .map_or((*home, *normal, None), |on| {
            (on, plan.shape.closest(&on).normal, Some(on))
        })
    }
}

/// Relaxes the particles of thin parts alone, before all others: they start in rough places.
pub(crate) fn relax_thin<const D: usize>(
    plan: &Plan<'_, D>,
    cloud: &mut Cloud<D>,
    fixed: &[(Vector<D>, f64)],
    target: Option<&Sources<D>>,
    run: Relaxation,
) {
    let (thin, rest): (Vec<usize>, Vec<usize>) =
        (0..cloud.len()).partition(|&n| cloud.lock[n] == Lock::Thin);
    if thin.is_empty() {
        return;
    }
    let mut part = Cloud::default();
    for &n in &thin {
        part.push(
            cloud.position[n],
            cloud.layer[n],
            cloud.lock[n],
            cloud.volume[n],
        );
    }
    let reach = plan.support() + plan.options.spacing;
    let near = Sources::new(&plan.mirrors, part.particles(), reach);
    let others = rest.iter().map(|&n| (cloud.position[n], cloud.volume[n]));
    let others: Vec<(Vector<D>, f64)> = others.chain(fixed.iter().copied()).collect();
    let places: Vec<Vector<D>> = others.iter().map(|other| other.0).collect();
    let gaps = near.nearest(&places, reach, false);
    let others: Vec<(Vector<D>, f64)> = others
        .into_iter()
        .zip(gaps)
        .filter(|&(_, gap)| gap < reach)
        .map(|(other, _)| other)
        .collect();
    relax(plan, &mut part, &others, target, run);
    for (&n, position) in thin.iter().zip(part.position) {
        cloud.position[n] = position;
    }
}

/// Normals of particles that move on a level; zero for the others.
fn normals_of_locked<const D: usize>(shape: &dyn Shape<D>, cloud: &Cloud<D>) -> Vec<Vector<D>> {
    (0..cloud.len())
        .into_par_iter()
        .map(|n| match cloud.lock[n] {
            Lock::Level(_) => shape.closest(&cloud.position[n]).normal,
            _ => Vector::zeros(),
        })
        .collect()
}

/// Spreads seeds evenly on the sheet `distance = level`, each seeing the others of its sheet only;
/// those that are `fixed` stay.
pub(crate) fn spread_on_sheet<const D: usize>(
    plan: &Plan<'_, D>,
    seeds: &mut [Seed<D>],
    level: f64,
    run: Relaxation,
) {
    let spacing = plan.options.spacing;
    let smoothing = run.smoothing * spacing;
    let mut homes: Vec<Vector<D>> = seeds.iter().map(|seed| seed.place).collect();
    let mut swings = vec![Vector::zeros(); seeds.len()];
    for step in 0..run.steps {
        // Relaxation in space follows, so a little drift off the sheet does no harm.
        let places: Vec<Vector<D>> = seeds.iter().map(|seed| seed.place).collect();
        let sheet = OnSheet::new(&plan.mirrors, &places, SUPPORT * smoothing);
        let settle = Settle::at(step, run.steps).min(Settle::Nearly);
        let momentum = run.momentum_at(step);
        let all = seeds.par_iter_mut().zip(homes.par_iter_mut());
        let all = all.zip(swings.par_iter_mut());
        all.enumerate().for_each(|(n, ((seed, home), swing))| {
            // Where the region cuts the body off, seeds beyond it hold those inside.
            if seed.fixed || plan.is_far_beyond_region(&seed.place) {
                return;
            }
            let slope = sheet.sum(&seed.place, smoothing).1;
            let mut push = -run.strength * spacing.powi(4) * slope;
            push += REPULSION * spacing * sheet.crowding(n, &seed.place, CROWDED * spacing);
            push += momentum * *swing;
            push -= seed.normal * seed.normal.dot(&push);
            let moved = displaced(&plan.mirrors, &seed.place, &push, spacing);
            let (place, normal, on_level) =
                settle.onto(plan, &moved, (&*home, &seed.normal), level);
            *swing = place - seed.place;
            (seed.place, seed.normal) = (place, normal);
            *home = on_level.unwrap_or(*home);
        });
    }
}

/// A place on a level near `start`, by Newton's method along the gradient, or along what the mirror
/// planes leave of it.
fn onto_level<const D: usize>(
    shape: &dyn Shape<D>,
    mirrors: &Mirrors,
    start: &Vector<D>,
    level: f64,
    (spacing, tolerance): (f64, f64),
) -> Option<Vector<D>> {
    let mut place = *start;
    for _ in 0..MOST_NEWTON_STEPS {
        let closest = shape.closest(&place);
        let error = closest.distance - level;
        if error.abs() <= tolerance {
            return Some(place);
        }
        let mut gradient = closest.normal;
        let step = place - error * gradient;
        let allowed = clear_of_planes(mirrors, start, step, spacing);
        for &(axis, _) in mirrors.planes() {
            if allowed[axis] != step[axis] && place[axis] == allowed[axis] {
                gradient[axis] = 0.0;
            }
        }
        let slope = gradient.norm_squared();
        if slope < 1e-3 {
            return None;
        }
        let step = place - error / slope * gradient;
        place = clear_of_planes(mirrors, start, step, spacing);
    }
    None
}

/// `point` displaced by at most the longest step.
fn displaced<const D: usize>(
    mirrors: &Mirrors,
    point: &Vector<D>,
    push: &Vector<D>,
    spacing: f64,
) -> Vector<D> {
    let length = push.norm();
    let longest = LONGEST_STEP * spacing;
    let part = if length > longest {
        longest / length
    } else {
        1.0
    };
    clear_of_planes(mirrors, point, point + part * push, spacing)
}

/// Where a particle that was at `start` ends: on the mirror planes on which it lay, and clear of the
/// others.
fn clear_of_planes<const D: usize>(
    mirrors: &Mirrors,
    start: &Vector<D>,
    mut end: Vector<D>,
    spacing: f64,
) -> Vector<D> {
    for &(axis, position) in mirrors.planes() {
        end[axis] = if start[axis] == position {
            position
        } else {
            let nearest = (PLANE_CLEARANCE * spacing).min(start[axis] - position);
            end[axis].max(position + nearest)
        };
    }
    end
}
