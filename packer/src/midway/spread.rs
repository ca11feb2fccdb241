//! Particles spread evenly over the sites of thin parts: enough to cover them, as many as their area asks for.

use std::collections::BTreeMap;

use aero_geometry::Vector;
use aero_geometry::parallel::prelude::*;

use super::seats::Seat;
use super::sites::Site;
use crate::cloud::Cloud;
use crate::nearest::Nearest;
use crate::plan::Plan;
use crate::sheets::Touched;

/// Every site is at most this far, in spacings, from a particle.
const COVERED: f64 = 1.0;

/// Particles are at least this far apart, in spacings, when they are laid, in the plane and in space: on a line, moving evens out any gap.
const APART: [f64; 2] = [0.5, 0.7];

/// And this far from those of the layers beside.
const BESIDE: f64 = 0.75;

/// Particles off a mirror plane keep this far from it, in spacings.
const OFF_PLANE: f64 = 0.35;

/// Width of the blocks whose counts are set right one by one, in spacings.
const BLOCK: f64 = 8.0;

/// Particles that are added in one round are at least this far apart, in spacings.
const TOUCHED: f64 = 1.5;

/// Rounds of adding particles.
const ROUNDS: usize = 40;

/// Rounds of moving each particle to the middle of the sites nearest to it [Lloyd 1982, IEEE Trans. Inf. Theory 28, 129].
const MOVES: usize = 16;

/// The particles of all thin parts, none near to those in `cloud`.
pub(super) fn spread<const D: usize>(
    plan: &Plan<'_, D>,
    sites: &[Site<D>],
    cloud: &Cloud<D>,
) -> Vec<Seat<D>> {
    let spacing = plan.options.spacing;
    let beside = Nearest::new(&plan.mirrors, &cloud.position, BESIDE * spacing);
    let free: Vec<bool> = sites
        .par_iter()
        .map(|site| {
            let planes = plan.mirrors.planes();
            let clear = planes.iter().all(|&(axis, position)| {
                let height = site.place[axis] - position;
                height == 0.0 || height > OFF_PLANE * spacing
            });
            clear
                && beside
                    .find(&site.place, BESIDE * spacing, |_| true)
                    .is_none()
        })
        .collect();
    let mut chosen = sweep(plan, sites, &free);
    add(plan, sites, &free, &mut chosen);
    let mut seats: Vec<Seat<D>> = chosen.iter().map(|&n| Seat::on(&sites[n])).collect();
    for _ in 0..MOVES {
        move_to_middles(plan, sites, &mut seats);
    }
    seats
}

/// Goes over the sites along their longest extent and takes each that is not near to one taken before.
fn sweep<const D: usize>(plan: &Plan<'_, D>, sites: &[Site<D>], free: &[bool]) -> Vec<usize> {
    let reach = COVERED * plan.options.spacing;
    let places: Vec<Vector<D>> = sites.iter().map(|site| site.place).collect();
    let nearest = Nearest::new(&plan.mirrors, &places, reach);
    let low = places
        .iter()
        .fold(Vector::repeat(f64::INFINITY), |a: Vector<D>, p| a.inf(p));
    let high = places
        .iter()
        .fold(Vector::repeat(f64::NEG_INFINITY), |a: Vector<D>, p| {
            a.sup(p)
        });
    let longest = (high - low).imax();
    let mut order: Vec<usize> = (0..sites.len()).filter(|&n| free[n]).collect();
    order.sort_by(|&a, &b| {
        places[a][longest]
            .total_cmp(&places[b][longest])
            .then(a.cmp(&b))
    });
    let mut covered = vec![false; sites.len()];
    let mut chosen = Vec::new();
    for n in order {
        if covered[n] {
            continue;
        }
        chosen.push(n);
        let mut cover = |centre: &Vector<D>| {
            nearest.within(centre, reach, |other, _, _| {
                covered[other as usize] |= !sites[n].is_across(&sites[other as usize]);
            });
        };
        cover(&places[n]);
        plan.mirrors
            .images_within(&places[n], reach, |_, image| cover(&image));
    }
    chosen
}

