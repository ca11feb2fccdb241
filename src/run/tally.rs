//! What is summed up over a run: drift of conserved totals, mean loads, speed.

use serde::{Deserialize, Serialize};

use super::coefficients::Coefficients;
use super::steady::Window;
use super::stopwatch::Stopwatch;
use super::{
    bends, far_field, inlets, leaks, outlets, reach, refined, shown, stagnation, thrown_back,
    warmth,
};
use crate::case::{Pressure, RunPlan, warnings};
use crate::output::{BodyMotion, BodySummary, Conservation, Particles, Summary, peak_memory};
use aero_packer::Warning;
use aero_solver::Flow;
use aero_solver::frame::{Load, Totals};
use aero_solver::method::Method;
use aero_solver::problem::Body;
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
    coefficients: Coefficients,
    warnings: Option<Vec<Warning>>,
    is_viscous: bool,
    sums: Sums,
}

/// Running sums, which a run that is resumed goes on with.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct Sums {
    start: Totals,
    impulse: Vec<[f64; 3]>,
    /// Moments over time.
    turn: Vec<[f64; 3]>,
    /// Squares of the forces' components over time.
    square: Vec<[f64; 3]>,
    duration: f64,
    /// Largest way of each body that the gas moves.
    reach: Vec<f64>,
    /// When the means began; none before they do.
    from: Option<f64>,
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

