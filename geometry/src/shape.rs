//! What every body offers, whether analytic or read from a file.

use crate::{Bounds, Crease, Outline, Vector};

/// The answer to "where is the surface from here?".
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Closest<const D: usize> {
    /// Closest point on the surface.
    pub point: Vector<D>,
    /// Signed distance to it: negative inside the body.
    pub distance: f64,
    /// Unit normal there, out of the body into the fluid. Where the closest point is an edge
    /// or a corner it is the direction from (or, inside, to) that point.
    pub normal: Vector<D>,
    /// Number of the smooth part of the surface (face, side, patch) that the point belongs to.
    pub face: u32,
}

/// A closed body, or the solid side of an endless wall.
pub trait Shape<const D: usize>: Send + Sync + std::fmt::Debug {
    /// A box that holds the body; infinite where the body is.
    fn bounds(&self) -> Bounds<D>;

    /// Closest surface point, signed distance and outward normal, from any point in space.
    fn closest(&self, point: &Vector<D>) -> Closest<D>;

    /// Signed distance, negative inside.
    fn signed_distance(&self, point: &Vector<D>) -> f64 {
        self.closest(point).distance
    }

    /// How far it is from a place inside of the body along a unit vector to where that leaves it, metres; zero from outside. Nothing
    /// from a shape that cannot tell at once, or where the way passes through an edge: steps of the signed distance tell then.
    fn way_out(&self, from: &Vector<D>, direction: &Vector<D>) -> Option<f64> {
        let _ = (from, direction);
        None
    }

    /// Coordinate planes `(axis, position)` about which the body is mirror symmetric.
    fn mirror_planes(&self) -> Vec<(usize, f64)> {
        Vec::new()
    }

    /// The exact curve, of a two-dimensional shape that is one.
    fn outline(&self) -> Option<&Outline> {
        None
    }

    /// Segments (2D) or triangles (3D) that cover the surface where it meets `region`, curved parts in pieces about `size`
    /// long at most; parts that lie inside of the body or beyond the region may be among them. Empty for a shape that
    /// cannot tell.
    fn facets(&self, size: f64, region: &Bounds<D>) -> Vec<[Vector<D>; D]> {
        let _ = (size, region);
        Vec::new()
    }

    /// Calls `visit` with each of [`Shape::facets`] in their order; millions of them need no memory then.
    fn for_each_facet(&self, size: f64, region: &Bounds<D>, visit: &mut dyn FnMut([Vector<D>; D])) {
        self.facets(size, region).into_iter().for_each(visit);
    }

    /// Sharp edges (3D) of the surface where it meets `region`, round ones in pieces about `size` long at most; parts
    /// that lie inside of the body or beyond the region may be among them. Empty for a shape that cannot tell.
    fn creases(&self, size: f64, region: &Bounds<D>) -> Vec<Crease<D>> {
        let _ = (size, region);
        Vec::new()
    }

    /// Area (2D) or volume (3D) of the body, metres to the power `D`; `None` where it is endless.
    fn measure(&self) -> Option<f64> {
        None
    }
}

/// A shape behind a pointer is the shape.
macro_rules! forward {
    ($pointer:ty) => {
        impl<S: Shape<D> + ?Sized, const D: usize> Shape<D> for $pointer {
            fn bounds(&self) -> Bounds<D> {
                (**self).bounds()
            }

            fn closest(&self, point: &Vector<D>) -> Closest<D> {
                (**self).closest(point)
            }

            fn signed_distance(&self, point: &Vector<D>) -> f64 {
                (**self).signed_distance(point)
            }

            fn way_out(&self, from: &Vector<D>, direction: &Vector<D>) -> Option<f64> {
                (**self).way_out(from, direction)
            }

            fn mirror_planes(&self) -> Vec<(usize, f64)> {
                (**self).mirror_planes()
            }

            fn outline(&self) -> Option<&Outline> {
                (**self).outline()
            }

            fn facets(&self, size: f64, region: &Bounds<D>) -> Vec<[Vector<D>; D]> {
                (**self).facets(size, region)
            }

            fn for_each_facet(
                &self,
                size: f64,
                region: &Bounds<D>,
                visit: &mut dyn FnMut([Vector<D>; D]),
            ) {
                (**self).for_each_facet(size, region, visit);
            }

            fn creases(&self, size: f64, region: &Bounds<D>) -> Vec<Crease<D>> {
                (**self).creases(size, region)
            }

            fn measure(&self) -> Option<f64> {
                (**self).measure()
            }
        }
    };
}

forward!(&S);
forward!(Box<S>);
forward!(std::sync::Arc<S>);
