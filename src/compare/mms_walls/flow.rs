//! Weakly compressible gas beside a wall, kept to a solution by sources: particles stay where they are, so that their arrangement is what it
//! is called.

use rayon::prelude::*;

use super::arrangement::Places;
use super::equations::{SOUND, terms};
use super::ghosts::{Now, Overridden, Treated};
use super::operators::{Fields, Gradient, Gradients, volumes};
use super::solution::{Condition, Exact, Family, Solution};
use super::treatment::{Mistake, Treatment};
use crate::points::cloud::{Cloud, SMOOTHING_RATIO};

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
                let step = COURANT * SMOOTHING_RATIO * places.spacing / (SOUND + SPEED);
                (TIME / step / SNAPSHOTS as f64).ceil() as usize * SNAPSHOTS
            }
        };
        Flow::new(self, places).run(steps)
    }
}

impl Flow {
    fn new(trial: &Trial<'_>, places: &Places) -> Self {
        let solution = trial.solution;
        let gas = Cloud::new(places.gas.clone(), places.spacing);
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
        let cloud = Cloud::new(points, places.spacing);
        let volume = volumes(&cloud);
        let overrides = trial.treatment.is_some_and(Treatment::overrides_gas);
        let overridden = if overrides {
            let (gas, first) = (places.gas.len(), places.gas.len() + places.given.len());
            Overridden::all(&cloud, &volume, gas, first, solution)
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
        let now = Now {
            solution: self.solution,
            left: self.left(time),
        };
        self.override_gas(fields, now);
        let own = self.fill(fields, now);
        let gradients = self.gradient.of(fields);
        let mut rates: Fields = (0..self.gas)
            .into_par_iter()
            .map(|i| self.rate(i, fields, &gradients, now))
            .collect();
        rates.resize(fields.len(), [0.0; 3]);
        let first = fields.len() - self.treated.len();
        for (rate, own) in rates[first..].iter_mut().zip(own) {
            rate[0] = own;
        }
        rates
    }

    /// The rates of a particle of the gas, the source among them.
    fn rate(&self, i: usize, fields: &Fields, gradients: &Gradients, now: Now) -> [f64; 3] {
        let exact = &self.exact[i];
        let value = exact.value.map(|v| now.left * v);
        let slopes = exact.gradient.map(|g| g.map(|v| now.left * v));
        let [found_bend, exact_bend] = if self.solution.condition == Condition::NoSlip {
            let [_, u, v] = exact.laplacian.map(|v| now.left * v);
            [self.gradient.laplacian(i, gradients), [u, v]]
        } else {
            [[0.0; 2]; 2]
        };
        let found = terms(&fields[i], &gradients[i], found_bend);
        let lacking = terms(&value, &slopes, exact_bend);
        let decay = self.solution.decay();
        std::array::from_fn(|k| found[k] - lacking[k] - decay * value[k])
    }

    /// Gives ghosts their state; returns the rates of the pressures that are their own.
    fn fill(&self, fields: &mut Fields, now: Now) -> Vec<f64> {
        let first = fields.len() - self.treated.len();
        let given = fields[self.gas..first].iter_mut();
        for (state, exact) in given.zip(&self.exact[self.gas..]) {
            *state = exact.value.map(|v| now.left * v);
        }
        let (gas, ghosts) = fields.split_at_mut(first);
        let fill = |(k, (treated, state)): (usize, (&Treated, &mut [f64; 3]))| {
            let exact = self.exact[first + k].value.map(|v| now.left * v);
            treated.fill(gas, state, exact, now)
        };
        let treated = self.treated.par_iter().zip(ghosts.par_iter_mut());
        treated.enumerate().map(fill).collect()
    }

    fn override_gas(&self, fields: &mut Fields, now: Now) {
        let found: Vec<[f64; 2]> = self
            .overridden
            .par_iter()
            .map(|one| one.velocity(fields, now))
            .collect();
        for (one, velocity) in self.overridden.iter().zip(found) {
            fields[one.particle][1..].copy_from_slice(&velocity);
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

fn advance(fields: &mut Fields, rates: &Fields, time: f64) {
    fields
        .par_iter_mut()
        .zip(rates)
        .for_each(|(state, rate)| *state = std::array::from_fn(|k| state[k] + time * rate[k]));
}
