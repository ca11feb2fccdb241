//! Outlets of particles that hold a pressure, see [`super::held`].

use aero_geometry::Vector;
use aero_geometry::parallel::prelude::*;

use super::come_back::come_back;
use super::held::Held;
use super::incoming::Incoming;
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

    /// Gas comes back in from rest at the pressure, as through a face of points, and along the side as the free stream goes.
    fn come_back(
        &self,
        problem: &Problem<D>,
        gone: &[OpenParticle<D>],
        places: &[Vector<D>],
        now: f64,
    ) -> Vec<Option<State<D>>> {
        come_back(problem, |place| self.at(place, now), gone, places)
    }

    /// The wave on its way out goes through the particles, `dR+/dt = -c (du/dn + dp/dn / (rho c) + div_t v)`, which is `dR+/dn` of gas of one entropy, with what the flow along the side takes off it [after
    /// Yoo & Im 2007, Combust. Theory Model. 11, 259-286]; entropy and the velocity along the side ride with them. The wave that comes in is
    /// the same all along their way: who leaves takes on that of those who left there before, and who comes back that of all who do about it, which
    /// left at other times and from other places.
    fn go_on(
        &self,
        problem: &Problem<D>,
        fluid: &[Particle<D>],
        gone: &mut [OpenParticle<D>],
        older: &[OpenParticle<D>],
        [before, now]: [f64; 2],
    ) {
        let Held { place, gamma, .. } = self.held;
        let (axis, outward, step) = (place.axis, -place.inward(), now - before);
        let along = |particle: &Particle<D>| Along {
            density: particle.density,
            speed: outward * particle.velocity[axis],
            pressure: problem.gas.pressure(particle.density, particle.energy),
        };
        let rings = Rings::new(problem);
        let mut upstream = Upstream::new(place, problem.resolution.lattice());
        let reach = upstream.reach();
        let near = fluid
            .iter()
            .filter(|particle| -place.depth(&particle.position) < reach);
        let all = near.chain(gone.iter().map(|open| &open.particle));
        for particle in all {
            upstream.add(particle.position, along(particle).speed_and_rise(gamma));
        }
        upstream.sort();
        let mut known = Upstream::new(place, problem.resolution.lattice());
        let is_drawn_in = |open: &&OpenParticle<D>| along(&open.particle).speed < 0.0;
        for open in older.iter().chain(gone.iter().filter(is_drawn_in)) {
            let Incoming { back, entropy, .. } = self.held.own(&along(&open.particle));
            known.add(open.particle.position, [back, entropy]);
        }
        known.sort();
        gone.par_iter_mut().for_each(|open| {
            let particle = &mut open.particle;
            let gas = along(particle);
            let held = self.at(&particle.position, now);
            let waves = gas.waves(gamma);
            let own = gas.speed_and_rise(gamma);
            let sound = gas.sound(gamma);
            let [faster, risen] = upstream.before(&particle.position, own, sound * step);
            // Gas of another entropy at the same pressure sends no sound.
            let more = faster - own[0] + (waves.ahead - gas.speed) * (risen / own[1] - 1.0);
            // Rings grow, whichever way they leave.
            let parting = parting(axis, &open.gradients) + rings.growth(particle);
            if gas.speed >= sound {
                // A pressure that it cannot pass sends a shock in.
                if let Some(behind) = held.shocked(&gas) {
                    set(particle, &behind, gamma, outward * behind.speed, axis);
                }
                return;
            }
            let ahead = waves.ahead + more - step * sound * parting;
            let Some(gas) = (Waves { ahead, ..waves }).state(gamma) else {
                return;
            };
            // Those who have left keep the wave that they have.
            let there = known.mean(&particle.position);
            let there = there.filter(|_| !older.is_empty() || own[0] < 0.0);
            let handed_down = there.map_or(held.own(&gas), |[back, entropy]| Incoming {
                back,
                entropy,
                parting: 0.0,
            });
            let back = held.later(&handed_down, &gas, 0.0, step).back;
            let Some(next) = (Waves {
                ahead,
                back,
                ..waves
            })
            .state(gamma) else {
                return;
            };
            set(particle, &next, gamma, outward * next.speed, axis);
        });
    }
}

