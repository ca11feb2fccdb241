//! Forces and moments on bodies and walls.

use aero_geometry::Vector;
use nalgebra::Vector3;

use super::FixedSimulation;
use super::viscous::WallShare;
use super::walls::Wall;
use crate::frame::{Load, Totals};
use crate::sides::closed::reflections;
use crate::walls::rigid::pad;
use crate::walls::wall_sides;

impl<const D: usize> FixedSimulation<D> {
    /// Loads on the bodies, in scene order; then on the wall sides in the order of [`crate::wall_sides`]: sums of pressure and friction times
    /// area at the last evaluation.
    ///
    /// What presses walls alike presses the surfaces themselves: cells end a little off them at edges and where other surfaces meet them, which
    /// is nothing beside what pressures differ by but much beside a small drag times the pressure of the stream.
    ///
    /// A body that a symmetry plane cuts is reported whole; of one that runs on through an open side, what lies in the domain.
    pub fn loads(&self) -> Vec<Load> {
        let bodies = &self.problem.bodies;
        let count = bodies.len() + wall_sides(&self.problem.domain).len();
        let calm = self.problem.free_stream.pressure;
        let mut loads: Vec<Load> = (self.uniform().iter())
            .map(|load| Load {
                force: load.force.map(|force| force * calm),
                moment: load.moment.map(|moment| moment * calm),
                ..Load::default()
            })
            .collect();
        let reflections: Vec<_> = (0..count)
            .map(|owner| {
                let extent = bodies.get(owner).map(|body| body.shape.bounds());
                reflections(&self.problem.domain, extent.as_ref())
            })
            .collect();
        let centres: Vec<Vector3<f64>> = (0..count)
            .map(|owner| {
                bodies
                    .get(owner)
                    .map_or_else(Vector3::zeros, |body| pad(&body.moment_centre))
            })
            .collect();
        let is_axisymmetric = self.problem.domain.is_axisymmetric();
        let mut shares = self.wall_shares();
        for (wall, pressure) in self.walls() {
            let owner = wall.owner as usize;
            let mut force = wall.image.area() * ((pressure - calm) * self.around());
            let mut foot = wall.foot;
            let mut friction = Vector::zeros();
            if let Some(share) = shares.next() {
                let size = wall.image.size * self.around();
                friction = Vector::from(share.stress) * -size;
                let images = reflections[owner].len() as f64;
                loads[owner].heat += share.heat * size * images;
                force += friction;
            }
            if is_axisymmetric {
                // What points away from the axis cancels all around.
                (force[1], foot[1], friction[1]) = (0.0, 0.0, 0.0);
            }
            for (sign, shift) in &reflections[owner] {
                let force = pad(&sign.component_mul(&force));
                let arm = pad(&(sign.component_mul(&foot) + shift)) - centres[owner];
                let moment = arm.cross(&force);
                let friction = pad(&sign.component_mul(&friction));
                for k in 0..3 {
                    loads[owner].force[k] += force[k];
                    loads[owner].moment[k] += moment[k];
                    loads[owner].friction[k] += friction[k];
                }
            }
        }
        loads
    }

    /// What the gas received since the start: inflow minus outflow through open sides, and the impulse of walls.
    pub fn inflow(&self) -> Totals {
        self.totals_of(&self.tally.received)
    }

    /// What each wall does to the gas beside its pressure, in the order of [`Self::walls`]; nothing of gas without viscosity.
    pub(super) fn wall_shares(&self) -> impl Iterator<Item = &WallShare<D>> {
        self.columns.shares.iter().flatten()
    }

    /// All walls with the pressure on them.
    pub(super) fn walls(&self) -> impl Iterator<Item = (&Wall<D>, f64)> {
        let blocks = self.net.blocks.iter().zip(&self.columns.pressures);
        blocks.flat_map(|(block, pressures)| block.walls.iter().zip(pressures.iter().copied()))
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use aero_geometry::{Placed, Placement, Shape, bodies};

    use super::*;
    use crate::fixed::tests::flows::stream;

    /// Walls of cells are not quite as large as the surface is where a side cuts it, nor where another body stands on it.
    #[test]
    fn gas_at_rest_presses_bodies_with_no_more_than_its_pressure() {
        let cone: Arc<dyn Shape<3>> = Arc::new(bodies::cone(20.0, 1.2).expect("a cone"));
        let fin = bodies::cuboid([0.4, 0.07, 0.9]).expect("a fin");
        let at = Placement::default().moved(Vector::<3>::new(0.5, 0.0, 0.0));
        let fin: Arc<dyn Shape<3>> = Arc::new(Placed::new(fin, at));
        let problem = stream(
            0.0,
            [[-0.2, -0.6, -0.6], [0.91, 0.6, 0.6]],
            0.1,
            vec![cone, fin],
        );
        let calm = problem.free_stream.pressure;
        let mut flow = FixedSimulation::new(problem).expect("a flow");
        flow.step(1.0).expect("a step");
        for (load, uniform) in flow.loads().iter().zip(flow.uniform_loads()) {
            for k in 0..3 {
                let off = load.force[k] - calm * uniform.force[k];
                assert!(off.abs() < 1e-12, "{load:?} {uniform:?}");
                let off = load.moment[k] - calm * uniform.moment[k];
                assert!(off.abs() < 1e-12, "{load:?} {uniform:?}");
            }
        }
        let walls: Vector<3> = (flow.walls().filter(|(wall, _)| wall.owner == 0))
            .map(|(wall, _)| wall.image.area())
            .sum();
        let cone = flow.uniform_loads()[0].force[0];
        assert!((walls[0] / cone - 1.0).abs() > 3e-4, "{walls:?} {cone}");
    }
}
