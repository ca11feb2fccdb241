//! What comes to the bodies of all that their panels show.

use aero_geometry::Vector;

use crate::frame::PanelFrame;
use crate::problem::Problem;
use crate::rings::Rings;
use crate::sides::closed::reflections;
use crate::walls::rigid::pad;

/// Forces on the bodies of `problem`, in scene order: the integrals over what the domain holds of them of the pressure over the free stream's
/// and the friction that `panels` show, but for what is spread. As with loads, a body that a symmetry plane cuts counts whole.
pub fn shown_forces<const D: usize>(problem: &Problem<D>, panels: &PanelFrame) -> Vec<[f64; 3]> {
    let calm = problem.free_stream.pressure;
    let rings = Rings::new(problem);
    let mut forces = vec![Vector::<D>::zeros(); problem.bodies.len()];
    for (number, &body) in panels.body.iter().enumerate() {
        let Some(force) = forces.get_mut(body as usize) else {
            continue;
        };
        let over = panels.pressure[number] - calm;
        for k in 0..D {
            let stress = panels.friction[number][k] - over * panels.normal[number][k];
            force[k] += stress * panels.area[number];
        }
    }
    for (force, spread) in forces.iter_mut().zip(&panels.spread) {
        for k in 0..D {
            force[k] -= spread[k];
        }
    }
    let each = forces.iter().zip(&problem.bodies).map(|(force, body)| {
        let force = rings.axial(*force);
        let images = reflections(&problem.domain, Some(&body.shape.bounds()));
        let whole: Vector<D> = (images.iter())
            .map(|(sign, _)| sign.component_mul(&force))
            .sum();
        pad(&whole).into()
    });
    each.collect()
}
