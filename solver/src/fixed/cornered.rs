//! Cells in space whose faces do not say what they look like: those in which surfaces meet, or that took a piece of another.

use std::collections::HashSet;

use aero_geometry::Vector;
use aero_geometry::parallel::prelude::*;

use super::build::Builder;
use super::cells::Rings;
use super::cut_cell::CutCell;
use super::merge::Target;
use super::voronoi::Voronoi;

impl<const D: usize> Builder<'_, D> {
    /// The pieces, among those of cells that were `cut`, of such cells, `targets` being the owners of them all; in the plane none. They are cut once more:
    /// of all others it need not be kept what bounds them.
    pub fn cornered(
        &self,
        positions: &[Vector<D>],
        cut: &[CutCell<D>],
        targets: &[Vec<Option<Target<D>>>],
    ) -> Rings<D> {
        if D < 3 {
            return Rings::new();
        }
        let mut cells: HashSet<u32> = HashSet::new();
        for (cell, targets) in cut.iter().zip(targets) {
            for (part, target) in cell.parts.iter().zip(targets) {
                let is_meant =
                    |target: &&Target<D>| target.cell != cell.number || part.walls.len() > 1;
                cells.extend(target.iter().filter(is_meant).map(|target| target.cell));
            }
        }
        if cells.is_empty() {
            return Rings::new();
        }
        let voronoi = Voronoi::new(self.plot, self.cloud, positions);
        let is_owner = |target: &Option<Target<D>>| {
            target
                .as_ref()
                .is_some_and(|target| cells.contains(&target.cell))
        };
        let wanted: Vec<usize> = (0..cut.len())
            .filter(|&k| targets[k].iter().any(is_owner))
            .collect();
        let again = wanted.par_iter().map(|&k| {
            let cell = self.cut_with(&voronoi, cut[k].number as usize, true);
            let owned = cell.parts.into_iter().zip(&targets[k]);
            let owned = owned.filter(|(_, target)| is_owner(target));
            let seen = owned.filter_map(|(part, target)| {
                let target = target.as_ref()?;
                let rings = part.rings.iter();
                let rings =
                    rings.map(|ring| ring.iter().map(|place| place - target.offset).collect());
                Some((target.cell, rings.collect()))
            });
            seen.collect::<Rings<D>>()
        });
        let mut rings: Rings<D> = again.collect::<Vec<_>>().into_iter().flatten().collect();
        rings.sort_by_key(|(cell, _)| *cell);
        rings
    }
}
