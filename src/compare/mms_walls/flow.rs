//! Weakly compressible gas beside a wall, kept to a solution by sources: particles stay where they are, so that their arrangement is what it
//! is called.

use aero_geometry::Vector;
use aero_geometry::kernel::QuinticSpline;
use rayon::prelude::*;

use super::arrangement::{Cloud, Ghost, Places};
use super::operators::{Fields, Gradient, Gradients, volumes};
use super::solution::{Condition, Exact, Family, Solution};
use super::treatment::{Mistake, Rule, Treatment};

/// Speed of sound, m/s, density where the pressure is zero, kg/m^3 [section II], and viscosity, m^2/s, of which the paper says nothing.
const SOUND: f64 = 20.0;
const DENSITY: f64 = 1.0;
const VISCOSITY: f64 = 0.01;
/// Time that passes: 100 of the paper's steps, s [eq 6], which are those of its finest spacing.
const TIME: f64 = 100.0 * 0.00012;
const STEPS: usize = 100;
/// How often errors are taken.
const SNAPSHOTS: usize = 5;
/// Courant number of our own solutions' steps, by the smoothing length.
const COURANT: f64 = 0.7;
/// Largest speed of them all, m/s.
const SPEED: f64 = 3.0;

/// What is run.
#[derive(Clone, Copy)]
pub struct Trial<'a> {
    pub solution: Solution,
    /// None for ghosts that take the solution.
    pub treatment: Option<&'a dyn Treatment>,
    pub mistake: Option<Mistake>,
}

/// What became of it.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// Mean errors over the gas and over time [eq 21]: of the pressure, Pa, and of the velocity, m/s.
    pub errors: [f64; 2],
    /// The gas at the end.
    gas: Fields,
}

impl Outcome {
    /// Mean difference between two at the end, of pressure and velocity: what a treatment adds to the error where the other has ghosts that take
    /// the solution.
    pub fn beside(&self, other: &Self) -> [f64; 2] {
        mean_difference(self.gas.iter().copied().zip(other.gas.iter().copied()))
    }
}

/// A ghost, how it follows from the gas, and the solution at the wall.
struct Treated {
    ghost: Ghost,
    rule: Rule,
    /// Of the solution at its foot, at the time zero.
    wall: Exact,
}

/// A particle of the gas whose velocity its neighbours make.
struct Overridden {
    particle: usize,
    /// Of the gas.
    weights: Vec<(usize, f64)>,
    /// Velocity of the wall at the time zero.
    wall: [f64; 2],
}

/// The gas and all that it needs.
struct Flow {
    solution: Solution,
    gas: usize,
    treated: Vec<Treated>,
    overridden: Vec<Overridden>,
    gradient: Gradient,
    /// The solution at all points, at the time zero.
    exact: Vec<Exact>,
}

impl Trial<'_> {
    /// Runs it about particles that lie so.
    pub fn run(&self, places: &Places) -> Outcome {
        let steps = match self.solution.family {
            Family::Published => STEPS,
            Family::Sheared => {
                let step = COURANT * places.smoothing() / (SOUND + SPEED);
                (TIME / step / SNAPSHOTS as f64).ceil() as usize * SNAPSHOTS
            }
        };
        Flow::new(self, places).run(steps)
    }
}

impl Flow {
    fn new(trial: &Trial<'_>, places: &Places) -> Self {
        let solution = trial.solution;
        let gas = Cloud::new(places.gas.clone(), places.smoothing());
        let mut points = places.gas.clone();
        points.extend(&places.given);
        let mut treated = Vec::new();
        match trial.treatment {
            None => points.extend(places.tested.iter().map(|ghost| ghost.position)),
            Some(treatment) => {
                for ghost in places.ghosts(treatment.layers()) {
                    let Some(mut rule) = treatment.rule(solution.condition, &gas, &ghost) else {
                        continue;
                    };
                    if let Some(mistake) = trial.mistake {
                        rule = rule.mistaken(mistake);
                    }
                    points.push(ghost.position);
                    let wall = solution.at(&ghost.foot);
                    treated.push(Treated { ghost, rule, wall });
                }
            }
        }
        let cloud = Cloud::new(points, places.smoothing());
        let volume = volumes(&cloud);
        let overrides = trial.treatment.is_some_and(Treatment::overrides_gas);
        let overridden = if overrides {
            row_at_wall(&cloud, &volume, &places.gas, places.given.len(), solution)
        } else {
            Vec::new()
        };
        let count = if solution.condition == Condition::NoSlip {
            cloud.points.len()
        } else {
            places.gas.len()
        };
        Self {
            solution,
            gas: places.gas.len(),
            treated,
            overridden,
            gradient: Gradient::new(&cloud, &volume, count),
            exact: cloud
                .points
                .par_iter()
                .map(|place| solution.at(place))
                .collect(),
        }
    }

