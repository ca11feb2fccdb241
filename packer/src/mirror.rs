//! Mirror planes: the part of space that is packed, and the copies that fill the rest.

use aero_geometry::{Bounds, MirrorPlane, Shape, Vector};

use crate::PackOptions;

/// The planes used, at most one per axis; the side above each plane is packed.
#[derive(Clone, Debug, Default)]
pub(crate) struct Mirrors {
    planes: Vec<(usize, f64)>,
}

impl Mirrors {
    /// The planes of `shape`, the first of each axis.
    pub fn of<const D: usize>(shape: &dyn Shape<D>) -> Self {
        let mut planes: Vec<(usize, f64)> = Vec::new();
        for (axis, position) in shape.mirror_planes() {
            if axis < D && planes.iter().all(|&(a, _)| a != axis) {
                planes.push((axis, position));
            }
        }
        Self { planes }
    }

    /// The planes for which `wanted(axis, position)` holds.
    pub fn only(&self, wanted: impl Fn(usize, f64) -> bool) -> Self {
        let planes = self.planes.iter().copied();
        Self {
            planes: planes
                .filter(|&(axis, position)| wanted(axis, position))
                .collect(),
        }
    }

    /// All planes, as `(axis, position)`.
    pub fn planes(&self) -> &[(usize, f64)] {
        &self.planes
    }

    /// Position of the plane across `axis`.
    pub fn plane(&self, axis: usize) -> Option<f64> {
        self.planes
            .iter()
            .find(|&&(a, _)| a == axis)
            .map(|&(_, position)| position)
    }

    /// The part of `bounds` above all planes, first enlarged to be symmetric about each.
    pub fn fundamental<const D: usize>(&self, bounds: &Bounds<D>) -> Bounds<D> {
        let mut part = *bounds;
        for &(axis, position) in &self.planes {
            let reach = (bounds.max[axis] - position).max(position - bounds.min[axis]);
            part.min[axis] = position;
            part.max[axis] = position + reach;
        }
        part
    }

    /// True for points above or on all planes.
    pub fn above<const D: usize>(&self, point: &Vector<D>) -> bool {
        self.planes
            .iter()
            .all(|&(axis, position)| point[axis] >= position)
    }

    /// The point put exactly on the planes that are nearer than `tolerance`.
    pub fn snapped<const D: usize>(&self, mut point: Vector<D>, tolerance: f64) -> Vector<D> {
        for &(axis, position) in &self.planes {
            if (point[axis] - position).abs() < tolerance {
                point[axis] = position;
            }
        }
        point
    }

    /// What a particle counts in the packed part of space: one half for each plane that it is on.
    pub fn share<const D: usize>(&self, point: &Vector<D>) -> f64 {
        let on = self
            .planes
            .iter()
            .filter(|&&(axis, position)| point[axis] == position);
        0.5_f64.powi(on.count() as i32)
    }

    /// The image of a point in the packed part of space.
    pub fn folded<const D: usize>(&self, mut point: Vector<D>) -> Vector<D> {
        for &(axis, position) in &self.planes {
            if point[axis] < position {
                point[axis] = reflect(point[axis], position);
            }
        }
        point
    }

    /// Calls `visit` with every image of a point and the axes, as a bit set, whose signs flip: one
    /// for each subset of the planes that the point does not lie on, the point itself excepted.
    pub fn images<const D: usize>(&self, point: &Vector<D>, visit: impl FnMut(u32, Vector<D>)) {
        self.images_within(point, f64::INFINITY, visit);
    }

    /// As [`Self::images`], about the planes nearer than `reach` only.
    pub fn images_within<const D: usize>(
        &self,
        point: &Vector<D>,
        reach: f64,
        mut visit: impl FnMut(u32, Vector<D>),
    ) {
        for subset in 1..1_usize << self.planes.len() {
            let mut image = *point;
            let mut flips = 0;
            let mut distinct = true;
            for (n, &(axis, position)) in self.planes.iter().enumerate() {
                if subset >> n & 1 == 1 {
                    distinct &= point[axis] != position && point[axis] - position < reach;
                    image[axis] = reflect(image[axis], position);
                    flips |= 1 << axis;
                }
            }
            if distinct {
                visit(flips, image);
            }
        }
    }
}

/// The mirrors of the region that cut a body elsewhere than in its own planes, the first across each axis; an endless body goes on as it
/// is.
pub(crate) fn cutting_mirrors<const D: usize>(
    shape: &dyn Shape<D>,
    options: &PackOptions<D>,
) -> Vec<MirrorPlane> {
    let Some(region) = &options.region else {
        return Vec::new();
    };
    let (body, own) = (shape.bounds(), shape.mirror_planes());
    let first_across = |axis: usize| {
        let faces = [(region.min[axis], true), (region.max[axis], false)];
        let mirrors = faces.into_iter().zip(options.mirrors[axis]);
        mirrors
            .filter(|(_, is_mirror)| *is_mirror)
            .map(|((position, shows_above), _)| MirrorPlane {
                axis,
                position,
                shows_above,
            })
            .find(|plane| body.min[axis] < plane.position && plane.position < body.max[axis])
    };
    (0..D)
        .filter(|&axis| body.size()[axis].is_finite())
        .filter_map(first_across)
        .filter(|plane| !own.contains(&(plane.axis, plane.position)))
        .collect()
}

/// A coordinate mirrored about `position`; a plain change of sign where `position` is zero.
pub(crate) fn reflect(coordinate: f64, position: f64) -> f64 {
    2.0 * position - coordinate
}

/// A direction with the signs of the axes in `flips` turned.
pub(crate) fn flip<const D: usize>(direction: &Vector<D>, flips: u32) -> Vector<D> {
    Vector::from_fn(|k, _| {
        if flips & (1 << k) == 0 {
            direction[k]
        } else {
            -direction[k]
        }
    })
}
