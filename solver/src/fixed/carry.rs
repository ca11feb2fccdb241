//! From the cells of one cloud to those of another: what each new cell gets of each old one, by the volume that they
//! share. Uniform gas stays uniform, and away from walls nothing is lost.

use std::sync::OnceLock;

use aero_geometry::Vector;
use aero_geometry::parallel::prelude::*;

use super::build::Builder;
use super::cloud::{Cloud, NOBODY};
use super::levels::{parent, parts};
use super::nearby::Nearby;
use super::plot::Plot;
use super::polytope::Polytope;
use super::solids::Line;
use super::state::Conserved;
use super::voronoi::{IN_BODY, Voronoi};
use super::whole::Whole;

/// Overlaps below this part of a cell are left out.
const LEAST: f64 = 1e-12;

/// Part by which what an old cell holds may be squeezed or thinned.
const ROOM: f64 = 0.02;

/// Part of an old cell in a new one: the old one's number, and the part of the *new* cell that it fills.
pub type Share = (u32, f64);

/// What each new cell is made of; the parts of each add up to one. `same` tells those that are whole old cells.
pub fn shares<const D: usize>(
    plot: &Plot<'_, D>,
    old: &Cloud<D>,
    new: &Cloud<D>,
    same: &[u32],
) -> Vec<Vec<Share>> {
    let positions = [old.positions(), new.positions()];
    let overlay = Overlay {
        plot,
        old,
        new,
        builders: [Builder::new(*plot, old), Builder::new(*plot, new)],
        voronoi: [
            Voronoi::new(*plot, old, &positions[0]),
            Voronoi::new(*plot, new, &positions[1]),
        ],
        nearby: Nearby::new(&positions[0]),
        planes: vec![OnceLock::new(); old.places.len()],
    };
    (0..new.places.len())
        .into_par_iter()
        .map(|number| {
            if same[number] != NOBODY {
                return vec![(same[number], 1.0)];
            }
            overlay
                .on_lattice(number)
                .unwrap_or_else(|| overlay.cut(number))
        })
        .collect()
}

struct Overlay<'a, const D: usize> {
    plot: &'a Plot<'a, D>,
    old: &'a Cloud<D>,
    new: &'a Cloud<D>,
    builders: [Builder<'a, D>; 2],
    voronoi: [Voronoi<'a, D>; 2],
    nearby: Nearby<'a, D>,
    /// The planes around old cells, from their points, once they are asked for.
    planes: Vec<OnceLock<Vec<(Vector<D>, f64)>>>,
}

impl<const D: usize> Overlay<'_, D> {
    /// The shares where both clouds are a lattice: the same cell, the one that it is a part of, or its parts.
    fn on_lattice(&self, number: usize) -> Option<Vec<Share>> {
        let site = self.new.places[number].site?;
        let [before, after] = &self.builders;
        if !after.is_plain(number) {
            return None;
        }
        if let Some(same) = self.old.at(&site) {
            return before.is_plain(same).then(|| vec![(same as u32, 1.0)]);
        }
        let mut whole = site;
        while whole.level > 0 {
            whole = parent(&whole);
            if let Some(whole) = self.old.at(&whole) {
                return before.is_plain(whole).then(|| vec![(whole as u32, 1.0)]);
            }
        }
        let mut shares = Vec::new();
        for part in parts(&site) {
            let part = self.old.at(&part).filter(|&part| before.is_plain(part))?;
            let [low, high] = before.block(part);
            shares.push((part as u32, (high - low).product()));
        }
        Some(normalised(shares))
    }

    /// The shares of any cell: what the planes around each old point leave of it.
    fn cut(&self, number: usize) -> Vec<Share> {
        let place = &self.new.places[number];
        let (cell, _) = self.voronoi[1].cell(number);
        let reach = cell.reach_squared().sqrt();
        // The new point lies in the old cell of the nearest old point, and cells beside that are at most twice as wide.
        let home = self.nearby.nearest(&place.position, place.spacing);
        let old = home.map_or(place.spacing, |home| self.old.places[home as usize].spacing);
        let radius = reach + 2.0 * (D as f64).sqrt() * old.max(place.spacing);
        let mut near = Vec::new();
        self.nearby.within(&place.position, radius, &mut near);
        near.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let mut shares = Vec::new();
        for &(_, other) in &near {
            let line = Line {
                from: place.position,
                to: self.old.places[other as usize].position,
                unit: place.spacing,
            };
            if !self.plot.solids.sees(&line) {
                continue;
            }
            let volume = self.common(number, &cell, other as usize);
            if volume > LEAST * place.spacing.powi(D as i32) {
                shares.push((other, volume));
            }
        }
        if shares.is_empty() {
            let nearest = near.first().map_or(0, |&(_, other)| other);
            return vec![(nearest, 1.0)];
        }
        normalised(shares)
    }

    /// The planes half way to the neighbours of an old point.
    fn planes_around(&self, other: usize) -> Vec<(Vector<D>, f64)> {
        let (cell, links) = self.voronoi[0].cell(other);
        let links = cell.facets.iter().filter_map(|facet| {
            let number = (facet.label as usize).checked_sub(2 * D)?;
            links.get(number)
        });
        links
            .map(|link| {
                let distance = link.apart.norm();
                (link.apart / distance, 0.5 * distance)
            })
            .collect()
    }

    /// Volume of the gas that a new cell and an old one have in common.
    fn common(&self, number: usize, cell: &Polytope<D>, other: usize) -> f64 {
        let place = &self.new.places[number];
        let shift = self.old.places[other].position - place.position;
        let mut common = cell.clone();
        for (normal, offset) in self.planes[other].get_or_init(|| self.planes_around(other)) {
            common.clip(normal, offset + normal.dot(&shift), IN_BODY, place.spacing);
            if common.facets.is_empty() {
                return 0.0;
            }
        }
        let whole = Whole {
            cell: &common,
            point: &place.position,
            unit: place.spacing,
            about_axis: self.plot.domain.is_axisymmetric(),
            keeps_rings: false,
        };
        let parts = whole.parts(self.plot.solids);
        parts.iter().map(|part| part.volume).sum()
    }
}

