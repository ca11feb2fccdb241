//! Medians of particle values over a stretch of one coordinate or a ball: the gas behind a reflected
//! shock, the pressure at a stagnation point.

use super::{MetricError, median, positive, same_length};

/// A median and what it is made of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Probe {
    /// The median.
    pub median: f64,
    /// Least value.
    pub least: f64,
    /// Greatest value.
    pub greatest: f64,
    /// Number of particles.
    pub particles: usize,
}

/// Median of the `values` whose coordinate lies within `stretch` (both ends included).
pub fn median_within(
    coordinates: &[f64],
    values: &[f64],
    stretch: [f64; 2],
) -> Result<Probe, MetricError> {
    same_length("values", values, coordinates.len())?;
    let inside = coordinates
        .iter()
        .zip(values)
        .filter(|(x, _)| (stretch[0]..=stretch[1]).contains(*x));
    probe(inside.map(|(_, v)| *v).collect())
}

/// Median of the `values` of particles within `radius` of `point`.
pub fn median_near(
    positions: &[[f64; 3]],
    values: &[f64],
    point: [f64; 3],
    radius: f64,
) -> Result<Probe, MetricError> {
    same_length("values", values, positions.len())?;
    positive("the probe's radius", radius)?;
    let near = |p: &[f64; 3]| {
        let d2: f64 = (0..3).map(|a| (p[a] - point[a]).powi(2)).sum();
        d2 <= radius * radius
    };
    let inside = positions.iter().zip(values).filter(|(p, _)| near(p));
    probe(inside.map(|(_, v)| *v).collect())
}

fn probe(mut values: Vec<f64>) -> Result<Probe, MetricError> {
    let particles = values.len();
    // Sorted by the median; NaN sorts to an end and so shows in one of the extremes.
    let median = median(&mut values);
    match (values.first(), values.last()) {
        (Some(&least), Some(&greatest)) => Ok(Probe {
            median,
            least,
            greatest,
            particles,
        }),
        _ => Err(MetricError::TooFew {
            what: "particles within the probe",
            found: 0,
            needed: 1,
            remedy: "widen it or use a finer spacing",
        }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_what_lies_within_counts() {
        let x = [0.0, 0.1, 0.2, 0.3, 0.4];
        let found = median_within(&x, &[9.0, 1.0, 3.0, 2.0, 9.0], [0.1, 0.3]).unwrap();
        assert_eq!(
            found,
            Probe {
                median: 2.0,
                least: 1.0,
                greatest: 3.0,
                particles: 3
            }
        );
    }

    #[test]
    fn a_ball_has_its_radius_and_an_even_number_its_middle() {
        let positions = [[0.0; 3], [0.1, 0.0, 0.0], [0.0, 0.0, 2.0]];
        let found = median_near(&positions, &[1.0, 2.0, 50.0], [0.0; 3], 0.5).unwrap();
        assert_eq!((found.median, found.particles), (1.5, 2));
    }

    #[test]
    fn an_empty_probe_is_refused() {
        let error = median_near(&[[0.0; 3]], &[1.0], [5.0; 3], 1.0).unwrap_err();
        assert!(error.to_string().contains("widen it"), "{error}");
    }
}
