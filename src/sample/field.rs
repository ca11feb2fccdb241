//! The gas on a lattice.

use aero_geometry::Vector;
use aero_geometry::parallel::prelude::*;

use super::gas::{Gas, State};
use super::lattice::Lattice;

/// The gas on a lattice at one time, first axis first; missing axes have one point.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Field {
    /// Lowest corner.
    pub origin: [f64; 3],
    /// Distance between points along each axis.
    pub spacing: [f64; 3],
    /// Cells along each axis.
    pub cells: [usize; 3],
    /// The gas; carried on a little way into bodies, undisturbed where none is near.
    pub states: Vec<State>,
    /// True of points in the gas.
    pub is_gas: Vec<bool>,
}

impl Field {
    /// The gas on `lattice`. Each point is found by itself: any number of threads finds the same bits.
    pub fn new<const D: usize>(gas: &Gas<'_, D>, lattice: &Lattice<D>) -> Self {
        let at = |number: usize| {
            let spot = gas.at(&lattice.place(number));
            let state = spot.state.unwrap_or(gas.stream());
            (state, spot.is_gas && spot.state.is_some())
        };
        let found: Vec<(State, bool)> = (0..lattice.count()).into_par_iter().map(at).collect();
        let pad = |vector: &Vector<D>, other: f64| {
            std::array::from_fn(|k| if k < D { vector[k] } else { other })
        };
        Self {
            origin: pad(&lattice.origin, 0.0),
            spacing: pad(&lattice.spacing, 1.0),
            cells: std::array::from_fn(|k| lattice.cells.get(k).copied().unwrap_or(0)),
            states: found.iter().map(|(state, _)| *state).collect(),
            is_gas: found.iter().map(|(_, is_gas)| *is_gas).collect(),
        }
    }

    /// True of each cell that has no corner in the gas.
    pub fn hidden_cells(&self) -> Vec<bool> {
        let [nx, ny, nz] = self.cells;
        let counts = [nx.max(1), ny.max(1), nz.max(1)];
        let ends = self.cells.map(|n| n.min(1));
        let cell = |number: usize| {
            let [x, y] = [number % counts[0], number / counts[0] % counts[1]];
            let z = number / (counts[0] * counts[1]);
            let mut corners = (0..8).map(|corner: usize| {
                let [i, j, k] = [corner & 1, corner >> 1 & 1, corner >> 2];
                let [i, j, k] = [x + i * ends[0], y + j * ends[1], z + k * ends[2]];
                self.is_gas[(k * (ny + 1) + j) * (nx + 1) + i]
            });
            !corners.any(|is_gas| is_gas)
        };
        (0..counts.iter().product()).map(cell).collect()
    }
}
