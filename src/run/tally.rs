//! What is summed up over a run: drift of conserved totals, mean loads, speed.

use aero_geometry::Vector;
use serde::{Deserialize, Serialize};

use super::steady::Window;
use super::stopwatch::Stopwatch;
use crate::case::RunPlan;
use crate::output::{BodySummary, Conservation, Particles, Summary, peak_memory};
use aero_solver::Flow;
use aero_solver::frame::{Load, Totals};
use aero_solver::method::Method;
use aero_solver::problem::{Body, Problem};
use aero_solver::scheme::{Extrapolation, Precision};

/// Part of the run, at its end, over which loads are averaged.
const MEAN_PART: f64 = 0.2;

/// What is summed up over a run.
pub(super) struct Tally {
    name: String,
    stopwatch: Stopwatch,
    /// Processor time of this process when its first step began: packing is not part of the speed.
    cpu_before: f64,
    mean_from: f64,
    sums: Sums,
}

/// Running sums, which a run that is resumed goes on with.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct Sums {
    start: Totals,
    impulse: Vec<[f64; 3]>,
    /// Squares of the forces' components over time.
    square: Vec<[f64; 3]>,
    duration: f64,
    /// Spent by processes before this one.
    spent: Spent,
}

/// Time spent, s.
#[derive(Clone, Copy, Debug, Default, Serialize, Deserialize)]
struct Spent {
    wall: f64,
    cpu: f64,
    /// Processor time spent on steps.
    stepping: f64,
}

impl Tally {
    /// Begins with the state at the start.
    pub(super) fn start<const D: usize>(
        plan: &RunPlan<D>,
        simulation: &Flow<D>,
        stopwatch: Stopwatch,
    ) -> Self {
        let bodies = &simulation.problem().bodies;
        let sums = Sums {
            start: simulation.totals(),
            impulse: vec![[0.0; 3]; bodies.len()],
            square: vec![[0.0; 3]; bodies.len()],
            duration: 0.0,
            spent: Spent::default(),
        };
        Self::resume(plan, sums, stopwatch)
    }

    /// Goes on from earlier sums.
    pub(super) fn resume<const D: usize>(
        plan: &RunPlan<D>,
        sums: Sums,
        stopwatch: Stopwatch,
    ) -> Self {
        Self {
            name: plan.name.clone(),
            stopwatch,
            cpu_before: stopwatch.cpu_seconds(),
            mean_from: (1.0 - MEAN_PART) * plan.end_time,
            sums,
        }
    }

    /// What [`Self::resume`] goes on from.
    pub(super) fn sums(&self) -> Sums {
        Sums {
            spent: self.spent(),
            ..self.sums.clone()
        }
    }

    fn spent(&self) -> Spent {
        let (before, cpu) = (&self.sums.spent, self.stopwatch.cpu_seconds());
        Spent {
            wall: before.wall + self.stopwatch.wall_seconds(),
            cpu: before.cpu + cpu,
            stepping: before.stepping + cpu - self.cpu_before,
        }
    }

    /// Adds a step of length `dt`.
    pub(super) fn add<const D: usize>(&mut self, simulation: &Flow<D>, dt: f64) {
        if simulation.time() < self.mean_from {
            return;
        }
        self.sums.duration += dt;
        let sums = self.sums.impulse.iter_mut().zip(&mut self.sums.square);
        for ((impulse, square), load) in sums.zip(simulation.loads()) {
            for k in 0..3 {
                impulse[k] += load.force[k] * dt;
                square[k] += load.force[k] * load.force[k] * dt;
            }
        }
    }

    /// Takes the loads of a steady run's last window for those of the last part of a run.
    pub(super) fn settle(&mut self, window: Window) {
        self.mean_from = window.from;
        self.sums.impulse = window.impulse;
        self.sums.square = window.square;
        self.sums.duration = window.duration;
    }

    /// The summary as of now.
    pub(super) fn summary<const D: usize>(
        &self,
        simulation: &Flow<D>,
        stop_reason: &str,
    ) -> Summary {
        let problem = simulation.problem();
        // What the summary itself costs is no part of the speed.
        let spent = self.spent();
        let statistics = simulation.statistics();
        let stepping = spent.stepping.max(f64::MIN_POSITIVE);
        let loads = simulation.loads();
        let bodies = problem.bodies.iter().enumerate().map(|(number, body)| {
            let load = loads.get(number).copied().unwrap_or_default();
            (body.name.clone(), self.body(problem, number, body, &load))
        });
        Summary {
            case: self.name.clone(),
            motion: match problem.method {
                Method::WithTheGas => "with-the-gas",
                Method::Fixed(_) => "fixed",
            }
            .into(),
            scheme: match problem.method {
                Method::WithTheGas => problem.scheme.name,
                Method::Fixed(_) => "muscl-hllc",
            }
            .into(),
            extrapolation: match (problem.method, problem.scheme.wall.extrapolation) {
                (Method::Fixed(_), _) => "none",
                (_, Extrapolation::Wom) => "wom",
                (_, Extrapolation::Wm) => "wm",
            }
            .into(),
            precision: match problem.scheme.precision {
                Precision::Double => "double",
                Precision::Mixed => "mixed",
            }
            .into(),
            dimension: D,
            spacing: problem.spacing,
            particles: Particles {
                fluid: statistics.fluid,
                ghost: statistics.ghost,
            },
            points_per_level: simulation.points_per_level(),
            steps: simulation.steps(),
            end_time: simulation.time(),
            stop_reason: stop_reason.into(),
            wall_seconds: spent.wall,
            cpu_seconds: spent.cpu,
            peak_memory_bytes: peak_memory(),
            threads: rayon::current_num_threads(),
            particle_updates_per_cpu_second: statistics.particle_updates as f64 / stepping,
            neighbours_mean: statistics.neighbours_mean,
            conservation: (simulation.time() > 0.0)
                .then(|| drift(&self.sums.start, &simulation.totals(), &simulation.inflow())),
            bodies: bodies.collect(),
            leaked: statistics.leaked,
            mirror_fallbacks: statistics.mirror_fallbacks,
            min_density: statistics.min_density,
            min_energy: statistics.min_energy,
        }
    }

