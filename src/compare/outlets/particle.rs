//! A particle of the gas or of a side's buffer.

use aero_geometry::Vector;

/// Steps of the time average [Negi et al. 2020, section 3.4].
const STEPS: usize = 6;

/// A particle: where it is, its state, and what treatments keep of it.
#[derive(Clone, Copy, Debug)]
pub struct Particle {
    /// m.
    pub position: Vector<2>,
    /// Pressure above that of the stream, Pa, and velocity, m/s.
    pub state: [f64; 3],
    /// Pressures and speeds along the duct of the last steps in which no sound was heard.
    past: [[f64; 2]; STEPS],
    /// The wave that it hears beyond the outlet, Pa, and whether gas is in its reach.
    pub wave: (f64, bool),
}

impl Particle {
    /// One that has always been in this state.
    pub fn new(position: Vector<2>, state: [f64; 3]) -> Self {
        Self {
            position,
            state,
            past: [[state[0], state[1]]; STEPS],
            wave: (0.0, false),
        }
    }

    /// Takes its pressure and speed into the average.
    pub fn remember(&mut self) {
        self.past.rotate_right(1);
        self.past[0] = [self.state[0], self.state[1]];
    }

    /// Mean pressure and speed of the last steps [eq 28].
    pub fn mean(&self) -> [f64; 2] {
        [0, 1].map(|k| self.past.iter().map(|now| now[k]).sum::<f64>() / STEPS as f64)
    }
}
