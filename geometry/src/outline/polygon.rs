//! Polygons: outlines from points, and points from a text file.

use std::path::Path;

use super::Outline;
use super::piece::Piece;
use crate::Vector;
use crate::error::GeometryError;

/// Points that lie this close, relative to the polygon's extent, are one point.
const SAME_POINT: f64 = 1e-8;

/// A closed polygon through `points`, in either order. Consecutive duplicates are merged, and the
/// first point may be repeated at the end. Corners are creases;
/// four and more in a row that bend alike, by less than 30 degrees each, are the samples of a curve.
///
/// # Errors
/// Fewer than three distinct points, no area, edges that cross or touch, and numbers that are not
/// finite.
pub fn polygon(points: &[Vector<2>]) -> Result<Outline, GeometryError> {
    if let Some(index) = points.iter().position(|p| !p.iter().all(|x| x.is_finite())) {
        return Err(GeometryError::Curve(format!(
            "point {} is ({}, {}); give finite numbers",
            index + 1,
            points[index].x,
            points[index].y
        )));
    }
    let Some(first) = points.first() else {
        return Err(GeometryError::Curve("has no points".into()));
    };
    let (low, high) = points
        .iter()
        .fold((*first, *first), |(low, high), p| (low.inf(p), high.sup(p)));
    let tolerance = SAME_POINT * (high - low).max();
    let mut distinct: Vec<Vector<2>> = Vec::with_capacity(points.len());
    for point in points {
        if distinct
            .last()
            .is_none_or(|last| (point - last).norm() > tolerance)
        {
            distinct.push(*point);
        }
    }
    while distinct.len() > 1 && (distinct[distinct.len() - 1] - distinct[0]).norm() <= tolerance {
        distinct.pop();
    }
    if distinct.len() < 3 {
        return Err(GeometryError::Curve(format!(
            "a polygon needs three different points, but has {}",
            distinct.len()
        )));
    }
    let edges = (0..distinct.len())
        .map(|k| Piece::segment(distinct[k], distinct[(k + 1) % distinct.len()]))
        .collect();
    Outline::sampled(vec![edges])
}

/// Reads the points of a polygon: `x y` per line, in metres; a comma may part them, `#` starts a
/// comment, and empty lines are skipped.
///
/// # Errors
/// A line that does not hold two finite numbers, by its number.
pub fn parse_points(text: &str) -> Result<Vec<Vector<2>>, GeometryError> {
    let mut points = Vec::new();
    for (index, line) in text.lines().enumerate() {
        let content = line.split('#').next().unwrap_or_default();
        // A byte order mark is no white space, but some editors begin files with it.
        let content = content.trim_start_matches('\u{feff}').trim();
        if content.is_empty() {
            continue;
        }
        let fail = |reason: String| GeometryError::Text {
            line: index + 1,
            reason,
        };
        let mut numbers = [0.0; 2];
        let mut words = content
            .split(|c: char| c.is_whitespace() || c == ',' || c == ';')
            .filter(|word| !word.is_empty());
        for (axis, number) in numbers.iter_mut().enumerate() {
            let Some(word) = words.next() else {
                return Err(fail(format!(
                    "has {axis} numbers; a point needs two, `x y`"
                )));
            };
            *number = word
                .parse::<f64>()
                .ok()
                .filter(|x| x.is_finite())
                .ok_or_else(|| fail(format!("`{word}` is not a finite number")))?;
        }
        if let Some(word) = words.next() {
            return Err(fail(format!(
                "goes on with `{word}` after `x y`; a point has two numbers"
            )));
        }
        points.push(Vector::<2>::new(numbers[0], numbers[1]));
    }
    Ok(points)
}

