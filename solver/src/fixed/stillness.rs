//! Whether a value that was watched over iterations has come to rest.

/// Iterations over which nothing may change.
pub const WINDOW: usize = 20;

/// The most iterations of a window.
pub const LONGEST: usize = 3 * WINDOW;

/// How what was watched is looked at.
#[derive(Clone, Copy, Debug)]
pub struct Look {
    /// Iterations of each of the two windows that a creep is told by.
    pub window: usize,
    /// Largest part of a window's way that the next is taken to go.
    slowest: f64,
}

impl Look {
    /// Of any flow.
    pub const USUAL: Self = Self {
        window: WINDOW,
        slowest: SLOWEST,
    };
    /// Of a flow that begins near its end: what it has not left for as long it hardly leaves later.
    pub const NEAR: Self = Self {
        window: WINDOW / 2,
        slowest: 0.99, // the square root of that of twice the window
    };
    /// Of a plane stream slower than sound that bodies turn far away: their lift goes by that turn, and the turn by their lift, a little in each
    /// iteration, so that a lift near its end creeps.
    pub const TURNED: Self = Self {
        window: LONGEST,
        slowest: SLOWEST,
    };
    /// Of a flow that takes long to come to rest: of viscous gas, or slower than sound between sides that hold a pressure.
    pub const LONG: Self = Self {
        window: WINDOW,
        slowest: SLOWEST_OF_ALL,
    };
}

/// Part of its range that a value that creeps goes on by in a window.
const STRAIGHT: f64 = 0.9;

/// Largest part of a window's way that the next is taken to go, so that what only seems to creep is not waited for for ever.
const SLOWEST: f64 = 0.98;

/// The same where heat has to spread, or a pressure to drive a whole duct.
const SLOWEST_OF_ALL: f64 = 0.9995;

/// How far apart values are.
pub fn range(values: &[f64]) -> f64 {
    let most = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let least = values.iter().copied().fold(f64::INFINITY, f64::min);
    most - least
}

/// Range of the last values of two windows; more of one that creeps, all through both windows and one way: what is left of its way if
/// each window goes on to take the same part of the one before, at most the slowest.
pub fn change(values: &[f64], Look { window, slowest }: Look) -> f64 {
    let (first, second) = (&values[..=window], &values[window..]);
    let last = range(&values[values.len() - 1 - window.max(WINDOW)..]);
    let way = |values: &[f64]| values[values.len() - 1] - values[0];
    let creeps = |values: &[f64]| way(values).abs() > STRAIGHT * range(values);
    let (before, now) = (way(first), way(second));
    if creeps(first) && creeps(second) && before * now > 0.0 {
        let part = (now / before).min(slowest);
        last.max(now.abs() / (1.0 - part))
    } else {
        last
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn watched(value: impl Fn(f64) -> f64) -> Vec<f64> {
        (0..=2 * WINDOW).map(|k| value(k as f64)).collect()
    }

    #[test]
    fn what_creeps_is_far_from_where_it_goes() {
        // Half a per cent of the way in each iteration: the rest of the way is what it is at the start of the second window.
        let change = change(&watched(|k| (-0.005 * k).exp()), Look::USUAL);
        let rest = (-0.005 * WINDOW as f64).exp();
        assert!((change / rest - 1.0).abs() < 1e-9, "{change} {rest}");
    }

    /// Half the windows tell as much: neither a creep nor what changed in the first of them is missed.
    #[test]
    fn what_begins_near_is_looked_at_as_strictly() {
        let near = |value: &dyn Fn(f64) -> f64| {
            let values: Vec<f64> = (0..=WINDOW).map(|k| value(k as f64)).collect();
            change(&values, Look::NEAR)
        };
        let rest = near(&|k| (-0.005 * k).exp()) / (-0.005 * 0.5 * WINDOW as f64).exp();
        assert!((rest - 1.0).abs() < 1e-9, "{rest}");
        assert_eq!(near(&|k| if k < 3.0 { 1.0 } else { 0.0 }), 1.0);
    }

    /// A lift that creeps and swings a little, so that no window goes one way: what it creeps by in a long one tells.
    #[test]
    fn what_creeps_and_swings_is_seen_over_many_iterations() {
        let lift = |k: usize| 2e-5 * k as f64 + 2e-4 * (0.7 * k as f64).sin();
        let values: Vec<f64> = (0..=2 * LONGEST).map(lift).collect();
        let usual = change(&values[2 * (LONGEST - WINDOW)..], Look::USUAL);
        assert!(usual < 1e-3, "{usual}");
        let turned = change(&values, Look::TURNED);
        assert!(turned > 1e-3, "{turned}");
    }

    #[test]
    fn what_swings_changes_by_its_range() {
        let change = change(&watched(|k| (1.3 * k).sin()), Look::USUAL);
        assert!((1.9..=2.0).contains(&change), "{change}");
    }
}
