//! Where solids meet: a body on a wall side, bodies that touch or overlap. Together they are one solid, and a ghost belongs to the
//! nearest surface of that: the faces with which they meet are no walls. What two of them fill counts once.
//!
//! Bodies that move are left as they are: what meets now parts later.

use aero_geometry::{Pencils, Vector};

use super::Ghost;
use super::curvature::shape_operator;
use super::solids::{Solids, TOUCHING};
use crate::layers::GHOSTS;
use crate::panels::Panels;
use crate::problem::Problem;
use crate::records::Matrix;

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
        ghost.reference_mass = ghost.shown.density * ghost.volume;
    }
    let tolerance = TOUCHING * problem.resolution.finest();
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
        let Some(normal) = arm.try_normalize(1e-9 * problem.resolution.at(&ghost.position)) else {
            continue;
        };
        ghost.normal = normal;
        ghost.origin.normal = normal;
        ghost.depth = arm.norm();
        ghost.layer = (ghost.depth / problem.resolution.at(&ghost.position)) as u32;
        let reached = solids.distance(&ghost.mirror());
        ghost.has_mirror = (reached - ghost.depth).abs() < MIRRORED * ghost.depth;
        ghost.origin.curvature = Matrix::zeros();
        if let Some(body) = problem.bodies.get(owner as usize)
            && problem.scheme.wall.follows_the_bend
            && ghost.has_mirror
        {
            let above = foot + normal * (0.1 * problem.resolution.at(&foot));
            ghost.origin.curvature =
                shape_operator(&body.shape, &above, problem.resolution.at(&foot));
        }
    }
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
        let tolerance = TOUCHING * solids.problem.resolution.finest();
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
        let reach = (GHOSTS as f64 + 2.0) * solids.problem.resolution.lattice();
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
        let tolerance = TOUCHING * self.solids.problem.resolution.at(&on);
        let body = self.solids.problem.bodies.get(owner as usize);
        let seen = body.map(|body| body.shape.closest(&on));
        let exact = seen.filter(|seen| {
            let (foot, normal) = (&seen.point, &seen.normal);
            !self.solids.is_hidden(foot, normal, owner, tolerance)
        });
        Some((exact.map_or(on, |seen| seen.point), owner))
    }
}
