//! Rims: what the corners of a meridian sweep about the axis.

use std::f64::consts::{PI, TAU};

use super::Revolution;
use crate::outline::piece::right_of;
use crate::{Bounds, Crease, Vector};

/// Least number of pieces of a rim.
const FEWEST: f64 = 16.0;

impl Revolution {
    /// The rims, in pieces about `size` long at most that are as far within the circle in their middle as beyond it at their ends.
    pub(super) fn rims(&self, size: f64, region: &Bounds<3>) -> Vec<Crease<3>> {
        let mut rims = Vec::new();
        for corner in self.meridian.corners() {
            let (x, radius) = (corner.point.x, corner.point.y);
            if radius <= 0.0 {
                continue;
            }
            let [before, after] = corner.pieces.map(|number| &self.meridian.pieces()[number]);
            let tangents = [
                before.tangent(before.range()[1]),
                after.tangent(after.range()[0]),
            ];
            let count = (TAU * radius / size).ceil().max(FEWEST);
            let farther = 2.0 / (1.0 + (PI / count).cos());
            let end = |number: f64| {
                let (sine, cosine) = (TAU * number / count).sin_cos();
                let radius = radius * farther;
                Vector::<3>::new(x, radius * cosine, radius * sine)
            };
            for number in 0..count as usize {
                let number = number as f64;
                let ends = [end(number), end((number + 1.0) % count)];
                let low = ends[0].inf(&ends[1]);
                let high = ends[0].sup(&ends[1]);
                if region.intersection(&Bounds::new(low, high)).is_empty() {
                    continue;
                }
                let (sine, cosine) = (TAU * (number + 0.5) / count).sin_cos();
                let normals = tangents.map(|tangent| {
                    let flat = right_of(&tangent);
                    Vector::<3>::new(flat.x, flat.y * cosine, flat.y * sine)
                });
                rims.push(Crease {
                    ends,
                    normals,
                    is_convex: corner.interior_angle < PI,
                });
            }
        }
        rims
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::outline::Piece;
    use crate::{Placed, Placement, Shape, bodies};

    /// A cone of 15 degrees, a cylinder and a base.
    fn shoulder() -> Revolution {
        let rise = f64::to_radians(15.0).tan();
        let corners = [[0.0, 0.0], [1.0, rise], [2.0, rise], [2.0, 0.0]];
        let ends = corners.map(Vector::<2>::from);
        let pieces = ends.windows(2).map(|ends| Piece::segment(ends[0], ends[1]));
        Revolution::new(pieces.collect()).unwrap()
    }

    fn everywhere() -> Bounds<3> {
        Bounds::new(Vector::repeat(-9.0), Vector::repeat(9.0))
    }

    #[test]
    fn rims_go_around_the_axis_and_turn_as_the_meridian() {
        let rise = f64::to_radians(15.0).tan();
        let rims = shoulder().creases(0.05, &everywhere());
        let at_shoulder: Vec<_> = rims.iter().filter(|rim| rim.ends[0].x < 1.5).collect();
        assert_eq!(2 * at_shoulder.len(), rims.len());
        let mut around = 0.0;
        for rim in at_shoulder {
            let [from, to] = rim.ends;
            let middle = 0.5 * (from + to);
            assert!((to - from).norm() < 0.051);
            assert!((middle.y.hypot(middle.z) - rise).abs() < 1e-3);
            assert!((rim.turn().to_degrees() - 15.0).abs() < 1e-9);
            for normal in rim.normals {
                assert!(normal.dot(&(to - from)).abs() < 1e-12);
                assert!(normal.y * middle.y + normal.z * middle.z > 0.0);
            }
            around += (to - from).norm();
        }
        assert!((around / (TAU * rise) - 1.0).abs() < 1e-3);
    }

    #[test]
    fn a_flare_begins_at_a_hollow() {
        let corners = [[0.0, 0.2], [1.0, 0.2], [2.0, 0.5], [2.0, 0.0], [0.0, 0.0]];
        let ends = corners.map(Vector::<2>::from);
        let pieces = ends[..4]
            .windows(2)
            .map(|ends| Piece::segment(ends[0], ends[1]));
        let front = Piece::segment(ends[4], ends[0]);
        let body = Revolution::new([front].into_iter().chain(pieces).collect()).unwrap();
        for rim in body.creases(0.05, &everywhere()) {
            assert_eq!(rim.is_convex, rim.ends[0].x != 1.0);
        }
    }

    #[test]
    fn rims_are_placed_with_their_body_and_cut_off_with_their_region() {
        let place = Placement::<3>::default()
            .scaled(2.0)
            .unwrap()
            .rotated_about(&Vector::z(), PI)
            .unwrap()
            .moved(Vector::<3>::new(5.0, 0.0, 0.0));
        let placed = Placed::new(shoulder(), place);
        let upper = Bounds::new(Vector::<3>::new(2.0, 0.0, 0.0), Vector::repeat(9.0));
        let rims = placed.creases(0.1, &upper);
        let all = placed.creases(0.1, &everywhere());
        assert!(rims.len() < all.len() / 4 && rims.len() > all.len() / 9);
        for rim in rims {
            let [a, b] = rim.normals;
            assert!((rim.ends[0].x - 3.0).abs() < 1e-12);
            assert!(
                (a.norm() - 1.0).abs() < 1e-12
                    && (a.dot(&b) - f64::to_radians(15.0).cos()).abs() < 1e-9
            );
        }
    }

    #[test]
    fn smooth_bodies_and_tips_have_none() {
        assert!(
            bodies::sphere(0.3)
                .unwrap()
                .creases(0.1, &everywhere())
                .is_empty()
        );
        // The tip of a cone is none, its base is one.
        let rims = bodies::cone(15.0, 1.0).unwrap().creases(0.1, &everywhere());
        assert!(
            rims.iter()
                .all(|rim| rim.ends[0].x == 1.0 && rim.turn() > 1.5)
        );
    }
}
