//! What comes back in through outlets of particles that hold a pressure, see [`super::held`].
//!
//! Gas that left and comes back leaves nothing behind it in the buffer. Were nothing to fill that, the flow would end in a void and run out into it: a jet
//! that draws gas in from its sides would empty the domain.

use aero_geometry::Vector;

use super::held::Held;
use super::particle::OpenParticle;
use super::upstream::Upstream;
use super::waves::Along;
use crate::problem::{Problem, State};

/// So near to a particle, in spacings, no other one comes back in.
const CLOSE: f64 = 0.85;

/// The state in which gas comes back in at each of the `places` at the outer end of a buffer, where it does and nothing is there yet: from rest at the
/// pressure that the outlet `held_at` the place has, against the wave on its way out that the gas `gone` about it has, and along the side as the free
/// stream goes.
pub fn come_back<const D: usize>(
    problem: &Problem<D>,
    held_at: impl Fn(&Vector<D>) -> Held,
    gone: &[OpenParticle<D>],
    places: &[Vector<D>],
) -> Vec<Option<State<D>>> {
    let Some(first) = places.first() else {
        return Vec::new();
    };
    let Held { place, gamma, .. } = held_at(first);
    let outward = -place.inward();
    let spacing = problem.resolution.lattice();
    let mut there = Upstream::new(place, spacing);
    for OpenParticle { particle, .. } in gone {
        let gas = Along {
            density: particle.density,
            speed: outward * particle.velocity[place.axis],
            pressure: problem.gas.pressure(particle.density, particle.energy),
        };
        there.add(particle.position, [gas.speed, gas.waves(gamma).ahead]);
    }
    there.sort();
    let close = CLOSE * spacing / there.reach();
    let state = |position: &Vector<D>| {
        let [speed, ahead] = there.mean(position)?;
        if speed >= 0.0 || there.nearest(position)? < close {
            return None;
        }
        let gas = held_at(position).returning(ahead);
        let mut velocity = problem.free_stream.velocity;
        velocity[place.axis] = outward * gas.speed;
        Some(State {
            density: gas.density,
            velocity,
            pressure: gas.pressure,
        })
    };
    places.iter().map(state).collect()
}

#[cfg(test)]
mod tests {
    use super::super::model::Place;
    use super::*;
    use crate::problem::Side;
    use crate::tests::cube;
    use approx::assert_relative_eq;

    const GAMMA: f64 = 1.4;

    /// Gas that left and comes back makes room behind it, which gas from rest at the pressure fills; what goes on out makes none.
    #[test]
    fn gas_comes_back_in_behind_gas_that_does() {
        let mut problem = cube::<2>(8, Side::Outlet);
        problem.free_stream.velocity = [0.0, 0.1].into();
        let dx = problem.resolution.lattice();
        let particle = crate::Simulation::new(problem.clone()).unwrap().fluid[0];
        let pressure = problem.free_stream.pressure;
        let place = Place {
            axis: 0,
            end: 1,
            face: 1.0,
            part: None,
        };
        let held = Held::new(&problem, place, pressure, Some(0.25));
        let places = [0.0, 0.5 * dx].map(|x| Vector::from([1.0 + 5.5 * dx + x, 0.4]));
        let states = |speed: f64| {
            let mut gone = particle;
            gone.position = [1.0 + 5.0 * dx, 0.4].into();
            gone.velocity = [speed, 0.3].into();
            let gone = [OpenParticle::of_lattice(gone, 1, None)];
            come_back(&problem, |_| held, &gone, &places)
        };
        // Half a spacing from the particle there is no room yet.
        let [None, Some(back)] = states(-0.2)[..] else {
            panic!("{:?}", states(-0.2));
        };
        assert!(back.velocity[0] < 0.0);
        assert_relative_eq!(back.velocity[1], 0.1);
        let sound = GAMMA * back.pressure / back.density;
        let rise = 1.0 + 0.5 * (GAMMA - 1.0) * back.velocity[0].powi(2) / sound;
        let total = back.pressure * rise.powf(GAMMA / (GAMMA - 1.0));
        assert_relative_eq!(total, pressure, max_relative = 1e-12);
        assert_eq!(states(0.2), [None, None]);
    }
}
