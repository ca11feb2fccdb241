//! Tells when a flow has become steady: forces and shocks no longer change from one window of time to
//! the next.
//!
//! A window is as long as the free stream needs to cross the domain. Compared are means over it, so that
//! neither the noise of particles nor the inlet's rhythm counts. A shock that still moves changes the
//! mass of the gas in the domain and its centre, wherever it is.

use serde::{Deserialize, Serialize};

use aero_solver::Flow;
use aero_solver::problem::Problem;

/// Largest change of a mean from window to window, relative to the force on the body, the mass of the
/// gas, and the diagonal of the domain.
const TOLERANCE: f64 = 1e-3;

/// So many windows in a row must agree with the one before: two, because one may hit a turning point.
const WINDOWS: u32 = 2;

/// Sums over a stretch of time of what is weighed by the time it stands for.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub(super) struct Window {
    /// When it began.
    pub(super) from: f64,
    /// Time summed up.
    pub(super) duration: f64,
    /// Force on each body.
    pub(super) impulse: Vec<[f64; 3]>,
    /// Squares of its components.
    pub(super) square: Vec<[f64; 3]>,
    /// Moment on each body.
    pub(super) turn: Vec<[f64; 3]>,
    mass: f64,
    centre: [f64; 3],
}

/// Means over a window.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct Means {
    force: Vec<[f64; 3]>,
    mass: f64,
    centre: [f64; 3],
}

/// Watches a run window by window.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct Monitor {
    names: Vec<String>,
    /// Length of a window.
    length: f64,
    diagonal: f64,
    window: Window,
    previous: Option<Means>,
    /// What changed most between the last two windows, and by how much.
    change: Option<(String, f64)>,
    agreed: u32,
}

impl Monitor {
    /// Watches runs of `problem` from their start.
    pub(super) fn new<const D: usize>(problem: &Problem<D>) -> Self {
        let stream = &problem.free_stream;
        let size = problem.domain.bounds.size();
        let speed = stream.velocity.norm();
        let length = if speed > 0.0 {
            size.dot(&stream.velocity.abs()) / (speed * speed)
        } else {
            size.max() / problem.gas.sound_speed_at(stream.density, stream.pressure)
        };
        let names: Vec<String> = problem
            .bodies
            .iter()
            .map(|body| body.name.clone())
            .collect();
        Self {
            window: Window::new(0.0, names.len()),
            names,
            length,
            diagonal: size.norm(),
            previous: None,
            change: None,
            agreed: 0,
        }
    }

    /// Adds a step of length `dt`; returns why the run may end, with the last window, once the flow is
    /// steady.
    pub(super) fn add<const D: usize>(
        &mut self,
        simulation: &Flow<D>,
        dt: f64,
    ) -> Option<(String, Window)> {
        self.window.add(simulation, dt);
        let now = simulation.time();
        if now < self.window.from + self.length {
            return None;
        }
        let next = Window::new(now, self.names.len());
        let full = std::mem::replace(&mut self.window, next);
        let means = full.means();
        if let Some(previous) = self.previous.replace(means.clone()) {
            let change = self.largest_change(&previous, &means);
            self.agreed = if change.1 < TOLERANCE {
                self.agreed + 1
            } else {
                0
            };
            self.change = Some(change);
        }
        if self.agreed < WINDOWS {
            return None;
        }
        Some((
            format!("steady: {}", self.last_change(self.change.as_ref()?)),
            full,
        ))
    }

    /// Why a run that came to its end time is not steady.
    pub(super) fn verdict(&self) -> String {
        match &self.change {
            Some(change) => format!("end time reached, not steady: {}", self.last_change(change)),
            None => format!(
                "end time reached, too early to tell whether the flow is steady: that takes windows of {:.3e}",
                self.length
            ),
        }
    }

    fn last_change(&self, (what, change): &(String, f64)) -> String {
        format!(
            "{what} changed most, by {:.2} %, between the last windows of {:.3e}",
            100.0 * change,
            self.length
        )
    }

    fn largest_change(&self, before: &Means, now: &Means) -> (String, f64) {
        let distance = |a: &[f64; 3], b: &[f64; 3]| {
            let squares = a.iter().zip(b).map(|(a, b)| (a - b) * (a - b));
            squares.sum::<f64>().sqrt()
        };
        let mut changes = vec![
            ("the mass of the gas", (now.mass / before.mass - 1.0).abs()),
            (
                "the centre of the gas",
                distance(&now.centre, &before.centre) / self.diagonal,
            ),
        ];
        let forces: Vec<String> = self
            .names
            .iter()
            .map(|name| format!("the force on `{name}`"))
            .collect();
        for (body, what) in forces.iter().enumerate() {
            let size = distance(&now.force[body], &[0.0; 3]).max(f64::MIN_POSITIVE);
            changes.push((what, distance(&now.force[body], &before.force[body]) / size));
        }
        // Two changes at least are in the list.
        let (what, change) =
            changes.into_iter().fold(
                ("", 0.0),
                |most, one| if one.1 >= most.1 { one } else { most },
            );
        (what.to_owned(), change)
    }
}

impl Window {
    /// The loads now, for those of a window.
    pub(super) fn now<const D: usize>(simulation: &Flow<D>, bodies: usize) -> Self {
        let mut window = Self::new(simulation.time(), bodies);
        window.add(simulation, 1.0);
        window
    }

    /// An empty one.
    pub(super) fn new(from: f64, bodies: usize) -> Self {
        Self {
            from,
            impulse: vec![[0.0; 3]; bodies],
            square: vec![[0.0; 3]; bodies],
            turn: vec![[0.0; 3]; bodies],
            ..Self::default()
        }
    }

    /// Adds what there is now, weighted by `dt`.
    pub(super) fn add<const D: usize>(&mut self, simulation: &Flow<D>, dt: f64) {
        self.duration += dt;
        let sums = self.impulse.iter_mut().zip(&mut self.square);
        let sums = sums.zip(&mut self.turn);
        for (((impulse, square), turn), load) in sums.zip(simulation.loads()) {
            for k in 0..3 {
                turn[k] += load.moment[k] * dt;
                impulse[k] += load.force[k] * dt;
                square[k] += load.force[k] * load.force[k] * dt;
            }
        }
        let (mass, centre) = simulation.mass_and_centre();
        self.mass += mass * dt;
        for k in 0..3 {
            self.centre[k] += centre[k] * dt;
        }
    }

    fn means(&self) -> Means {
        let mean = |sums: &[f64; 3]| sums.map(|sum| sum / self.duration);
        Means {
            force: self.impulse.iter().map(mean).collect(),
            mass: self.mass / self.duration,
            centre: mean(&self.centre),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_largest_change_is_named() {
        let monitor = Monitor {
            names: vec!["nose".into()],
            length: 1.0,
            diagonal: 10.0,
            window: Window::default(),
            previous: None,
            change: None,
            agreed: 0,
        };
        let before = Means {
            force: vec![[3.0, 4.0, 0.0]],
            mass: 2.0,
            centre: [1.0, 0.0, 0.0],
        };
        let mut now = before.clone();
        now.mass = 2.002;
        let (what, change) = monitor.largest_change(&before, &now);
        assert_eq!(what, "the mass of the gas");
        assert!((change - 1e-3).abs() < 1e-12);
        now.force[0][1] = 4.05;
        let (what, change) = monitor.largest_change(&before, &now);
        assert_eq!(what, "the force on `nose`");
        assert!((change - 0.01).abs() < 1e-4, "{change}");
    }
}
