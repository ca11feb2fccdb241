//! Numbers read off particles: shock angles and positions, plateaus, errors against profiles,
//! force statistics, orders of convergence.
//!
//! Every function takes plain arrays, one entry per particle; positions always have three
//! components, missing axes zero. Unless a function says otherwise, give it the gas only, without
//! ghosts and buffers. Nothing here knows what the right answer is.

mod cells;
pub mod crossing;
pub mod gradient;
pub mod gradient_angle;
pub mod interpolate;
pub mod invariants;
mod kernel;
mod least_squares;
pub mod line;
pub mod nose;
pub mod order;
pub mod plateau;
pub mod profile;
pub mod shedding;
pub mod shock_line;
pub mod stagnation;
pub mod stand_off;
#[cfg(test)]
mod testing;
pub mod window;

/// Why a number could not be read off the particles.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum MetricError {
    /// Arrays that belong together differ in length.
    #[error("{what} has {found} entries for {expected} particles")]
    Length {
        /// The array.
        what: &'static str,
        /// Its length.
        found: usize,
        /// The number of particles.
        expected: usize,
    },
    /// Too few particles or samples lie where the metric looks.
    #[error("{what}: found {found}, need {needed}; {remedy}")]
    TooFew {
        /// What was counted.
        what: &'static str,
        /// How many there are.
        found: usize,
        /// How many are needed.
        needed: usize,
        /// What to change.
        remedy: &'static str,
    },
    /// A value that must be positive is not.
    #[error("{0} must be a positive, finite number")]
    NotPositive(&'static str),
}

/// Refuses an array whose length is not that of the particles.
fn same_length<T>(what: &'static str, array: &[T], expected: usize) -> Result<(), MetricError> {
    if array.len() == expected {
        Ok(())
    } else {
        Err(MetricError::Length {
            what,
            found: array.len(),
            expected,
        })
    }
}

/// Refuses a value that is not positive and finite.
fn positive(what: &'static str, value: f64) -> Result<(), MetricError> {
    if value > 0.0 && value.is_finite() {
        Ok(())
    } else {
        Err(MetricError::NotPositive(what))
    }
}

/// Middle value of `values`, which are reordered; the mean of the two middle ones for an even
/// number, NaN for none.
pub fn median(values: &mut [f64]) -> f64 {
    if values.is_empty() {
        return f64::NAN;
    }
    values.sort_by(f64::total_cmp);
    let half = values.len() / 2;
    if values.len() % 2 == 1 {
        values[half]
    } else {
        0.5 * (values[half - 1] + values[half])
    }
}
