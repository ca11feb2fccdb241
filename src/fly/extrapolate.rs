//! From values at a few spacings to the value at none, with a band.

use nalgebra::{Matrix3, Vector3};
use serde::Serialize;

/// Orders that a method of first to second order can show; others are chance (Eça, Hoekstra 2014).
const CREDIBLE: [f64; 2] = [0.5, 2.1];

/// Orders among which the best is looked for.
const ORDERS: [f64; 2] = [0.05, 8.0];

/// Values at least that show an order.
pub(super) const LEAST: usize = 3;

/// Safety factor on the error estimate where the observed order is credible and values lie near the fit (Roache 1994, J. Fluids
/// Eng. 116, 405, doi 10.1115/1.2910291).
const SAFE: f64 = 1.25;

/// And where not, or only two spacings are known.
const UNSAFE: f64 = 3.0;

/// A value with its band.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Extrapolated {
    /// At a spacing of nothing.
    pub value: f64,
    /// Half width of the band.
    pub band: f64,
    /// Observed order; none where the values do not show one.
    pub order: Option<f64>,
}

/// From `(spacing, value)` pairs, coarse to fine.
///
/// `f = f0 + c h^p` is fitted to three values or more, by least squares with weights 1/h; with four or more, what they scatter by
/// widens the band [Eça, Hoekstra 2014, J. Comput. Phys. 262, 104, doi 10.1016/j.jcp.2014.01.006]. Where p is credible, f0 is the
/// value, and the band is `1.25 |f - f0|` at the finest, by first order where a higher one shows, plus the scatter. Where it is
/// not, or is no longer when the first or the last of four values or more is left out, the finest value stands, and the band is the wider one of the
/// fits of first and second order, `3 |f - f0|` where values scatter by more than they change or leave the order to chance, and no less than three
/// times what the last step changed. Values that come together faster
/// than any order of the method began too coarse: the coarsest is left out, as long as three are left; where those do so too, errors of first
/// and second order cancel, and the band reaches `1.25 |f - f0|` of `f = f0 + a h + b h^2` as well (the same authors). Two values have a band of three times their difference, a single one an infinite one.
pub fn extrapolate(runs: &[(f64, f64)]) -> Extrapolated {
    let (value, band) = match runs {
        [] => (f64::NAN, f64::INFINITY),
        [(_, value)] => (*value, f64::INFINITY),
        [first, second] => (second.1, UNSAFE * (first.1 - second.1).abs()),
        [.., first, before, last] => return of_many(runs, [*first, *before, *last]),
    };
    Extrapolated {
        value,
        band,
        order: None,
    }
}

/// From runs that show no trend: the last value, and three times what all of them differ by.
pub fn beyond(runs: &[(f64, f64)]) -> Extrapolated {
    let [most, least] = ends(runs);
    let last = runs.last().map_or(f64::NAN, |run| run.1);
    Extrapolated {
        value: last,
        band: if runs.len() < 2 {
            f64::INFINITY
        } else {
            UNSAFE * (most - least)
        },
        order: None,
    }
}

/// The largest and the least value.
fn ends(runs: &[(f64, f64)]) -> [f64; 2] {
    let values = runs.iter().map(|run| run.1);
    [
        values.clone().fold(f64::MIN, f64::max),
        values.fold(f64::MAX, f64::min),
    ]
}

/// With the last three of `runs`.
fn of_many(runs: &[(f64, f64)], [first, before, last]: [(f64, f64); 3]) -> Extrapolated {
    let order = observed_order(runs);
    if let [_, finer @ ..] = runs
        && finer.len() >= LEAST
        && order.is_some_and(|p| p > CREDIBLE[1])
    {
        return extrapolate(finer);
    }
    let is_chance = runs.len() > LEAST && parts_differ(runs);
    if let Some(p) = order.filter(|p| is_credible(*p) && !is_chance) {
        // A method of second order at best is not trusted to be better, and shocks are of first order.
        let fit = Fit::new(runs, p.min(2.0));
        return Extrapolated {
            value: fit.limit,
            band: SAFE * Fit::new(runs, p.min(1.0)).error(last) + fit.doubt(last),
            order,
        };
    }
    // Mean change from run to run: what scatters by less can be trusted to show a trend.
    let [most, least] = ends(runs);
    let change = (most - least) / (runs.len() - 1) as f64;
    let bands = [1.0, 2.0].map(|p| {
        let fit = Fit::new(runs, p);
        let is_trend = fit.scatter < change && !is_chance;
        let factor = if is_trend { SAFE } else { UNSAFE };
        factor * (fit.error(last) + fit.doubt(last))
    });
    let mut step = (last.1 - before.1).abs();
    if order.is_none() {
        step = step.max(0.5 * (before.1 - first.1).abs());
    }
    let turned = UNSAFE * step;
    let cancelled = if order.is_some_and(|p| p > CREDIBLE[1]) {
        SAFE * (last.1 - limit_of_two_orders(runs)).abs()
    } else {
        0.0
    };
    Extrapolated {
        value: last.1,
        band: bands.into_iter().fold(turned.max(cancelled), f64::max),
        order,
    }
}

