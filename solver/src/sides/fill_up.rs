//! Gas that comes back in at the outer end of outlets' buffers, see [`super::come_back`].

use aero_geometry::Vector;
use aero_geometry::kernel::SMOOTHING_RATIO;

use super::buffers::{Buffers, Contents};
use super::particle::OpenParticle;
use super::upstream::Upstream;
use super::zone::Zone;
use crate::lattice;
use crate::layers::BUFFER;
use crate::particles::Particle;
use crate::problem::Problem;

/// So near to each other, in spacings of the gas itself, gas that comes back does not stay.
const CROWDED: f64 = 0.5;

impl<const D: usize> Buffers<D> {
    /// Takes out what other gas that comes back has run into. Nothing keeps the particles of a buffer apart; inside, two at one place would be taken
    /// for gas twice as dense.
    pub(super) fn thin_out(&mut self, problem: &Problem<D>) {
        for (number, side) in self.sides.iter().enumerate() {
            let place = side.model.goes_on().then_some(side.place);
            let Some(place) = place else { continue };
            let comes_back = |open: &OpenParticle<D>| {
                usize::from(open.side) == number
                    && place.inward() * open.particle.velocity[place.axis] > 0.0
            };
            let mut there = Upstream::new(place, problem.resolution.lattice());
            let particles = &mut self.contents.particles;
            for OpenParticle { particle, .. } in particles.iter().filter(|open| comes_back(open)) {
                there.add(particle.position, [particle.id as f64]);
            }
            there.sort();
            particles.retain(|open| {
                let Particle { id, position, .. } = &open.particle;
                let close = CROWDED * open.particle.smoothing_length / SMOOTHING_RATIO;
                !comes_back(open) || !there.has(position, close, |[other]| *other < *id as f64)
            });
        }
    }

    /// Lets gas come back in where that of a buffer has moved off, at places of a lattice that rests.
    pub(super) fn fill_up(&mut self, problem: &Problem<D>, now: f64) {
        let drift = Vector::zeros();
        let rows = self.sides.rows;
        for (number, side) in self.sides.iter().enumerate() {
            if !side.model.goes_on() {
                continue;
            }
            let axis = side.place.axis;
            let outermost = (BUFFER as f64 - 1.0) * rows.pitch(axis);
            let is_outermost = |position: &Vector<D>| {
                side.place.depth(position) > outermost
                    && self.sides.zone(position) == Zone::Beyond(number)
                    && problem.is_free(position, &rows)
            };
            let all = self.sides.slabs(&drift).into_iter();
            let all = all.flat_map(|(first, last)| lattice::points(first, last));
            let places: Vec<Vector<D>> = all
                .map(|index| rows.position(&index, &drift))
                .filter(is_outermost)
                .collect();
            let Contents { particles, ids, .. } = &mut self.contents;
            let first = *ids;
            *ids += places.len() as u64;
            let states = side.model.come_back(problem, particles, &places, now);
            for (id, (position, state)) in (first..).zip(places.iter().zip(states)) {
                if let Some(state) = state {
                    let particle = problem.particle(*position, &state, id);
                    let particle = particle.of_share(rows.share());
                    particles.push(OpenParticle::of_lattice(particle, number, None));
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::problem::{Side, State};
    use crate::tests::cube;

    /// Of two that come back at one place the older stays; those on their way out pass each other.
    #[test]
    fn no_two_come_back_at_one_place() {
        let side = Side::HeldOutlet {
            pressure: 1.0 / 1.4,
            relaxation: 0.25,
        };
        let problem = cube::<2>(8, side);
        let left = |speed: f64| {
            let mut buffers = Buffers::new(&problem);
            let state = State {
                velocity: [speed, 0.0].into(),
                ..problem.free_stream
            };
            for (id, x) in [(7, 1.0), (8, 1.04), (9, 1.1)] {
                let position = [x, 0.4].into();
                let Zone::Beyond(side) = buffers.sides.zone(&position) else {
                    panic!("{position:?}");
                };
                let particle = problem.particle(position, &state, id);
                buffers.add(OpenParticle::of_lattice(particle, side, None));
            }
            buffers.thin_out(&problem);
            let ids = buffers.particles().iter().map(|open| open.particle.id);
            ids.collect::<Vec<_>>()
        };
        assert_eq!(left(-0.1), [7, 9]);
        assert_eq!(left(0.1), [7, 8, 9]);
    }
}
