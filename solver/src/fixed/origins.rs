//! From which cells new ones take a state, where only that matters and not how much there is of it.

use aero_geometry::parallel::prelude::*;

use super::carry::Share;
use super::cloud::{Cloud, Place};
use super::levels::{parent, parts};
use super::nearby::Nearby;
use super::plot::Plot;
use super::solids::Line;

/// Where the gas of each new cell comes from if only its state matters: the same cell, the one that it is a part of, or its parts, and
/// where there is none of them the nearest that it sees. All shares of a cell are alike.
pub fn origins<const D: usize>(plot: &Plot<'_, D>, [old, new]: [&Cloud<D>; 2]) -> Vec<Vec<Share>> {
    let positions = old.positions();
    let nearby = Nearby::new(&positions);
    let origin = |place: &Place<D>| {
        if let Some(site) = place.site {
            let mut known = site;
            loop {
                if let Some(there) = old.at(&known) {
                    return vec![(there as u32, 1.0)];
                }
                if known.level == 0 {
                    break;
                }
                known = parent(&known);
            }
            let found: Vec<Share> = parts(&site)
                .filter_map(|part| old.at(&part).map(|there| (there as u32, 1.0)))
                .collect();
            if !found.is_empty() {
                return found;
            }
        }
        vec![(nearest(plot, old, &nearby, place), 1.0)]
    };
    new.places.par_iter().map(origin).collect()
}

/// The nearest point that a place sees, or the nearest one.
fn nearest<const D: usize>(
    plot: &Plot<'_, D>,
    cloud: &Cloud<D>,
    nearby: &Nearby<'_, D>,
    place: &Place<D>,
) -> u32 {
    let far = plot.domain.bounds.size().norm();
    let mut radius = 2.0 * place.spacing;
    let mut near = Vec::new();
    loop {
        near.clear();
        nearby.within(&place.position, radius, &mut near);
        near.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let is_seen = |&&(_, other): &&(f64, u32)| {
            plot.solids.sees(&Line {
                from: place.position,
                to: cloud.places[other as usize].position,
                unit: place.spacing,
            })
        };
        if let Some(&(_, other)) = near.iter().find(is_seen) {
            return other;
        }
        if radius > far {
            return near.first().map_or(0, |&(_, other)| other);
        }
        radius *= 2.0;
    }
}
