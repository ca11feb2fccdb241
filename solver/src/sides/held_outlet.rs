//! Outlets of particles that hold a pressure, see [`super::held`].

use aero_geometry::Vector;

use super::held::Held;
use super::model::OpenModel;
use super::particle::OpenParticle;
use super::upstream::Upstream;
use super::waves::{Along, Waves};
use crate::diffusive::Gradients;
use crate::particles::Particle;
use crate::problem::{Given, Problem, State};
use crate::rings::Rings;

/// The outlet of particles.
#[derive(Clone, Debug)]
pub struct HeldOutlet<const D: usize> {
    held: Held,
    /// The pressure, where it is not the same everywhere and at all times.
    given: Option<Given<D>>,
}

impl<const D: usize> HeldOutlet<D> {
    /// One like `held`, whose pressure may be `given`.
    pub fn new(held: Held, given: Option<&Given<D>>) -> Self {
        Self {
            held,
            given: given.cloned(),
        }
    }

    /// That of a place and time.
    fn at(&self, position: &Vector<D>, time: f64) -> Held {
        let given = self.given.as_ref();
        given.map_or(self.held, |given| {
            self.held.at(given.at(position, time).pressure)
        })
    }
}

impl<const D: usize> OpenModel<D> for HeldOutlet<D> {
    fn inflow(&self, _problem: &Problem<D>) -> Option<State<D>> {
        None
    }

    fn goes_on(&self) -> bool {
        true
    }

    /// The wave on its way out goes through the particles, `dR+/dt = -c dR+/dn`; entropy and the velocity along the side ride
    /// with them.
    fn go_on(
        &self,
        problem: &Problem<D>,
        fluid: &[Particle<D>],
        gone: &mut [OpenParticle<D>],
        [before, now]: [f64; 2],
    ) {
        let Held { place, gamma, .. } = self.held;
        let (axis, outward, step) = (place.axis, -place.inward(), now - before);
        let along = |particle: &Particle<D>| Along {
            density: particle.density,
            speed: outward * particle.velocity[axis],
            pressure: problem.gas.pressure(particle.density, particle.energy),
        };
        let waves = |particle: &Particle<D>| {
            let Waves { ahead, back, .. } = along(particle).waves(gamma);
            [ahead, back]
        };
        let rings = Rings::new(problem);
        let mut upstream = Upstream::new(place, problem.spacing);
        let reach = upstream.reach();
        let near = fluid
            .iter()
            .filter(|particle| -place.depth(&particle.position) < reach);
        let all = near.chain(gone.iter().map(|open| &open.particle));
        for particle in all {
            upstream.add(particle.position, waves(particle));
        }
        upstream.sort();
        for open in gone {
            let particle = &mut open.particle;
            let gas = along(particle);
            let held = self.at(&particle.position, now);
            let waves = gas.waves(gamma);
            let slopes = upstream.slopes(&particle.position, [waves.ahead, waves.back]);
            // Rings grow, whichever way they leave.
            let parting = parting(axis, &open.gradients) + rings.growth(particle);
            let parting = gas.sound(gamma) * parting;
            let next = held
                .ridden(&gas, step, slopes[1], -parting)
                .and_then(|back| {
                    let ahead = waves.ahead - step * (gas.sound(gamma) * slopes[0] + parting);
                    let next = Waves {
                        ahead,
                        back,
                        ..waves
                    };
                    next.state(gamma)
                });
            let Some(next) = next else {
                continue;
            };
            let wider = (particle.density / next.density).powf(1.0 / D as f64);
            particle.smoothing_length *= wider;
            particle.density = next.density;
            particle.energy = next.pressure / ((gamma - 1.0) * next.density);
            particle.velocity[axis] = outward * next.speed;
        }
    }
}

/// How fast gas parts across `axis` by its gradients.
fn parting<const D: usize>(axis: usize, gradients: &Gradients<D>) -> f64 {
    gradients.velocity.trace() - gradients.velocity[(axis, axis)]
}

#[cfg(test)]
mod tests {
    use super::super::model::Place;
    use super::*;
    use crate::problem::Side;
    use crate::tests::cube;
    use approx::assert_relative_eq;

    const GAMMA: f64 = 1.4;

    #[test]
    fn gas_parts_across_the_side_alone() {
        let mut gradients = Gradients::<3>::zeros();
        gradients.velocity[(0, 0)] = -3.0;
        gradients.velocity[(1, 1)] = 2.0;
        gradients.velocity[(2, 2)] = 0.5;
        gradients.velocity[(0, 1)] = 7.0;
        let parts = [0, 1, 2].map(|axis| parting(axis, &gradients));
        assert_eq!(parts, [2.5, -2.5, -1.0]);
    }

    /// Gas that left and goes on parting at a rate `a`: the wave on its way out falls by `c a` per time, `dR+/dt = -c div_t v`.
    #[test]
    fn gas_that_left_and_parts_slows_the_wave_that_it_sends_out() {
        let problem = cube::<2>(8, Side::Outlet);
        let mut particle = crate::Simulation::new(problem.clone()).unwrap().fluid[0];
        particle.velocity = [0.5, 0.1].into();
        let mut gone = [OpenParticle::of_lattice(particle, 1, None)];
        gone[0].gradients.velocity[(1, 1)] = 0.3;
        let gas = |particle: &Particle<2>| Along {
            density: particle.density,
            speed: particle.velocity[0],
            pressure: (GAMMA - 1.0) * particle.density * particle.energy,
        };
        let before = gas(&particle);
        let place = Place {
            axis: 0,
            end: 1,
            face: 1.0,
            part: None,
        };
        let held = Held::new(&problem, place, 1.0, Some(0.25));
        HeldOutlet::new(held, None).go_on(&problem, &[], &mut gone, [0.0, 0.01]);
        let after = gas(&gone[0].particle).waves(GAMMA).ahead;
        let change = (after - before.waves(GAMMA).ahead) / 0.01;
        assert_relative_eq!(change, -0.3 * before.sound(GAMMA), epsilon = 1e-12);
    }
}
