//! How long a flight takes, and which spacings fit a budget.

/// Iterations in which flows settle, roughly.
const ITERATIONS: f64 = 600.0;

/// Points that a flow adds beyond those at its start.
const ADDED: f64 = 1.4;

/// Part of the budget that is planned: the rest is for what is not foreseen.
const PLANNED: f64 = 0.7;

/// Runs that are planned: as many as show how far values scatter about their trend.
pub const FAMILY: usize = 4;

/// Ratios of neighbouring spacings that still show an order, and the largest of use.
const RATIOS: [f64; 2] = [1.18, 2.0];

/// How the time goes with the spacing, and how far spacings lie apart.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Costs {
    /// Power of the inverse spacing.
    pub power: f64,
    /// Ratio of neighbouring spacings where nothing speaks against it.
    pub ratio: f64,
}

impl Costs {
    /// Of flows in so many dimensions: points, and iterations that grow slowly with them; or steps that grow as fast.
    pub fn new(dimension: usize, with_the_gas: bool) -> Self {
        let more = if with_the_gas { 1.0 } else { 0.4 };
        Self {
            power: dimension as f64 + more,
            ratio: if dimension == 3 { 1.35 } else { 1.6 },
        }
    }

    /// Seconds that a flow takes which a burst has shown to take so many before its first step, and so many a step.
    pub fn of_burst([before, a_step]: [f64; 2], steps_to_go: f64, settles: bool) -> f64 {
        before
            + if settles {
                a_step * ITERATIONS * ADDED
            } else {
                a_step * steps_to_go
            }
    }

    /// What a run takes over one that is coarser by the ratio.
    pub fn step(self) -> f64 {
        self.ratio.powf(self.power)
    }

    /// Spacing of a family's coarsest run over that of its finest.
    pub fn coarsest(self) -> f64 {
        self.ratio.powi(FAMILY as i32 - 1)
    }

    /// Seconds of a family whose coarsest takes `first`.
    pub fn of_family(self, first: f64) -> f64 {
        let step = self.step();
        (0..FAMILY as i32).map(|n| first * step.powi(n)).sum()
    }

    /// What a run takes of the time that it and so many finer ones take.
    pub fn share(self, finer: usize) -> f64 {
        let step = self.step();
        1.0 / (0..=finer as i32).map(|n| step.powi(n)).sum::<f64>()
    }

    /// Factor on the spacing of the coarsest, which takes `first` seconds, with which the family fits `budget` seconds: endless where nothing is left.
    pub fn fit(self, first: f64, budget: f64) -> f64 {
        if budget <= 0.0 {
            return f64::INFINITY;
        }
        (self.of_family(first) / (PLANNED * budget)).powf(1.0 / self.power)
    }

    /// Ratio of the next spacing to the last, which took `seconds`, where `left` seconds are left for so many; none where none
    /// fits.
    pub fn next_ratio(self, seconds: f64, left: f64, runs: usize) -> Option<f64> {
        let fits = |ratio: f64| {
            let step = ratio.powf(self.power);
            let sum: f64 = (1..=runs).map(|n| step.powi(n as i32)).sum();
            seconds * sum <= PLANNED * left
        };
        let [least, most] = [RATIOS[0], RATIOS[1].min(1.25 * self.ratio)];
        if !fits(least) {
            return None;
        }
        let steps = (0..=40).map(|k| most - (most - least) * f64::from(k) / 40.0);
        let mut steps = steps.into_iter();
        steps.find(|ratio| fits(*ratio))
    }
}

/// Minutes, for people.
pub fn minutes(seconds: f64) -> String {
    if seconds < 90.0 {
        format!("{seconds:.0} seconds")
    } else {
        format!("{:.1} minutes", seconds / 60.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_family_that_is_fitted_fits() {
        let costs = Costs::new(3, false);
        let factor = costs.fit(2.0, 600.0);
        let first = 2.0 * factor.powf(-costs.power);
        assert!((costs.of_family(first) - PLANNED * 600.0).abs() < 1e-6);
        assert_eq!(costs.fit(2.0, -17.0), f64::INFINITY);
    }

    #[test]
    fn shares_of_a_family_grow_to_all_that_is_left() {
        let costs = Costs::new(3, false);
        let first = costs.of_family(1.0) * costs.share(FAMILY - 1);
        assert!((first - 1.0).abs() < 1e-12);
        assert_eq!(costs.share(0), 1.0);
    }

    #[test]
    fn what_is_left_decides_the_next_spacing() {
        let costs = Costs::new(3, false);
        let wide = costs.next_ratio(1.0, 1e6, 1).unwrap();
        let narrow = costs.next_ratio(1.0, 4.0, 1).unwrap();
        assert!(wide > narrow && narrow >= RATIOS[0]);
        assert!(costs.next_ratio(1.0, 1.0, 1).is_none());
    }
}
