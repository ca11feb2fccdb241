//! What of the panels gas may be in front of: not the foot of a post on a wall, nor the wall below it.

use aero_geometry::Vector;
use aero_geometry::parallel::prelude::*;

use super::Panel;
use crate::problem::Problem;
use crate::walls::solids::{Solids, TOUCHING};

/// Pieces per edge of a panel, in the plane and in space.
const PIECES: [usize; 2] = [32, 8];

/// Finds the part of each panel that no other solid covers.
pub fn find<const D: usize>(problem: &Problem<D>, panels: &mut [Panel<D>]) {
    let solids = Solids::new(problem);
    if D == 1 || !solids.may_meet() {
        return;
    }
    panels.par_iter_mut().for_each(|panel| {
        let above = panel.normal * (TOUCHING * problem.resolution.at(&panel.centre));
        let all = middles(&panel.corners);
        let free = all
            .iter()
            .filter(|middle| !solids.covers(&(*middle + above), panel.owner));
        panel.exposed = free.count() as f64 / all.len() as f64;
    });
}

/// Middles of the equal pieces of a segment or a triangle.
fn middles<const D: usize>(corners: &[Vector<D>; D]) -> Vec<Vector<D>> {
    let pieces = PIECES[usize::from(D > 2)];
    let step = 1.0 / pieces as f64;
    let u = (corners[1] - corners[0]) * step;
    if D == 2 {
        return (0..pieces)
            .map(|i| corners[0] + u * (i as f64 + 0.5))
            .collect();
    }
    let v = (corners[D - 1] - corners[0]) * step;
    let third = 1.0 / 3.0;
    let mut all = Vec::new();
    for i in 0..pieces {
        for j in 0..pieces - i {
            let at = |a: f64, b: f64| corners[0] + u * (i as f64 + a) + v * (j as f64 + b);
            all.push(at(third, third));
            if i + j + 1 < pieces {
                all.push(at(2.0 * third, 2.0 * third));
            }
        }
    }
    all
}
