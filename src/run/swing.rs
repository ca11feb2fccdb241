//! Tells when the loads of a flow that settles are steady in the mean, though it goes on swinging: wakes behind blunt bases never
//! come to rest.

use serde::{Deserialize, Serialize};

use super::steady::Window;
use aero_solver::Flow;

/// Iterations in the shortest window: three of them are longer than a flow waits before it asks for other points.
const SHORTEST: f64 = 150.0;

/// So many lengths of windows, each twice the one before: the mean over a part of a swing says nothing of the mean of the swing.
const LENGTHS: usize = 4;

/// Largest change of a mean force from window to window, relative to the force.
const TOLERANCE: f64 = 1e-3;

/// Part of itself by which the swing of viscous gas about the mean may change from window to window: one that dies away is on its way to the
/// steady flow, and its means, over windows that are no whole number of swings, say nothing yet.
const SAME: f64 = 0.1;

/// So many windows in a row must agree with the one before.
const WINDOWS: u32 = 2;

/// Watches a flow that settles, by windows of several lengths.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct Swing {
    /// Points there were; with others all begins anew.
    points: Vec<usize>,
    /// From the shortest windows to the longest.
    watches: [Watch; LENGTHS],
    bodies: usize,
}

/// Watches a flow window by window.
#[derive(Clone, Debug, Serialize, Deserialize)]
struct Watch {
    /// Iterations in a window.
    length: f64,
    window: Window,
    previous: Option<Window>,
    agreed: u32,
}

impl Swing {
    /// Watches so many bodies.
    pub(super) fn new(bodies: usize) -> Self {
        Self {
            points: Vec::new(),
            watches: std::array::from_fn(|k| Watch::new(SHORTEST * 2_f64.powi(k as i32), bodies)),
            bodies,
        }
    }

    /// Adds an iteration; returns the last window once means no longer change over windows of one of the lengths.
    pub(super) fn add<const D: usize>(&mut self, simulation: &Flow<D>) -> Option<Window> {
        if self.bodies == 0 {
            return None;
        }
        let points = simulation.points_per_level();
        if points != self.points {
            *self = Self::new(self.bodies);
            self.points = points;
        }
        let is_viscous = simulation.problem().gas.is_viscous();
        for watch in &mut self.watches {
            watch.window.add(simulation, 1.0);
            if watch.window.duration >= watch.length
                && let Some(window) = watch.turn_over(is_viscous)
            {
                return Some(window);
            }
        }
        None
    }

    /// Means over the last full window, of a flow that was stopped: over the longest, that hold the most of a swing.
    pub(super) fn last(&self) -> Option<Window> {
        let mut longest = self.watches.iter().rev();
        longest.find_map(|watch| watch.previous.clone())
    }
}

impl Watch {
    fn new(length: f64, bodies: usize) -> Self {
        Self {
            length,
            window: Window::new(0.0, bodies),
            previous: None,
            agreed: 0,
        }
    }

    /// Begins the next window; returns the one that is full once it agrees with those before.
    fn turn_over(&mut self, is_viscous: bool) -> Option<Window> {
        let next = Window::new(0.0, self.window.impulse.len());
        let full = std::mem::replace(&mut self.window, next);
        let before = self.previous.replace(full.clone())?;
        let dies_away = is_viscous && (spread(&full) / spread(&before) - 1.0).abs() > SAME;
        self.agreed = if change(&before, &full) < TOLERANCE && !dies_away {
            self.agreed + 1
        } else {
            0
        };
        (self.agreed >= WINDOWS).then_some(full)
    }
}

/// Largest change of a mean force between two windows, relative to the largest force.
fn change(before: &Window, now: &Window) -> f64 {
    let mean = |window: &Window| -> Vec<[f64; 3]> {
        let each = window.impulse.iter();
        each.map(|sum| sum.map(|x| x / window.duration)).collect()
    };
    let [before, now] = [mean(before), mean(now)];
    let size = |force: &[f64; 3]| force.iter().map(|f| f * f).sum::<f64>().sqrt();
    let largest = now.iter().map(size).fold(f64::MIN_POSITIVE, f64::max);
    let changes = before.iter().zip(&now).map(|(a, b)| {
        let apart: [f64; 3] = std::array::from_fn(|k| a[k] - b[k]);
        size(&apart) / largest
    });
    changes.fold(0.0, f64::max)
}

/// Standard deviation of the force within a window, relative to the largest mean.
pub(super) fn spread(window: &Window) -> f64 {
    let mut largest = f64::MIN_POSITIVE;
    let mut most = 0.0_f64;
    for (impulse, square) in window.impulse.iter().zip(&window.square) {
        let mean = impulse.map(|sum| sum / window.duration);
        largest = largest.max(mean.iter().map(|f| f * f).sum::<f64>().sqrt());
        for k in 0..3 {
            let variance = square[k] / window.duration - mean[k] * mean[k];
            most = most.max(variance.max(0.0).sqrt());
        }
    }
    most / largest
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A window of forces along x.
    fn window(forces: impl Iterator<Item = f64>) -> Window {
        let mut window = Window::new(0.0, 1);
        for force in forces {
            window.impulse[0][0] += force;
            window.square[0][0] += force * force;
            window.duration += 1.0;
        }
        window
    }

    #[test]
    fn a_swing_about_the_same_mean_is_steady_and_a_drift_is_not() {
        let swing = |mean: f64| window((0..150).map(move |k| mean + 0.1 * f64::from(k).sin()));
        let mut watch = Watch::new(150.0, 1);
        for (mean, done) in [(2.0, false), (2.0, false), (2.0, true), (2.1, false)] {
            watch.window = swing(mean);
            assert_eq!(watch.turn_over(false).is_some(), done, "{mean}");
        }
        let dying = |part: f64| window((0..150).map(move |k| 2.0 + part * f64::from(k).sin()));
        for (is_viscous, done) in [(false, true), (true, false)] {
            let mut watch = Watch::new(150.0, 1);
            for part in [0.1, 0.07, 0.05] {
                watch.window = dying(part);
                assert_eq!(watch.turn_over(is_viscous).is_some(), done && part == 0.05);
            }
        }
        assert!((spread(&swing(2.0)) - 0.1 / 2.0 / 2.0_f64.sqrt()).abs() < 1e-3);
    }

    /// Iterations after which a force is steady in the mean; none where it is not within five thousand.
    fn steady_after(force: impl Fn(f64) -> f64) -> Option<u32> {
        let mut swing = Swing::new(1);
        (1..=5000).find(|iteration| {
            swing.watches.iter_mut().any(|watch| {
                let force = force(f64::from(*iteration));
                watch.window.impulse[0][0] += force;
                watch.window.square[0][0] += force * force;
                watch.window.duration += 1.0;
                watch.window.duration >= watch.length && watch.turn_over(false).is_some()
            })
        })
    }

    #[test]
    fn a_swing_longer_than_the_shortest_window_has_its_mean_over_a_longer_one() {
        let swing = |period: f64| move |k: f64| 2.0 + 0.008 * (6.3 * k / period).sin();
        assert_eq!(steady_after(swing(40.0)), Some(450));
        let slow = steady_after(swing(470.0)).expect("a mean");
        assert!((900..=3600).contains(&slow), "{slow}");
        // A creep is none, over windows of any length.
        assert_eq!(steady_after(|k| 2.0 + 1e-4 * k), None);
    }
}