/// Brings a particle into the state `gas`, its `speed` along `axis`.
fn set<const D: usize>(
    particle: &mut Particle<D>,
    gas: &Along,
    gamma: f64,
    speed: f64,
    axis: usize,
) {
    particle.smoothing_length *= (particle.density / gas.density).powf(1.0 / D as f64);
    particle.density = gas.density;
    particle.energy = gas.pressure / ((gamma - 1.0) * gas.density);
    particle.velocity[axis] = speed;
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

    fn gas(particle: &Particle<2>) -> Along {
        Along {
            density: particle.density,
            speed: particle.velocity[0],
            pressure: (GAMMA - 1.0) * particle.density * particle.energy,
        }
    }

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
        let before = gas(&particle);
        let held = Held::new(&problem, place(), 1.0, Some(0.25));
        HeldOutlet::new(held, None).go_on(&problem, &[], &mut gone, &[], [0.0, 0.01]);
        let after = gas(&gone[0].particle).waves(GAMMA).ahead;
        let change = (after - before.waves(GAMMA).ahead) / 0.01;
        assert_relative_eq!(change, -0.3 * before.sound(GAMMA), epsilon = 1e-12);
    }

    fn place() -> Place {
        Place {
            axis: 0,
            end: 1,
            face: 1.0,
            part: None,
        }
    }

    /// A shock runs into gas that left faster than sound, from a pressure that it cannot pass; any other lets it go.
    #[test]
    fn gas_that_left_faster_than_sound_meets_the_shock_of_a_pressure_it_cannot_pass() {
        let problem = cube::<2>(8, Side::Outlet);
        let mut particle = crate::Simulation::new(problem.clone()).unwrap().fluid[0];
        let inside = problem.gas.pressure(particle.density, particle.energy);
        let sound = (GAMMA * inside / particle.density).sqrt();
        particle.velocity = [1.2 * sound, 0.1].into();
        // Behind a normal shock at Mach 1.2: 1.513 (NACA 1135, 1953, eq. 93).
        for (rise, is_slower) in [(1.5, false), (1.6, true)] {
            let held = Held::new(&problem, place(), rise * inside, Some(0.25));
            let mut gone = [OpenParticle::of_lattice(particle, 1, None)];
            HeldOutlet::new(held, None).go_on(&problem, &[], &mut gone, &[], [0.0, 0.01]);
            let after = &gone[0].particle;
            let pressure = problem.gas.pressure(after.density, after.energy);
            let expected = if is_slower { rise } else { 1.0 };
            assert_relative_eq!(pressure, expected * inside, max_relative = 1e-12);
            assert_eq!(after.velocity[0] < particle.velocity[0], is_slower);
        }
    }

    /// Light gas behind dense gas at one pressure and speed goes out without a sound.
    #[test]
    fn gas_of_another_entropy_changes_no_wave_on_its_way_out() {
        let problem = cube::<2>(8, Side::Outlet);
        let fluid = crate::Simulation::new(problem.clone()).unwrap().fluid;
        let mut particle = fluid[0];
        particle.velocity = [0.4, 0.0].into();
        let pressure = (GAMMA - 1.0) * particle.density * particle.energy;
        let outlet = HeldOutlet::new(Held::new(&problem, place(), pressure, Some(0.25)), None);
        let behind = [0.85, 0.95].map(|x| {
            let mut other = particle;
            other.position = [x, 0.4].into();
            other.density = 0.25 * particle.density;
            other.energy = 4.0 * particle.energy;
            other
        });
        particle.position = [1.02, 0.4].into();
        let mut gone = [OpenParticle::of_lattice(particle, 1, None)];
        outlet.go_on(&problem, &behind, &mut gone, &[], [0.0, 0.01]);
        let left = &gone[0].particle;
        assert_relative_eq!(left.velocity[0], 0.4, epsilon = 1e-12);
        assert_relative_eq!(left.density, particle.density, epsilon = 1e-12);
        assert_relative_eq!(left.energy, particle.energy, epsilon = 1e-12);
    }

    /// Gas of one entropy whose pressure rises out of the domain: `dR+/dt = -c dR+/dn`.
    #[test]
    fn a_sound_on_its_way_out_goes_on_through_gas_that_left() {
        const RISE: f64 = 0.3;
        let problem = cube::<2>(8, Side::Outlet);
        let mut particle = crate::Simulation::new(problem.clone()).unwrap().fluid[0];
        particle.position = [1.02, 0.4].into();
        particle.velocity = [0.4, 0.0].into();
        let behind = [0.85, 0.95].map(|x| {
            let mut other = particle;
            other.position = [x, 0.4].into();
            // Of the speed of sound.
            let part = 1.0 + RISE * (x - 1.02);
            other.energy *= part * part;
            other.density *= part.powf(2.0 / (GAMMA - 1.0));
            other
        });
        let before = gas(&particle);
        let outlet = HeldOutlet::new(Held::new(&problem, place(), 1.0, Some(0.25)), None);
        let mut gone = [OpenParticle::of_lattice(particle, 1, None)];
        outlet.go_on(&problem, &behind, &mut gone, &[], [0.0, 0.01]);
        let after = gas(&gone[0].particle).waves(GAMMA).ahead;
        let sound = before.sound(GAMMA);
        let expected = -sound * 2.0 / (GAMMA - 1.0) * sound * RISE;
        let change = (after - before.waves(GAMMA).ahead) / 0.01;
        assert_relative_eq!(change, expected, max_relative = 1e-9);
    }

    /// Particles that come back left at other times, each with the wave of then; those on their way out keep theirs.
    #[test]
    fn those_who_come_back_take_on_each_others_wave() {
        let problem = cube::<2>(8, Side::Outlet);
        let particle = crate::Simulation::new(problem.clone()).unwrap().fluid[0];
        let pressure = (GAMMA - 1.0) * particle.density * particle.energy;
        let outlet = HeldOutlet::new(Held::new(&problem, place(), pressure, Some(0.25)), None);
        let apart = |speed: f64| {
            let mut gone = [(0.4, 0.0), (0.45, 0.1)].map(|(y, more)| {
                let mut other = particle;
                other.position = [1.05, y].into();
                other.velocity[0] = speed + more;
                OpenParticle::of_lattice(other, 1, None)
            });
            outlet.go_on(&problem, &[], &mut gone, &[], [0.0, 1e-9]);
            let [one, other] = gone.map(|open| outlet.held.own(&gas(&open.particle)).back);
            other - one
        };
        assert_relative_eq!(apart(0.2), 0.1, epsilon = 1e-6);
        assert!(apart(-0.4) < 0.05, "{}", apart(-0.4));
    }

    /// Who leaves brings another speed at the pressure that is held; what comes in is what came in there before, and goes on from that.
    #[test]
    fn who_leaves_takes_on_the_wave_of_those_who_left_before() {
        let problem = cube::<2>(8, Side::Outlet);
        let mut particle = crate::Simulation::new(problem.clone()).unwrap().fluid[0];
        let pressure = (GAMMA - 1.0) * particle.density * particle.energy;
        let outlet = HeldOutlet::new(Held::new(&problem, place(), pressure, Some(0.25)), None);
        let back = |particle: &Particle<2>| outlet.held.own(&gas(particle)).back;
        particle.position = [1.02, 0.4].into();
        particle.velocity = [0.5, 0.0].into();
        let older = [0.35, 0.45].map(|y| {
            let mut other = particle;
            other.position = [1.08, y].into();
            OpenParticle::of_lattice(other, 1, None)
        });
        let expected = back(&particle);
        particle.velocity[0] = 0.6;
        let leave = |older: &[OpenParticle<2>], step: f64| {
            let mut gone = [OpenParticle::of_lattice(particle, 1, None)];
            outlet.go_on(&problem, &[], &mut gone, older, [0.0, step]);
            gone[0].particle
        };
        let left = leave(&older, 1e-9);
        assert_relative_eq!(back(&left), expected, epsilon = 1e-8);
        assert!(left.velocity[0] < 0.56 && left.velocity[0] > 0.54);
        assert_relative_eq!(back(&leave(&[], 1e-9)), expected + 0.1, epsilon = 1e-8);
        // Its pressure is above the one held by then, and what comes in draws it out.
        assert!(back(&leave(&older, 0.1)) > expected + 1e-4);
    }
}
