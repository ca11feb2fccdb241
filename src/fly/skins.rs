//! The body's surface as triangles: by pressure, by how finely its thickness is resolved, and bare.

use std::f64::consts::TAU;

use aero_geometry::Shape;
use aero_geometry::Vector;
use aero_geometry::parallel::prelude::*;

use super::body_view::Skin;
use super::flight::{Extent, Flight};
use super::read::Cells;

/// Pieces around the axis that a meridian is turned in.
const AROUND: usize = 72;

/// Spacings to which a thickness is measured: more is enough.
pub const ENOUGH: f64 = 8.0;

/// The surface of a run by an array, its images included.
pub fn by_array(flight: &Flight, surface: &Cells, array: &str) -> Skin {
    let values = surface.arrays.get(array).map_or(&[][..], Vec::as_slice);
    let mut skin = Skin::default();
    for (cell, value) in surface.corners.iter().zip(values) {
        match (&flight.extent, &cell[..]) {
            (Extent::Meridian(_), [a, b]) => turn(&mut skin, *a, *b, *value),
            (Extent::Space(mirrors), [a, b, c]) => {
                skin.corners.push([*a, *b, *c]);
                skin.values.push(*value);
                images(&mut skin, mirrors, [*a, *b, *c], *value);
            }
            _ => {}
        }
    }
    skin
}

/// A segment of the meridian all around the axis.
fn turn(skin: &mut Skin, a: [f64; 3], b: [f64; 3], value: f64) {
    let at = |p: [f64; 3], k: usize| {
        let (s, c) = (TAU * k as f64 / AROUND as f64).sin_cos();
        [p[0], p[1].abs() * c, p[1].abs() * s]
    };
    for k in 0..AROUND {
        let [a0, b0, a1, b1] = [at(a, k), at(b, k), at(a, k + 1), at(b, k + 1)];
        skin.corners.extend([[a0, b0, b1], [a0, b1, a1]]);
        skin.values.extend([value, value]);
    }
}

fn images(skin: &mut Skin, mirrors: &[usize], corners: [[f64; 3]; 3], value: f64) {
    for image in 1..1_usize << mirrors.len() {
        let mut turned = corners;
        for (bit, axis) in mirrors.iter().enumerate() {
            if image >> bit & 1 == 1 {
                for corner in &mut turned {
                    corner[*axis] = -corner[*axis];
                }
            }
        }
        skin.corners.push(turned);
        skin.values.push(value);
    }
}

/// The body's own triangles.
pub fn bare(flight: &Flight) -> Skin {
    let facets = flight.shape.facets(f64::INFINITY, &flight.shape.bounds());
    let corners = facets.iter().map(|facet| facet.map(|p| [p[0], p[1], p[2]]));
    Skin {
        values: vec![f64::NAN; facets.len()],
        corners: corners.collect(),
    }
}

/// By how many of the finest cells lie across the body behind each triangle, at most [`ENOUGH`].
pub fn by_thickness(flight: &Flight, finest: f64) -> Skin {
    let size = (0.02 * flight.bounds.size().max()).max(finest);
    let facets = flight.shape.facets(size, &flight.shape.bounds());
    let facets: Vec<[Vector<3>; 3]> = facets.into_iter().flat_map(|f| pieces(f, size)).collect();
    let thickness = |facet: &[Vector<3>; 3]| {
        let normal = (facet[1] - facet[0]).cross(&(facet[2] - facet[0]));
        let normal = normal.try_normalize(0.0)?;
        let middle = (facet[0] + facet[1] + facet[2]) / 3.0;
        let mut depth = 1e-3 * finest;
        for _ in 0..60 {
            if depth > ENOUGH * finest {
                return Some(ENOUGH);
            }
            let gap = -flight.shape.signed_distance(&(middle - depth * normal));
            if gap <= 1e-4 * finest && depth > 0.02 * finest {
                break;
            }
            depth += gap.max(0.01 * finest);
        }
        Some(depth / finest)
    };
    let values = facets
        .par_iter()
        .map(|facet| thickness(facet).unwrap_or(f64::NAN));
    Skin {
        values: values.collect(),
        corners: facets
            .iter()
            .map(|f| f.map(|p| [p[0], p[1], p[2]]))
            .collect(),
    }
}

/// A facet in pieces whose edges are no longer than `size`.
fn pieces(facet: [Vector<3>; 3], size: f64) -> Vec<[Vector<3>; 3]> {
    let mut whole = vec![facet];
    let mut pieces = Vec::new();
    while let Some([a, b, c]) = whole.pop() {
        let lengths = [(b - a).norm(), (c - b).norm(), (a - c).norm()];
        let longest = lengths.into_iter().fold(0.0, f64::max);
        if longest <= size || !longest.is_finite() {
            pieces.push([a, b, c]);
            continue;
        }
        // The longest edge first.
        let [a, b, c] = match lengths.map(|length| length == longest) {
            [true, ..] => [a, b, c],
            [_, true, _] => [b, c, a],
            _ => [c, a, b],
        };
        let middle = (a + b) * 0.5;
        whole.extend([[a, middle, c], [middle, b, c]]);
    }
    pieces
}

/// Parts of the surface, by area, behind which fewer than two and fewer than four of the finest cells lie.
pub fn thin_parts(skin: &Skin) -> [f64; 2] {
    let mut sums = [0.0; 2];
    let mut total = 0.0;
    for (corners, value) in skin.corners.iter().zip(&skin.values) {
        let [a, b, c] = corners.map(Vector::<3>::from);
        let area = 0.5 * (b - a).cross(&(c - a)).norm();
        total += area;
        for (sum, limit) in sums.iter_mut().zip([2.0, 4.0]) {
            if *value < limit {
                *sum += area;
            }
        }
    }
    sums.map(|sum| sum / f64::max(total, f64::MIN_POSITIVE))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pieces_of_a_facet_are_small_and_make_it_up() {
        let [a, b, c] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.05, 0.0]].map(Vector::<3>::from);
        let all = pieces([a, b, c], 0.1);
        let up = |[a, b, c]: &[Vector<3>; 3]| 0.5 * (b - a).cross(&(c - a))[2];
        let area: f64 = all.iter().map(up).sum();
        assert!((area - 0.025).abs() < 1e-12, "{area}");
        assert!(all.iter().all(|piece| up(piece) > 0.0));
        let edge = |p: &[Vector<3>; 3]| {
            (0..3)
                .map(|k| (p[k] - p[(k + 1) % 3]).norm())
                .fold(0.0, f64::max)
        };
        assert!(all.iter().all(|piece| edge(piece) <= 0.1));
        assert_eq!(pieces([a, b, c], 2.0).len(), 1);
    }
}
