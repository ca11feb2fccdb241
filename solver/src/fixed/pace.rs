//! How long the steps towards the steady state are.
//!
//! Symmetric Gauss-Seidel sweeps over slopes that its left-hand side does not know are not stable at any Courant number ([`super::relax`]). A fast
//! stream carries what grows out of the domain before it counts; a slow one lets it swing to and fro. Where the residual grows steps therefore go on
//! in two stages, and are shortened should it still grow; in a slow stream without viscosity also where it hardly falls, for what swings may have stopped to grow
//! [after the switched evolution relaxation of Mulder & van Leer 1985, J. Comput. Phys. 59,
//! 232-246].

use serde::{Deserialize, Serialize};

/// The Courant number grows by this much with each iteration.
const RAMP: f64 = 0.4;

/// Up to this much.
const FASTEST: f64 = 20.0;

/// After so many iterations.
pub const RAMP_LENGTH: u64 = 48;

/// It is never bounded by less.
const SLOWEST: f64 = 2.0;

/// Iterations over which residuals are averaged.
const WINDOW: u32 = 20;

/// A residual that is so many times what it was grows; limiters make one cycle by less.
const GROWN: f64 = 2.0;

/// Windows after which the residual of a slow stream has fallen, unless something keeps it swinging.
const LONG: u32 = 5;

/// It has not where this part of what it was in the first of them is left.
const KEPT: f64 = 0.5;

/// The Courant number, and the residuals that it goes by.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Pace {
    fastest: f64,
    /// Sum of the squares of the residuals of this window, and how many they are.
    window: (f64, u32),
    /// The least of the windows before, as a mean square.
    least: Option<f64>,
    /// That of the first window, and how many there were.
    #[serde(default)]
    begun: (f64, u32),
    /// True once the residual has grown.
    #[serde(default)]
    is_staged: bool,
}

impl Default for Pace {
    fn default() -> Self {
        Self {
            fastest: FASTEST,
            window: (0.0, 0),
            least: None,
            begun: (0.0, 0),
            is_staged: false,
        }
    }
}

impl Pace {
    /// True where steps go in two stages.
    pub fn is_staged(&self) -> bool {
        self.is_staged
    }

    /// Courant number of the next iteration, `calm` iterations after the gas was far from rest.
    pub fn courant(&self, calm: u64) -> f64 {
        (1.0 + RAMP * calm as f64).min(self.fastest)
    }

    /// Goes by the `residual` of an iteration in gas that `may_swing` to and fro or not, `since` iterations after points came or went.
    pub fn go_by(&mut self, residual: f64, since: u64, may_swing: bool) {
        if RAMP * (since as f64) < FASTEST {
            self.window = (0.0, 0);
            self.least = None;
            self.begun = (0.0, 0);
            return;
        }
        let (sum, count) = (self.window.0 + residual * residual, self.window.1 + 1);
        self.window = (sum, count);
        if count < WINDOW {
            return;
        }
        self.window = (0.0, 0);
        let mean = sum / f64::from(count);
        let least = self.least.unwrap_or(mean);
        let has_grown = mean > GROWN * GROWN * least;
        if has_grown && self.is_staged {
            self.fastest = (0.5 * self.fastest).max(SLOWEST);
        }
        let least_now = if has_grown { mean } else { mean.min(least) };
        let (first, windows) = match self.begun {
            (_, 0) => (mean, 1),
            (first, windows) => (first, windows.saturating_add(1)),
        };
        self.begun = (first, windows);
        let has_stalled = may_swing && windows == LONG && least_now > KEPT * KEPT * first;
        self.is_staged |= has_grown || has_stalled;
        self.least = Some(least_now);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn after(residual: impl Fn(f64) -> f64) -> (f64, bool) {
        of_gas(false, residual)
    }

    fn of_gas(may_swing: bool, residual: impl Fn(f64) -> f64) -> (f64, bool) {
        let mut pace = Pace::default();
        for calm in 0..400 {
            pace.go_by(residual(calm as f64), calm, may_swing);
        }
        (pace.courant(400), pace.is_staged())
    }

    #[test]
    fn steps_are_parted_then_shortened_where_the_residual_grows_and_not_where_it_falls_or_cycles() {
        assert_eq!(after(|k| (-0.01 * k).exp()), (FASTEST, false));
        assert_eq!(after(|k| 1.0 + 0.3 * (0.07 * k).sin()), (FASTEST, false));
        assert_eq!(after(|k| (0.003 * k).exp()), (FASTEST, true));
        assert_eq!(after(|k| (0.006 * k).exp()), (0.5 * FASTEST, true));
        assert_eq!(after(|k| (0.1 * k).exp()), (SLOWEST, true));
    }

    #[test]
    fn steps_in_slow_streams_are_parted_where_the_residual_hardly_falls() {
        let swinging = |k: f64| 1.0 + 0.3 * (0.07 * k).sin();
        assert_eq!(of_gas(true, swinging), (FASTEST, true));
        assert_eq!(of_gas(true, |k| (-0.001 * k).exp()), (FASTEST, true));
        // What has fallen may cycle on.
        let settled = |k: f64| (-0.02 * k).exp().max(0.1) * swinging(k);
        assert_eq!(of_gas(true, settled), (FASTEST, false));
    }

    #[test]
    fn what_comes_with_new_points_is_no_growth() {
        let mut pace = Pace::default();
        for calm in (0..300).chain(0..300) {
            pace.go_by((-0.02 * calm as f64).exp(), calm, true);
        }
        assert_eq!(pace.courant(300), FASTEST);
        assert_eq!(pace.courant(5), 3.0);
        assert_eq!(pace.courant(RAMP_LENGTH), FASTEST);
        assert!(pace.courant(RAMP_LENGTH - 1) < FASTEST);
    }
}
