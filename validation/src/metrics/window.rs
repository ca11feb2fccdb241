//! Statistics of a history (a force, a moment) over a window of time, and its distance from
//! another history.

use super::{MetricError, same_length};

/// Time-weighted statistics.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WindowStatistics {
    /// Mean over time.
    pub mean: f64,
    /// Root mean square over time.
    pub rms: f64,
    /// Standard deviation over time.
    pub deviation: f64,
    /// Least value.
    pub least: f64,
    /// Greatest value.
    pub greatest: f64,
    /// Number of samples in the window.
    pub samples: usize,
}

/// Statistics of `values` over `window` (first and last time), each sample weighted by the time it
/// stands for (trapezoidal rule), so that uneven time steps do not count uneven.
pub fn statistics(
    times: &[f64],
    values: &[f64],
    window: [f64; 2],
) -> Result<WindowStatistics, MetricError> {
    same_length("values", values, times.len())?;
    let inside: Vec<[f64; 2]> = times
        .iter()
        .zip(values)
        .filter(|(t, _)| (window[0]..=window[1]).contains(*t))
        .map(|(t, v)| [*t, *v])
        .collect();
    let duration = match inside.as_slice() {
        [first, .., last] if last[0] > first[0] => last[0] - first[0],
        _ => {
            return Err(MetricError::TooFew {
                what: "samples of the history inside the window",
                found: inside.len(),
                needed: 2,
                remedy: "widen the window or run longer",
            });
        }
    };
    let integral = |f: &dyn Fn(f64) -> f64| {
        let sum: f64 = inside
            .windows(2)
            .map(|w| 0.5 * (f(w[0][1]) + f(w[1][1])) * (w[1][0] - w[0][0]))
            .sum();
        sum / duration
    };
    let mean = integral(&|v| v);
    Ok(WindowStatistics {
        mean,
        rms: integral(&|v| v * v).sqrt(),
        deviation: integral(&|v| (v - mean) * (v - mean)).sqrt(),
        least: inside.iter().map(|s| s[1]).fold(f64::INFINITY, f64::min),
        greatest: inside
            .iter()
            .map(|s| s[1])
            .fold(f64::NEG_INFINITY, f64::max),
        samples: inside.len(),
    })
}

/// Root mean square over `window` of the difference from a reference history, which is interpolated
/// linearly to `times`; samples outside the reference's times are left out.
pub fn rms_difference(
    times: &[f64],
    values: &[f64],
    reference: (&[f64], &[f64]),
    window: [f64; 2],
) -> Result<f64, MetricError> {
    same_length("values", values, times.len())?;
    same_length("the reference's values", reference.1, reference.0.len())?;
    let (mut kept_times, mut differences) = (Vec::new(), Vec::new());
    for (t, v) in times.iter().zip(values) {
        if let Some(right) = interpolate(reference.0, reference.1, *t) {
            kept_times.push(*t);
            differences.push(v - right);
        }
    }
    Ok(statistics(&kept_times, &differences, window)?.rms)
}

/// Linear interpolation in a table of rising `x`; none outside it.
fn interpolate(x: &[f64], y: &[f64], at: f64) -> Option<f64> {
    let above = x.partition_point(|v| *v < at);
    if above == x.len() || (above == 0 && x[0] > at) {
        return None;
    }
    if above == 0 {
        return Some(y[0]);
    }
    let share = (at - x[above - 1]) / (x[above] - x[above - 1]);
    Some(y[above - 1] + share * (y[above] - y[above - 1]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn uneven_steps_do_not_count_uneven() {
        let times = [0.0, 0.1, 0.2, 0.3, 1.0];
        let values = [1.0, 1.0, 1.0, 1.0, 3.0];
        let found = statistics(&times, &values, [0.0, 1.0]).unwrap();
        assert_relative_eq!(found.mean, 1.7, max_relative = 1e-12);
        assert_eq!((found.least, found.greatest, found.samples), (1.0, 3.0, 5));
    }

    #[test]
    fn a_sine_has_its_known_mean_and_deviation() {
        let times: Vec<f64> = (0..=1000).map(|k| f64::from(k) / 1000.0).collect();
        let values: Vec<f64> = times
            .iter()
            .map(|t| 2.0 + (t * std::f64::consts::TAU).sin())
            .collect();
        let found = statistics(&times, &values, [0.0, 1.0]).unwrap();
        assert_relative_eq!(found.mean, 2.0, max_relative = 1e-9);
        assert_relative_eq!(found.deviation, 0.5_f64.sqrt(), max_relative = 1e-5);
        assert_relative_eq!(found.rms, 4.5_f64.sqrt(), max_relative = 1e-5);
    }

    #[test]
    fn the_difference_from_a_shifted_copy_is_the_shift() {
        let times: Vec<f64> = (0..50).map(|k| f64::from(k) * 0.1).collect();
        let values: Vec<f64> = times.iter().map(|t| t * t + 0.25).collect();
        let right: Vec<f64> = times.iter().map(|t| t * t).collect();
        let found = rms_difference(&times, &values, (&times, &right), [0.3, 4.0]).unwrap();
        assert_relative_eq!(found, 0.25, max_relative = 1e-9);
    }

    #[test]
    fn an_empty_window_is_refused() {
        assert!(statistics(&[0.0, 1.0], &[1.0, 1.0], [2.0, 3.0]).is_err());
    }
}
