//! Order of convergence: the slope of error against spacing on log axes.

use super::MetricError;
use super::least_squares::{Row, fit};

/// The power law `error = factor * spacing^order` fitted to several runs.
#[derive(Clone, Debug, PartialEq)]
pub struct Order {
    /// Exponent.
    pub order: f64,
    /// Factor.
    pub factor: f64,
    /// Orders between neighbouring spacings, from the coarsest pair to the finest.
    pub pairwise: Vec<f64>,
}

/// Fits the order to runs of different `spacings`; errors of zero, negative or not finite are left
/// out (they have no logarithm).
pub fn convergence_order(spacings: &[f64], errors: &[f64]) -> Result<Order, MetricError> {
    super::same_length("errors", errors, spacings.len())?;
    let mut runs: Vec<[f64; 2]> = spacings
        .iter()
        .zip(errors)
        .filter(|(h, e)| **h > 0.0 && **e > 0.0 && h.is_finite() && e.is_finite())
        .map(|(h, e)| [h.ln(), e.ln()])
        .collect();
    runs.sort_by(|a, b| b[0].total_cmp(&a[0]));
    let rows: Vec<Row<2>> = runs
        .iter()
        .map(|[h, e]| Row {
            terms: [1.0, *h],
            value: *e,
        })
        .collect();
    let line = fit(&rows).ok_or(MetricError::TooFew {
        what: "runs of different spacing with a positive error",
        found: runs.len(),
        needed: 2,
        remedy: "add runs at other spacings",
    })?;
    Ok(Order {
        order: line.x[1],
        factor: line.x[0].exp(),
        pairwise: runs
            .windows(2)
            .map(|w| (w[1][1] - w[0][1]) / (w[1][0] - w[0][0]))
            .collect(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn a_power_law_gives_its_exponent_whatever_the_order_of_runs() {
        let spacings = [0.1, 0.4, 0.2];
        let errors = spacings.map(|h: f64| 3.0 * h.powf(1.5));
        let found = convergence_order(&spacings, &errors).unwrap();
        assert_relative_eq!(found.order, 1.5, max_relative = 1e-12);
        assert_relative_eq!(found.factor, 3.0, max_relative = 1e-12);
        assert_eq!(found.pairwise.len(), 2);
    }

    #[test]
    fn one_spacing_has_no_order() {
        assert!(convergence_order(&[0.1, 0.1], &[1.0, 2.0]).is_err());
        assert!(convergence_order(&[0.1, 0.2], &[0.0, 2.0]).is_err());
    }
}
