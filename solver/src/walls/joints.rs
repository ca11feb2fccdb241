//! Where solids meet: a body on a wall side, bodies that touch or overlap. Together they are one solid, and a ghost belongs to the
//! nearest surface of that: the faces with which they meet are no walls. What two of them fill counts once.
//!
//! Bodies that move are left as they are: what meets now parts later.

use aero_geometry::{Bounds, Pencils, Vector};

use super::Ghost;
use super::curvature::shape_operator;
use crate::layers::GHOSTS;
use crate::panels::Panels;
use crate::problem::{Body, Problem, Side};
use crate::records::Matrix;

/// A foot this close to another solid, in spacings, is on no wall: no gas fits between.
const TOUCHING: f64 = 0.25;

/// Mirror images at no more than this part of the depth off the surface are in the gas.
const MIRRORED: f64 = 0.1;

/// Makes one solid of what meets. `ghosts` are those of the bodies in scene order, then those of the wall sides.
pub fn join<const D: usize>(problem: &Problem<D>, ghosts: &mut [Ghost<D>]) {
    let solids = Solids::new(problem);
    if !solids.may_meet() {
        return;
    }
    for ghost in ghosts.iter_mut() {
        ghost.volume *= solids.share(ghost);
        ghost.reference_mass = ghost.density * ghost.volume;
    }
    let tolerance = TOUCHING * problem.spacing;
    let hidden: Vec<usize> = (0..ghosts.len())
        .filter(|&g| {
            let ghost = &ghosts[g];
            solids.is_hidden(&ghost.foot(), &ghost.normal, ghost.body, tolerance)
        })
        .collect();
    if hidden.is_empty() {
        return;
    }
    let surface = Surface::new(&solids);
    for g in hidden {
        let ghost = &mut ghosts[g];
        let Some((foot, owner)) = surface.nearest(&ghost.position) else {
            // No gas ever sees it.
            ghost.volume = 0.0;
            ghost.reference_mass = 0.0;
            continue;
        };
        let arm = foot - ghost.position;
        let Some(normal) = arm.try_normalize(1e-9 * problem.spacing) else {
            continue;
        };
        ghost.normal = normal;
        ghost.origin_normal = normal;
        ghost.depth = arm.norm();
        ghost.layer = (ghost.depth / problem.spacing) as u32;
        let reached = solids.distance(&ghost.mirror());
        ghost.has_mirror = (reached - ghost.depth).abs() < MIRRORED * ghost.depth;
        ghost.origin_curvature = Matrix::zeros();
        if let Some(body) = problem.bodies.get(owner as usize)
            && problem.scheme.wall.follows_the_bend
            && ghost.has_mirror
        {
            let above = foot + normal * (0.1 * problem.spacing);
            ghost.origin_curvature = shape_operator(&body.shape, &above, problem.spacing);
        }
    }
}

/// All that is solid and stays where it is: bodies, and what lies beyond wall sides.
struct Solids<'a, const D: usize> {
    problem: &'a Problem<D>,
    /// Number of each body with a box around it.
    bodies: Vec<(u32, &'a Body<D>, Bounds<D>)>,
}

impl<'a, const D: usize> Solids<'a, D> {
    fn new(problem: &'a Problem<D>) -> Self {
        let reach = 2.0 * problem.spacing;
        let still = problem.bodies.iter().enumerate();
        let still = still.filter(|(_, body)| !body.motion.is_moving());
        let boxed = still.map(|(n, body)| (n as u32, body, body.shape.bounds().grown(reach)));
        Self {
            problem,
            bodies: boxed.collect(),
        }
    }

    /// False where no two of them come near to each other.
    fn may_meet(&self) -> bool {
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
    fn distance(&self, point: &Vector<D>) -> f64 {
        let walls = -self.beyond_walls(point);
        let bodies = self.bodies.iter().map(|(_, body, _)| body);
        let bodies = bodies.map(|body| body.shape.signed_distance(point));
        bodies.fold(walls, f64::min)
    }

    /// True of a point on the surface of `owner`, with `normal`, that lies in another solid or faces one that touches it, or that is
    /// beyond a plane that cuts its own.
    fn is_hidden(&self, foot: &Vector<D>, normal: &Vector<D>, owner: u32, tolerance: f64) -> bool {
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

    /// What of a ghost no earlier solid fills: a cell cut by their surfaces.
    fn share(&self, ghost: &Ghost<D>) -> f64 {
        let size = self.problem.spacing;
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

/// What of the solids' surfaces gas is in front of.
struct Surface<'a, const D: usize> {
    solids: &'a Solids<'a, D>,
    panels: Panels<D>,
    exposed: Vec<u32>,
    grid: Pencils<D>,
    reach: f64,
}

impl<'a, const D: usize> Surface<'a, D> {
    fn new(solids: &'a Solids<'a, D>) -> Self {
        let panels = Panels::new(solids.problem);
        let tolerance = TOUCHING * solids.problem.spacing;
        let exposed: Vec<u32> = panels
            .all()
            .iter()
            .zip(0..)
            .filter(|(panel, _)| {
                !solids.is_hidden(&panel.centre, &panel.normal, panel.owner, tolerance)
            })
            .map(|(_, number)| number)
            .collect();
        let places: Vec<_> = exposed
            .iter()
            .map(|&n| panels.all()[n as usize].centre)
            .collect();
        let reach = (GHOSTS as f64 + 2.0) * solids.problem.spacing;
        Self {
            grid: Pencils::new(&places, reach),
            solids,
            panels,
            exposed,
            reach,
        }
    }

    /// The nearest point that gas is in front of, and whose it is; none within the reach of ghosts.
    fn nearest(&self, point: &Vector<D>) -> Option<(Vector<D>, u32)> {
        let mut best: Option<(f64, Vector<D>, u32)> = None;
        self.grid
            .for_each_run_near(point, point, self.reach, |run| {
                for &n in &self.grid.order()[run] {
                    let panel = &self.panels.all()[self.exposed[n as usize] as usize];
                    let on = panel.closest(point);
                    let apart = (on - point).norm_squared();
                    if best.is_none_or(|(least, ..)| apart < least) {
                        best = Some((apart, on, panel.owner));
                    }
                }
            });
        let (_, on, owner) = best?;
        // Panels are chords: the foot lies on the surface itself, unless that goes on behind another solid there.
        let tolerance = TOUCHING * self.solids.problem.spacing;
        let body = self.solids.problem.bodies.get(owner as usize);
        let seen = body.map(|body| body.shape.closest(&on));
        let exact = seen.filter(|seen| {
            let (foot, normal) = (&seen.point, &seen.normal);
            !self.solids.is_hidden(foot, normal, owner, tolerance)
        });
        Some((exact.map_or(on, |seen| seen.point), owner))
    }
}
