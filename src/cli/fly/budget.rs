//! How a flight's time is shared out between its runs and what comes after them.

use aero::fly::Costs;

/// Iterations after which a run that is cut short counts.
pub(super) const UNDER_WAY: u64 = 100;

/// A run may take so many times its share of what is left: a coarse wake that never settles leaves time for the finer ones.
pub(super) const PATIENCE: f64 = 4.0;

/// Part of the budget kept for what comes after the last iteration: its files, the pictures of the report; and seconds at most.
const CLOSING: f64 = 0.15;
const CLOSING_MOST: f64 = 20.0;

/// Seconds that a run may take.
#[derive(Clone, Copy, Debug)]
pub(super) struct Room {
    /// As it is shared out.
    pub(super) seconds: f64,
    /// No other has come through: without it there is nothing to tell.
    pub(super) is_first: bool,
}

impl Room {
    /// True where a run ends that has taken so many seconds and iterations: the first is let on until it can be told from.
    pub(super) fn is_over(self, seconds: f64, steps: u64) -> bool {
        seconds >= self.seconds && !(self.is_first && steps < UNDER_WAY)
    }
}

/// Seconds of a budget that runs may take.
pub(super) fn for_runs(budget: f64) -> f64 {
    budget - (CLOSING * budget).min(CLOSING_MOST)
}

/// Seconds that a run may take of those that are `left` for it and so many finer ones.
pub(super) fn may_take(costs: Costs, left: f64, finer: usize) -> f64 {
    left * (PATIENCE * costs.share(finer)).min(1.0)
}

#[cfg(test)]
mod tests {
    use aero::fly::FAMILY;

    use super::*;

    /// In planes as in space: one that takes what it was thought to is not cut short, two that go on for ever leave more than half of
    /// the budget, and the finest may take all that is left.
    #[test]
    fn coarse_runs_that_do_not_settle_leave_their_time_to_finer_ones() {
        const BUDGET: f64 = 600.0;
        for dimension in [2, 3] {
            let costs = Costs::new(dimension, false);
            let mut left = BUDGET;
            for finer in [FAMILY - 1, FAMILY - 2] {
                let seconds = may_take(costs, left, finer);
                assert!(seconds > 2.0 * left * costs.share(finer), "{seconds}");
                left -= seconds;
            }
            assert!(left > 0.5 * BUDGET, "{left} s in {dimension} dimensions");
            assert_eq!(may_take(costs, left, 0), left);
        }
    }

    #[test]
    fn time_is_kept_for_the_report_and_no_more_than_it_takes() {
        assert_eq!(for_runs(60.0), 51.0);
        assert_eq!(for_runs(6000.0), 6000.0 - CLOSING_MOST);
        assert_eq!(for_runs(f64::INFINITY), f64::INFINITY);
    }

    #[test]
    fn the_first_run_is_let_on_until_it_tells_something() {
        let mut room = Room {
            seconds: 2.0,
            is_first: true,
        };
        assert!(!room.is_over(3.0, UNDER_WAY - 1) && room.is_over(3.0, UNDER_WAY));
        // Even where nothing was left for it.
        room.seconds = -17.0;
        assert!(!room.is_over(0.0, UNDER_WAY - 1) && room.is_over(0.0, UNDER_WAY));
        room.seconds = 2.0;
        room.is_first = false;
        assert!(room.is_over(3.0, 1) && !room.is_over(1.0, 1));
    }
}
