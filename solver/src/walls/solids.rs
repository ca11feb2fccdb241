//! All that is solid and stays where it is, as one: what of a surface lies in, or touches, another solid.

use aero_geometry::{Bounds, Vector};

use super::Ghost;
use crate::problem::{Body, Problem, Side};

/// A foot this close to another solid, in spacings, is on no wall: no gas fits between.
pub const TOUCHING: f64 = 0.25;

/// Surfaces this close, in spacings, are one.
const FLUSH: f64 = 1e-6;

/// So far ahead of a surface, in spacings, it is seen whether another begins there.
const NEAR: f64 = 1e-3;

/// Cosine from which on two directions are one.
const ALIKE: f64 = 0.9;

/// All that is solid and stays where it is: bodies, and what lies beyond wall sides.
pub struct Solids<'a, const D: usize> {
    pub problem: &'a Problem<D>,
    /// Number of each body with a box around it.
    bodies: Vec<(u32, &'a Body<D>, Bounds<D>)>,
}

impl<'a, const D: usize> Solids<'a, D> {
    /// Those of `problem`.
    pub fn new(problem: &'a Problem<D>) -> Self {
        let reach = 2.0 * problem.resolution.lattice();
        let still = problem.bodies.iter().enumerate();
        let still = still.filter(|(_, body)| !body.motion.is_moving());
        let boxed = still.map(|(n, body)| (n as u32, body, body.shape.bounds().grown(reach)));
        Self {
            problem,
            bodies: boxed.collect(),
        }
    }

    /// False where no two of them come near to each other.
    pub fn may_meet(&self) -> bool {
        let sides = self.problem.domain.each_side();
        let planes: Vec<_> = sides
            .filter(|(_, _, side, _)| is_still_wall(*side) || side.is_mirror())
            .collect();
        self.bodies.iter().enumerate().any(|(n, (_, _, extent))| {
            let others = &self.bodies[..n];
            others
                .iter()
                .any(|(_, _, other)| !extent.intersection(other).is_empty())
                || planes.iter().any(|(axis, end, _, plane)| {
                    [extent.min[*axis] < *plane, extent.max[*axis] > *plane][*end]
                })
        })
    }

    /// Depth of `point` beyond the walls that stay where they are: the largest; negative within.
    fn beyond_walls(&self, point: &Vector<D>) -> f64 {
        let sides = self.problem.domain.each_side();
        sides
            .filter(|(_, _, side, _)| is_still_wall(*side))
            .map(|(axis, end, _, plane)| [plane - point[axis], point[axis] - plane][end])
            .fold(f64::NEG_INFINITY, f64::max)
    }

    /// True of a point beyond a mirror plane about which `body` is not symmetric: the plane cuts it there, and its image is
    /// another body.
    fn is_beyond_a_cut(&self, body: &Body<D>, point: &Vector<D>, tolerance: f64) -> bool {
        let sides = self.problem.domain.each_side();
        let mirrors = sides.filter(|(_, _, side, _)| side.is_mirror());
        let mut beyond = mirrors.filter(|(axis, end, _, plane)| {
            [plane - point[*axis], point[*axis] - plane][*end] > tolerance
        });
        beyond.any(|(axis, _, _, plane)| {
            let near = |(k, at): &(usize, f64)| *k == axis && (at - plane).abs() < tolerance;
            !body.shape.mirror_planes().iter().any(near)
        })
    }

    /// Distance from the solid of all; negative within.
    pub fn distance(&self, point: &Vector<D>) -> f64 {
        let walls = -self.beyond_walls(point);
        let bodies = self.bodies.iter().map(|(_, body, _)| body);
        let bodies = bodies.map(|body| body.shape.signed_distance(point));
        bodies.fold(walls, f64::min)
    }

    /// True of a point on the surface of `owner`, with `normal`, that lies in another solid or faces one that touches it, or that is
    /// beyond a plane that cuts its own.
    pub fn is_hidden(
        &self,
        foot: &Vector<D>,
        normal: &Vector<D>,
        owner: u32,
        tolerance: f64,
    ) -> bool {
        let own = self.bodies.iter().find(|(number, ..)| *number == owner);
        if own.is_none() && (owner as usize) < self.problem.bodies.len() {
            // It moves.
            return false;
        }
        let is_cut = own.is_some_and(|(_, body, _)| {
            self.beyond_walls(foot) > -tolerance || self.is_beyond_a_cut(body, foot, tolerance)
        });
        is_cut
            || self.bodies.iter().any(|(number, body, extent)| {
                if *number == owner || !extent.contains(foot) {
                    return false;
                }
                let distance = body.shape.signed_distance(foot);
                // Beside a surface that it is flush with, or at right angles to, gas is in front of it.
                let faces = || body.shape.signed_distance(&(foot + normal * tolerance));
                distance < -tolerance
                    || distance < tolerance && faces() < distance - 0.5 * tolerance
            })
    }

    /// True of a point on the surface of `owner`, with `normal`, that no gas is in front of: it lies in another solid, faces one that it touches,
    /// or is flush with one of an earlier body, whose surface it is then. Nothing covers what moves.
    pub fn covers(&self, point: &Vector<D>, normal: &Vector<D>, owner: u32) -> bool {
        let is_wall = owner as usize >= self.problem.bodies.len();
        if !is_wall && self.bodies.iter().all(|(number, ..)| *number != owner) {
            return false;
        }
        let size = self.problem.resolution.at(point);
        let (touching, flush, near) = (TOUCHING * size, FLUSH * size, NEAR * size);
        let covers = |distance: &dyn Fn(&Vector<D>) -> f64, is_earlier: bool| {
            let here = distance(point);
            let nearer = |ahead: f64| (here - distance(&(point + normal * ahead))) / ahead;
            here < -flush
                || here < flush && (nearer(near) > 0.0 || is_earlier && nearer(near) < -ALIKE)
                || here < touching && nearer(touching) > ALIKE
        };
        covers(&|at| -self.beyond_walls(at), false)
            || self.bodies.iter().any(|(number, body, extent)| {
                let is_other = *number != owner && extent.contains(point);
                is_other && covers(&|at| body.shape.signed_distance(at), *number < owner)
            })
    }

    /// What of a ghost no earlier solid fills: a cell cut by their surfaces.
    pub fn share(&self, ghost: &Ghost<D>) -> f64 {
        let size = self.problem.resolution.at(&ghost.position);
        let is_of_wall = ghost.body as usize >= self.problem.bodies.len();
        if is_of_wall || !self.bodies.iter().any(|(number, ..)| *number == ghost.body) {
            return 1.0;
        }
        let earlier = self.bodies.iter().filter(|(n, ..)| *n < ghost.body);
        let near = earlier.filter(|(_, _, extent)| extent.contains(&ghost.position));
        near.map(|(_, body, _)| {
            let distance = body.shape.signed_distance(&ghost.position);
            (0.5 + distance / size).clamp(0.0, 1.0)
        })
        .product()
    }
}

/// True of a plane wall that does not move.
fn is_still_wall(side: Side) -> bool {
    matches!(side, Side::Wall { velocity, acceleration, .. } if velocity == 0.0 && acceleration == 0.0)
}
