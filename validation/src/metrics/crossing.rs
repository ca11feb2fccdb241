//! Where scattered samples along a line cross a level: the building block of shock positions.
//!
//! The samples are smoothed by local straight lines, so that neither the disorder of particles nor
//! their crowding on the dense side of a shock shifts the crossing.

use super::least_squares::solve;

/// A crossing of the level.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing {
    /// Where.
    pub coordinate: f64,
    /// Change of the smoothed value over two widths to either side; its sign tells the direction.
    pub rise: f64,
}

/// All crossings of `level` by `values` over `coordinates`, in ascending order.
///
/// `width` is the half-width of the smoothing window, one to two particle spacings; stretches with
/// fewer than three samples in the window are bridged.
pub fn level_crossings(
    coordinates: &[f64],
    values: &[f64],
    level: f64,
    width: f64,
) -> Vec<Crossing> {
    let mut samples: Vec<[f64; 2]> = coordinates
        .iter()
        .zip(values)
        .filter(|(s, v)| s.is_finite() && v.is_finite())
        .map(|(s, v)| [*s, *v])
        .collect();
    samples.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let (Some(first), Some(last)) = (samples.first(), samples.last()) else {
        return Vec::new();
    };
    let step = 0.125 * width;
    if step.is_nan() || step <= 0.0 || (last[0] - first[0]) / step > 1e6 {
        return Vec::new();
    }
    let stations = ((last[0] - first[0]) / step) as usize + 1;
    let mut crossings = Vec::new();
    let mut before: Option<[f64; 2]> = None;
    for k in 0..=stations {
        let s = (first[0] + k as f64 * step).min(last[0]);
        let Some(value) = smoothed(&samples, s, width) else {
            continue;
        };
        if let Some([s0, v0]) = before
            && (v0 - level).signum() != (value - level).signum()
            && v0 != value
        {
            let at = s0 + (level - v0) / (value - v0) * (s - s0);
            let side = |offset: f64| {
                let place = (at + offset).clamp(first[0], last[0]);
                smoothed(&samples, place, width)
            };
            let (left, right) = (side(-2.0 * width), side(2.0 * width));
            let rise = right.unwrap_or(value) - left.unwrap_or(v0);
            crossings.push(Crossing {
                coordinate: at,
                rise,
            });
        }
        before = Some([s, value]);
    }
    crossings
}

/// Value at `s` of the straight line fitted to the samples within `width`, weighted towards the
/// middle; `samples` are sorted by coordinate.
fn smoothed(samples: &[[f64; 2]], s: f64, width: f64) -> Option<f64> {
    let from = samples.partition_point(|p| p[0] < s - width);
    let to = samples.partition_point(|p| p[0] <= s + width);
    if to - from < 3 {
        return None;
    }
    let mut a = [[0.0; 2]; 2];
    let mut b = [0.0; 2];
    for [at, value] in &samples[from..to] {
        let d = (at - s) / width;
        let weight = (1.0 - d * d).powi(2) + 1e-9;
        a[0][0] += weight;
        a[0][1] += weight * d;
        a[1][1] += weight * d * d;
        b[0] += weight * value;
        b[1] += weight * d * value;
    }
    a[1][0] = a[0][1];
    // A line through samples that all lie on one side would be an extrapolation: take the mean.
    let lean = a[0][1].abs() / a[0][0];
    if lean > 0.5 {
        return Some(b[0] / a[0][0]);
    }
    Some(solve(a, b).map_or(b[0] / a[0][0], |x| x[0]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::metrics::testing::Scatter;

    #[test]
    fn the_middle_of_a_noisy_step_is_found() {
        let mut scatter = Scatter::new(1);
        let places: Vec<f64> = (0..200)
            .map(|k| f64::from(k) * 0.05 + 0.02 * scatter.next())
            .collect();
        let values: Vec<f64> = places
            .iter()
            .map(|s| 2.0 + ((s - 4.7) / 0.3).tanh() + 0.02 * scatter.next())
            .collect();
        let found = level_crossings(&places, &values, 2.0, 0.3);
        assert_eq!(found.len(), 1, "{found:?}");
        assert!((found[0].coordinate - 4.7).abs() < 0.01, "{found:?}");
        assert!(found[0].rise > 1.5);
    }

    #[test]
    fn crowding_on_the_dense_side_does_not_shift_the_crossing() {
        let mut places: Vec<f64> = (0..40).map(|k| f64::from(k) * 0.1 - 4.0).collect();
        places.extend((0..200).map(|k| f64::from(k) * 0.02));
        let values: Vec<f64> = places
            .iter()
            .map(|s| 3.0 + 2.0 * (s / 0.3).tanh())
            .collect();
        let found = level_crossings(&places, &values, 3.0, 0.2);
        assert!(found[0].coordinate.abs() < 0.01, "{found:?}");
    }

    #[test]
    fn a_bump_is_crossed_twice_in_opposite_directions() {
        let places: Vec<f64> = (0..400).map(|k| f64::from(k) * 0.01).collect();
        let values: Vec<f64> = places
            .iter()
            .map(|s| (-(s - 2.0) * (s - 2.0)).exp())
            .collect();
        let found = level_crossings(&places, &values, 0.5, 0.05);
        assert_eq!(found.len(), 2);
        let half_width = 2_f64.ln().sqrt();
        assert!((found[0].coordinate - (2.0 - half_width)).abs() < 1e-3);
        assert!((found[1].coordinate - (2.0 + half_width)).abs() < 1e-3);
        assert!(found[0].rise > 0.0 && found[1].rise < 0.0);
    }

    #[test]
    fn no_samples_or_no_crossing_give_nothing() {
        assert!(level_crossings(&[], &[], 1.0, 0.1).is_empty());
        assert!(level_crossings(&[0.0, 0.1, 0.2], &[0.0, 0.0, 0.0], 1.0, 0.1).is_empty());
        assert!(level_crossings(&[0.0, 1.0], &[0.0, 2.0], 1.0, 0.0).is_empty());
    }
}