    fn body<const D: usize>(
        &self,
        problem: &Problem<D>,
        number: usize,
        body: &Body<D>,
        load: &Load,
    ) -> BodySummary {
        let force_mean = if self.sums.duration > 0.0 {
            self.sums.impulse[number].map(|impulse| impulse / self.sums.duration)
        } else {
            load.force
        };
        let force_spread: [f64; 3] = std::array::from_fn(|k| {
            let square = self.sums.square[number][k] / self.sums.duration.max(f64::MIN_POSITIVE);
            // The difference of two large numbers may round to below zero.
            (square - force_mean[k] * force_mean[k]).max(0.0).sqrt()
        });
        let stream = &problem.free_stream;
        let scale = 0.5 * stream.density * stream.velocity.norm_squared() * body.reference_area;
        let axes = stream_axes(&stream.velocity).filter(|_| scale > 0.0);
        let along = |axis: usize, force: &[f64; 3]| {
            let axes = axes.as_ref()?;
            Some((0..3).map(|k| axes[axis][k] * force[k]).sum::<f64>() / scale)
        };
        BodySummary {
            force: load.force,
            moment: load.moment,
            cd: along(0, &load.force),
            cl: along(1, &load.force),
            cm: axes.map(|_| load.moment.map(|m| m / (scale * body.reference_length))),
            cd_mean: along(0, &force_mean),
            cl_mean: along(1, &force_mean),
            force_mean,
            force_spread: if self.sums.duration > 0.0 {
                force_spread
            } else {
                [0.0; 3]
            },
            mean_from: self.mean_from,
            reference_area: body.reference_area,
            reference_length: body.reference_length,
        }
    }
}

/// Unit vectors along the stream and across it towards `+y` (towards `+z` where the stream itself
/// goes along `y` in space); none for a gas at rest.
fn stream_axes<const D: usize>(velocity: &Vector<D>) -> Option<[[f64; 3]; 2]> {
    /// Nearly along an axis, what is left of it across is round-off.
    const ALONG: f64 = 1e-6;
    let drag = velocity.try_normalize(0.0)?;
    let drag: [f64; 3] = std::array::from_fn(|k| if k < D { drag[k] } else { 0.0 });
    if D < 3 {
        return Some([drag, [-drag[1], drag[0], 0.0]]);
    }
    let across = |up: usize| {
        let mut lift = drag.map(|d| -drag[up] * d);
        lift[up] += 1.0;
        let length = lift.iter().map(|l| l * l).sum::<f64>().sqrt();
        (length > ALONG).then(|| lift.map(|l| l / length))
    };
    let lift = across(1).or_else(|| across(2))?;
    Some([drag, lift])
}

fn drift(start: &Totals, now: &Totals, inflow: &Totals) -> Conservation {
    let scale = (2.0 * start.mass * start.energy).sqrt();
    let momentum = (0..3)
        .map(|k| now.momentum[k] - start.momentum[k] - inflow.momentum[k])
        .map(|d| d * d)
        .sum::<f64>()
        .sqrt();
    Conservation {
        mass: (now.mass - start.mass - inflow.mass) / start.mass,
        momentum: momentum / scale,
        energy: (now.energy - start.energy - inflow.energy) / start.energy,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lift_points_up_and_across_the_stream() {
        let [drag, lift] = stream_axes(&Vector::<3>::new(2.0, 0.0, 0.0)).unwrap();
        assert_eq!(drag, [1.0, 0.0, 0.0]);
        assert_eq!(lift, [0.0, 1.0, 0.0]);
        let [_, lift] = stream_axes(&Vector::<3>::new(0.0, 1.0, 0.0)).unwrap();
        assert_eq!(lift, [0.0, 0.0, 1.0]);
        let [_, lift] = stream_axes(&Vector::<2>::new(0.0, 1.0)).unwrap();
        assert_eq!(lift, [-1.0, 0.0, 0.0]);
        assert!(stream_axes(&Vector::<2>::zeros()).is_none());
    }

    #[test]
    fn what_came_in_is_no_drift() {
        let start = Totals {
            mass: 2.0,
            momentum: [1.0, 0.0, 0.0],
            energy: 4.0,
        };
        let inflow = Totals {
            mass: 0.5,
            momentum: [0.25, 0.0, 0.0],
            energy: 1.0,
        };
        let now = Totals {
            mass: 2.5,
            momentum: [1.25, 0.0, 0.0],
            energy: 5.0,
        };
        let drift = drift(&start, &now, &inflow);
        assert_eq!([drift.mass, drift.momentum, drift.energy], [0.0; 3]);
    }
}
