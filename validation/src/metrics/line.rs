//! Errors of a flow along one line, as finite-volume codes state them: means over length, not over
//! particles, which crowd where gas is dense.

use super::{MetricError, same_length};

/// Mean of `|f - f_exact|` over the length of `window`, by the trapezoidal rule between
/// neighbouring particles of the line; what lies beyond the outermost particles counts as their
/// value. A value that is not finite makes the error infinite.
pub fn mean_error(
    coordinates: &[f64],
    values: &[f64],
    window: [f64; 2],
    exact: impl Fn(f64) -> f64,
) -> Result<f64, MetricError> {
    same_length("values", values, coordinates.len())?;
    let [low, high] = window;
    let mut points: Vec<(f64, f64)> = coordinates
        .iter()
        .copied()
        .zip(values.iter().copied())
        .filter(|(x, _)| (low..=high).contains(x))
        .collect();
    if points.len() < 2 {
        return Err(MetricError::TooFew {
            what: "particles in the window",
            found: points.len(),
            needed: 2,
            remedy: "check the window and the coordinates' range",
        });
    }
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    let errors: Vec<(f64, f64)> = points
        .iter()
        .map(|(x, value)| {
            let error = (value - exact(*x)).abs();
            (*x, if error.is_nan() { f64::INFINITY } else { error })
        })
        .collect();
    if errors.iter().any(|(_, error)| error.is_infinite()) {
        return Ok(f64::INFINITY);
    }
    let (first, last) = (errors[0], errors[errors.len() - 1]);
    let ends = (first.0 - low) * first.1 + (high - last.0) * last.1;
    let sum: f64 = errors
        .windows(2)
        .map(|pair| (pair[1].0 - pair[0].0) * 0.5 * (pair[0].1 + pair[1].1))
        .sum();
    Ok((ends + sum) / (high - low))
}

/// Mean of `exact` over the length of `window`.
pub fn mean(window: [f64; 2], exact: impl Fn(f64) -> f64) -> f64 {
    /// Jumps are met within a thousandth of a per cent of the window.
    const SAMPLES: u32 = 100_000;
    let [low, high] = window;
    let at = |k: u32| low + (high - low) * (f64::from(k) + 0.5) / f64::from(SAMPLES);
    (0..SAMPLES).map(|k| exact(at(k))).sum::<f64>() / f64::from(SAMPLES)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn crowded_particles_count_by_the_length_they_cover() {
        // Nine particles crowd at the left, where the error is 1; the right half is exact.
        let x: Vec<f64> = (0..=9).map(|k| f64::from(k) / 18.0).chain([1.0]).collect();
        let f: Vec<f64> = x.iter().map(|x| f64::from(u8::from(*x < 0.5))).collect();
        let error = mean_error(&x, &f, [0.0, 1.0], |_| 0.0).unwrap();
        assert!((error - (0.5 - 0.5 / 18.0)).abs() < 1e-12, "{error}");
        assert!((mean([0.0, 2.0], |x| x) - 1.0).abs() < 1e-12);
    }

    #[test]
    fn a_lost_particle_makes_the_error_infinite() {
        let error = mean_error(&[0.0, 1.0], &[f64::NAN, 1.0], [0.0, 1.0], |_| 1.0).unwrap();
        assert!(error.is_infinite());
    }
}
