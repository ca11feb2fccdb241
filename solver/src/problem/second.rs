//! A second gas in the flow.

use std::sync::Arc;

use aero_geometry::Vector;

use crate::gas::Gas;

/// A gas that lies beside that of the free stream at the start and does not mix with it; of particles, which keep what they are made of.
#[derive(Clone)]
pub struct SecondGas<const D: usize> {
    /// The gas, an ideal one.
    pub gas: Gas,
    /// True where it is at the start.
    pub fills: Arc<dyn Fn(&Vector<D>) -> bool + Send + Sync>,
    /// Its density at the start, in place of what the flow has there.
    pub density: Option<f64>,
}

impl<const D: usize> std::fmt::Debug for SecondGas<D> {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter
            .debug_struct("SecondGas")
            .field("gas", &self.gas)
            .field("density", &self.density)
            .finish_non_exhaustive()
    }
}
