//! The gas at the start.

use aero_geometry::Vector;

use crate::problem::{Earlier, Initial, Problem, State};

impl<const D: usize> Problem<D> {
    /// State of the gas at `position` and time zero; none in a vacuum, where the density is zero.
    ///
    /// # Errors
    /// Where the state is none of a gas.
    pub fn initial_state(&self, position: &Vector<D>) -> Result<Option<State<D>>, String> {
        let mut state = self.state_at_start(position);
        if let Some(second) = &self.second
            && let Some(density) = second.density
            && (second.fills)(position)
        {
            state.density = density;
        }
        let fail = |what: &str, value: f64| {
            let place: Vec<String> = position.iter().map(|x| format!("{x:.6}")).collect();
            let place = place.join(", ");
            Err(format!(
                "the {what} at the start is {value} at ({place}); check `initial`"
            ))
        };
        if state.density == 0.0 {
            return Ok(None);
        }
        if !(state.density > 0.0 && state.density.is_finite()) {
            return fail("density", state.density);
        }
        if !(state.pressure > self.gas.least_pressure() && state.pressure.is_finite()) {
            return fail("pressure", state.pressure);
        }
        match state.velocity.iter().find(|u| !u.is_finite()) {
            Some(&u) => fail("velocity", u),
            None => Ok(Some(state)),
        }
    }

    fn state_at_start(&self, position: &Vector<D>) -> State<D> {
        match &self.initial {
            Initial::FreeStream => self.free_stream,
            Initial::Field(field) | Initial::Earlier(Earlier { field, .. }) => field.0(position),
            Initial::Riemann {
                left,
                right,
                position: diaphragm,
                smooth,
            } => {
                let distance = position[0] - diaphragm;
                let share = if *smooth {
                    // Villodi & Ramachandran 2024, eq. 38.
                    1.0 / (1.0 + (2.0 * distance / (3.0 * self.resolution.at(position))).exp())
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
