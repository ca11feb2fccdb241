//! Gas that bodies shut in starts with the mass that it should have: what their walls leave of the lattice's cells goes to the particles nearest. Where gas comes
//! in or out it does not matter what was there at first.

use std::collections::HashMap;

use aero_geometry::Vector;
use foldhash::fast::FixedState;

use super::Particle;
use crate::lattice;
use crate::problem::{Problem, Side};
use crate::scheme::Volume;
use crate::sides::Rows;

/// Places along each axis of a cell at which it is asked whether gas is there: in the plane, and in space.
const PLACES: [i64; 2] = [16, 4];

/// Particles of the fluid by their place in the lattice.
pub type Placed<const D: usize> = HashMap<[i64; D], usize, FixedState>;

/// True of gas that no side lets in or out, among bodies whose surface the lattice does not know. Particles whose volume is the room that there
/// is have equal masses.
pub fn is_shut_in<const D: usize>(problem: &Problem<D>) -> bool {
    let is_bare = problem
        .bodies
        .iter()
        .all(|body| body.packed_fluid.is_none());
    let may_differ = problem.scheme.operators.volume == Volume::OfDensity;
    let is_closed = !problem.domain.has(Side::is_open);
    !problem.bodies.is_empty() && is_bare && may_differ && is_closed
}

/// Gives those of the `fluid` next to walls the mass of all the gas that is nearest to them, of the lattice from `first` to before `last`.
pub fn fill<const D: usize>(
    problem: &Problem<D>,
    rows: &Rows<D>,
    [first, last]: [[i64; D]; 2],
    placed: &Placed<D>,
    fluid: &mut [Particle<D>],
) {
    let whole = 0.5 * problem.resolution.lattice() * (D as f64).sqrt();
    let mut shares = HashMap::<usize, f64, FixedState>::default();
    for index in lattice::points(first, last) {
        let middle = rows.position(&index, &Vector::zeros());
        let clear = clearance(problem, &middle);
        if clear < -whole {
            continue;
        }
        let own = placed.get(&index);
        if own.is_none() && clear >= 0.5 * problem.resolution.at(&middle) {
            // No wall left this place empty.
            continue;
        }
        if clear > whole {
            if let Some(&number) = own {
                *shares.entry(number).or_default() += 1.0;
            }
            continue;
        }
        let places = PLACES[usize::from(D > 2)];
        let part = (places as f64).powi(-(D as i32));
        for place in lattice::points([0; D], [places; D]) {
            let offset = Vector::from_fn(|k, _| (place[k] as f64 + 0.5) / places as f64 - 0.5);
            let place = middle + offset * problem.resolution.at(&middle);
            let is_within = (0..D)
                .all(|axis| (0..2).all(|end| problem.domain.depth_within(axis, end, &place) > 0.0));
            if !is_within || clearance(problem, &place) <= 0.0 {
                continue;
            }
            let taker = own
                .copied()
                .or_else(|| nearest(rows, &index, &place, placed));
            if let Some(taker) = taker {
                *shares.entry(taker).or_default() += part;
            }
        }
    }
    for (number, share) in shares {
        let particle = &mut fluid[number];
        *particle = particle.of_share(share);
        particle.smoothing_length *= share.powf(1.0 / D as f64);
    }
}

/// How far a place is from the nearest body; negative within one, and endless far from all.
fn clearance<const D: usize>(problem: &Problem<D>, place: &Vector<D>) -> f64 {
    let near = problem.bodies.iter().filter(|body| {
        let around = body
            .shape
            .bounds()
            .grown(2.0 * problem.resolution.at(place));
        around.contains(place)
    });
    near.map(|body| body.shape.signed_distance(place))
        .fold(f64::INFINITY, f64::min)
}

/// The particle nearest to a `place` in the cell at `index`, of those in the cells around.
fn nearest<const D: usize>(
    rows: &Rows<D>,
    index: &[i64; D],
    place: &Vector<D>,
    placed: &Placed<D>,
) -> Option<usize> {
    let around = lattice::points([-1; D], [2; D]);
    let found = around.filter_map(|step| {
        let other: [i64; D] = std::array::from_fn(|k| index[k] + step[k]);
        let number = *placed.get(&other)?;
        let away = (rows.position(&other, &Vector::zeros()) - place).norm_squared();
        Some((away, number))
    });
    found
        .min_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)))
        .map(|(_, number)| number)
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use aero_geometry::{Placed as Moved, Placement, Shape, bodies};

    use crate::particles::start;
    use crate::problem::Side;
    use crate::tests::seam::body_on_the_lattice;
    use crate::tests::{cube, slip_body};

    use super::*;

    /// A square askew in a closed box, wherever it lies, leaves the rest of the box to the gas; nothing is done for gas that may come and go.
    #[test]
    fn shut_in_gas_has_the_mass_of_all_the_room_that_a_body_leaves() {
        for (turned, x) in [(0.0, 2.0), (0.0, 2.03), (0.3, 2.03), (0.8, 1.97)] {
            let mut problem = cube::<2>(40, Side::Symmetry);
            let square = Arc::new(bodies::rectangle(1.04, 1.0, 0.0).unwrap()) as Arc<dyn Shape<2>>;
            let place = Placement::default()
                .rotated(turned)
                .moved(Vector::<2>::new(x, 1.96));
            let shape: Arc<dyn Shape<2>> = Arc::new(Moved::new(square, place));
            problem.bodies = vec![body_on_the_lattice(&problem, shape)];
            let (fluid, _) = start(&problem).unwrap();
            let mass: f64 = fluid.iter().map(|particle| particle.mass).sum();
            let expected = 1.4 * (16.0 - 1.04);
            assert!(
                (mass / expected - 1.0).abs() < 3e-4,
                "{turned} {x}: {mass} {expected}"
            );
            let own = 1.4 * problem.resolution.lattice().powi(2);
            let shares = fluid.iter().map(|particle| particle.mass / own);
            assert!(shares.fold(0.0, f64::max) < 2.5);
        }
        let with_circle = |side: Side| {
            let mut problem = cube::<2>(8, side);
            problem.bodies = vec![slip_body(Arc::new(bodies::circle(0.2).unwrap()))];
            problem
        };
        assert!(is_shut_in(&with_circle(Side::WALL)));
        assert!(!is_shut_in(&with_circle(Side::FreeStream)));
        let mut liquid = with_circle(Side::WALL);
        liquid.scheme.operators.volume = Volume::Summed;
        assert!(!is_shut_in(&liquid));
    }
}
