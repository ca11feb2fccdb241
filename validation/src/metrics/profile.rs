//! Errors of particle values against an exact profile along one coordinate.

use super::{MetricError, same_length};

/// Particle means of the error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ProfileError {
    /// Mean of `|f - f_exact|`.
    pub l1: f64,
    /// Root mean square of `f - f_exact`.
    pub l2: f64,
    /// Largest `|f - f_exact|`.
    pub largest: f64,
    /// `l1` over the mean of `|f_exact|`.
    pub l1_relative: f64,
    /// Number of particles compared.
    pub particles: usize,
}

/// Compares `values` at `coordinates` with `exact`, particle by particle. Particles where `exact`
/// gives none are left out, and so can be used to look at part of a profile.
///
/// A value that is not finite makes the error infinite: a broken run must not look good.
pub fn profile_error(
    coordinates: &[f64],
    values: &[f64],
    exact: impl Fn(f64) -> Option<f64>,
) -> Result<ProfileError, MetricError> {
    same_length("values", values, coordinates.len())?;
    let (mut sum, mut squares, mut largest, mut size) = (0.0, 0.0, 0.0_f64, 0.0);
    let mut particles = 0;
    for (x, value) in coordinates.iter().zip(values) {
        let Some(right) = exact(*x) else { continue };
        let error = (value - right).abs();
        let error = if error.is_nan() { f64::INFINITY } else { error };
        sum += error;
        squares += error * error;
        largest = largest.max(error);
        size += right.abs();
        particles += 1;
    }
    if particles == 0 {
        return Err(MetricError::TooFew {
            what: "particles where the exact profile is known",
            found: 0,
            needed: 1,
            remedy: "check the coordinates' range",
        });
    }
    let count = f64::from(particles);
    Ok(ProfileError {
        l1: sum / count,
        l2: (squares / count).sqrt(),
        largest,
        l1_relative: sum / size,
        particles: particles as usize,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn the_means_are_over_the_particles() {
        let error =
            profile_error(&[0.0, 1.0, 2.0, 3.0], &[1.0, 2.0, 1.0, 4.0], |_| Some(1.0)).unwrap();
        assert_relative_eq!(error.l1, 1.0);
        assert_relative_eq!(error.l2, 2.5_f64.sqrt());
        assert_relative_eq!(error.largest, 3.0);
        assert_relative_eq!(error.l1_relative, 1.0);
    }

    #[test]
    fn places_without_an_exact_value_are_left_out() {
        let exact = |x: f64| (x < 1.5).then_some(0.0);
        let error = profile_error(&[0.0, 1.0, 2.0], &[1.0, 1.0, 100.0], exact).unwrap();
        assert_eq!(error.particles, 2);
        assert_relative_eq!(error.l1, 1.0);
        assert!(profile_error(&[5.0], &[1.0], exact).is_err());
    }

    #[test]
    fn a_lost_particle_makes_the_error_infinite() {
        let error = profile_error(&[0.0, 1.0], &[1.0, f64::NAN], |_| Some(1.0)).unwrap();
        assert!(error.l1.is_infinite() && error.largest.is_infinite());
    }
}
