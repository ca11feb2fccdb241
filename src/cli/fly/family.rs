//! Spacings of a flight's runs: those that are planned, and which comes next.

use aero::fly::{Costs, FAMILY};

/// Runs that show an order.
const ORDER: usize = 3;

/// The coarsest spacing over the finest, below which values say more of where points happen to lie than of the spacing.
const SPREAD: f64 = 2.0;

/// Spacings of runs that are planned.
pub struct Family {
    /// The coarsest.
    pub(super) first: f64,
    pub(super) ratio: f64,
    /// True where there are just these: what is left of the budget makes no finer ones.
    pub(super) is_fixed: bool,
    /// Seconds that the finest may take.
    pub(super) seconds: f64,
}

impl Family {
    /// The finest that is planned.
    pub fn finest(&self) -> f64 {
        self.first / self.ratio.powi(FAMILY as i32 - 1)
    }

    /// Seconds that it may take.
    pub fn seconds_of_finest(&self) -> f64 {
        self.seconds
    }
}

/// The next spacing after so many `runs` whose coarsest and finest spacings are `ends`, the finest of which took `seconds`, with `left`
/// seconds left: a finer one, with others after it if they fit; where none fits, a coarser one until there are as many as show an order, and they
/// lie far enough apart.
pub fn next_spacing(
    costs: Costs,
    [coarsest, finest]: [f64; 2],
    runs: usize,
    seconds: f64,
    left: f64,
) -> Option<f64> {
    let planned = FAMILY.saturating_sub(runs).max(1);
    let ratio = (1..=planned)
        .rev()
        .find_map(|more| costs.next_ratio(seconds, left, more));
    ratio.map(|ratio| finest / ratio).or_else(|| {
        let too_few = runs < ORDER || coarsest < SPREAD * finest;
        (too_few && seconds < left).then_some(coarsest * costs.ratio)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn finer_runs_come_as_long_as_they_fit_and_coarser_ones_where_too_few_do() {
        let costs = Costs::new(3, false);
        let next = |runs, seconds, left| next_spacing(costs, [2.0, 1.0], runs, seconds, left);
        // Time for all, time for one, time for none of three or of one.
        assert!(next(1, 1.0, 1e4).is_some_and(|next| next < 1.0 / costs.ratio + 1e-12));
        let one = next(1, 10.0, 40.0).expect("a finer one");
        assert!(one < 1.0 && costs.next_ratio(10.0, 40.0, 3).is_none());
        assert_eq!(next(1, 30.0, 40.0), Some(2.0 * costs.ratio));
        assert_eq!(next(2, 30.0, 40.0), Some(2.0 * costs.ratio));
        assert_eq!(next(3, 30.0, 40.0), None);
        let close = next_spacing(costs, [1.4, 1.0], 3, 30.0, 40.0);
        assert_eq!(close, Some(1.4 * costs.ratio));
        assert_eq!(next(1, 50.0, 40.0), None);
    }
}
