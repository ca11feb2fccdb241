//! Placing a body: scale, then turn, then move.

use crate::error::GeometryError;
use crate::{Bounds, Closest, Crease, Shape, Vector};

type Matrix<const D: usize> = nalgebra::SMatrix<f64, D, D>;

/// A similarity: `x -> translation + rotation * (scale * x)`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placement<const D: usize> {
    scale: f64,
    rotation: Matrix<D>,
    translation: Vector<D>,
}

impl<const D: usize> Default for Placement<D> {
    fn default() -> Self {
        Self {
            scale: 1.0,
            rotation: Matrix::<D>::identity(),
            translation: Vector::<D>::zeros(),
        }
    }
}

impl<const D: usize> Placement<D> {
    /// The same placement, then scaled by `factor` about the origin.
    ///
    /// # Errors
    /// A factor that is not finite and above zero.
    pub fn scaled(mut self, factor: f64) -> Result<Self, GeometryError> {
        if !(factor.is_finite() && factor > 0.0) {
            return Err(GeometryError::Placement(format!(
                "scale is {factor}, but must be above zero"
            )));
        }
        self.scale *= factor;
        self.translation *= factor;
        Ok(self)
    }

    /// The same placement, then moved by `offset` (metres).
    #[must_use]
    pub fn moved(mut self, offset: Vector<D>) -> Self {
        self.translation += offset;
        self
    }

    fn turned(mut self, rotation: Matrix<D>) -> Self {
        // Quarter turns are exact, so that they keep mirror planes where they were.
        let rotation = rotation.map(|x| {
            if x.abs() < 1e-15 {
                0.0
            } else if (x.abs() - 1.0).abs() < 1e-15 {
                x.signum()
            } else {
                x
            }
        });
        self.rotation = rotation * self.rotation;
        self.translation = rotation * self.translation;
        self
    }

    /// Factor by which lengths grow.
    pub fn scale(&self) -> f64 {
        self.scale
    }

    /// Where a point of the body goes.
    pub fn point(&self, p: &Vector<D>) -> Vector<D> {
        self.rotation * (self.scale * p) + self.translation
    }

    /// Where a direction goes; lengths are kept.
    pub fn direction(&self, d: &Vector<D>) -> Vector<D> {
        self.rotation * d
    }

    /// Where a placed direction comes from.
    pub fn direction_back(&self, d: &Vector<D>) -> Vector<D> {
        self.rotation.tr_mul(d)
    }

    /// Where a placed point comes from.
    pub fn point_back(&self, p: &Vector<D>) -> Vector<D> {
        self.rotation.tr_mul(&(p - self.translation)) / self.scale
    }
}

impl Placement<2> {
    /// The same placement, then turned counter-clockwise by `angle` (radians) about the origin.
    #[must_use]
    pub fn rotated(self, angle: f64) -> Self {
        self.turned(*nalgebra::Rotation2::new(angle).matrix())
    }
}

impl Placement<3> {
    /// The same placement, then turned by `angle` (radians, right-handed) about `axis`, which
    /// passes through the origin.
    ///
    /// # Errors
    /// An axis without direction.
    pub fn rotated_about(self, axis: &Vector<3>, angle: f64) -> Result<Self, GeometryError> {
        let length = axis.norm();
        if !(length.is_finite() && length > 0.0 && angle.is_finite()) {
            return Err(GeometryError::Placement(
                "the axis of rotation needs a direction and the angle must be finite".into(),
            ));
        }
        let axis = nalgebra::Unit::new_unchecked(axis / length);
        Ok(self.turned(*nalgebra::Rotation3::from_axis_angle(&axis, angle).matrix()))
    }
}

/// A shape seen through a placement.
#[derive(Clone, Debug)]
pub struct Placed<S, const D: usize> {
    shape: S,
    placement: Placement<D>,
}

impl<S: Shape<D>, const D: usize> Placed<S, D> {
    /// `shape` after `placement`. An outline is better placed itself ([`crate::Outline::placed`]):
    /// it then stays an outline.
    pub fn new(shape: S, placement: Placement<D>) -> Self {
        Self { shape, placement }
    }

