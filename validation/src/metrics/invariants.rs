//! Two checks that need no reference solution: in a steady stream without friction the total
//! enthalpy is the same everywhere, across shocks too, and the entropy never falls.

use super::{MetricError, median, same_length};

/// Departures from a constant, over the constant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Departure {
    /// Median of the departure's size.
    pub median: f64,
    /// The departure's size that 95 per cent of the particles stay below.
    pub percentile_95: f64,
    /// Largest departure's size.
    pub largest: f64,
}

/// Departure of the total enthalpy `gamma/(gamma-1) p/rho + u^2/2` from `free_stream`, its value in
/// the oncoming stream.
pub fn total_enthalpy(
    velocity: &[[f64; 3]],
    density: &[f64],
    pressure: &[f64],
    free_stream: f64,
    gamma: f64,
) -> Result<Departure, MetricError> {
    same_length("density", density, velocity.len())?;
    same_length("pressure", pressure, velocity.len())?;
    super::positive("the free stream's total enthalpy", free_stream)?;
    let departures = velocity
        .iter()
        .zip(density)
        .zip(pressure)
        .map(|((u, rho), p)| {
            let kinetic = 0.5 * u.iter().map(|v| v * v).sum::<f64>();
            (gamma / (gamma - 1.0) * p / rho + kinetic) / free_stream - 1.0
        });
    departure(departures.collect())
}

/// Departure of the entropy function `p / rho^gamma` from `expected`, its value on the streamlines
/// that the particles given lie on.
pub fn entropy(
    density: &[f64],
    pressure: &[f64],
    expected: f64,
    gamma: f64,
) -> Result<Departure, MetricError> {
    same_length("pressure", pressure, density.len())?;
    super::positive("the expected entropy function", expected)?;
    let departures = density
        .iter()
        .zip(pressure)
        .map(|(rho, p)| p / rho.powf(gamma) / expected - 1.0);
    departure(departures.collect())
}

fn departure(departures: Vec<f64>) -> Result<Departure, MetricError> {
    // NaN counts as infinitely far.
    let mut sizes: Vec<f64> = departures
        .into_iter()
        .map(|d| if d.is_nan() { f64::INFINITY } else { d.abs() })
        .collect();
    let middle = median(&mut sizes);
    let Some(&largest) = sizes.last() else {
        return Err(MetricError::TooFew {
            what: "particles",
            found: 0,
            needed: 1,
            remedy: "give the particles of the stream",
        });
    };
    let index = (0.95 * (sizes.len() - 1) as f64).round() as usize;
    Ok(Departure {
        median: middle,
        percentile_95: sizes[index],
        largest,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::normal::normal_shock;
    use approx::assert_relative_eq;

    #[test]
    fn total_enthalpy_is_the_same_on_both_sides_of_a_shock() {
        let shock = normal_shock(3.0, 1.4).unwrap();
        let c2 = (1.4 * shock.temperature_ratio).sqrt();
        let velocity = [
            [3.0 * 1.4_f64.sqrt(), 0.0, 0.0],
            [shock.mach * c2, 0.0, 0.0],
        ];
        let density = [1.0, shock.density_ratio];
        let pressure = [1.0, shock.pressure_ratio];
        let free = 3.5 + 0.5 * 9.0 * 1.4;
        let found = total_enthalpy(&velocity, &density, &pressure, free, 1.4).unwrap();
        assert!(found.largest < 1e-12, "{found:?}");
    }

    #[test]
    fn the_statistics_of_a_departure_are_those_of_its_size() {
        let density = vec![1.0; 101];
        let pressure: Vec<f64> = (0..101).map(|k| 1.0 - f64::from(k) / 1000.0).collect();
        let found = entropy(&density, &pressure, 1.0, 1.4).unwrap();
        assert_relative_eq!(found.median, 0.05, max_relative = 1e-9);
        assert_relative_eq!(found.percentile_95, 0.095, max_relative = 1e-9);
        assert_relative_eq!(found.largest, 0.1, max_relative = 1e-9);
    }

    #[test]
    fn a_lost_particle_is_infinitely_far() {
        let found = entropy(&[1.0, f64::NAN], &[1.0, 1.0], 1.0, 1.4).unwrap();
        assert!(found.largest.is_infinite());
    }
}
