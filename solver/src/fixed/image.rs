//! Mirror images of the points of cells at walls.

use aero_geometry::Vector;

use super::calmness::steepness;
use super::cells::{Matrix, RADIAL};
use super::reconstruction::{Neighbours, rise};
use super::state::Primitive;

/// The mirror image of a cell's point behind a plane.
#[derive(Clone, Copy, Debug)]
pub struct Image<const D: usize> {
    /// Unit normal of the plane, out of the gas.
    pub normal: [f64; D],
    /// Area of the cell's face on it.
    pub size: f64,
    /// What counts of that in gradients: the face in the plane of rings, all of it elsewhere.
    pub share: f64,
    /// Distance of the point from it.
    pub distance: f64,
}

impl<const D: usize> Image<D> {
    /// Of `point` behind the plane through `foot` of a face `area`.
    pub fn new(area: &Vector<D>, point: &Vector<D>, foot: &Vector<D>) -> Self {
        let size = area.norm();
        let normal = if size > 0.0 {
            area / size
        } else {
            Vector::zeros()
        };
        Self {
            normal: normal.into(),
            size,
            share: size,
            // At an edge a point may lie beyond the plane of a wall that its cell holds a part of: it has no image there.
            distance: (foot - point).dot(&normal).max(0.0),
        }
    }

    /// The same about an axis that the face is at this distance from; on the axis itself it has no area.
    #[must_use]
    pub fn at_radius(self, radius: f64) -> Self {
        Self {
            share: if radius > 0.0 {
                self.size / radius
            } else {
                0.0
            },
            ..self
        }
    }

    /// Behind an axis at the lower end of the radius: a face of this length in the plane, and of no area.
    pub fn behind_axis(length: f64, distance: f64) -> Self {
        let mut normal = [0.0; D];
        normal[RADIAL] = -1.0;
        Self {
            normal,
            size: 0.0,
            share: length,
            distance,
        }
    }

    /// Area times the unit normal.
    pub fn area(&self) -> Vector<D> {
        Vector::from(self.normal) * self.size
    }

    /// `w d d^T` with the image at `d = 2 distance normal` and `w` area over distance.
    pub fn moment(&self) -> Matrix<D> {
        let normal = Vector::from(self.normal);
        normal * normal.transpose() * (2.0 * self.share * self.distance)
    }

    /// The state of `cell` drawn out to the plane, with the mirror image as its neighbour.
    pub fn inner(
        &self,
        cell: &Primitive<D>,
        slopes: &[Primitive<D>; D],
        calmness: f64,
    ) -> Primitive<D> {
        let apart = self.normal.map(|n| 2.0 * self.distance * n);
        let rise = rise(slopes, &apart);
        let [inner, _] = Neighbours {
            means: [*cell, cell.mirrored(&self.normal)],
            rises: [rise; 2],
            smooth: steepness(calmness),
            order: calmness,
            has_layers: false,
            evenness: None,
        }
        .states();
        inner
    }

    /// `w d`.
    #[inline]
    pub fn weight(&self) -> [f64; D] {
        self.normal.map(|n| n * self.share)
    }
}
