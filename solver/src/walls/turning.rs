//! Prescribed rotation: angle, angular velocity and angular acceleration of a body over time.

use std::f64::consts::TAU;

use nalgebra::Vector3;

use crate::problem::Turning;

impl Turning {
    /// Angle turned through since time zero, as a rotation vector.
    pub fn angle(&self, time: f64) -> Vector3<f64> {
        match self {
            Self::Steady(rate) => rate * time,
            Self::Cosine {
                amplitude,
                period,
                phase,
            } => {
                let frequency = TAU / period;
                amplitude * (((frequency * time + phase).sin() - phase.sin()) / frequency)
            }
            Self::Table { axis, times, rates } => {
                axis * (integral(times, rates, time) - integral(times, rates, 0.0))
            }
        }
    }

    /// Angular velocity.
    pub fn rate(&self, time: f64) -> Vector3<f64> {
        match self {
            Self::Steady(rate) => *rate,
            Self::Cosine {
                amplitude,
                period,
                phase,
            } => amplitude * (TAU / period * time + phase).cos(),
            Self::Table { axis, times, rates } => {
                let piece = Piece::at(times, rates, time);
                axis * (piece.rate + piece.slope * piece.elapsed)
            }
        }
    }

    /// Angular acceleration.
    pub fn acceleration(&self, time: f64) -> Vector3<f64> {
        match self {
            Self::Steady(_) => Vector3::zeros(),
            Self::Cosine {
                amplitude,
                period,
                phase,
            } => {
                let frequency = TAU / period;
                amplitude * (-frequency * (frequency * time + phase).sin())
            }
            Self::Table { axis, times, rates } => axis * Piece::at(times, rates, time).slope,
        }
    }
}

/// The straight line of a table that holds at one time.
struct Piece {
    /// Rate where the line begins.
    rate: f64,
    slope: f64,
    /// Time since it began; negative before the table.
    elapsed: f64,
}

impl Piece {
    fn at(times: &[f64], rates: &[f64], time: f64) -> Self {
        let after = times.partition_point(|&t| t <= time);
        let begin = after.saturating_sub(1);
        let slope = if after == 0 || after == times.len() {
            0.0
        } else {
            (rates[after] - rates[begin]) / (times[after] - times[begin])
        };
        Self {
            rate: rates[begin],
            slope,
            elapsed: time - times[begin],
        }
    }
}

/// Integral of a table's rate from its first time to `time`.
fn integral(times: &[f64], rates: &[f64], time: f64) -> f64 {
    let whole: f64 = (1..times.len())
        .take_while(|&k| times[k] <= time)
        .map(|k| 0.5 * (rates[k] + rates[k - 1]) * (times[k] - times[k - 1]))
        .sum();
    let Piece {
        rate,
        slope,
        elapsed,
    } = Piece::at(times, rates, time);
    whole + elapsed * (rate + 0.5 * slope * elapsed)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn turnings() -> [Turning; 3] {
        let axis = Vector3::new(0.0, 0.6, 0.8);
        [
            Turning::Steady(axis * 3.0),
            Turning::Cosine {
                amplitude: axis * 5.0,
                period: 1.5,
                phase: 0.4,
            },
            Turning::Table {
                axis,
                times: vec![0.25, 1.0, 3.0],
                rates: vec![1.0, -2.0, 4.0],
            },
        ]
    }

    #[test]
    fn rate_and_acceleration_are_derivatives_of_the_angle() {
        let step = 1e-4;
        for turning in turnings() {
            for time in [0.1, 0.7, 1.9, 4.0] {
                let (before, after) = (time - step, time + step);
                let rate = (turning.angle(after) - turning.angle(before)) / (2.0 * step);
                let acceleration = (turning.rate(after) - turning.rate(before)) / (2.0 * step);
                assert!((rate - turning.rate(time)).norm() < 1e-6, "{turning:?}");
                let slope = turning.acceleration(time);
                assert!((acceleration - slope).norm() < 1e-5, "{turning:?}");
            }
        }
    }

    #[test]
    fn a_body_starts_unturned() {
        for turning in turnings() {
            assert_eq!(turning.angle(0.0), Vector3::zeros(), "{turning:?}");
        }
    }
}