    /// What is left of the solution.
    fn left(&self, time: f64) -> f64 {
        (-self.solution.decay() * time).exp()
    }

    fn run(&self, steps: usize) -> Outcome {
        let mut fields: Fields = self.exact.iter().map(|exact| exact.value).collect();
        let step = TIME / steps as f64;
        let mut sum = [0.0; 2];
        for done in 0..steps {
            let time = done as f64 * step;
            let first = self.rates(&mut fields, time);
            let mut middle = fields.clone();
            advance(&mut middle, &first, 0.5 * step);
            let second = self.rates(&mut middle, time + 0.5 * step);
            advance(&mut fields, &second, step);
            if (done + 1) % (steps / SNAPSHOTS) == 0 {
                let errors = self.errors(&fields, time + step);
                sum = [0, 1].map(|k| sum[k] + errors[k] / SNAPSHOTS as f64);
            }
        }
        fields.truncate(self.gas);
        Outcome {
            errors: sum,
            gas: fields,
        }
    }

    fn errors(&self, fields: &Fields, time: f64) -> [f64; 2] {
        let left = self.left(time);
        let exact = self.exact.iter().map(|exact| exact.value.map(|v| left * v));
        mean_difference(fields[..self.gas].iter().copied().zip(exact))
    }

    /// Shows the walls the gas and returns the rates of the gas, and of ghosts that have a pressure of their own.
    fn rates(&self, fields: &mut Fields, time: f64) -> Fields {
        let left = self.left(time);
        self.override_gas(fields, left);
        let slopes = self.fill(fields, left);
        let gradients = self.gradient.of(fields);
        let mut rates: Fields = (0..self.gas)
            .into_par_iter()
            .map(|i| self.rate(i, fields, &gradients, left))
            .collect();
        rates.resize(fields.len(), [0.0; 3]);
        let first = fields.len() - self.treated.len();
        for (k, slope) in slopes.into_iter().enumerate() {
            rates[first + k][0] = slope;
        }
        rates
    }

    /// `dp/dt = -rho c^2 div u - u.grad p + S`, `du/dt = -grad p/rho - u.grad u + nu lap u + S` [eqs 1, 2, about points that stay].
    fn rate(&self, i: usize, fields: &Fields, gradients: &Gradients, left: f64) -> [f64; 3] {
        let bend = if self.solution.condition == Condition::NoSlip {
            self.gradient.laplacian(i, gradients)
        } else {
            [0.0; 2]
        };
        let found = terms(&fields[i], &gradients[i], bend);
        let exact = &self.exact[i];
        let value = exact.value.map(|v| left * v);
        let slopes = exact.gradient.map(|g| g.map(|v| left * v));
        let bend = if self.solution.condition == Condition::NoSlip {
            [left * exact.laplacian[1], left * exact.laplacian[2]]
        } else {
            [0.0; 2]
        };
        let source = terms(&value, &slopes, bend);
        let decay = self.solution.decay();
        std::array::from_fn(|k| found[k] - source[k] - decay * value[k])
    }

    /// Gives ghosts their state; returns the rates of the pressures that are their own.
    fn fill(&self, fields: &mut Fields, left: f64) -> Vec<f64> {
        let first = fields.len() - self.treated.len();
        for (state, exact) in fields[self.gas..first]
            .iter_mut()
            .zip(&self.exact[self.gas..])
        {
            *state = exact.value.map(|v| left * v);
        }
        let (gas, ghosts) = fields.split_at_mut(first);
        let fill = |(k, (treated, state)): (usize, (&Treated, &mut [f64; 3]))| {
            let exact = self.exact[first + k].value.map(|v| left * v);
            treated.fill(gas, state, exact, left, &self.solution)
        };
        let treated = self.treated.par_iter().zip(ghosts.par_iter_mut());
        treated.enumerate().map(fill).collect()
    }

    fn override_gas(&self, fields: &mut Fields, left: f64) {
        let mean = |one: &Overridden| -> [f64; 2] {
            std::array::from_fn(|k| {
                let wall = left * one.wall[k];
                let sum = one.weights.iter();
                wall + sum
                    .map(|(j, w)| w * (fields[*j][k + 1] - wall))
                    .sum::<f64>()
            })
        };
        let means: Vec<[f64; 2]> = self.overridden.par_iter().map(mean).collect();
        for (one, [u, v]) in self.overridden.iter().zip(means) {
            fields[one.particle][1..].copy_from_slice(&[u, v]);
        }
    }
}

