//! Which joints of an outline are creases, between smooth faces, and which belong to one.

/// A tangent that turns less than this (radians) is smooth: arcs and lines made to be tangent
/// are so to rounding.
const SMOOTH_TURN: f64 = 1e-6;

/// A joint between samples of a curve turns less than this (radians; 30 degrees).
const COARSEST: f64 = std::f64::consts::FRAC_PI_6;

/// Joints between samples that turn less than this (radians; 3 degrees) are no creases: that is how uneven measured points are.
const FLAT: f64 = std::f64::consts::PI / 60.0;

/// Joints of one curve bend alike: turns over lengths differ by this factor at most from one to the next.
const ALIKE: f64 = 4.0;

/// So many joints one after another, at least, make a curve; fewer are corners, of a ramp or a rhombus.
const FEWEST: usize = 4;

/// What straight pieces stand for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Pieces {
    /// Themselves: each joint that is not tangent is a crease.
    Exact,
    /// Themselves too, but where many joints in a row bend alike, samples of a curve.
    Samples,
}

impl Pieces {
    /// Which joints of a chain are creases, by the piece that starts there: `turns` there (none at a loose end, which counts as one), `lengths`
    /// of the pieces. Where no end is loose the last piece leads into the first.
    pub fn creases(self, turns: &[Option<f64>], lengths: &[f64]) -> Vec<bool> {
        let least = match self {
            Self::Exact => SMOOTH_TURN,
            Self::Samples => FLAT,
        };
        let mut creases: Vec<bool> = turns
            .iter()
            .map(|turn| turn.is_none_or(|turn| turn.abs() > least))
            .collect();
        if self == Self::Samples {
            for run in curves(turns, lengths) {
                for place in run {
                    creases[place] = false;
                }
            }
        }
        creases
    }
}

/// The runs of joints that are those of a curve.
fn curves(turns: &[Option<f64>], lengths: &[f64]) -> Vec<Vec<usize>> {
    let count = turns.len();
    let bend = |place: usize| {
        let turn = turns[place].filter(|turn| turn.abs() < COARSEST)?;
        Some(turn / lengths[(place + count - 1) % count].min(lengths[place]))
    };
    let goes_on = |place: usize| match (bend(place), bend((place + 1) % count)) {
        (Some(a), Some(b)) => a * b > 0.0 && a.abs().max(b.abs()) <= ALIKE * a.abs().min(b.abs()),
        _ => false,
    };
    // A circle has no end to begin behind.
    let start = (0..count).find(|&place| !goes_on(place));
    let first = start.map_or(0, |place| place + 1);
    let mut runs = vec![Vec::new()];
    for place in (first..first + count).map(|place| place % count) {
        runs.last_mut().expect("never empty").push(place);
        if !goes_on(place) {
            runs.push(Vec::new());
        }
    }
    runs.retain(|run: &Vec<usize>| run.len() >= FEWEST);
    runs
}

#[cfg(test)]
mod tests {
    use super::*;

    const DEGREE: f64 = std::f64::consts::PI / 180.0;

    fn creases(degrees: &[f64], lengths: &[f64]) -> Vec<usize> {
        let turns: Vec<Option<f64>> = degrees.iter().map(|turn| Some(turn * DEGREE)).collect();
        let all = Pieces::Samples.creases(&turns, lengths);
        (0..all.len()).filter(|&place| all[place]).collect()
    }

    /// Three ramps of an intake, one behind the other: as straight as they are drawn.
    #[test]
    fn a_few_corners_in_a_row_are_corners() {
        let turns = [90.0, -6.0, -6.0, -6.0, 18.0, 90.0, 90.0, 84.0];
        let lengths = [2.0, 1.0, 1.0, 1.0, 1.0, 1.0, 5.0, 1.0];
        assert_eq!(creases(&turns, &lengths), [0, 1, 2, 3, 4, 5, 6, 7]);
    }

    #[test]
    fn many_that_bend_alike_are_a_curve_and_what_bends_more_or_the_other_way_is_not_of_it() {
        let mut turns = vec![90.0, 90.0, 90.0, 2.5];
        turns.extend([5.0; 11]);
        turns.extend([2.5, -10.0]);
        let mut lengths = vec![2.0, 2.0, 2.0];
        lengths.extend([0.1; 13]);
        lengths.push(1.0);
        assert_eq!(creases(&turns, &lengths), [0, 1, 2, 16]);
        // As much in one joint as in five of the curve.
        turns[9] = 25.0;
        assert_eq!(creases(&turns, &lengths), [0, 1, 2, 9, 16]);
    }

    #[test]
    fn all_of_a_circle_is_a_curve_and_uneven_points_are_no_corners() {
        assert!(creases(&[22.5; 16], &[0.4; 16]).is_empty());
        assert_eq!(creases(&[60.0; 6], &[1.0; 6]).len(), 6);
        let uneven = [90.0, 1.0, -2.0, 0.5, 90.0, 90.0, 90.0];
        assert_eq!(creases(&uneven, &[1.0; 7]), [0, 4, 5, 6]);
        let exact = Pieces::Exact.creases(&[Some(1e-3), Some(1e-9), None], &[1.0; 3]);
        assert_eq!(exact, [true, false, true]);
    }
}
