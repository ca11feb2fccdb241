//! Numbers of the faces of thin parts: one bit each.

use aero_geometry::{Shape, Vector};

use super::across::Across;
use super::{FaceSet, NOWHERE};
use crate::records::Matrix;
use crate::walls::curvature::tangents;

/// A face of a body, and which part of it where a smooth face is its own opposite, as an ellipse's is: the side of
/// the frame's axis along which its normal mostly points.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Key {
    face: u32,
    part: u8,
}

impl Key {
    /// The frame's axis that the part looks along.
    fn axis(self) -> usize {
        usize::from(self.part / 2)
    }

    /// Which way along it.
    fn sign(self) -> f64 {
        if self.part % 2 == 1 { 1.0 } else { -1.0 }
    }
}

/// Which faces of a body take part in thin parts.
#[derive(Clone, Debug)]
pub struct Numbers<const D: usize> {
    /// Frames of the faces that are their own opposite, first axis across the thinnest place.
    frames: Vec<(u32, Matrix<D>)>,
    /// Bit of each face that takes part.
    bits: Vec<(Key, u32)>,
}

/// At least this part of the ghosts between two faces must have a foot on both; where fewer have, the body is a wire
/// or a cone's point rather than a plate, and all its gas goes by the ghosts' own normals.
const FLAT: f64 = 0.75;

/// Parts of a face are as near to a normal where their cosines differ by less.
const TIE: f64 = 0.02;

impl<const D: usize> Numbers<D> {
    /// Finds the pairs of opposite faces among `crossings` of `shape` and numbers them from `first` on; returns the
    /// pairs too. Past the last bit faces stay without a number.
    pub fn new(
        shape: &dyn Shape<D>,
        crossings: &[Across<D>],
        first: usize,
    ) -> (Self, Vec<[u32; 2]>) {
        let mut numbers = Self {
            frames: frames(shape, crossings),
            bits: Vec::new(),
        };
        let mut pairs: Vec<([Key; 2], [usize; 2])> = Vec::new();
        for crossing in crossings {
            let mut pair = numbers.pair(crossing);
            pair.sort_unstable();
            let known = pairs.iter().position(|(known, _)| *known == pair);
            let index = known.unwrap_or_else(|| {
                pairs.push((pair, [0; 2]));
                pairs.len() - 1
            });
            pairs[index].1[usize::from(crossing.has_foot)] += 1;
        }
        pairs.retain(|(pair, [without, with])| {
            pair[0] != pair[1] && *with as f64 >= FLAT * (with + without) as f64
        });
        // Where bits run out, the faces with the fewest ghosts go without.
        pairs.sort_by_key(|(pair, [_, with])| (std::cmp::Reverse(*with), *pair));
        let mut opposite = Vec::new();
        for (pair, _) in &pairs {
            let mut bits = [0; 2];
            for (bit, key) in bits.iter_mut().zip(pair) {
                let known = numbers.bits.iter().find(|(known, _)| known == key);
                *bit = known.map_or((first + numbers.bits.len()) as u32, |&(_, bit)| bit);
                if known.is_none() && *bit < NOWHERE.trailing_zeros() {
                    numbers.bits.push((*key, *bit));
                }
            }
            if bits.iter().all(|&bit| bit < NOWHERE.trailing_zeros()) {
                opposite.push(bits);
            }
        }
        (numbers, opposite)
    }

    /// Number of faces that have a bit.
    pub fn len(&self) -> usize {
        self.bits.len()
    }

    /// The bit of a face, as a set; empty for one that takes no part, and two or three where `normal` lies midway between parts.
    pub fn set(&self, face: u32, normal: &Vector<D>) -> FaceSet {
        let along = self.along(face, normal);
        let bits = self.bits.iter().filter(|(known, _)| {
            known.face == face
                && along.is_none_or(|along| along[known.axis()] * known.sign() > along.amax() - TIE)
        });
        bits.fold(0, |set, (_, bit)| set | 1 << bit)
    }

    /// The faces on both sides of a ghost. Of a face that is its own opposite they lie along one axis of the frame, that to which the way across is
    /// nearest: each normal alone may be nearer to another one where a ghost stands between two, and parts that lie side by side be taken for
    /// the two sides of a plate.
    fn pair(&self, crossing: &Across<D>) -> [Key; 2] {
        let (near, far) = (&crossing.near, &crossing.far);
        if near.face != far.face {
            return [near, far].map(|foot| self.key(foot.face, &foot.normal));
        }
        let way = near.normal - far.normal;
        [way, -way].map(|way| self.key(near.face, &way))
    }

