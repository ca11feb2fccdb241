//! The swing of the loads on a body that sheds vortices: how often, how far, and about what.
//!
//! A period begins where the lift rises through the middle of its range. It must have been a quarter of the way down before, so that no ripple
//! about the middle counts as a period of its own.

use super::{MetricError, same_length};

/// Part of the way from the middle of the lift's range to its ends that it must go down before a rise begins a period.
const DOWN: f64 = 0.25;

/// The lift's range is that of this last part of the record: what is before it may have grown still.
const LATE: f64 = 0.5;

/// Loads over the last periods of a record.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shedding {
    /// Periods per time.
    pub frequency: f64,
    /// Mean of the drag over whole periods.
    pub drag: f64,
    /// Half of what lies between the least and the largest drag, mean of the periods.
    pub drag_amplitude: f64,
    /// Mean of the lift over whole periods.
    pub lift: f64,
    /// Half of what lies between the least and the largest lift, mean of the periods.
    pub lift_amplitude: f64,
    /// Largest departure of the lift's amplitude in one of the periods from their mean, in parts of that.
    pub unsteadiness: f64,
}

/// Reads the last `periods` whole periods off a record of drag and lift at increasing times, all in whatever units.
///
/// # Errors
/// Arrays of unequal length; fewer whole periods in the later half of the record, and so a lift that does not swing.
pub fn shedding(
    time: &[f64],
    drag: &[f64],
    lift: &[f64],
    periods: usize,
) -> Result<Shedding, MetricError> {
    same_length("drag", drag, time.len())?;
    same_length("lift", lift, time.len())?;
    let starts = starts(time, lift);
    let found = starts.len().saturating_sub(1);
    if periods == 0 || found < periods {
        return Err(MetricError::TooFew {
            what: "whole periods of the lift",
            found,
            needed: periods.max(1),
            remedy: "let the flow go on for longer, or start it with a larger disturbance",
        });
    }
    let starts = &starts[found - periods..];
    let (first, last) = (starts[0], starts[periods]);
    let swings = |values: &[f64]| -> Vec<f64> {
        let each = starts.windows(2).map(|ends| {
            let [low, high] = range(within(time, values, [ends[0], ends[1]]));
            0.5 * (high - low)
        });
        each.collect()
    };
    let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
    let lifts = swings(lift);
    let lift_amplitude = mean(&lifts);
    let apart = lifts.iter().map(|swing| (swing - lift_amplitude).abs());
    Ok(Shedding {
        frequency: periods as f64 / (last - first),
        drag: integral(time, drag, [first, last]) / (last - first),
        drag_amplitude: mean(&swings(drag)),
        lift: integral(time, lift, [first, last]) / (last - first),
        lift_amplitude,
        unsteadiness: apart.fold(0.0, f64::max) / lift_amplitude,
    })
}

/// Times in the later part of a record at which the lift rises through the middle of its range there.
fn starts(time: &[f64], lift: &[f64]) -> Vec<f64> {
    let (Some(&begin), Some(&end)) = (time.first(), time.last()) else {
        return Vec::new();
    };
    let from = time.partition_point(|&t| t < end - LATE * (end - begin));
    let (time, lift) = (&time[from..], &lift[from..]);
    let [low, high] = range(lift.iter().copied());
    let middle = 0.5 * (low + high);
    let down = middle - DOWN * (middle - low);
    let mut was_down = false;
    let mut starts = Vec::new();
    for k in 1..time.len() {
        let [a, b] = [lift[k - 1], lift[k]];
        was_down |= a < down;
        // A ripple may rise through the middle on the way down, and more than once on the way up: the first time there counts.
        if was_down && a < middle && b >= middle {
            starts.push(time[k - 1] + (time[k] - time[k - 1]) * (middle - a) / (b - a));
            was_down = false;
        }
    }
    starts
}

/// Values between two times.
fn within<'a>(
    time: &'a [f64],
    values: &'a [f64],
    [from, to]: [f64; 2],
) -> impl Iterator<Item = f64> + 'a {
    let pairs = time.iter().zip(values);
    pairs
        .filter(move |(t, _)| (from..=to).contains(*t))
        .map(|(_, value)| *value)
}

