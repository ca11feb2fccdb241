//! What is known of each cell.

use super::net::Net;
use super::slopes::Slopes;
use super::state::{Conserved, Primitive};
use super::viscous::WallShare;

/// A value per cell of each kind, and per wall of each block.
#[derive(Debug)]
pub(super) struct Columns<const D: usize> {
    /// What cells hold per volume.
    pub held: Vec<Conserved<D>>,
    /// What they held at the start of the step.
    pub before: Vec<Conserved<D>>,
    /// The same as density, velocity and pressure.
    pub states: Vec<Primitive<D>>,
    /// How they change within a cell.
    pub slopes: Vec<Slopes<D>>,
    /// Cells that this step takes in first order.
    pub careful: Vec<u32>,
    /// Pressure on each wall of each block at the last evaluation.
    pub pressures: Vec<Vec<f64>>,
    /// Viscosity of each cell; none of gas without.
    pub viscosities: Vec<f64>,
    /// What each wall of each block did to viscous gas at the last evaluation; nothing is there of other gas.
    pub shares: Vec<Vec<WallShare<D>>>,
}

impl<const D: usize> Columns<D> {
    /// Of cells that hold this, without slopes, with the same pressure on all walls.
    pub fn new(
        held: Vec<Conserved<D>>,
        states: Vec<Primitive<D>>,
        net: &Net<D>,
        pressure: f64,
        is_viscous: bool,
    ) -> Self {
        let walls = net.blocks.iter().map(|block| block.walls.len());
        let nothing = |count: usize| vec![WallShare::NONE; if is_viscous { count } else { 0 }];
        let shares = walls.clone().map(nothing).collect();
        Self {
            before: held.clone(),
            slopes: vec![Slopes::LEVEL; states.len()],
            careful: Vec::new(),
            pressures: walls.map(|count| vec![pressure; count]).collect(),
            viscosities: Vec::new(),
            shares,
            held,
            states,
        }
    }
}
