//! How nearly a body is its own mirror image: its triangles need not be, for corners on one side of a bent surface may face the middles of
//! triangles on the other.

use std::collections::HashMap;

use aero_geometry::parallel::prelude::*;
use aero_geometry::{Bounds, Shape, Vector};

/// The image of a corner may be off the surface by this part of the body's least extent, and by that part of its largest: round-off of files.
const OFF: [f64; 2] = [1e-4, 2e-6];

/// A body whose images are off by less than this part of its least extent was meant to be its own mirror image.
const MEANT: f64 = 5e-3;

/// Neighbours that meet at a smaller angle, in degrees, are pieces of one bent surface.
const BENT: f64 = 40.0;

/// Neighbours that meet at a smaller angle, in degrees, lie in one plane.
const FLAT: f64 = 0.05;

/// How far off the image of a corner on a bent surface may be, in rises of its arcs: one for where it comes to lie, and the middle of the box,
/// through which the mirror goes, may be off by half a rise.
const RISES: f64 = 2.5;

/// A step out of a corner leads away from the surface by less than this part of it where the corner lies between two parts.
const BETWEEN: f64 = 0.9;

/// Corners that are mirrored, at most.
const CORNERS: usize = 200_000;

/// What a body is to its mirror image.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Likeness {
    /// The same.
    Same,
    /// Off it by so much, though it looks the same.
    Near(f64),
    /// Another body.
    Other,
}

/// What a body that fills `bounds` is to its image across the plane `axis = 0`.
pub(super) fn likeness(shape: &dyn Shape<3>, bounds: &Bounds<3>, axis: usize) -> Likeness {
    let size = bounds.size();
    let same = OFF[0] * size.min() + OFF[1] * size.max();
    let off = |p: &Vector<3>| shape.signed_distance(p).abs();
    let corners = corners(
        &shape.facets(f64::INFINITY, bounds),
        0.1 * OFF[1] * size.max(),
    );
    // Where parts cut each other, corners lie on the facets, not on what the facets stand for, and pieces of facets have no neighbours along whole edges.
    let largest = corners.iter().map(|corner| corner.rise).fold(0.0, f64::max);
    let step = 1e-3 * size.min();
    let is_between_parts = |corner: &Corner| {
        let sum: Vector<3> = corner.normals.iter().sum();
        let out = sum.try_normalize(0.0).unwrap_or_default();
        shape.signed_distance(&(corner.place + step * out)) < BETWEEN * step
    };
    let every = corners.len().div_ceil(CORNERS).max(1);
    let excess: Vec<f64> = (0..corners.len().div_ceil(every))
        .into_par_iter()
        .map(|n| {
            let corner = &corners[n * every];
            let mut image = corner.place;
            image[axis] = -image[axis];
            let off_it = off(&image);
            let beyond = |rise: f64| (off_it - RISES * rise - same).max(0.0);
            // Corners that other parts hide are off the surface themselves.
            if beyond(corner.rise) == 0.0 || corner.is_flat() || off(&corner.place) > same {
                0.0
            } else if corner.is_bent() || is_between_parts(corner) {
                beyond(largest)
            } else {
                beyond(corner.rise)
            }
        })
        .collect();
    match excess.into_iter().fold(0.0, f64::max) {
        0.0 => Likeness::Same,
        most if most < MEANT * size.min() => Likeness::Near(most),
        _ => Likeness::Other,
    }
}

/// A corner of triangles.
struct Corner {
    place: Vector<3>,
    /// The largest rise of an arc over a triangle there.
    rise: f64,
    /// Unit normals of the triangles.
    normals: Vec<Vector<3>>,
}

impl Corner {
    /// True of a place within a facet, at which only pieces of it meet.
    fn is_flat(&self) -> bool {
        let first = self.normals.first();
        let mut angles = self.normals.iter().zip(first.into_iter().cycle());
        angles.all(|(a, b)| a.angle(b).to_degrees() < FLAT)
    }

    /// True where two of the triangles are pieces of one bent surface.
    fn is_bent(&self) -> bool {
        self.normals.iter().enumerate().any(|(n, a)| {
            let others = self.normals[n + 1..].iter();
            let mut angles = others.map(|b| a.angle(b).to_degrees());
            angles.any(|angle| angle > FLAT && angle < BENT)
        })
    }
}