fn is_credible(order: f64) -> bool {
    (CREDIBLE[0]..=CREDIBLE[1]).contains(&order)
}

/// True where values show no credible order any more once the first, or the last, is left out.
fn parts_differ(runs: &[(f64, f64)]) -> bool {
    let parts = [&runs[1..], &runs[..runs.len() - 1]];
    parts
        .into_iter()
        .any(|part| !observed_order(part).is_some_and(is_credible))
}

/// `f0 + c h^p` with a given p, by weighted least squares.
struct Fit {
    power: f64,
    limit: f64,
    slope: f64,
    /// Standard deviation of the values from the fit; of three values none is known.
    scatter: f64,
    /// Sum of the weighted squares of what is left.
    left: f64,
}

impl Fit {
    fn new(runs: &[(f64, f64)], power: f64) -> Self {
        let total: f64 = runs.iter().map(|(h, _)| 1.0 / h).sum();
        let weighted = |of: &dyn Fn(f64, f64) -> f64| -> f64 {
            let parts = runs.iter().map(|(h, f)| of(h.powf(power), *f) / h);
            parts.sum::<f64>() / total
        };
        let (x, f) = (weighted(&|x, _| x), weighted(&|_, f| f));
        let slope = weighted(&|a, b| (a - x) * (b - f)) / weighted(&|a, _| (a - x) * (a - x));
        let limit = f - slope * x;
        let left = weighted(&|a, b| (b - limit - slope * a).powi(2));
        let free = runs.len().saturating_sub(3);
        let scatter = if free == 0 {
            0.0
        } else {
            (left * runs.len() as f64 / free as f64).sqrt()
        };
        Self {
            power,
            limit,
            slope,
            scatter,
            left,
        }
    }

    /// What the fit says is wrong with a value.
    fn error(&self, (h, _): (f64, f64)) -> f64 {
        (self.slope * h.powf(self.power)).abs()
    }

    /// What is wrong with the fit.
    fn doubt(&self, (h, f): (f64, f64)) -> f64 {
        self.scatter + (f - self.limit - self.slope * h.powf(self.power)).abs()
    }
}

/// The f0 of `f0 + a h + b h^2`, by least squares with weights 1/h.
fn limit_of_two_orders(runs: &[(f64, f64)]) -> f64 {
    let (mut normal, mut right) = (Matrix3::zeros(), Vector3::zeros());
    let unit = runs.last().map_or(1.0, |run| run.0);
    for (spacing, f) in runs {
        let h = spacing / unit;
        let terms = Vector3::new(1.0, h, h * h);
        normal += terms * terms.transpose() / h;
        right += terms * (f / h);
    }
    normal
        .lu()
        .solve(&right)
        .map_or(f64::INFINITY, |found| found[0])
}

