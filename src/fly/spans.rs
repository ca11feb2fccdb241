//! Where rays out of the axis are inside a body: spans of radii at a station along the axis, the same all around a body of revolution.

use std::f64::consts::TAU;

use aero_geometry::Vector;

/// Directions around the axis; no divisor of usual facet counts.
const AROUND: usize = 23;

/// Largest part by which radii around the axis may differ: that of a tube of 16 facets.
pub(super) const ROUND: f64 = 0.02;

/// Spans nearer to one another than this part of the largest radius are one.
const TOUCHING: f64 = 1e-6;

/// Radii are whole multiples of this part of the largest: those that are alike on both sides of a station are the same, or apart.
const GRAIN: f64 = 1e-9;

/// Where rays are inside, from and to, in the order of the radii.
pub(super) type Spans = Vec<[f64; 2]>;

/// The triangles of a body whose axis is x.
pub(super) struct Facets {
    /// Corners, around normals that point out of the body, in the order of their least x.
    all: Vec<[Vector<3>; 3]>,
    /// The longest of them along x.
    longest: f64,
    /// The largest radius.
    reach: f64,
}

/// Where a ray passes through the surface: the radius, and one out of the body or one into it.
type Crossing = (f64, i32);

impl Facets {
    /// Of a body that goes as far as `reach` from the axis.
    pub(super) fn new(mut all: Vec<[Vector<3>; 3]>, reach: f64) -> Self {
        all.sort_by(|a, b| least(a).total_cmp(&least(b)));
        let long = |facet: &[Vector<3>; 3]| {
            let most = facet.iter().map(|corner| corner[0]);
            most.fold(f64::NEG_INFINITY, f64::max) - least(facet)
        };
        let longest = all.iter().map(long).fold(0.0, f64::max);
        Self {
            all,
            longest,
            reach,
        }
    }

    /// The spans at a station: means of squares over all directions, which keep the section of the facets. None where directions differ, as they do
    /// about a body that is not round.
    pub(super) fn at(&self, x: f64) -> Option<Spans> {
        let mut all = self.crossings(x).into_iter().map(|each| self.spans(each));
        let first = all.next()??;
        let mut most = first.clone();
        let mut least = first.clone();
        let mut squares: Spans = first.iter().map(|span| span.map(|r| r * r)).collect();
        for spans in all {
            let spans = spans.filter(|spans| spans.len() == first.len())?;
            for (n, span) in spans.iter().enumerate() {
                for (k, r) in span.iter().enumerate() {
                    most[n][k] = most[n][k].max(*r);
                    least[n][k] = least[n][k].min(*r);
                    squares[n][k] += r * r;
                }
            }
        }
        let mut both = most.iter().flatten().zip(least.iter().flatten());
        let is_round =
            both.all(|(most, least)| most - least <= ROUND * most + 1e-3 * ROUND * self.reach);
        let grain = GRAIN * self.reach;
        let mean = |square: f64| ((square / AROUND as f64).sqrt() / grain).round() * grain;
        is_round.then(|| squares.iter().map(|span| span.map(mean)).collect())
    }

    /// What each ray at a station passes through.
    fn crossings(&self, x: f64) -> [Vec<Crossing>; AROUND] {
        let rays: [[f64; 2]; AROUND] = std::array::from_fn(|k| {
            let (s, c) = (TAU * k as f64 / AROUND as f64).sin_cos();
            [c, s]
        });
        let mut found = [const { Vec::new() }; AROUND];
        let from = |x: f64| self.all.partition_point(|facet| least(facet) < x);
        for facet in &self.all[from(x - self.longest)..from(x)] {
            let Some([p, q]) = cut(facet, x) else {
                continue;
            };
            let normal = (facet[1] - facet[0]).cross(&(facet[2] - facet[0]));
            for (ray, found) in rays.iter().zip(&mut found) {
                let beside = |point: [f64; 2]| ray[0] * point[1] - ray[1] * point[0];
                let (a, b) = (beside(p), beside(q));
                if (a < 0.0) == (b < 0.0) {
                    continue;
                }
                let part = a / (a - b);
                let along = |k: usize| ray[k] * (p[k] + part * (q[k] - p[k]));
                let radius = along(0) + along(1);
                let out = ray[0] * normal[1] + ray[1] * normal[2];
                if radius > 0.0 {
                    found.push((radius, if out > 0.0 { 1 } else { -1 }));
                }
            }
        }
        found
    }

    /// Where a ray is inside, by how many parts of the body it is in; none of a surface that is not closed.
    fn spans(&self, mut crossings: Vec<Crossing>) -> Option<Spans> {
        crossings.sort_by(|a, b| a.0.total_cmp(&b.0));
        // Far out a ray is outside.
        let mut depth: i32 = crossings.iter().map(|(_, out)| out).sum();
        let mut spans = Spans::new();
        let mut from = 0.0;
        for (radius, out) in crossings {
            let before = depth;
            depth -= out;
            if before == 0 && depth == 1 {
                from = radius;
            } else if before == 1 && depth == 0 {
                match spans.last_mut() {
                    Some(last) if from - last[1] < TOUCHING * self.reach => last[1] = radius,
                    _ => spans.push([from, radius]),
                }
            } else if before.min(depth) < 0 {
                return None;
            }
        }
        Some(spans)
    }
}

/// Where a triangle begins along the axis.
fn least(facet: &[Vector<3>; 3]) -> f64 {
    facet[0][0].min(facet[1][0]).min(facet[2][0])
}

/// Where the plane across the axis at `x` cuts a triangle: both ends, across the axis.
fn cut(facet: &[Vector<3>; 3], x: f64) -> Option<[[f64; 2]; 2]> {
    let is_before = facet.map(|corner| corner[0] < x);
    // The corner that is alone on its side.
    let alone = (0..3).find(|&k| {
        is_before[k] != is_before[(k + 1) % 3] && is_before[k] != is_before[(k + 2) % 3]
    })?;
    let ends = [1, 2].map(|k| {
        // From the side before, so that both triangles of an edge find the same place.
        let [a, b] = if is_before[alone] {
            [facet[alone], facet[(alone + k) % 3]]
        } else {
            [facet[(alone + k) % 3], facet[alone]]
        };
        let part = (x - a[0]) / (b[0] - a[0]);
        [1, 2].map(|axis| a[axis] + part * (b[axis] - a[axis]))
    });
    Some(ends)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_that_touch_or_overlap_are_one_and_an_open_surface_has_no_inside() {
        let facets = Facets::new(Vec::new(), 1.0);
        let spans = |crossings: &[Crossing]| facets.spans(crossings.to_vec());
        let touching = [(0.2, -1), (0.4, 1), (0.4 + 1e-8, -1), (0.6, 1)];
        assert_eq!(spans(&touching), Some(vec![[0.2, 0.6]]));
        let overlapping = [(0.2, -1), (0.3, -1), (0.4, 1), (0.6, 1)];
        assert_eq!(spans(&overlapping), Some(vec![[0.2, 0.6]]));
        let apart = [(0.1, 1), (0.4, -1), (0.6, 1)];
        assert_eq!(spans(&apart), Some(vec![[0.0, 0.1], [0.4, 0.6]]));
        assert_eq!(spans(&[(0.2, 1), (0.4, 1), (0.6, -1)]), None);
        assert_eq!(spans(&[(0.2, -1)]), None);
    }
}