    fn key(&self, face: u32, normal: &Vector<D>) -> Key {
        let part = self.along(face, normal).map_or(0, |along| {
            let axis = along.iamax();
            2 * axis as u8 + u8::from(along[axis] > 0.0)
        });
        Key { face, part }
    }

    /// `way` in the frame of a face that is its own opposite.
    fn along(&self, face: u32, way: &Vector<D>) -> Option<Vector<D>> {
        let (_, frame) = self.frames.iter().find(|(known, _)| *known == face)?;
        Some(frame * way)
    }
}

/// A mirror plane whose normal has more than this along the way across a part is across that way itself.
const ACROSS: f64 = 0.7;

/// A frame for each face that is its own opposite, its own mirror image where the body is.
fn frames<const D: usize>(shape: &dyn Shape<D>, crossings: &[Across<D>]) -> Vec<(u32, Matrix<D>)> {
    let mut thinnest: Vec<(u32, f64, Vector<D>)> = Vec::new();
    for crossing in crossings {
        let (near, far) = (&crossing.near, &crossing.far);
        if near.face != far.face {
            continue;
        }
        let thickness = (near.point - far.point).norm();
        // Both faces may lean towards a tip: the way across is between their normals.
        let across = near.normal - far.normal;
        match thinnest.iter_mut().find(|(face, ..)| *face == near.face) {
            Some((_, least, way)) if thickness < *least => {
                (*least, *way) = (thickness, across);
            }
            Some(_) => {}
            None => thinnest.push((near.face, thickness, across)),
        }
    }
    let planes = shape.mirror_planes();
    thinnest
        .into_iter()
        .filter_map(|(face, _, across)| {
            let way = mirrored(across.try_normalize(f64::EPSILON)?, &planes)?;
            let mut rows = vec![way];
            rows.extend(tangents(&way));
            Some((face, Matrix::from_fn(|a, b| rows[a][b])))
        })
        .collect()
}

/// A direction near `way` that each of the planes mirrors onto itself or its opposite.
fn mirrored<const D: usize>(mut way: Vector<D>, planes: &[(usize, f64)]) -> Option<Vector<D>> {
    for &(axis, _) in planes {
        if way[axis].abs() > ACROSS {
            return Some(Vector::from_fn(|k, _| if k == axis { 1.0 } else { 0.0 }));
        }
        way[axis] = 0.0;
        way = way.try_normalize(f64::EPSILON)?;
    }
    Some(way)
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{FRAC_PI_4, PI};

    use aero_geometry::bodies;

    use super::super::Foot;
    use super::*;

    /// Ghosts of a round body on the diagonals of its frame, where rounding decides which part either side is of.
    #[test]
    fn parts_of_a_round_face_are_opposite_across_it_alone() {
        let cone = bodies::cone(15.0, 1.0).expect("a cone");
        let foot = |angle: f64| {
            let normal = Vector::<3>::new(0.0, angle.cos(), angle.sin());
            Foot {
                point: normal * 0.1,
                normal,
                face: 0,
            }
        };
        let crossing = |eighth: i32| {
            let angle = FRAC_PI_4 * f64::from(eighth);
            Across {
                ghost: 0,
                near: foot(angle),
                far: foot(angle + PI),
                has_foot: true,
                is_own: true,
            }
        };
        let crossings: Vec<_> = (-4..4).map(crossing).collect();
        let (numbers, pairs) = Numbers::new(&cone, &crossings, 0);
        let part = |bit: u32| {
            let (key, _) = numbers
                .bits
                .iter()
                .find(|(_, known)| *known == bit)
                .expect("a part");
            key.part
        };
        assert!(!pairs.is_empty());
        for [a, b] in pairs {
            assert_eq!(part(a) / 2, part(b) / 2, "side by side");
        }
        for (angle, parts) in [(0.3, 1), (FRAC_PI_4 + 1e-3, 2), (FRAC_PI_4 - 1e-3, 2)] {
            let seen = numbers.set(0, &foot(angle).normal);
            assert_eq!(seen.count_ones(), parts, "{angle}");
        }
    }

    #[test]
    fn a_direction_is_along_or_across_each_mirror_plane() {
        let way = Vector::<3>::new(-0.3, 0.6, 0.8).normalize();
        let none = mirrored(way, &[]).expect("a direction");
        assert_eq!(none, way);
        let round = mirrored(way, &[(1, 0.0), (2, 0.0)]).expect("a direction");
        assert_eq!(round, Vector::<3>::z());
        let half = mirrored(Vector::<3>::new(0.8, 0.0, 0.6), &[(2, 0.0)]);
        assert_eq!(half, Some(Vector::<3>::x()));
    }
}
