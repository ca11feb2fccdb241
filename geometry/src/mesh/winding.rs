//! The generalized winding number: how many times a surface winds around a point.
//!
//! Far parts of the surface count by their dipole. [Barill, Dickson, Schmidt, Levin & Jacobson
//! 2018, "Fast winding numbers for soups and clouds", ACM Trans. Graph. 37, 43]

use std::f64::consts::PI;

use super::tree::Tree;
use crate::Vector;

/// A part of the surface is far beyond this many of its radii; the authors' choice.
const FAR: f64 = 2.0;

/// Signed solid angle of a triangle seen from the origin, up to 4 pi for a whole surface;
/// positive where the origin is behind it. [van Oosterom & Strackee 1983, IEEE Trans. Biomed. Eng. 30, 125]
#[inline]
pub(super) fn solid_angle([a, b, c]: &[Vector<3>; 3]) -> f64 {
    let (la, lb, lc) = (a.norm(), b.norm(), c.norm());
    let numerator = a.dot(&b.cross(c));
    let denominator = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
    if numerator == 0.0 {
        // In the triangle's own plane it is seen edge-on; on the triangle neither side is right.
        return 0.0;
    }
    2.0 * numerator.atan2(denominator)
}

/// The dipole of a part of the surface.
#[derive(Clone, Debug)]
struct Dipole {
    /// Centre of area.
    center: Vector<3>,
    /// Sum of area times normal.
    moment: Vector<3>,
    area: f64,
    /// Distance from the centre to the farthest point of the part.
    radius: f64,
}

/// Dipoles of all nodes of a tree.
#[derive(Clone, Debug)]
pub(super) struct Winding {
    dipoles: Vec<Dipole>,
}

impl Winding {
    pub fn new(tree: &Tree, corners: impl Fn(u32) -> [Vector<3>; 3]) -> Self {
        let zero = Dipole {
            center: Vector::<3>::zeros(),
            moment: Vector::<3>::zeros(),
            area: 0.0,
            radius: 0.0,
        };
        let mut dipoles = vec![zero; tree.nodes.len()];
        // Children come after their parents.
        for (index, node) in tree.nodes.iter().enumerate().rev() {
            let (mut weighted, mut moment, mut area) =
                (Vector::<3>::zeros(), Vector::<3>::zeros(), 0.0);
            if node.count > 0 {
                for facet in node.first..node.first + node.count {
                    let [a, b, c] = corners(facet);
                    let normal = 0.5 * (b - a).cross(&(c - a));
                    let size = normal.norm();
                    moment += normal;
                    area += size;
                    weighted += (a + b + c) * (size / 3.0);
                }
            } else {
                for child in [node.first, node.first + 1] {
                    let dipole: &Dipole = &dipoles[child as usize];
                    moment += dipole.moment;
                    area += dipole.area;
                    weighted += dipole.center * dipole.area;
                }
            }
            let center = if area > 0.0 {
                weighted / area
            } else {
                0.5 * (node.min + node.max)
            };
            let reach = (center - node.min).abs().sup(&(node.max - center).abs());
            dipoles[index] = Dipole {
                center,
                moment,
                area,
                radius: reach.norm(),
            };
        }
        Self { dipoles }
    }

    /// The winding number about `p`: one inside of a closed surface, zero outside.
    pub fn number(
        &self,
        tree: &Tree,
        p: &Vector<3>,
        corners: impl Fn(u32) -> [Vector<3>; 3],
    ) -> f64 {
        let mut total = 0.0;
        let mut stack = Vec::with_capacity(64);
        stack.push(0_u32);
        while let Some(index) = stack.pop() {
            let dipole = &self.dipoles[index as usize];
            let offset = dipole.center - p;
            let distance_squared = offset.norm_squared();
            let far = FAR * dipole.radius;
            if distance_squared > far * far {
                total += dipole.moment.dot(&offset) / (distance_squared * distance_squared.sqrt());
                continue;
            }
            let node = &tree.nodes[index as usize];
            if node.count > 0 {
                for facet in node.first..node.first + node.count {
                    total += solid_angle(&corners(facet).map(|v| v - p));
                }
            } else {
                stack.push(node.first + 1);
                stack.push(node.first);
            }
        }
        total / (4.0 * PI)
    }
}
