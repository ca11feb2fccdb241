//! The lee of a body: what of its surface has nothing of the body behind it.

use aero_geometry::{Shape, Vector};

use super::spans::ROUND;

/// Off the surface at first, and least step, in lengths of the body.
const NEAR: [f64; 2] = [1e-5, 1e-3];

/// A body in a stream, seen from behind.
pub(super) struct Lee<'a> {
    shape: &'a dyn Shape<3>,
    /// Where the stream goes, of length one.
    way: Vector<3>,
    /// Length of the body, and the longest way through its box.
    lengths: [f64; 2],
    /// Way along the stream within which a place that was taken for one of the surface has come out of the body.
    leave: f64,
}

impl<'a> Lee<'a> {
    /// Of places on surfaces that turn away from the stream by a sine of `steep` and more.
    ///
    /// The meridian of a body of revolution is the mean of radii that differ by [`ROUND`]: it lies that much inside some of its facets.
    pub(super) fn new(shape: &'a dyn Shape<3>, way: [f64; 3], steep: f64) -> Self {
        let size = shape.bounds().size();
        Self {
            shape,
            way: way.into(),
            lengths: [size[0], size.norm()],
            leave: 0.5 * ROUND * size[1].max(size[2]) / steep,
        }
    }

    /// True where a way along the stream from `place`, which is on the surface but for what facets are off it, meets no more of the body: by
    /// steps as long as the distance from it.
    pub(super) fn is_open(&self, place: &Vector<3>, normal: &Vector<3>) -> bool {
        let [length, through] = self.lengths;
        let [off, least] = NEAR.map(|part| part * length);
        let mut point = place + normal * off;
        let mut gone = 0.0;
        let mut is_out = false;
        while gone < through {
            let distance = self.shape.signed_distance(&point);
            if distance < 0.0 && (is_out || gone > self.leave) {
                return false;
            }
            is_out |= distance >= 0.0;
            let step = distance.max(least);
            point += self.way * step;
            gone += step;
        }
        true
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use aero_geometry::outline::Piece;
    use aero_geometry::{Mending, Revolution, Solid, Watch, bodies, stl};

    use super::super::meridian::Meridian;
    use super::*;

    const AXIAL: [f64; 3] = [1.0, 0.0, 0.0];
    const STEEP: f64 = 25.0;

    /// As read from a file.
    fn mesh(body: &Revolution, around: usize) -> Arc<dyn Shape<3>> {
        let mut bytes = Vec::new();
        stl::write_binary(&mut bytes, &body.tessellate(around)).expect("a file");
        let soup = stl::parse(bytes).expect("triangles");
        let solid = Solid::new(soup, Mending::Refuse, &Watch::default());
        solid.expect("a solid").shape
    }

    /// Part of the frontal area of a sphere of so many facets around that is base, by its meridian.
    fn base(around: usize) -> f64 {
        let shape = mesh(&bodies::sphere(0.5).expect("a sphere"), around);
        let line = Meridian::of(shape.as_ref()).expect("a round body").corners;
        let steep = STEEP.to_radians().sin();
        let lee = Lee::new(shape.as_ref(), AXIAL, steep);
        let mut base = 0.0;
        for pair in line.windows(2) {
            let ([x0, r0], [x1, r1]) = (pair[0], pair[1]);
            let normal = Vector::<3>::new(r0 - r1, x1 - x0, 0.0).normalize();
            let middle = Vector::<3>::new(0.5 * (x0 + x1), 0.5 * (r0 + r1), 0.0);
            if normal[0] > steep && lee.is_open(&middle, &normal) {
                base += 4.0 * (r0 * r0 - r1 * r1);
            }
        }
        base
    }

    /// All that is closer to the axis than `cos 25` radii, whatever the facets.
    #[test]
    fn the_base_of_a_sphere_of_facets_is_that_of_the_sphere() {
        for around in [24, 48, 240] {
            let (base, exact) = (base(around), STEEP.to_radians().cos().powi(2));
            assert!((base - exact).abs() < 0.05, "{around}: {base}, {exact}");
        }
    }

    /// Behind the front wall of a groove stands its back wall.
    #[test]
    fn the_front_of_a_groove_is_no_base() {
        let line = [
            [0.0, 0.0],
            [0.0, 0.5],
            [0.4, 0.5],
            [0.4, 0.4],
            [0.5, 0.4],
            [0.5, 0.5],
            [1.0, 0.5],
            [1.0, 0.0],
        ];
        let point = |n: usize| Vector::<2>::from(line[n]);
        let pieces = (1..line.len()).map(|n| Piece::segment(point(n - 1), point(n)));
        let body = Revolution::new(pieces.collect()).expect("a body");
        let lee = Lee::new(&body, AXIAL, STEEP.to_radians().sin());
        let is_open = |x: f64| lee.is_open(&Vector::<3>::new(x, 0.45, 0.0), &AXIAL.into());
        assert!(!is_open(0.4) && is_open(1.0));
    }
}
