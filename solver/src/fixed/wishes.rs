//! Where the flow wants points added or taken away.

use super::FixedSimulation;
use super::refine::Wish;

/// Change of the density across a face, over the smaller one, above which both cells are to be split.
const STEEP: f64 = 0.05;

/// Change below which a cell may join those it was split from.
const FLAT: f64 = 0.01;

impl<const D: usize> FixedSimulation<D> {
    /// Largest change of the density across a face of each cell, over the smaller one.
    pub fn changes(&self) -> Vec<f64> {
        let mut steepest = vec![0.0_f64; self.points.len()];
        for (block, rest) in self.net.blocks.iter().zip(&self.quiet.blocks) {
            if !rest.is_awake {
                continue;
            }
            for face in &block.faces {
                let cells = [face.i as usize, face.j as usize];
                let [a, b] = cells.map(|i| self.states[i].density);
                let change = (a - b).abs() / a.min(b);
                for i in cells {
                    steepest[i] = steepest[i].max(change);
                }
            }
        }
        steepest
    }
}

/// What is to be done about each cell: shocks and expansions are split where the density changes by more than a twentieth from cell
/// to cell, and joined where it changes by less than a hundredth; by so much more where points are `dearer`.
pub fn wishes(changes: &[f64], dearer: f64) -> Vec<Wish> {
    let wish = |&change: &f64| {
        if change > STEEP * dearer {
            Wish::Split
        } else if change < FLAT * dearer {
            Wish::Join
        } else {
            Wish::Keep
        }
    };
    changes.iter().map(wish).collect()
}
