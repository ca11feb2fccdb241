//! Ghosts of the tested wall take their state, and gas at the wall that of its neighbours where a treatment asks for it.

use aero_geometry::Vector;
use aero_geometry::kernel::QuinticSpline;

use super::arrangement::Ghost;
use super::equations::{SOUND, stiffness};
use super::solution::{Condition, Exact, Solution};
use super::treatment::Rule;
use crate::points::cloud::Cloud;
use crate::points::weights::Weights;

/// A ghost, how it follows from the gas, and the solution at the wall.
pub struct Treated {
    pub ghost: Ghost,
    pub rule: Rule,
    /// At its foot, at the time zero.
    pub wall: Exact,
}

/// The solution now.
#[derive(Clone, Copy)]
pub struct Now {
    pub solution: Solution,
    /// What is left of it.
    pub left: f64,
}

impl Treated {
    /// Gives the ghost its `state`, what is not treated from the `exact` one; returns the rate of the pressure that is its own.
    pub fn fill(&self, gas: &[[f64; 3]], state: &mut [f64; 3], exact: [f64; 3], now: Now) -> f64 {
        match &self.rule {
            Rule::Wall(factor) => {
                let velocity = *factor * self.wall_velocity(now);
                *state = [exact[0], velocity.x, velocity.y];
                0.0
            }
            Rule::Reads {
                weights,
                rise,
                factor,
            } => {
                let sum = |k: usize| -> f64 {
                    weights.iter().map(|(j, w)| w * gas[*j as usize][k]).sum()
                };
                *state = exact;
                if now.solution.condition == Condition::Neumann {
                    state[0] = sum(0) + rise * self.slope(0, now);
                } else {
                    let read = Vector::<2>::new(sum(1), sum(2));
                    let velocity = self.beyond(read, *factor, now);
                    state[1..].copy_from_slice(velocity.as_slice());
                }
                0.0
            }
            Rule::Evolves { weights, own } => {
                state[1..].copy_from_slice(&exact[1..]);
                self.rate((weights, *own), gas, state, now)
            }
        }
    }

    /// Velocity beyond the wall of what was `read` on this side.
    fn beyond(&self, read: Vector<2>, factor: f64, now: Now) -> Vector<2> {
        let normal = self.ghost.normal;
        let wall = self.wall_velocity(now);
        let relative = read - wall;
        if now.solution.condition == Condition::Slip {
            read - (1.0 + factor) * relative.dot(&normal) * normal
        } else {
            wall - factor * relative
        }
    }

    /// `c (dp/dn - dp/dn|wall) - rho c^2 du_n/dn + S`, with slopes `sum w_j q_j + own q`; `S` is what the solution lacks of it.
    fn rate(
        &self,
        (weights, own): (&Weights, f64),
        gas: &[[f64; 3]],
        state: &[f64; 3],
        now: Now,
    ) -> f64 {
        let normal = self.ghost.normal;
        let across = |state: &[f64; 3]| state[1] * normal.x + state[2] * normal.y;
        let (mut pressed, mut stretched) = (own * state[0], own * across(state));
        for (j, w) in weights {
            let state = &gas[*j as usize];
            pressed += w * state[0];
            stretched += w * across(state);
        }
        let pressure = now.left * self.wall.value[0];
        let stretch = normal.x * self.slope(1, now) + normal.y * self.slope(2, now);
        let source = stiffness(pressure) * stretch - now.solution.decay() * pressure;
        SOUND * (pressed - self.slope(0, now)) - stiffness(state[0]) * stretched + source
    }

    /// Of the solution at the wall, along the normal into the gas.
    fn slope(&self, quantity: usize, now: Now) -> f64 {
        let [x, y] = self.wall.gradient[quantity];
        now.left * (x * self.ghost.normal.x + y * self.ghost.normal.y)
    }

    fn wall_velocity(&self, now: Now) -> Vector<2> {
        now.left * Vector::<2>::new(self.wall.value[1], self.wall.value[2])
    }
}

/// A particle of the gas whose velocity its neighbours and the wall make.
pub struct Overridden {
    pub particle: usize,
    weights: Vec<(usize, f64)>,
    /// Velocity of the wall at the time zero.
    wall: [f64; 2],
}

impl Overridden {
    /// The particles of the gas, `gas` in number, nearer than a smoothing length to a ghost from number `first` on, with the weights of
    /// `sum_gas W omega_j / (1 - sum_ghosts W omega_j)`.
    pub fn all(
        cloud: &Cloud,
        volume: &[f64],
        gas: usize,
        first: usize,
        solution: Solution,
    ) -> Vec<Self> {
        let mut row = Vec::new();
        for (particle, place) in cloud.points[..gas].iter().enumerate() {
            let (mut behind, mut nearest) = (0.0, f64::INFINITY);
            let mut weights = Vec::new();
            cloud.near(place, |j, arm| {
                let weight = QuinticSpline::<2>::value(arm.norm(), cloud.smoothing) * volume[j];
                if j < gas {
                    weights.push((j, weight));
                } else if j >= first {
                    behind += weight;
                    nearest = arm.norm().min(nearest);
                }
            });
            if nearest < cloud.smoothing {
                for (_, weight) in &mut weights {
                    *weight /= 1.0 - behind;
                }
                let (height, normal) = solution.form.height(place);
                let [_, u, v] = solution.at(&(place - height * normal)).value;
                row.push(Self {
                    particle,
                    weights,
                    wall: [u, v],
                });
            }
        }
        row
    }

    /// `u_w + sum w_j (u_j - u_w)`.
    pub fn velocity(&self, fields: &[[f64; 3]], now: Now) -> [f64; 2] {
        std::array::from_fn(|k| {
            let wall = now.left * self.wall[k];
            let sum = self.weights.iter();
            wall + sum
                .map(|(j, w)| w * (fields[*j][k + 1] - wall))
                .sum::<f64>()
        })
    }
}
