//! What a pressure of one everywhere would press the bodies with: nothing where they are closed. Gauge forces are the forces less the
//! free stream's pressure times this.

use nalgebra::Vector3;

use super::{Panels, is_shown};
use crate::frame::Load;
use crate::problem::Problem;
use crate::rings::Rings;
use crate::sides::closed::reflections;
use crate::walls::rigid::pad;
use crate::walls::wall_sides;

impl<const D: usize> Panels<D> {
    /// Loads of a pressure of one on what the domain of `problem` holds of its bodies, then of its wall sides, at time zero; whole
    /// where a symmetry plane cuts them.
    pub fn uniform_loads(&self, problem: &Problem<D>) -> Vec<Load> {
        let bodies = &problem.bodies;
        let count = bodies.len() + wall_sides(&problem.domain).len();
        let rings = Rings::new(problem);
        let mut loads = vec![Load::default(); count];
        let places: Vec<_> = (0..count)
            .map(|owner| {
                let body = bodies.get(owner);
                let extent = body.map(|body| body.shape.bounds());
                let centre = body.map_or_else(Vector3::zeros, |body| pad(&body.moment_centre));
                (reflections(&problem.domain, extent.as_ref()), centre)
            })
            .collect();
        let shown = self
            .all
            .iter()
            .filter(|panel| is_shown(&problem.domain, &panel.centre));
        for panel in shown {
            let around = rings.surface(&panel.centre);
            let (reflections, centre) = &places[panel.owner as usize];
            let load = &mut loads[panel.owner as usize];
            for (sign, shift) in reflections {
                let force = sign.component_mul(&panel.normal) * (-panel.size * around);
                let force = pad(&rings.axial(force));
                let arm = rings.axial(sign.component_mul(&panel.centre) + shift);
                let moment = (pad(&arm) - centre).cross(&force);
                for k in 0..3 {
                    load.force[k] += force[k];
                    load.moment[k] += moment[k];
                }
            }
        }
        loads
    }
}