fn normalised(mut shares: Vec<Share>) -> Vec<Share> {
    let total: f64 = shares.iter().map(|share| share.1).sum();
    for share in &mut shares {
        share.1 /= total;
    }
    shares
}

/// What new cells hold per volume when nothing is lost: each old cell hands out all that it holds to those that overlap it, by the
/// volume that they take of it.
///
/// `volumes` are those of old and new cells. Walls are bent, and old and new cells divide the gas next to them a little differently; what an
/// old cell's takers have more or less room for than it had is theirs, by up to a fiftieth. What is then left over is spread over
/// all cells that are new, by their masses.
pub fn carried<const D: usize>(
    held: &[Conserved<D>],
    volumes: [&[f64]; 2],
    shares: &[Vec<Share>],
) -> Vec<Conserved<D>> {
    let [before, after] = volumes;
    let mut taken = vec![0.0; before.len()];
    for (shares, volume) in shares.iter().zip(after) {
        for &(old, part) in shares {
            taken[old as usize] += part * volume;
        }
    }
    // The old cell that a new one is, of which nobody else has a part.
    let same = |shares: &[Share], volume: f64| match shares[..] {
        [(old, _)] => {
            let old = old as usize;
            (taken[old] == before[old] && volume == before[old]).then_some(old)
        }
        _ => None,
    };
    let mut is_same = vec![false; before.len()];
    let mut lost = Conserved::ZERO;
    let mut mass = 0.0;
    let mut carried = Vec::with_capacity(shares.len());
    for (shares, volume) in shares.iter().zip(after) {
        if let Some(old) = same(shares, *volume) {
            is_same[old] = true;
            carried.push(held[old]);
            continue;
        }
        let mut sum = Conserved::ZERO;
        for &(old, part) in shares {
            let old = old as usize;
            let fit = (before[old] / taken[old]).clamp(1.0 - ROOM, 1.0 + ROOM);
            sum = sum.plus(part * fit, &held[old]);
        }
        lost = lost.plus(-volume, &sum);
        mass += volume * sum.mass;
        carried.push(sum);
    }
    for ((held, volume), is_same) in held.iter().zip(before).zip(is_same) {
        if !is_same {
            lost = lost.plus(*volume, held);
        }
    }
    for ((carried, shares), volume) in carried.iter_mut().zip(shares).zip(after) {
        if same(shares, *volume).is_none() {
            *carried = carried.plus(carried.mass / mass, &lost);
        }
    }
    carried
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The takers of one cell have a tenth more room than it had, that of another a fifth less; a third cell stays as it is.
    #[test]
    fn what_new_cells_have_no_room_for_is_spread_over_them() {
        let gas = |mass: f64| Conserved::<2> {
            mass,
            momentum: [0.5 * mass, -mass],
            energy: 3.0 * mass,
        };
        let (held, before) = ([gas(1.0), gas(2.0), gas(5.0)], [1.0; 3]);
        let shares = [0, 0, 1, 2].map(|old| vec![(old, 1.0)]);
        let after = [0.5, 0.6, 0.8, 1.0];
        let carried = carried(&held, [&before, &after], &shares);
        let total = |held: &[Conserved<2>], volumes: &[f64]| {
            let add =
                |sum: Conserved<2>, (held, volume): (&Conserved<2>, &f64)| sum.plus(*volume, held);
            held.iter().zip(volumes).fold(Conserved::ZERO, add)
        };
        let lost = total(&held, &before).plus(-1.0, &total(&carried, &after));
        assert!(lost.mass.abs() < 1e-14, "{lost:?}");
        assert!(lost.momentum.iter().all(|m| m.abs() < 1e-14), "{lost:?}");
        assert!(lost.energy.abs() < 1e-13, "{lost:?}");
        assert_eq!(carried[3].mass, 5.0);
        // By its own room each would be off by less than a fiftieth before the rest is spread.
        let dense = carried[2].mass / carried[0].mass;
        assert!((dense / (2.0 * 1.02 / 0.98) - 1.0).abs() < 1e-14, "{dense}");
    }
}
