//! Rims: what the convex corners of a meridian sweep about the axis.

use std::f64::consts::{PI, TAU};

use super::Revolution;
use crate::outline::piece::right_of;
use crate::{Bounds, Ridge, Vector};

/// Least number of pieces of a rim.
const FEWEST: f64 = 16.0;

impl Revolution {
    /// The rims, in pieces about `size` long at most that are as far within the circle in their middle as beyond it at their ends.
    pub(super) fn rims(&self, size: f64, region: &Bounds<3>) -> Vec<Ridge<3>> {
        let mut rims = Vec::new();
        for corner in self.meridian.corners() {
            let (x, radius) = (corner.point.x, corner.point.y);
            if corner.interior_angle >= PI || radius <= 0.0 {
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
                rims.push(Ridge { ends, normals });
            }
        }
        rims
    }
}