impl Treated {
    /// Gives the ghost its state, what is not treated from the `exact` one; returns the rate of its own pressure.
    fn fill(
        &self,
        gas: &[[f64; 3]],
        state: &mut [f64; 3],
        exact: [f64; 3],
        left: f64,
        solution: &Solution,
    ) -> f64 {
        let normal = self.ghost.normal;
        let along = |k: usize| {
            let [x, y] = self.wall.gradient[k];
            left * (x * normal.x + y * normal.y)
        };
        let wall = Vector::<2>::new(left * self.wall.value[1], left * self.wall.value[2]);
        match &self.rule {
            Rule::Wall(factor) => {
                let velocity = *factor * wall;
                *state = [exact[0], velocity.x, velocity.y];
                0.0
            }
            Rule::Reads {
                weights,
                rise,
                factor,
            } => {
                let read = |k: usize| weights.iter().map(|(j, w)| w * gas[*j as usize][k]).sum();
                *state = exact;
                if solution.condition == Condition::Neumann {
                    let pressure: f64 = read(0);
                    state[0] = pressure + rise * along(0);
                    return 0.0;
                }
                let velocity = Vector::<2>::new(read(1), read(2));
                let beyond = velocity - wall;
                let found = if solution.condition == Condition::Slip {
                    velocity - (1.0 + factor) * beyond.dot(&normal) * normal
                } else {
                    wall - *factor * beyond
                };
                state[1..].copy_from_slice(found.as_slice());
                0.0
            }
            Rule::Evolves { weights, own } => {
                state[1..].copy_from_slice(&exact[1..]);
                let across = |state: &[f64; 3]| state[1] * normal.x + state[2] * normal.y;
                let read = |of: &dyn Fn(&[f64; 3]) -> f64| {
                    let sum = weights.iter().map(|(j, w)| w * of(&gas[*j as usize]));
                    sum.sum::<f64>() + own * of(state)
                };
                let (pressed, stretched) = (read(&|state| state[0]), read(&across));
                let stiffness = |pressure: f64| density(pressure) * SOUND * SOUND;
                let exact_stretch = normal.x * along(1) + normal.y * along(2);
                let pressure = left * self.wall.value[0];
                // What the solution lacks of the equation.
                let source = stiffness(pressure) * exact_stretch - solution.decay() * pressure;
                SOUND * (pressed - along(0)) - stiffness(state[0]) * stretched + source
            }
        }
    }
}

/// Mean sizes of the differences of pressure and velocity.
fn mean_difference(pairs: impl ExactSizeIterator<Item = ([f64; 3], [f64; 3])>) -> [f64; 2] {
    let count = pairs.len() as f64;
    let mut sum = [0.0; 2];
    for (a, b) in pairs {
        sum[0] += (a[0] - b[0]).abs();
        sum[1] += (a[1] - b[1]).hypot(a[2] - b[2]);
    }
    sum.map(|sum| sum / count)
}

fn density(pressure: f64) -> f64 {
    DENSITY + pressure / (SOUND * SOUND)
}

/// The right-hand sides of a state with its gradients and the Laplacian of its velocity.
fn terms(state: &[f64; 3], gradient: &[[f64; 2]; 3], bend: [f64; 2]) -> [f64; 3] {
    let [p, u, v] = *state;
    let rho = density(p);
    let carried = |k: usize| u * gradient[k][0] + v * gradient[k][1];
    let divergence = gradient[1][0] + gradient[2][1];
    [
        -rho * SOUND * SOUND * divergence - carried(0),
        -gradient[0][0] / rho - carried(1) + VISCOSITY * bend[0],
        -gradient[0][1] / rho - carried(2) + VISCOSITY * bend[1],
    ]
}

fn advance(fields: &mut Fields, rates: &Fields, time: f64) {
    fields
        .par_iter_mut()
        .zip(rates)
        .for_each(|(state, rate)| *state = std::array::from_fn(|k| state[k] + time * rate[k]));
}

/// The particles of the gas nearer than a smoothing length to a ghost of the tested wall, and the weights of
/// `sum_gas W omega_j / (1 - sum_ghosts W omega_j)`.
fn row_at_wall(
    cloud: &Cloud,
    volume: &[f64],
    gas: &[Vector<2>],
    given: usize,
    solution: Solution,
) -> Vec<Overridden> {
    let mut row = Vec::new();
    for (particle, place) in gas.iter().enumerate() {
        let (mut behind, mut nearest) = (0.0, f64::INFINITY);
        let mut weights = Vec::new();
        cloud.near(place, |j, arm| {
            let weight = QuinticSpline::<2>::value(arm.norm(), cloud.smoothing) * volume[j];
            if j < gas.len() {
                weights.push((j, weight));
            } else if j >= gas.len() + given {
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
            row.push(Overridden {
                particle,
                weights,
                wall: [u, v],
            });
        }
    }
    row
}
