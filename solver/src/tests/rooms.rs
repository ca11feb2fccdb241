//! The room that gas starts in beside bodies.

use std::sync::Arc;

use aero_geometry::{Placed, Placement, Shape, Vector, bodies};

use super::cube;
use super::seam::body_on_the_lattice;
use crate::particles::{Particle, start};
use crate::problem::{Problem, Side};
use crate::scheme::Volume;

/// The gas about a rectangle in a box of 4 by 4, forty spacings wide, of density 1.4.
fn gas_about(
    size: [f64; 2],
    turned: f64,
    middle: [f64; 2],
    side: Side,
) -> (Problem<2>, Vec<Particle<2>>) {
    gas_between(&[[side; 2]; 2], size, turned, middle)
}

fn gas_between(
    sides: &[[Side; 2]; 2],
    [width, height]: [f64; 2],
    turned: f64,
    middle: [f64; 2],
) -> (Problem<2>, Vec<Particle<2>>) {
    let mut problem = cube::<2>(40, Side::WALL);
    problem.domain.sides = *sides;
    let body = bodies::rectangle(width, height, 0.0).unwrap();
    let place = Placement::default()
        .rotated(turned)
        .moved(Vector::from(middle));
    let shape: Arc<dyn Shape<2>> =
        Arc::new(Placed::new(Arc::new(body) as Arc<dyn Shape<2>>, place));
    problem.bodies = vec![body_on_the_lattice(&problem, shape)];
    let (fluid, _) = start(&problem).unwrap();
    let fluid = fluid.iter().copied().collect();
    (problem, fluid)
}

fn mass<'a>(fluid: impl IntoIterator<Item = &'a Particle<2>>) -> f64 {
    fluid.into_iter().map(|particle| particle.mass).sum()
}

#[test]
fn gas_has_the_mass_of_all_the_room_that_a_body_leaves() {
    for side in [Side::Symmetry, Side::FreeStream] {
        for (turned, x) in [(0.0, 2.0), (0.0, 2.03), (0.3, 2.03), (0.8, 1.97)] {
            let (problem, fluid) = gas_about([1.04, 1.0], turned, [x, 1.96], side);
            let (mass, expected) = (mass(&fluid), 1.4 * (16.0 - 1.04));
            assert!(
                (mass / expected - 1.0).abs() < 3e-4,
                "{turned} {x}: {mass} {expected}"
            );
            let own = 1.4 * problem.resolution.lattice().powi(2);
            let shares = fluid.iter().map(|particle| particle.mass / own);
            assert!(shares.fold(0.0, f64::max) < 2.5);
        }
    }
}

/// Nor does gas within leave for what is beyond.
#[test]
fn gas_beyond_a_side_is_none_of_the_particles_within() {
    let cut_or_standing = [
        (0.0, [4.0, 2.0], 1.0),
        (0.3, [4.0, 2.0], 1.0),
        (0.7, [4.0, 2.0], 1.0),
        (0.0, [2.0, 0.5], 2.0),
        (0.0, [2.03, 0.49], 1.98),
        (0.3, [2.0, 0.0], 1.0),
    ];
    for (turned, middle, area) in cut_or_standing {
        let sides = [[Side::FreeStream; 2], [Side::WALL, Side::FreeStream]];
        let (_, fluid) = gas_between(&sides, [2.0, 1.0], turned, middle);
        let (mass, expected) = (mass(&fluid), 1.4 * (16.0 - area));
        assert!(
            (mass / expected - 1.0).abs() < 1e-3,
            "{turned} {middle:?}: {mass} {expected}"
        );
    }
}

#[test]
fn gas_stands_in_the_middle_of_its_room() {
    let spacing = 0.1;
    // A row of the lattice stands at y = 2.55; so far off it is the upper face of the body.
    for gap in [0.55, 0.7, 0.9, 1.1, 1.3, 1.45] {
        let height = 0.5 + 0.1 * (0.5 - gap);
        let upper = 2.55 - gap * spacing;
        let (_, fluid) = gas_about([1.0, height], 0.0, [2.0, upper - 0.5 * height], Side::WALL);
        let above = fluid.iter().filter(|p| p.position[1] > upper);
        let above = above.filter(|p| (p.position[0] - 1.95).abs() < 1e-9);
        let first = above.min_by(|a, b| a.position[1].total_cmp(&b.position[1]));
        let first = first.unwrap();
        let room = first.mass / (1.4 * spacing * spacing);
        let expected = gap + 0.5;
        // Of a surface between two of sixteen places of a cell one counts too many or too few.
        assert!((room - expected).abs() < 0.04, "{gap}: {room} {expected}");
        let off = (first.position[1] - upper) / spacing;
        assert!((off - 0.5 * expected).abs() < 0.03, "{gap}: {off}");
    }
}

#[test]
fn gas_keeps_to_its_side_of_a_plate_thinner_than_a_spacing() {
    for lower in [1.91, 1.93, 1.96, 1.98] {
        let (_, fluid) = gas_about([6.0, 0.03], 0.0, [2.0, lower + 0.015], Side::WALL);
        let above = mass(fluid.iter().filter(|p| p.position[1] > lower));
        let expected = 1.4 * 4.0 * (4.0 - lower - 0.03);
        assert!(
            (above / expected - 1.0).abs() < 2e-3,
            "{lower}: {above} {expected}"
        );
        let below = mass(fluid.iter().filter(|p| p.position[1] < lower));
        let expected = 1.4 * 4.0 * lower;
        assert!(
            (below / expected - 1.0).abs() < 2e-3,
            "{lower}: {below} {expected}"
        );
    }
}

/// It passes between particles and corners of their cells, which are two parts in ten thousand of the gas above.
#[test]
fn gas_keeps_to_its_side_of_a_thin_plate_askew() {
    let (turned, thickness) = (0.6_f64, 0.02);
    for height in [2.0, 2.02, 2.03, 2.07] {
        let (_, fluid) = gas_about([8.0, thickness], turned, [2.0, height], Side::WALL);
        let above = fluid
            .iter()
            .filter(|p| p.position[1] - height > turned.tan() * (p.position[0] - 2.0));
        let across = 0.5 * thickness / turned.cos();
        let expected = 1.4 * 4.0 * (4.0 - height - across);
        let mass = mass(above);
        assert!(
            (mass / expected - 1.0).abs() < 1.5e-4,
            "{height}: {mass} {expected}"
        );
    }
}

#[test]
fn rooms_about_a_body_are_symmetric_as_it_is() {
    for (width, turned) in [(0.93, 0.25 * std::f64::consts::PI), (0.84, 0.0)] {
        let (_, fluid) = gas_about([width; 2], turned, [2.0, 2.0], Side::WALL);
        let sums = fluid.iter().map(|particle| {
            let off = particle.position - Vector::repeat(2.0);
            // What is off one diagonal is off the other as well.
            Vector::<3>::new(off[0], off[1], off[0] * off[1]) * particle.mass
        });
        let sum: Vector<3> = sums.sum();
        assert!(sum.amax() < 1e-12, "{width}: {sum}");
    }
}

#[test]
fn particles_of_a_liquid_keep_their_mass() {
    let (mut problem, _) = gas_about([1.04, 1.0], 0.3, [2.03, 1.96], Side::WALL);
    problem.scheme.operators.volume = Volume::Summed;
    let (fluid, _) = start(&problem).unwrap();
    let first = fluid.iter().next().unwrap().mass;
    assert!(fluid.iter().all(|particle| particle.mass == first));
}
