//! Small exact shapes to pack.
#![allow(dead_code, reason = "each test file uses some of them")]

use aero_geometry::{Bounds, Closest, Shape, Vector};

/// A circle or a sphere.
#[derive(Clone, Debug)]
pub struct Ball<const D: usize> {
    pub centre: Vector<D>,
    pub radius: f64,
}

impl<const D: usize> Ball<D> {
    pub fn new(radius: f64) -> Self {
        Self {
            centre: Vector::zeros(),
            radius,
        }
    }
}

impl<const D: usize> Shape<D> for Ball<D> {
    fn bounds(&self) -> Bounds<D> {
        Bounds::new(self.centre, self.centre).grown(self.radius)
    }

    fn closest(&self, point: &Vector<D>) -> Closest<D> {
        let out = point - self.centre;
        let r = out.norm();
        let normal = if r > 0.0 {
            out / r
        } else {
            Vector::from_fn(|k, _| f64::from(u8::from(k == 0)))
        };
        Closest {
            point: self.centre + self.radius * normal,
            distance: r - self.radius,
            normal,
            face: 0,
        }
    }

    fn mirror_planes(&self) -> Vec<(usize, f64)> {
        (0..D).map(|k| (k, self.centre[k])).collect()
    }
}

/// A polygon, counter-clockwise; or an endless wall, whose far vertices are out of sight.
#[derive(Clone, Debug)]
pub struct Polygon {
    pub vertices: Vec<Vector<2>>,
    pub endless: bool,
    pub planes: Vec<(usize, f64)>,
}

impl Polygon {
    pub fn new(vertices: &[[f64; 2]]) -> Self {
        Self {
            vertices: vertices.iter().map(|&v| Vector::from(v)).collect(),
            endless: false,
            planes: Vec::new(),
        }
    }

    /// A rectangle from `min` to `max`.
    pub fn rectangle(min: [f64; 2], max: [f64; 2]) -> Self {
        Self::new(&[min, [max[0], min[1]], max, [min[0], max[1]]])
    }

    /// The wall `y = 0`, turned up by `degrees` at the origin.
    pub fn corner(degrees: f64) -> Self {
        let far = 1000.0;
        let angle = degrees.to_radians();
        let mut corner = Self::new(&[
            [-far, -2.0 * far],
            [far, -2.0 * far],
            [far * angle.cos(), far * angle.sin()],
            [0.0, 0.0],
            [-far, 0.0],
        ]);
        corner.endless = true;
        corner
    }

    pub fn with_planes(mut self, planes: &[(usize, f64)]) -> Self {
        self.planes = planes.to_vec();
        self
    }

    pub fn turned(mut self, degrees: f64) -> Self {
        let (sin, cos) = degrees.to_radians().sin_cos();
        for v in &mut self.vertices {
            *v = Vector::from([cos * v[0] - sin * v[1], sin * v[0] + cos * v[1]]);
        }
        self
    }

    /// Two circular arcs of chord `chord` and half thickness `half`, as fine polygons.
    pub fn biconvex(chord: f64, half: f64, pieces: usize) -> Self {
        let radius = (chord * chord / 4.0 + half * half) / (2.0 * half);
        let opening = (0.5 * chord / radius).asin();
        let arc = |n: usize| {
            let t = -opening + 2.0 * opening * n as f64 / pieces as f64;
            [radius * t.sin(), radius * t.cos() - (radius - half)]
        };
        let mut vertices: Vec<[f64; 2]> = (0..pieces)
            .map(|n| {
                let [x, y] = arc(n);
                [x, -y]
            })
            .collect();
        vertices.extend((0..pieces).map(|n| {
            let [x, y] = arc(n);
            [-x, y]
        }));
        Self::new(&vertices).with_planes(&[(1, 0.0)])
    }
}

impl Shape<2> for Polygon {
    fn bounds(&self) -> Bounds<2> {
        if self.endless {
            return Bounds::new(
                Vector::repeat(f64::NEG_INFINITY),
                Vector::repeat(f64::INFINITY),
            );
        }
        let mut bounds = Bounds::new(self.vertices[0], self.vertices[0]);
        for v in &self.vertices {
            bounds.min = bounds.min.inf(v);
            bounds.max = bounds.max.sup(v);
        }
        bounds
    }

    fn closest(&self, point: &Vector<2>) -> Closest<2> {
        let mut best = (f64::INFINITY, Vector::zeros(), 0, Vector::zeros());
        let mut inside = false;
        for n in 0..self.vertices.len() {
            let a = self.vertices[n];
            let b = self.vertices[(n + 1) % self.vertices.len()];
            let edge = b - a;
            let t = ((point - a).dot(&edge) / edge.norm_squared()).clamp(0.0, 1.0);
            let foot = a + t * edge;
            let d = (point - foot).norm();
            if d < best.0 {
                let out = Vector::from([edge[1], -edge[0]]).normalize();
                best = (d, foot, n, out);
            }
            if (a[1] > point[1]) != (b[1] > point[1])
                && point[0] < a[0] + (point[1] - a[1]) / (b[1] - a[1]) * edge[0]
            {
                inside = !inside;
            }
        }
        let (d, foot, face, out) = best;
        let sign = if inside { -1.0 } else { 1.0 };
        let normal = if d > 1e-12 {
            sign * (point - foot) / d
        } else {
            out
        };
        Closest {
            point: foot,
            distance: sign * d,
            normal,
            face: face as u32,
        }
    }

    fn mirror_planes(&self) -> Vec<(usize, f64)> {
        self.planes.clone()
    }
}
