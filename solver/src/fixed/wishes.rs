//! Where the flow wants points added or taken away.

use super::FixedSimulation;
use super::refine::Wish;

/// Change of the density across a face, over the smaller one, above which both cells are to be split.
const STEEP: f64 = 0.05;

/// Change below which a cell may join those it was split from.
const FLAT: f64 = 0.01;

impl<const D: usize> FixedSimulation<D> {
    /// What is to be done about each cell: shocks and expansions are split where the density changes by more than a twentieth
    /// from cell to cell, and joined where it changes by less than a hundredth.
    pub fn wishes(&self) -> Vec<Wish> {
        let mut steepest = vec![0.0_f64; self.points.len()];
        for face in self.net.blocks.iter().flat_map(|block| &block.faces) {
            let cells = [face.i as usize, face.j as usize];
            let [a, b] = cells.map(|i| self.states[i].density);
            let change = (a - b).abs() / a.min(b);
            for i in cells {
                steepest[i] = steepest[i].max(change);
            }
        }
        let wish = |change: f64| {
            if change > STEEP {
                Wish::Split
            } else if change < FLAT {
                Wish::Join
            } else {
                Wish::Keep
            }
        };
        steepest.into_iter().map(wish).collect()
    }
}
