//! Cells derived from points, and the faces between them.

use aero_geometry::Vector;
use nalgebra::SMatrix;

use super::face_list::FaceList;

/// Axis in the meridian plane along which the radius is measured.
pub const RADIAL: usize = 1;

/// A square matrix.
pub type Matrix<const D: usize> = SMatrix<f64, D, D>;

/// The polygons that bound pieces of cells, each as seen from the point of its cell, by whose number they are sorted.
pub type Rings<const D: usize> = Vec<(u32, Vec<Vec<Vector<D>>>)>;

/// Cells derived from points, and the faces between them.
#[derive(Clone, Debug, Default)]
pub struct Cells<const D: usize> {
    /// Where the points are, m; runs of some hundred of them lie close together.
    pub points: Vec<Vector<D>>,
    /// Volume in space, area in the plane, length on a line; per radian about an axis.
    pub volumes: Vec<f64>,
    /// Between two cells, sorted by `(i, j)`.
    pub faces: FaceList<D>,
    /// On bodies and walls.
    pub walls: Vec<WallFace<D>>,
    /// On the other sides of the domain.
    pub sides: Vec<SideFace<D>>,
    /// What bounds the cells in space whose faces do not say it.
    pub cornered: Rings<D>,
    /// Pieces behind thin parts that nobody could take.
    pub lost: usize,
    /// Largest part of a cell's faces that did not close before its wall took it, in spacings to their power.
    pub open: f64,
}

/// What a wall belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WallOwner {
    /// A body, by its number in the case.
    Body(u32),
    /// A side of the domain.
    Side {
        /// Its axis.
        axis: u8,
        /// Lower or upper end.
        end: u8,
    },
}

/// A face on a wall.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WallFace<const D: usize> {
    /// Cell.
    pub i: u32,
    /// Area times the unit normal out of the gas.
    pub area: Vector<D>,
    /// What it belongs to.
    pub owner: WallOwner,
    /// Shape operator of the wall, 1/m; positive where the body bulges into the gas.
    pub curvature: SMatrix<f64, D, D>,
    /// A point on the face's plane: the foot of the cell's point.
    pub foot: Vector<D>,
    /// Smooth part of the surface.
    pub facet: u32,
}

/// A face on a side of the domain that is no wall.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SideFace<const D: usize> {
    /// Cell.
    pub i: u32,
    /// Area times the unit normal out of the domain.
    pub area: Vector<D>,
    /// Axis of the side.
    pub axis: u8,
    /// Lower or upper end.
    pub end: u8,
    /// Middle of the face.
    pub centre: Vector<D>,
}

impl<const D: usize> Cells<D> {
    /// The points alone.
    pub fn into_points(self) -> Vec<Vector<D>> {
        self.points
    }

    /// Mean distance of each point from those of its neighbours, by the areas of the faces between.
    pub fn spacings(&self) -> Vec<f64> {
        let mut sums = vec![[0.0; 2]; self.points.len()];
        for face in self.faces.iter() {
            let size = face.area.norm();
            for i in [face.i, face.j] {
                sums[i as usize][0] += size * face.apart.norm();
                sums[i as usize][1] += size;
            }
        }
        sums.into_iter().map(|[sum, size]| sum / size).collect()
    }

    /// What is left of the sum of area vectors of each cell: nothing but rounding where it is closed. About an axis the
    /// radial part is the cell's area in the plane instead, and is left out.
    pub fn open_areas(&self, about_axis: bool) -> Vec<Vector<D>> {
        let mut sums = vec![Vector::<D>::zeros(); self.points.len()];
        for face in self.faces.iter() {
            sums[face.i as usize] += face.area;
            sums[face.j as usize] -= face.area;
        }
        for wall in &self.walls {
            sums[wall.i as usize] += wall.area;
        }
        for side in &self.sides {
            sums[side.i as usize] += side.area;
        }
        if about_axis && D == 2 {
            for sum in &mut sums {
                sum[1] = 0.0;
            }
        }
        sums
    }
}