fn range(values: impl Iterator<Item = f64>) -> [f64; 2] {
    values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| {
        [low.min(value), high.max(value)]
    })
}

/// Integral over time between two times, of straight lines between the samples.
fn integral(time: &[f64], values: &[f64], [from, to]: [f64; 2]) -> f64 {
    let mut sum = 0.0;
    for k in 1..time.len() {
        let [a, b] = [time[k - 1].max(from), time[k].min(to)];
        if a < b {
            let slope = (values[k] - values[k - 1]) / (time[k] - time[k - 1]);
            let middle = 0.5 * (a + b) - time[k - 1];
            sum += (values[k - 1] + slope * middle) * (b - a);
        }
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::metrics::testing::Scatter;
    use std::f64::consts::TAU;

    const FREQUENCY: f64 = 0.0393;

    /// Drag about 1.35 that swings twice as often as the lift, which grows to an amplitude of 0.7 about 0.02, with a third harmonic; steps of
    /// unequal length.
    fn record(ripple: f64) -> [Vec<f64>; 3] {
        let mut scatter = Scatter::new(3);
        let mut record = [const { Vec::new() }; 3];
        let mut time = 0.0_f64;
        while time < 400.0 {
            let grown = 1.0 / (1.0 + (-(time - 80.0) / 8.0).exp());
            let phase = TAU * FREQUENCY * time;
            let lift = 0.02 + grown * (0.7 * phase.sin() + 0.02 * (3.0 * phase).sin());
            let drag = 1.2 + 0.15 * grown + 0.05 * grown * (2.0 * phase + 0.3).cos();
            for (column, value) in record.iter_mut().zip([time, drag, lift]) {
                column.push(value);
            }
            record[2]
                .last_mut()
                .into_iter()
                .for_each(|lift| *lift += ripple * scatter.next());
            time += 0.03 * (1.0 + 0.5 * scatter.next());
        }
        record
    }

    #[test]
    fn a_lift_that_grew_to_its_swing_shows_its_last_periods() {
        let [time, drag, lift] = record(0.0);
        for periods in [1, 3, 6] {
            let found = shedding(&time, &drag, &lift, periods).unwrap();
            assert!(
                (found.frequency / FREQUENCY - 1.0).abs() < 1e-5,
                "{found:?}"
            );
            assert!((found.drag - 1.35).abs() < 1e-5, "{found:?}");
            assert!((found.drag_amplitude - 0.05).abs() < 1e-5, "{found:?}");
            assert!((found.lift - 0.02).abs() < 1e-4, "{found:?}");
            // The third harmonic is opposite at the crests.
            assert!((found.lift_amplitude - 0.68).abs() < 1e-4, "{found:?}");
            assert!(found.unsteadiness < 1e-4, "{found:?}");
        }
    }

    #[test]
    fn ripples_are_no_periods() {
        let [time, drag, lift] = record(0.05);
        let found = shedding(&time, &drag, &lift, 4).unwrap();
        assert!(
            (found.frequency / FREQUENCY - 1.0).abs() < 5e-3,
            "{found:?}"
        );
        assert!((found.lift_amplitude - 0.7).abs() < 0.05, "{found:?}");
    }

    #[test]
    fn a_swing_that_still_grows_says_so() {
        let time: Vec<f64> = (0..8000).map(|k| 0.05 * f64::from(k)).collect();
        let lift: Vec<f64> = time
            .iter()
            .map(|t| (0.01 * t).exp() * (TAU * FREQUENCY * t).sin())
            .collect();
        let found = shedding(&time, &lift, &lift, 3).unwrap();
        // By a factor of exp(0.01 / f) from one period to the next.
        assert!((found.unsteadiness - 0.27).abs() < 0.03, "{found:?}");
    }

    #[test]
    fn a_lift_that_does_not_swing_is_refused() {
        let time: Vec<f64> = (0..100).map(f64::from).collect();
        for lift in [vec![0.3; 100], time.clone()] {
            assert!(matches!(
                shedding(&time, &lift, &lift, 2),
                Err(MetricError::TooFew { found: 0, .. })
            ));
        }
        assert!(shedding(&[], &[], &[], 1).is_err());
        assert!(shedding(&time, &time[1..], &time, 1).is_err());
    }
}
