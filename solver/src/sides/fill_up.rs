//! Gas that comes back in at the outer end of outlets' buffers, see [`super::come_back`].

use aero_geometry::Vector;

use super::buffers::{Buffers, Contents};
use super::particle::OpenParticle;
use super::zone::Zone;
use crate::lattice;
use crate::layers::BUFFER;
use crate::problem::Problem;

impl<const D: usize> Buffers<D> {
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