/// The p of the best fit; none where three values turn back, or the best is the least that is looked for.
fn observed_order(runs: &[(f64, f64)]) -> Option<f64> {
    const STEPS: i32 = 200;
    if let [.., a, b, c] = runs
        && runs.len() == 3
        && (a.1 - b.1) * (b.1 - c.1) <= 0.0
    {
        return None;
    }
    let left = |p: f64| Fit::new(runs, p).left;
    let [least, most] = ORDERS;
    let width = (most - least) / f64::from(STEPS);
    let best = (0..=STEPS)
        .map(|n| least + width * f64::from(n))
        .min_by(|a, b| left(*a).total_cmp(&left(*b)))?;
    if best == least {
        return None;
    }
    let (mut low, mut high) = (best - width, (best + width).min(most));
    for _ in 0..80 {
        let (a, b) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
        if left(a) < left(b) {
            high = b;
        } else {
            low = a;
        }
    }
    Some(0.5 * (low + high))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A coarsest value that is far off the second order of the others.
    #[test]
    fn a_start_that_is_too_coarse_is_left_out() {
        let value = |h: f64| 2.0 + 0.3 * h * h;
        let runs = [0.16, 0.1, 0.0625].map(|h| (h, value(h)));
        let with = [&[(0.256, 2.2)][..], &runs].concat();
        let [with, without] = [extrapolate(&with), extrapolate(&runs)];
        assert_eq!(with, without);
        assert!((with.value - 2.0).abs() < 1e-9, "{with:?}");
        let error = (value(0.0625) - 2.0).abs();
        assert!(with.band > error && with.band < 10.0 * error, "{with:?}");
    }

    #[test]
    fn a_power_law_leads_to_its_limit_and_the_band_holds_the_finest_value() {
        for p in [1.0, 1.5, 2.0] {
            let runs = [0.3, 0.2, 0.12].map(|h: f64| (h, 1.0 + 0.4 * h.powf(p)));
            let found = extrapolate(&runs);
            assert!((found.value - 1.0).abs() < 1e-6, "{found:?}");
            assert!((found.order.unwrap() - p).abs() < 1e-5);
            assert!(found.band > runs[2].1 - 1.0);
        }
    }

    #[test]
    fn the_limit_of_values_that_scatter_lies_in_the_band() {
        let h = [0.5_f64, 0.36, 0.25, 0.18, 0.13];
        for shift in 0..5 {
            let runs = std::array::from_fn::<_, 5, _>(|n| {
                let noise = [0.004, -0.006, 0.005, 0.001, -0.004][(n + shift) % 5];
                (h[n], 1.0 + 0.1 * h[n] + noise)
            });
            for from in 0..2 {
                let found = extrapolate(&runs[from..]);
                assert!((found.value - 1.0).abs() < found.band, "{runs:?} {found:?}");
                assert!(found.band < 0.1, "{found:?}");
            }
        }
    }

    #[test]
    fn values_that_turn_back_or_run_away_have_wide_bands() {
        let turned = extrapolate(&[(0.4, 1.0), (0.2, 1.2), (0.1, 1.1)]);
        assert_eq!((turned.value, turned.order), (1.1, None));
        assert!(turned.band >= 0.3 - 1e-12);
        let away = extrapolate(&[(0.4, 1.0), (0.2, 1.1), (0.1, 1.3)]);
        assert_eq!(away.value, 1.3);
        assert!(away.band > 0.5);
        assert!(extrapolate(&[(0.1, 1.0)]).band.is_infinite());
    }

    /// Values that go away from where they must come to, as those of a plate do that is as thin as a cell.
    #[test]
    fn runs_that_have_not_seen_the_body_have_a_band_as_wide_as_all_their_differences() {
        let runs = [(0.4, 4.67), (0.3, 4.78), (0.22, 4.99), (0.15, 5.07)];
        let found = beyond(&runs);
        assert_eq!((found.value, found.order), (5.07, None));
        assert!((found.band - 1.2).abs() < 1e-9, "{found:?}");
        assert!(extrapolate(&runs).band < found.band);
        assert!(beyond(&runs[..1]).band.is_infinite());
    }

    /// Runs that are too coarse for a trend, whose errors cancel by chance.
    #[test]
    fn an_order_that_hangs_on_one_run_is_not_believed() {
        let runs = [
            (0.122, 0.18376),
            (0.0961, 0.18409),
            (0.0715, 0.1849),
            (0.0424, 0.18543),
        ];
        assert!(observed_order(&runs).is_some_and(is_credible));
        let found = extrapolate(&runs);
        assert_eq!((found.value, found.order.is_some()), (0.18543, true));
        // Theory has 0.1879.
        assert!(found.band > 0.0025, "{found:?}");
        let trend = [0.4, 0.3, 0.2, 0.1].map(|h| (h, 1.0 + h));
        assert!((extrapolate(&trend).value - 1.0).abs() < 1e-6);
    }

    /// The normal force of a cone of 15 degrees at 5 degrees of incidence, Mach 3: the tip's is too large, the rest's too small.
    #[test]
    fn errors_of_two_orders_that_cancel_are_seen() {
        let runs = [
            (0.1472, 0.15668),
            (0.1172, 0.15353),
            (0.0914, 0.15193),
            (0.0591, 0.15139),
        ];
        let found = extrapolate(&runs);
        // Finite volumes in conical coordinates have 0.1547.
        assert!((found.value - 0.1547).abs() < found.band, "{found:?}");
        assert!(found.band < 0.005, "{found:?}");
        let exact = |h: f64| 2.0 - 0.3 * h + 0.8 * h * h;
        let runs = [0.3, 0.25, 0.2].map(|h| (h, exact(h)));
        assert!((limit_of_two_orders(&runs) - 2.0).abs() < 1e-9);
    }

    #[test]
    fn a_suspiciously_fast_convergence_is_not_believed() {
        let found = extrapolate(&[(0.4, 2.0), (0.2, 1.01), (0.1, 1.0)]);
        assert!(found.order.unwrap() > 2.5);
        assert!(found.band >= 3.0 * 0.01 / 3.0 - 1e-12, "{found:?}");
    }
}
