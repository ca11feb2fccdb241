//! Faces on walls, and the mirror images behind them.

use aero_geometry::Vector;

use super::cells::WallFace;
use super::fluxes::smoothness;
use super::gas::Gas;
use super::net::Matrix;
use super::reconstruction::{Neighbours, rise};
use super::state::{Conserved, Primitive, dot};

/// The mirror image of a cell's point behind a plane.
#[derive(Clone, Copy, Debug)]
pub struct Image<const D: usize> {
    /// Unit normal of the plane, out of the gas.
    pub normal: [f64; D],
    /// Area of the cell's face on it.
    pub size: f64,
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
            // At an edge a point may lie beyond the plane of a wall that its cell holds a part of: it has no image there.
            distance: (foot - point).dot(&normal).max(0.0),
        }
    }

    /// Area times the unit normal.
    pub fn area(&self) -> Vector<D> {
        Vector::from(self.normal) * self.size
    }

    /// `w d d^T` with the image at `d = 2 distance normal` and `w` area over distance.
    pub fn moment(&self) -> Matrix<D> {
        let normal = Vector::from(self.normal);
        normal * normal.transpose() * (2.0 * self.size * self.distance)
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
            smooth: smoothness(calmness),
            order: calmness,
        }
        .states();
        inner
    }

    /// `w d`.
    #[inline]
    pub fn weight(&self) -> [f64; D] {
        self.normal.map(|n| n * self.size)
    }
}

/// A wall of a cell.
#[derive(Clone, Copy, Debug)]
pub struct Wall<const D: usize> {
    /// Cell.
    pub i: u32,
    /// The cell's image behind it.
    pub image: Image<D>,
    /// Number of what it belongs to: bodies first, wall sides after.
    pub owner: u32,
    /// Shape operator, 1/m.
    pub curvature: Matrix<D>,
    /// Where it is.
    pub foot: Vector<D>,
}

impl<const D: usize> Wall<D> {
    /// The wall `face` of the cell at `point`.
    pub fn new(face: &WallFace<D>, point: &Vector<D>, owner: u32) -> Self {
        Self {
            i: face.i,
            image: Image::new(&face.area, point, &face.foot),
            owner,
            curvature: face.curvature,
            foot: face.foot,
        }
    }

    /// Pressure on the wall: that of the Riemann problem between the cell's state, drawn out to the wall, and its mirror image.
    /// `slopes` and `calmness` are the cell's.
    ///
    /// Along a bent wall the gas presses outwards, `dp/dn = rho u.K u`; from the cell's middle to the wall this makes
    /// `p / (1 + d rho u.K u / p)` of `p`, which stays positive however far the middle is.
    pub fn pressure<G: Gas>(
        &self,
        gas: &G,
        cell: &Primitive<D>,
        slopes: &[Primitive<D>; D],
        calmness: f64,
    ) -> f64 {
        let Image {
            normal, distance, ..
        } = &self.image;
        let inner = self.image.inner(cell, slopes, calmness);
        let speed = dot(&inner.velocity, normal);
        let velocity = Vector::from(cell.velocity);
        let bend = distance * cell.density * velocity.dot(&(self.curvature * velocity));
        let pressure = if bend > 0.0 {
            inner.pressure * inner.pressure / (inner.pressure + bend)
        } else {
            inner.pressure - bend
        };
        gas.wall_pressure(inner.density, pressure, speed)
    }
}

/// What a wall at this pressure gives the gas per time: momentum alone.
#[inline]
pub fn push<const D: usize>(image: &Image<D>, pressure: f64) -> Conserved<D> {
    Conserved {
        mass: 0.0,
        momentum: image.normal.map(|n| -pressure * image.size * n),
        energy: 0.0,
    }
}