/// The polygon in a text file of points; see [`parse_points`] and [`polygon`].
///
/// # Errors
/// A file that cannot be read or does not hold a polygon.
pub fn polygon_file(path: &Path) -> Result<Outline, GeometryError> {
    let text = std::fs::read_to_string(path).map_err(|source| GeometryError::Read {
        path: path.to_owned(),
        source,
    })?;
    parse_points(&text)
        .and_then(|points| polygon(&points))
        .map_err(|source| GeometryError::In {
            path: path.to_owned(),
            source: Box::new(source),
        })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Shape;

    fn points(list: &[[f64; 2]]) -> Vec<Vector<2>> {
        list.iter().map(|&[x, y]| Vector::<2>::new(x, y)).collect()
    }

    fn refused(list: &[[f64; 2]]) -> String {
        polygon(&points(list)).unwrap_err().to_string()
    }

    #[test]
    fn a_clockwise_polygon_is_turned_round() {
        let list = [[0.0, 0.0], [0.0, 1.0], [1.0, 1.0], [1.0, 0.0]];
        let outline = polygon(&points(&list)).unwrap();
        assert_eq!(outline.area(), Some(1.0));
        assert!(outline.signed_distance(&Vector::<2>::new(0.5, 0.5)) < 0.0);
    }

    #[test]
    fn repeated_points_are_merged() {
        let list = [[0.0, 0.0], [1.0, 0.0], [1.0, 0.0], [0.0, 1.0], [0.0, 0.0]];
        assert_eq!(polygon(&points(&list)).unwrap().pieces().len(), 3);
    }

    #[test]
    fn what_bounds_no_solid_is_refused() {
        assert!(refused(&[]).contains("no points"));
        assert!(refused(&[[0.0, 0.0], [1.0, 1.0], [0.0, 0.0]]).contains("but has 2"));
        assert!(refused(&[[0.0, 0.0], [1.0, 1.0], [2.0, 2.0]]).contains("no area"));
        assert!(refused(&[[0.0, 0.0], [1.0, f64::NAN], [2.0, 2.0]]).contains("point 2"));
        let bow_tie = [[0.0, 0.0], [2.0, 1.0], [2.0, 0.0], [0.0, 1.5]];
        assert!(refused(&bow_tie).contains("near (1.2"));
        let spike = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [1.0, 0.0], [1.0, 1.0]];
        assert!(refused(&spike).contains("crosses or touches itself"));
        let touching = [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 0.0], [0.0, 1.0]];
        assert!(refused(&touching).contains("near (1.000000, 0.000000)"));
    }

    #[test]
    fn many_points_that_cross_are_refused_too() {
        let mut list = Vec::new();
        for k in 0..100 {
            let angle = std::f64::consts::TAU * f64::from(k) / 100.0;
            list.push([angle.cos(), (2.0 * angle).sin() + 0.001 * angle]);
        }
        assert!(refused(&list).contains("crosses"));
    }

    #[test]
    fn a_file_of_points_is_read_with_comments_and_commas() {
        let text = "\u{feff}# aerofoil\n0 0\n1, 0 # tail\n\n 0.5\t0.2\r\n";
        let read = parse_points(text).unwrap();
        assert_eq!(read, points(&[[0.0, 0.0], [1.0, 0.0], [0.5, 0.2]]));
    }

    #[test]
    fn a_bad_line_is_named() {
        let fails = |text: &str| parse_points(text).unwrap_err().to_string();
        assert_eq!(
            fails("0 0\n1\n"),
            "line 2: has 1 numbers; a point needs two, `x y`"
        );
        assert_eq!(fails("0 0\n1 two"), "line 2: `two` is not a finite number");
        assert_eq!(fails("0 nan"), "line 1: `nan` is not a finite number");
        assert!(fails("0 0 0").contains("goes on with `0`"));
    }

    #[test]
    fn shallow_joints_belong_to_one_face_and_sharp_ones_part_faces() {
        let mut list = vec![[1.0, 0.0]];
        for k in 1..50 {
            let angle = std::f64::consts::PI * f64::from(k) / 50.0;
            list.push([angle.cos(), angle.sin()]);
        }
        list.push([-1.0, 0.0]);
        let half_disc = polygon(&points(&list)).unwrap();
        assert_eq!(half_disc.faces.iter().max(), Some(&1));
        assert_eq!(half_disc.corners().len(), 2);
    }

    /// A ramp of 15 degrees, and a thin diamond: a stream meets their corners, not a curve as wide as a cell.
    #[test]
    fn shallow_corners_of_a_few_straight_edges_part_faces() {
        let ramp = [
            [-1.0, 0.0],
            [0.0, 0.0],
            [3.0, 0.8],
            [3.0, -1.0],
            [-1.0, -1.0],
        ];
        let diamond = [[0.0, 0.0], [0.5, -0.05], [1.0, 0.0], [0.5, 0.05]];
        for (list, count) in [(&ramp[..], 5_u32), (&diamond[..], 4)] {
            let outline = polygon(&points(list)).unwrap();
            assert_eq!(outline.faces.iter().max(), Some(&(count - 1)));
            let place = crate::Placement::default().rotated(0.3);
            assert_eq!(outline.placed(&place).corners().len(), count as usize);
        }
    }
}
