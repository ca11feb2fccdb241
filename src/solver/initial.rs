//! The gas at the start.

use aero_geometry::Vector;

use crate::case::{Case, Initial, State};

impl<const D: usize> Case<D> {
    /// State of the gas at `position` and time zero.
    pub fn initial_state(&self, position: &Vector<D>) -> State<D> {
        match &self.initial {
            Initial::FreeStream => self.free_stream,
            Initial::Field(field) => field.0(position),
            Initial::Riemann {
                left,
                right,
                position: diaphragm,
                smooth,
            } => {
                let distance = position[0] - diaphragm;
                let share = if *smooth {
                    // Villodi & Ramachandran 2024, eq. 38.
                    1.0 / (1.0 + (2.0 * distance / (3.0 * self.spacing)).exp())
                } else if distance < 0.0 {
                    1.0
                } else {
                    0.0
                };
                State {
                    density: right.density + share * (left.density - right.density),
                    velocity: right.velocity + (left.velocity - right.velocity) * share,
                    pressure: right.pressure + share * (left.pressure - right.pressure),
                }
            }
        }
    }
}