impl Sums {
    /// When the means of a run that stands at `now` begin if they are wanted from `mean_from` on. Those of a run that is made
    /// longer begin anew, unless what was summed up belongs to them too; then they begin where it does.
    fn begin(&mut self, mean_from: f64, now: f64) -> f64 {
        match self.from {
            Some(from) if now >= mean_from => from,
            Some(_) => {
                for sums in [&mut self.impulse, &mut self.turn, &mut self.square] {
                    sums.fill([0.0; 3]);
                }
                self.duration = 0.0;
                self.from = None;
                mean_from
            }
            None => mean_from,
        }
    }
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
            turn: vec![[0.0; 3]; bodies.len()],
            square: vec![[0.0; 3]; bodies.len()],
            duration: 0.0,
            reach: vec![0.0; bodies.len()],
            from: None,
            spent: Spent::default(),
        };
        Self::resume(plan, simulation, sums, stopwatch)
    }

    /// Goes on from earlier sums.
    pub(super) fn resume<const D: usize>(
        plan: &RunPlan<D>,
        simulation: &Flow<D>,
        mut sums: Sums,
        stopwatch: Stopwatch,
    ) -> Self {
        let mean_from = (1.0 - MEAN_PART) * plan.end_time;
        Self {
            name: plan.name.clone(),
            stopwatch,
            cpu_before: stopwatch.cpu_seconds(),
            mean_from: sums.begin(mean_from, simulation.time()),
            coefficients: Coefficients::new(plan, simulation),
            warnings: plan.warnings.clone(),
            is_viscous: simulation.problem().gas.is_viscous(),
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
        reach::grow(&mut self.sums.reach, simulation);
        if simulation.time() < self.mean_from {
            return;
        }
        self.sums.from = Some(self.mean_from);
        self.sums.duration += dt;
        let sums = self.sums.impulse.iter_mut().zip(&mut self.sums.square);
        let sums = sums.zip(&mut self.sums.turn);
        for (((impulse, square), turn), load) in sums.zip(simulation.loads()) {
            for k in 0..3 {
                turn[k] += load.moment[k] * dt;
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
        self.sums.turn = window.turn;
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
        let warnings = self.told(simulation, &loads);
        let bodies = problem.bodies.iter().enumerate().map(|(number, body)| {
            let load = loads.get(number).copied().unwrap_or_default();
            let summary = BodySummary {
                motion: BodyMotion::of(simulation, number),
                ..self.body(number, body, &load)
            };
            (body.name.clone(), summary)
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
            spacing: problem.resolution.lattice(),
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
            conservation: (simulation.time() > 0.0 && simulation.problem().source.is_none())
                .then(|| drift(&self.sums.start, &simulation.totals(), &simulation.inflow())),
            bodies: bodies.collect(),
            leaked: statistics.leaked,
            returned: statistics.returned,
            mirror_fallbacks: statistics.mirror_fallbacks,
            min_density: statistics.min_density,
            min_energy: statistics.min_energy,
            warnings,
        }
    }

    /// All that there is to say of the scene, and of its flow as it stands.
    fn told<const D: usize>(&self, simulation: &Flow<D>, loads: &[Load]) -> Vec<Warning> {
        let problem = simulation.problem();
        let names = problem.bodies.iter().map(|body| body.name.as_str());
        let ways = names.zip(self.sums.reach.iter().copied());
        // They take room to find, which is free again when the frame is made.
        let panels = simulation.panels();
        let frame = simulation.frame();
        self.warnings
            .clone()
            .unwrap_or_else(|| warnings(&problem.bodies))
            .into_iter()
            .chain(leaks::warnings(simulation))
            .chain(refined::warnings(simulation))
            .chain(far_field::warnings(problem, loads))
            .chain(inlets::warnings(problem, &frame))
            .chain(outlets::warnings(problem, &frame))
            .chain(thrown_back::warnings(problem, &frame, &panels))
            .chain(bends::warnings(problem, &panels))
            .chain(warmth::warnings(problem, &frame))
            .chain(stagnation::warnings(problem, &frame))
            .chain(shown::warnings(simulation, &panels, &self.coefficients))
            .chain(reach::warnings(ways, problem.resolution.lattice()))
            .collect()
    }

    fn body<const D: usize>(&self, number: usize, body: &Body<D>, load: &Load) -> BodySummary {
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
        let now = self.coefficients.of(number, load);
        let moment = if self.sums.duration > 0.0 {
            self.sums.turn[number].map(|turn| turn / self.sums.duration)
        } else {
            load.moment
        };
        let mean = Load {
            force: force_mean,
            moment,
            ..*load
        };
        let mean = self.coefficients.of(number, &mean);
        let gauge = self.coefficients.gauge(number, load);
        let norm = |force: &[f64; 3]| force.iter().map(|f| f * f).sum::<f64>().sqrt();
        let force_spread = if self.sums.duration > 0.0 {
            force_spread
        } else {
            [0.0; 3]
        };
        BodySummary {
            force: load.force,
            moment: load.moment,
            friction: self.is_viscous.then_some(load.friction),
            heat: self.is_viscous.then_some(load.heat),
            motion: None,
            force_gauge: gauge.force,
            moment_gauge: gauge.moment,
            coefficients: match self.coefficients.pressure() {
                Pressure::Gauge => "gauge",
                Pressure::Absolute => "absolute",
            }
            .into(),
            cd: now.map(|c| c.cd),
            cl: now.map(|c| c.cl),
            cm: now.map(|c| c.cm),
            ca: now.and_then(|c| c.ca),
            cn: now.and_then(|c| c.cn),
            cd_mean: mean.map(|c| c.cd),
            cl_mean: mean.map(|c| c.cl),
            cm_mean: mean.map(|c| c.cm),
            ca_mean: mean.and_then(|c| c.ca),
            cn_mean: mean.and_then(|c| c.cn),
            force_mean,
            force_spread,
            settled_percent: 100.0 * norm(&force_spread)
                / norm(&gauge.force).max(f64::MIN_POSITIVE),
            mean_from: self.mean_from,
            reference_area: body.reference_area,
            reference_length: body.reference_length,
            moment_centre: std::array::from_fn(|k| {
                body.moment_centre.get(k).copied().unwrap_or(0.0)
            }),
            uncovered_area_percent: body.report.uncovered_area_percent,
        }
    }
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