/// Adds particles at the sites farthest from any, block by block, until there are as many as the sites stand for; what a block lacks
/// or has too many is passed on.
fn add<const D: usize>(
    plan: &Plan<'_, D>,
    sites: &[Site<D>],
    free: &[bool],
    chosen: &mut Vec<usize>,
) {
    let spacing = plan.options.spacing;
    let block = |n: usize| -> [i64; D] {
        std::array::from_fn(|k| (sites[n].place[k] / (BLOCK * spacing)).floor() as i64)
    };
    let mut blocks: BTreeMap<[i64; D], (f64, Vec<usize>)> = BTreeMap::new();
    for n in 0..sites.len() {
        let entry = blocks.entry(block(n)).or_default();
        entry.0 += sites[n].count;
        entry.1.push(n);
    }
    let reach = 2.0 * spacing;
    for _ in 0..ROUNDS {
        let places: Vec<Vector<D>> = chosen.iter().map(|&n| sites[n].place).collect();
        let nearest = Nearest::new(&plan.mirrors, &places, reach);
        let gaps: Vec<f64> = (0..sites.len())
            .into_par_iter()
            .map(|n| {
                let same = |m: u32| !sites[n].is_across(&sites[chosen[m as usize]]);
                let found = nearest.find(&sites[n].place, reach, same);
                if free[n] {
                    found.map_or(reach, |found| found.1)
                } else {
                    0.0
                }
            })
            .collect();
        let mut have: BTreeMap<[i64; D], f64> = BTreeMap::new();
        for &n in chosen.iter() {
            *have.entry(block(n)).or_default() += plan.mirrors.share(&sites[n].place);
        }
        let before = chosen.len();
        let mut carry = 0.0;
        let mut touched = Touched::new(TOUCHED * spacing);
        for (key, (goal, members)) in &blocks {
            let have = have.get(key).copied().unwrap_or(0.0);
            carry += goal - have;
            let mut order = members.clone();
            order.sort_by(|&a, &b| gaps[b].total_cmp(&gaps[a]).then(a.cmp(&b)));
            let mut added: Vec<usize> = Vec::new();
            for n in order {
                if carry < 0.5 || gaps[n] < APART[usize::from(D > 2)] * spacing {
                    break;
                }
                // What is known of places beside it is out of date then.
                if touched.claim(&sites[n].place) {
                    added.push(n);
                    carry -= plan.mirrors.share(&sites[n].place);
                }
            }
            chosen.extend(added);
            carry = carry.clamp(-1.0, 1.0);
        }
        if chosen.len() == before {
            break;
        }
    }
}

/// Moves each particle to the middle of the sites nearest to it.
fn move_to_middles<const D: usize>(plan: &Plan<'_, D>, sites: &[Site<D>], seats: &mut [Seat<D>]) {
    let reach = 3.0 * COVERED * plan.options.spacing;
    let places: Vec<Vector<D>> = seats.iter().map(|seat| seat.place).collect();
    let nearest = Nearest::new(&plan.mirrors, &places, reach);
    let owners: Vec<Option<(u32, f64)>> = sites
        .par_iter()
        .map(|site| nearest.find(&site.place, reach, |n| !seats[n as usize].is_across(site)))
        .collect();
    let mut sums = vec![(Vector::<D>::zeros(), 0.0); seats.len()];
    for (site, owner) in sites.iter().zip(owners) {
        if let Some((n, _)) = owner {
            let sum = &mut sums[n as usize];
            sum.0 += site.area * site.place;
            sum.1 += site.area;
        }
    }
    seats
        .par_iter_mut()
        .zip(sums)
        .for_each(|(seat, (moment, area))| {
            if area > 0.0 {
                seat.move_to(plan, moment / area);
            }
        });
}
