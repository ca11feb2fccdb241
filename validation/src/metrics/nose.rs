//! What a surface shows at the nose of a body of revolution, from what it shows around it: cut cells scatter it from panel to panel.

use super::MetricError;
use super::least_squares::{Row, fit};

/// A value that is even about the nose.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AtNose {
    /// At the nose.
    pub value: f64,
    /// How much of that it has lost away from there, over the square of the angle in radians.
    pub bend: f64,
}

/// Fits `value (1 - bend a^2 + c a^4)` to the `values` at `angles` (radians) below `reach`.
pub fn at_nose(angles: &[f64], values: &[f64], reach: f64) -> Result<AtNose, MetricError> {
    super::same_length("values", values, angles.len())?;
    let rows: Vec<Row<3>> = angles
        .iter()
        .zip(values)
        .filter(|(angle, _)| angle.abs() < reach)
        .map(|(angle, value)| Row {
            terms: [1.0, angle.powi(2), angle.powi(4)],
            value: *value,
        })
        .collect();
    let [value, slope, _] = fit(&rows)
        .ok_or(MetricError::TooFew {
            what: "panels around the nose",
            found: rows.len(),
            needed: 3,
            remedy: "use a finer spacing",
        })?
        .x;
    Ok(AtNose {
        value,
        bend: -slope / value,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_even_polynomial_is_met_and_what_is_far_off_is_left_out() {
        let angles: Vec<f64> = (0..40).map(|k| 0.02 * f64::from(k)).collect();
        let value = |a: f64| {
            let far = if a < 0.5 { 0.0 } else { 1e6 };
            5.0 * (1.0 - 0.7 * a * a + 0.2 * a.powi(4)) + far
        };
        let values: Vec<f64> = angles.iter().map(|a| value(*a)).collect();
        let nose = at_nose(&angles, &values, 0.5).unwrap();
        assert!((nose.value - 5.0).abs() < 1e-9 && (nose.bend - 0.7).abs() < 1e-9);
        assert!(at_nose(&angles, &values, 0.03).is_err());
    }
}
