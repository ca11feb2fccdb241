//! Loads of what panels are pressed with.

use aero_geometry::Vector;
use nalgebra::Vector3;

use super::{Panels, Pressed, is_shown, owner_count};
use crate::frame::Load;
use crate::problem::Problem;
use crate::rings::Rings;
use crate::sides::closed::reflections;
use crate::walls::rigid::{Pose, pad};

impl<const D: usize> Panels<D> {
    /// Loads on what the domain of `problem` holds of its bodies, then of its wall sides, which are as `pose` says, of what their panels
    /// are `pressed` with; whole where a symmetry plane cuts them, and without what stands on another solid. Of what viscosity and heat do nothing is told apart.
    pub fn loads(
        &self,
        problem: &Problem<D>,
        pressed: &[Pressed<D>],
        pose: impl Fn(usize) -> Pose<D>,
    ) -> Vec<Load> {
        self.sums(problem, pose, |number, normal| {
            pressed[number].friction - normal * pressed[number].pressure
        })
    }

    /// The same of a pressure of one everywhere, at time zero: nothing where bodies are closed, and stand on nothing. Gauge forces are the
    /// forces less the free stream's pressure times this.
    pub fn uniform_loads(&self, problem: &Problem<D>) -> Vec<Load> {
        self.sums(problem, |_| Pose::at_rest(), |_, normal| -normal)
    }

    /// Sums of a traction, which is given for the number of a panel and its normal.
    fn sums(
        &self,
        problem: &Problem<D>,
        pose: impl Fn(usize) -> Pose<D>,
        traction: impl Fn(usize, &Vector<D>) -> Vector<D>,
    ) -> Vec<Load> {
        let rings = Rings::new(problem);
        let count = owner_count(problem);
        let places: Vec<_> = (0..count)
            .map(|owner| Place::new(problem, owner, pose(owner)))
            .collect();
        let mut loads = vec![Load::default(); count];
        for (number, panel) in self.all.iter().enumerate() {
            let place = &places[panel.owner as usize];
            let centre = place.pose.position(&panel.centre);
            if !panel.is_covered && is_shown(&problem.domain, &centre) {
                let normal = place.pose.direction(&panel.normal);
                let size = panel.size * rings.surface(&centre);
                let force = traction(number, &normal) * size;
                place.add(&rings, (&centre, &force), &mut loads[panel.owner as usize]);
            }
        }
        loads
    }
}

/// Where an owner of panels is, and what of it there is beside what the domain holds.
struct Place<const D: usize> {
    pose: Pose<D>,
    centre: Vector3<f64>,
    /// Signs and shifts of what symmetry planes make of it.
    reflections: Vec<(Vector<D>, Vector<D>)>,
}

impl<const D: usize> Place<D> {
    fn new(problem: &Problem<D>, owner: usize, pose: Pose<D>) -> Self {
        let body = problem.bodies.get(owner);
        let extent = body.map(|body| body.shape.bounds());
        let centre = body.map(|body| pad(&pose.position(&body.moment_centre)));
        Self {
            pose,
            centre: centre.unwrap_or_else(Vector3::zeros),
            reflections: reflections(&problem.domain, extent.as_ref()),
        }
    }

    /// Adds a force at a place to the `load`.
    fn add(&self, rings: &Rings, (at, force): (&Vector<D>, &Vector<D>), load: &mut Load) {
        for (sign, shift) in &self.reflections {
            let force = pad(&rings.axial(sign.component_mul(force)));
            let arm = rings.axial(sign.component_mul(at) + shift);
            let moment = (pad(&arm) - self.centre).cross(&force);
            for k in 0..3 {
                load.force[k] += force[k];
                load.moment[k] += moment[k];
            }
        }
    }
}
