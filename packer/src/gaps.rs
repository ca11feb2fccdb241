//! The last look at the ghosts before they leave: no two may stand closer than half a spacing, nor one next to its own image.

use aero_geometry::Vector;

use crate::cloud::{Cloud, Lock};
use crate::nearest::Nearest;
use crate::plan::Plan;

/// Least distance between two ghosts, in spacings.
pub(crate) const LEAST_GAP: f64 = 0.5;

/// Ghosts that had to make room end this far apart, in spacings.
const AIM: f64 = 0.55;

/// Rounds of pushing before ghosts are merged.
const PUSHES: usize = 30;

/// Rounds of merging; each leaves fewer.
const MERGES: usize = 20;

/// A pair of ghosts, or a ghost and its image: both numbers, the way from the second to the first, their distance.
type Close<const D: usize> = (usize, usize, Vector<D>, f64);

/// Pushes ghosts apart that are too close, and merges those for which there is no room; gives their number.
pub(crate) fn open_gaps<const D: usize>(plan: &Plan<'_, D>, cloud: &mut Cloud<D>) -> usize {
    for _ in 0..PUSHES {
        let close = close_pairs(plan, cloud, AIM);
        if close
            .iter()
            .all(|pair| pair.3 >= LEAST_GAP * plan.options.spacing)
        {
            return 0;
        }
        push(plan, cloud, &close);
    }
    let before = cloud.len();
    for _ in 0..MERGES {
        let close = close_pairs(plan, cloud, LEAST_GAP);
        if close.is_empty() {
            break;
        }
        merge(plan, cloud, close);
    }
    before - cloud.len()
}

/// All pairs nearer than `reach` spacings, each once; a ghost beside a mirror plane pairs with its image.
fn close_pairs<const D: usize>(plan: &Plan<'_, D>, cloud: &Cloud<D>, reach: f64) -> Vec<Close<D>> {
    let reach = reach * plan.options.spacing;
    let nearest = Nearest::new(&plan.mirrors, &cloud.position, reach);
    let mut found = Vec::new();
    for (n, place) in cloud.position.iter().enumerate() {
        nearest.within(place, reach, |other, at, distance| {
            let other = other as usize;
            let is_itself = other == n && at == place;
            if other >= n && !is_itself {
                found.push((n, other, place - at, distance));
            }
        });
    }
    found
}

/// Moves the ghosts of each pair apart by half of what is missing, those that may move.
fn push<const D: usize>(plan: &Plan<'_, D>, cloud: &mut Cloud<D>, close: &[Close<D>]) {
    let spacing = plan.options.spacing;
    let mut moves = vec![Vector::<D>::zeros(); cloud.len()];
    for &(n, other, offset, distance) in close {
        let missing = AIM * spacing - distance;
        let way = if distance > 1e-6 * spacing {
            offset / distance
        } else {
            // Of two in one place, each goes its own way.
            Vector::<D>::from_fn(|k, _| 1.0 / (k as f64 + 1.5)).normalize()
        };
        let is_fixed = |n: usize| matches!(cloud.lock[n], Lock::Frozen);
        let part = if is_fixed(n) || is_fixed(other) {
            1.0
        } else {
            0.5
        };
        if !is_fixed(n) {
            moves[n] += part * missing * way;
        }
        if other != n && !is_fixed(other) {
            moves[other] -= part * missing * way;
        }
    }
    for (n, step) in moves.into_iter().enumerate() {
        if step == Vector::<D>::zeros() {
            continue;
        }
        let start = cloud.position[n];
        let mut end = start + step;
        for &(axis, position) in plan.mirrors.planes() {
            if start[axis] == position {
                end[axis] = position;
            } else {
                end[axis] = end[axis].max(position);
            }
        }
        // A ghost stays on its level, and inside of the body.
        let seen = plan.shape.closest(&end);
        let level = match cloud.lock[n] {
            Lock::Level(level) => level,
            _ => seen
                .distance
                .min(plan.shape.signed_distance(&start))
                .min(0.0),
        };
        let on_level = end - (seen.distance - level) * seen.normal;
        if plan.mirrors.above(&on_level)
            && (plan.shape.signed_distance(&on_level) - level).abs() <= plan.tolerance
        {
            cloud.position[n] = on_level;
        } else if !matches!(cloud.lock[n], Lock::Level(_)) && seen.distance < 0.0 {
            cloud.position[n] = end;
        }
    }
}

/// Merges the closest pairs, each ghost once; a ghost too near to its own image goes onto the plane between them.
fn merge<const D: usize>(plan: &Plan<'_, D>, cloud: &mut Cloud<D>, mut close: Vec<Close<D>>) {
    close.sort_by(|a, b| a.3.total_cmp(&b.3).then((a.0, a.1).cmp(&(b.0, b.1))));
    let mut touched = vec![false; cloud.len()];
    let mut gone = vec![false; cloud.len()];
    for (n, other, ..) in close {
        if touched[n] || touched[other] {
            continue;
        }
        touched[n] = true;
        touched[other] = true;
        if n == other {
            let before = plan.mirrors.share(&cloud.position[n]);
            let half = 0.5 * LEAST_GAP * plan.options.spacing;
            let place = plan.mirrors.snapped(cloud.position[n], half);
            cloud.volume[n] *= before / plan.mirrors.share(&place);
            cloud.position[n] = place;
            continue;
        }
        // A frozen one stays, and so does one that counts for less because it stands on a mirror plane.
        let weight = |n: usize| {
            let share = plan.mirrors.share(&cloud.position[n]);
            (cloud.lock[n] == Lock::Frozen, 1.0 - share)
        };
        let (stays, goes) = if weight(other) > weight(n) {
            (other, n)
        } else {
            (n, other)
        };
        let share = |n: usize| plan.mirrors.share(&cloud.position[n]);
        cloud.volume[stays] += cloud.volume[goes] * share(goes) / share(stays);
        gone[goes] = true;
    }
    let mut n = 0;
    cloud.retain(|_| {
        n += 1;
        !gone[n - 1]
    });
}
