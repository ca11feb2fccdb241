//! Cells of a cloud that differs from an earlier one in places: those that no change touches are taken over.

use aero_geometry::Vector;
use aero_geometry::parallel::prelude::*;

use super::build::{Builder, Built};
use super::cloud::{Cloud, NOBODY, Place};
use super::cut_cell::CutCell;
use super::nearby::Nearby;
use super::plot::Plot;
use super::voronoi::{Voronoi, shifts};

/// The same with the cells that were cut `before`, of another cloud, taken over where no point near them came or went.
pub fn rebuilt<const D: usize>(
    plot: &Plot<'_, D>,
    cloud: &Cloud<D>,
    earlier: &Cloud<D>,
    before: Vec<CutCell<D>>,
) -> Built<D> {
    let builders = [earlier, cloud].map(|cloud| Builder::new(*plot, cloud));
    let positions = cloud.positions();
    let (cut, same) = builders[1].cut_again(&positions, &builders[0], before);
    let [_, builder] = builders;
    let cells = builder.assemble(positions, &cut);
    Built { cells, cut, same }
}

impl<const D: usize> Builder<'_, D> {
    /// The cells that are not plain, in order, and which cell of the earlier cloud each cell of this one is the same as.
    ///
    /// A cell is decided by the points within its reach, across periodic sides too: where none of them came or went it is the same, to the last bit.
    fn cut_again(
        &self,
        positions: &[Vector<D>],
        earlier: &Self,
        before: Vec<CutCell<D>>,
    ) -> (Vec<CutCell<D>>, Vec<u32>) {
        let [old, new] = [earlier.cloud, self.cloud].map(|cloud| &cloud.places);
        let at = |cloud: &Cloud<D>, place: &Place<D>| {
            place
                .site
                .and_then(|site| cloud.at(&site))
                .filter(|&found| cloud.places[found].position == place.position)
                .map_or(NOBODY, |found| found as u32)
        };
        let origin: Vec<u32> = new
            .par_iter()
            .map(|place| at(earlier.cloud, place))
            .collect();
        let renumbered: Vec<u32> = old.par_iter().map(|place| at(self.cloud, place)).collect();
        let gone = old
            .iter()
            .zip(&renumbered)
            .filter(|(_, now)| **now == NOBODY);
        let come = new.iter().zip(&origin).filter(|(_, then)| **then == NOBODY);
        let gone = gone.map(|(place, _)| place.position);
        let changed: Vec<Vector<D>> = gone.chain(come.map(|(place, _)| place.position)).collect();
        let nearby = Nearby::new(&changed);
        let shifts = shifts(self.plot.domain);
        let mut place_of = vec![NOBODY; old.len()];
        for (k, cell) in before.iter().enumerate() {
            place_of[cell.number as usize] = k as u32;
        }
        let mut before: Vec<Option<CutCell<D>>> = before.into_iter().map(Some).collect();
        let mut kept: Vec<Option<CutCell<D>>> = Vec::new();
        let mut same = vec![NOBODY; new.len()];
        let mut near = Vec::new();
        for number in 0..new.len() {
            let then = origin[number];
            if self.is_plain[number] {
                if then != NOBODY && earlier.is_plain[then as usize] {
                    same[number] = then;
                }
                continue;
            }
            let known = place_of
                .get(then as usize)
                .and_then(|&k| before.get(k as usize))
                .and_then(Option::as_ref);
            near.clear();
            if let Some(known) = known {
                for shift in &shifts {
                    let place = positions[number] - shift;
                    nearby.within(&place, known.reach * (1.0 + 1e-6), &mut near);
                }
            }
            if known.is_none() || !near.is_empty() {
                kept.push(None);
                continue;
            }
            let mut cell = before[place_of[then as usize] as usize].take();
            if let Some(cell) = &mut cell {
                cell.number = number as u32;
                for link in &mut cell.links {
                    link.to = renumbered[link.to as usize];
                }
                same[number] = then;
            }
            kept.push(cell);
        }
        let voronoi = Voronoi::new(self.plot, self.cloud, positions);
        let numbers = (0..new.len()).filter(|&number| !self.is_plain[number]);
        let numbers: Vec<usize> = numbers.collect();
        let cut = kept
            .into_par_iter()
            .zip(numbers)
            .map(|(known, number)| known.unwrap_or_else(|| self.cut_cell(&voronoi, number)))
            .collect();
        (cut, same)
    }
}