/// The corners of triangles, each once. Corners nearer than `near` are one.
fn corners(facets: &[[Vector<3>; 3]], near: f64) -> Vec<Corner> {
    let mut numbers: HashMap<[i64; 3], usize> = HashMap::new();
    let mut corners: Vec<Corner> = Vec::new();
    let mut number = |corner: &Vector<3>| {
        let key = [0, 1, 2].map(|k| (corner[k] / near).round() as i64);
        *numbers.entry(key).or_insert_with(|| {
            corners.push(Corner {
                place: *corner,
                rise: 0.0,
                normals: Vec::new(),
            });
            corners.len() - 1
        })
    };
    let triangles: Vec<[usize; 3]> = facets
        .iter()
        .map(|facet| [0, 1, 2].map(|n| number(&facet[n])))
        .collect();
    let mut edges: HashMap<[usize; 2], usize> = HashMap::new();
    let mut rises = vec![0.0_f64; facets.len()];
    for (facet, triangle) in triangles.iter().enumerate() {
        for n in 0..3 {
            let [a, b] = [triangle[n], triangle[(n + 1) % 3]];
            let edge = [a.min(b), a.max(b)];
            let Some(other) = edges.remove(&edge) else {
                edges.insert(edge, facet);
                continue;
            };
            let pair = [&facets[facet], &facets[other]];
            let rise = rise(pair, corners[a].place - corners[b].place);
            for facet in [facet, other] {
                rises[facet] = rises[facet].max(rise);
            }
        }
    }
    for ((triangle, rise), facet) in triangles.iter().zip(rises).zip(facets) {
        let normal = cross(facet).try_normalize(0.0).unwrap_or_default();
        for number in triangle {
            let corner = &mut corners[*number];
            corner.rise = corner.rise.max(rise);
            corner.normals.push(normal);
        }
    }
    corners
}

/// Twice the area of a triangle along its normal.
fn cross([a, b, c]: &[Vector<3>; 3]) -> Vector<3> {
    (b - a).cross(&(c - a))
}

/// How high an arc through the corners of two triangles that meet at `edge` rises over the wider one: `w tan(angle / 4) / 2`; nothing where they meet at a
/// sharp edge.
fn rise(pair: [&[Vector<3>; 3]; 2], edge: Vector<3>) -> f64 {
    let [a, b] = pair.map(cross);
    let angle = a.angle(&b);
    if angle.is_nan() || angle > BENT.to_radians() {
        return 0.0;
    }
    let width = a.norm().max(b.norm()) / edge.norm().max(f64::MIN_POSITIVE);
    0.5 * width * (0.25 * angle).tan()
}

#[cfg(test)]
mod tests {
    use aero_geometry::{Mesh, bodies};

    use super::*;

    type Facet = [Vector<3>; 3];

    /// A sphere of so many facets around, turned about x by `degrees`, with a plate that stands on it at an angle of `tilt` degrees to its middle plane.
    fn tailed(around: usize, degrees: f64, tilt: f64) -> Mesh {
        let turn = |p: Vector<3>, axis: &Vector<3>, degrees: f64| {
            let axis = nalgebra::Unit::new_normalize(*axis);
            nalgebra::Rotation3::from_axis_angle(&axis, degrees.to_radians()) * p
        };
        let sphere = bodies::sphere(0.5).unwrap().tessellate(around);
        let x = Vector::<3>::new(1.0, 0.0, 0.0);
        let mut facets: Vec<Facet> = sphere
            .iter()
            .map(|facet| facet.map(|p| turn(p, &x, degrees)))
            .collect();
        let at = |n: usize| {
            let high = |bit: usize| if n & bit == 0 { -1.0 } else { 1.0 };
            let corner = Vector::<3>::new(0.2 * high(1), 0.5 + 0.3 * high(2), 0.01 * high(4));
            turn(corner, &Vector::<3>::new(0.0, 1.0, 0.0), tilt)
        };
        let sides = [
            [0, 2, 3, 1],
            [4, 5, 7, 6],
            [0, 1, 5, 4],
            [2, 6, 7, 3],
            [0, 4, 6, 2],
            [1, 3, 7, 5],
        ];
        for [a, b, c, d] in sides {
            facets.extend([[at(a), at(b), at(c)], [at(a), at(c), at(d)]]);
        }
        Mesh::from_facets(facets).unwrap()
    }

    fn across_z(mesh: &Mesh) -> Likeness {
        likeness(mesh, &mesh.bounds(), 2)
    }

    #[test]
    fn a_body_whose_facets_do_not_match_is_its_mirror_image_all_the_same() {
        for degrees in [0.0, 2.0, 3.7] {
            assert_eq!(
                across_z(&tailed(24, degrees, 0.0)),
                Likeness::Same,
                "{degrees}"
            );
        }
    }

    #[test]
    fn a_tail_that_is_set_at_a_small_angle_is_seen() {
        let Likeness::Near(off) = across_z(&tailed(24, 0.0, 0.5)) else {
            panic!("nearly the same");
        };
        assert!(off > 1e-3 && off < 5e-3, "{off}");
        assert_eq!(across_z(&tailed(24, 0.0, 5.0)), Likeness::Other);
    }
}
