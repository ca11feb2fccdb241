//! Sharp convex edges of surfaces in space.

use crate::Vector;

/// A straight piece of a sharp convex edge, in which two smooth parts of a surface meet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ridge<const D: usize> {
    /// Its ends.
    pub ends: [Vector<D>; 2],
    /// Unit normals of both parts there, out of the body.
    pub normals: [Vector<D>; 2],
}

impl<const D: usize> Ridge<D> {
    /// Angle by which the surface turns, radians.
    pub fn turn(&self) -> f64 {
        let [a, b] = &self.normals;
        (b - a).norm().atan2((a + b).norm()) * 2.0
    }
}
