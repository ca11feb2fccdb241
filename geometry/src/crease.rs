//! Sharp edges of surfaces in space.

use crate::Vector;

/// A straight piece of a sharp edge, in which two smooth parts of a surface meet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crease<const D: usize> {
    /// Its ends.
    pub ends: [Vector<D>; 2],
    /// Unit normals of both parts there, out of the body.
    pub normals: [Vector<D>; 2],
    /// True where the body bulges, false in a hollow of it.
    pub is_convex: bool,
}

impl<const D: usize> Crease<D> {
    /// Angle by which the surface turns, radians.
    pub fn turn(&self) -> f64 {
        let [a, b] = &self.normals;
        (b - a).norm().atan2((a + b).norm()) * 2.0
    }
}
