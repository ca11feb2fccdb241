//! Points of a sweep that are mirror images of others.

use super::polar::Point;

/// Place of the incidence in a point.
const INCIDENCE: usize = 1;

/// True where points come from both sides.
pub fn may_be(points: &[Point]) -> bool {
    of(points).iter().any(Option::is_some)
}

/// Of each point, the number of the one that it is the mirror image of, if it need not be run: one from the side that reaches less far, whose
/// runs would be neighbours of no others.
pub fn of(points: &[Point]) -> Vec<Option<usize>> {
    let angles = || points.iter().filter_map(|point| point[INCIDENCE]);
    let [up, down] = [angles().fold(0.0, f64::max), -angles().fold(0.0, f64::min)];
    let is_left_out = |angle: f64| {
        if up >= down { angle < 0.0 } else { angle > 0.0 }
    };
    let image = |point: &Point| {
        let angle = point[INCIDENCE].filter(|angle| is_left_out(*angle))?;
        let mut other = *point;
        other[INCIDENCE] = Some(-angle);
        points.iter().position(|point| *point == other)
    };
    points.iter().map(image).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_of_the_shorter_side_are_images_of_those_that_are_there() {
        let points = |angles: &[f64]| -> Vec<Point> {
            let each = angles.iter();
            each.map(|angle| [None, Some(*angle), None]).collect()
        };
        let upwards = points(&[-2.0, -1.5, 0.0, 2.0, 4.0]);
        assert_eq!(of(&upwards), [Some(3), None, None, None, None]);
        let downwards = points(&[-4.0, -2.0, 0.0, 2.0]);
        assert_eq!(of(&downwards), [None, None, None, Some(1)]);
        assert!(!may_be(&points(&[0.0, 2.0])));
        let mut others = points(&[-1.0, 1.0]);
        others[0][2] = Some(3.0);
        assert!(!may_be(&others));
    }
}
