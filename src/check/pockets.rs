//! Gas shut in between bodies: it starts with the stream's speed and has nowhere to go.

use std::collections::BTreeSet;

use aero_geometry::Vector;
use aero_solver::problem::Problem;

use super::{Check, place};

/// More sites than this are not looked at.
const MOST: f64 = 3e6;

/// Gas this near to a body, in spacings, touches it.
const TOUCHES: f64 = 1.6;

/// Looks for pockets between bodies, on the lattice of the gas.
pub(super) fn look<const D: usize>(problem: &Problem<D>, found: &mut Check) {
    let bounds = &problem.domain.bounds;
    let spacing = problem.resolution.lattice();
    let still = problem.bodies.iter().all(|body| !body.motion.is_moving());
    let counts: [usize; D] =
        std::array::from_fn(|k| (bounds.size()[k] / spacing).round().max(1.0) as usize);
    let sites: f64 = counts.iter().map(|&count| count as f64).product();
    let has_open = problem.domain.has(aero_solver::problem::Side::is_open);
    if problem.bodies.len() < 2 || !still || !has_open || sites > MOST {
        return;
    }
    let strides: [usize; D] = std::array::from_fn(|k| counts[..k].iter().product());
    let index =
        |site: usize| -> [usize; D] { std::array::from_fn(|k| site / strides[k] % counts[k]) };
    let position = |site: usize| {
        let index = index(site);
        Vector::<D>::from_fn(|k, _| bounds.min[k] + (index[k] as f64 + 0.5) * spacing)
    };
    let distance = |body: usize, point: &Vector<D>| {
        let shape = &problem.bodies[body].shape;
        if shape.bounds().grown(2.0 * spacing).contains(point) {
            shape.signed_distance(point)
        } else {
            f64::INFINITY
        }
    };
    let all = 0..problem.bodies.len();
    let mut is_gas: Vec<bool> = (0..sites as usize)
        .map(|site| {
            let point = position(site);
            all.clone()
                .all(|body| distance(body, &point) >= 0.5 * spacing * (1.0 - 1e-6))
        })
        .collect();
    for start in 0..is_gas.len() {
        if !is_gas[start] {
            continue;
        }
        let (mut left, mut count, mut opens) = (vec![start], 0, false);
        let mut owners = BTreeSet::new();
        is_gas[start] = false;
        while let Some(site) = left.pop() {
            count += 1;
            let here = index(site);
            for k in 0..D {
                for (end, step) in [(0, -1), (1, 1)] {
                    let there = here[k] as i64 + step;
                    if there < 0 || there >= counts[k] as i64 {
                        let side = problem.domain.sides[k][end];
                        // Periodic sides lead on; that is as good as open here.
                        opens |= side.is_open() || side.is_periodic();
                        continue;
                    }
                    let next = (site as i64 + step * strides[k] as i64) as usize;
                    if is_gas[next] {
                        is_gas[next] = false;
                        left.push(next);
                    }
                }
            }
            if owners.len() < 2 {
                let point = position(site);
                let near = all
                    .clone()
                    .filter(|&body| distance(body, &point) < TOUCHES * spacing);
                owners.extend(near);
            }
        }
        if !opens && owners.len() > 1 {
            let names: Vec<_> = owners
                .iter()
                .map(|&n| format!("`{}`", problem.bodies[n].name))
                .collect();
            found.refusals.push(format!(
                "bodies {}: enclose gas near {}, about {count} particles that cannot leave; fill the pocket with a \
                 body, or open it by at least two spacings",
                names.join(" and "),
                place(&position(start))
            ));
        }
    }
}