    /// The shape before placing.
    pub fn inner(&self) -> &S {
        &self.shape
    }

    /// How it is placed.
    pub fn placement(&self) -> &Placement<D> {
        &self.placement
    }

    /// A box that holds what lies in `region` once it is placed.
    fn region_back(&self, region: &Bounds<D>) -> Bounds<D> {
        let corners = (0..1_usize << D).map(|n| {
            let corner = Vector::<D>::from_fn(|k, _| {
                if n >> k & 1 == 0 {
                    region.min[k]
                } else {
                    region.max[k]
                }
            });
            self.placement.point_back(&corner)
        });
        let nothing: Bounds<D> = Bounds::new(
            Vector::repeat(f64::INFINITY),
            Vector::repeat(f64::NEG_INFINITY),
        );
        corners.fold(nothing, |all, corner| {
            Bounds::new(all.min.inf(&corner), all.max.sup(&corner))
        })
    }
}

impl<S: Shape<D>, const D: usize> Shape<D> for Placed<S, D> {
    fn bounds(&self) -> Bounds<D> {
        let Bounds { min, max } = self.shape.bounds();
        let mut placed = Bounds::new(self.placement.translation, self.placement.translation);
        for row in 0..D {
            for column in 0..D {
                let factor = self.placement.rotation[(row, column)] * self.placement.scale;
                // Zero times an infinite side is nothing.
                if factor != 0.0 {
                    let (a, b) = (factor * min[column], factor * max[column]);
                    placed.min[row] += a.min(b);
                    placed.max[row] += a.max(b);
                }
            }
        }
        placed
    }

    fn closest(&self, point: &Vector<D>) -> Closest<D> {
        let closest = self.shape.closest(&self.placement.point_back(point));
        Closest {
            point: self.placement.point(&closest.point),
            distance: self.placement.scale * closest.distance,
            normal: self.placement.direction(&closest.normal),
            face: closest.face,
        }
    }

    fn way_out(&self, from: &Vector<D>, direction: &Vector<D>) -> Option<f64> {
        let placement = &self.placement;
        let from = placement.point_back(from);
        let way = self
            .shape
            .way_out(&from, &placement.direction_back(direction))?;
        Some(placement.scale * way)
    }

    fn mirror_planes(&self) -> Vec<(usize, f64)> {
        let Placement {
            scale,
            rotation,
            translation,
        } = &self.placement;
        self.shape
            .mirror_planes()
            .into_iter()
            .filter_map(|(axis, position)| {
                // The plane's normal must be a coordinate axis again.
                let normal = rotation.column(axis);
                let turned = (0..D).find(|&k| normal[k].abs() == 1.0)?;
                let position = translation[turned] + normal[turned] * scale * position;
                Some((turned, position))
            })
            .collect()
    }

    fn facets(&self, size: f64, region: &Bounds<D>) -> Vec<[Vector<D>; D]> {
        let region = self.region_back(region);
        let mut facets = self.shape.facets(size / self.placement.scale, &region);
        for corner in facets.iter_mut().flatten() {
            *corner = self.placement.point(corner);
        }
        facets
    }

    fn for_each_facet(&self, size: f64, region: &Bounds<D>, visit: &mut dyn FnMut([Vector<D>; D])) {
        let region = self.region_back(region);
        let placement = &self.placement;
        let mut place = |facet: [Vector<D>; D]| visit(facet.map(|corner| placement.point(&corner)));
        self.shape
            .for_each_facet(size / placement.scale, &region, &mut place);
    }

    fn creases(&self, size: f64, region: &Bounds<D>) -> Vec<Crease<D>> {
        let region = self.region_back(region);
        let mut creases = self.shape.creases(size / self.placement.scale, &region);
        for Crease { ends, normals, .. } in &mut creases {
            *ends = ends.map(|end| self.placement.point(&end));
            *normals = normals.map(|normal| self.placement.direction(&normal));
        }
        creases
    }

    fn measure(&self) -> Option<f64> {
        let measure = self.shape.measure()?;
        Some(measure * self.placement.scale.powi(D as i32))
    }
}
