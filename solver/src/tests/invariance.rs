use nalgebra::Rotation2;

use super::*;
use crate::scheme::Precision;
use crate::vectors::Arch;

/// A cloud in empty space: the stirred box's particles around its centre.
fn cloud(cells: usize, precision: Precision) -> Simulation<2> {
    let mut problem = stirred::<2>(cells);
    problem.scheme.precision = precision;
    problem.scheme = Scheme::PAPER;
    let centre = problem.domain.bounds.max * 0.5;
    let mut simulation = start(problem);
    let outside = |i: &usize| (simulation.fluid[*i].position - centre).norm() >= 0.9;
    let outside: Vec<_> = (0..simulation.fluid.len()).filter(outside).collect();
    simulation.fluid.remove(outside.into_iter());
    simulation
}

fn by_id(simulation: &Simulation<2>) -> Vec<crate::particles::Particle<2>> {
    let mut particles = simulation.fluid.to_vec();
    particles.sort_by_key(|particle| particle.id);
    particles
}

#[test]
fn a_rotated_cloud_gives_the_rotated_flow() {
    is_the_same_turned(Precision::Double, 1e-9);
    is_the_same_turned(Precision::Mixed, 1e-5);
}

fn is_the_same_turned(precision: Precision, allowed: f64) {
    let turn = Rotation2::new(0.61);
    let mut plain = cloud(40, precision);
    let centre = plain.problem.domain.bounds.max * 0.5;
    let mut turned = cloud(40, precision);
    for particle in &mut turned.fluid {
        particle.position = centre + turn * (particle.position - centre);
        particle.velocity = turn * particle.velocity;
    }
    // At the cloud's torn rim neighbours soon run out, and round-off decides whose matrix is
    // singular: only the first steps are comparable.
    advance(&mut plain, 6);
    advance(&mut turned, 6);
    for (plain, turned) in by_id(&plain).iter().zip(by_id(&turned)) {
        let expected = centre + turn * (plain.position - centre);
        assert!((turned.position - expected).norm() < allowed);
        assert!((turned.velocity - turn * plain.velocity).norm() < allowed);
        assert!((turned.energy - plain.energy).abs() < allowed);
    }
}

#[test]
fn a_moving_frame_gives_the_same_flow() {
    is_the_same_in_a_moving_frame(false);
    is_the_same_in_a_moving_frame(true);
}

fn is_the_same_in_a_moving_frame(shifting: bool) {
    let drift = Vector::<2>::new(3.0, -2.0);
    let mut problem = stirred::<2>(20);
    problem.scheme.transport_velocity.shifting = shifting;
    let mut still = start(problem.clone());
    let mut moving = start(problem);
    for particle in &mut moving.fluid {
        particle.velocity += drift;
    }
    advance(&mut still, 15);
    advance(&mut moving, 15);
    assert!((still.time() - moving.time()).abs() < 1e-12);
    for (still, moving) in by_id(&still).iter().zip(by_id(&moving)) {
        assert!((moving.velocity - drift - still.velocity).norm() < 1e-10);
        assert!((moving.density - still.density).abs() < 1e-10);
    }
}

#[test]
fn half_a_symmetric_flow_with_a_symmetry_plane_equals_the_whole() {
    half_equals_the_whole(false);
    half_equals_the_whole(true);
}

fn half_equals_the_whole(shifting: bool) {
    let symmetric = |problem: &mut Problem<2>| {
        problem.initial = Initial::Field(Field(Arc::new(|position: &Vector<2>| State {
            density: 1.4 + 0.3 * (position[0] * 3.0).cos(),
            velocity: Vector::<2>::new(0.4 * (position[1] * 2.0).cos(), 0.5 * position[1]),
            pressure: 1.0 + 0.2 * position[1] * position[1],
        })));
    };
    let mut whole = cube::<2>(20, WALL);
    whole.scheme.transport_velocity.shifting = shifting;
    whole.domain.bounds.min[1] = -1.0;
    whole.domain.bounds.max[1] = 1.0;
    symmetric(&mut whole);
    let mut half = whole.clone();
    half.domain.bounds.min[1] = 0.0;
    half.domain.sides[1][0] = Side::Symmetry;
    let (mut whole, mut half) = (start(whole), start(half));
    advance(&mut whole, 30);
    advance(&mut half, 30);
    for particle in &half.fluid {
        let twin = whole
            .fluid
            .iter()
            .min_by(|a, b| {
                let distance = |p: &Vector<2>| (p - particle.position).norm();
                distance(&a.position).total_cmp(&distance(&b.position))
            })
            .expect("the whole has particles");
        assert!((twin.position - particle.position).norm() < 1e-9);
        assert!((twin.velocity - particle.velocity).norm() < 1e-9);
    }
}

fn bits(threads: usize, shifting: bool, precision: Precision) -> Vec<u64> {
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(threads)
        .build()
        .expect("a pool");
    pool.install(|| {
        let mut problem = stirred::<2>(30);
        problem.domain.sides = [[Side::Inlet, Side::Outlet], [WALL, Side::Symmetry]];
        problem.free_stream.velocity = Vector::<2>::new(2.0, 0.0);
        problem.scheme.wall.extrapolation = Extrapolation::Wm;
        problem.scheme.transport_velocity.shield = true;
        problem.scheme.transport_velocity.shifting = shifting;
        problem.scheme.precision = precision;
        let mut simulation = start(problem);
        advance(&mut simulation, 40);
        simulation
            .fluid
            .iter()
            .flat_map(|p| [p.position[0], p.velocity[1], p.density, p.energy].map(f64::to_bits))
            .collect()
    })
}

#[test]
fn any_number_of_threads_gives_the_same_bits() {
    for (shifting, precision) in [
        (false, Precision::Double),
        (true, Precision::Double),
        (true, Precision::Mixed),
    ] {
        let one = bits(1, shifting, precision);
        assert_eq!(one, bits(2, shifting, precision));
        assert_eq!(one, bits(4, shifting, precision));
    }
}

/// A stirred box in space after some steps, with these vectors.
fn with_vectors(arch: pulp::Arch, precision: Precision) -> Vec<[f64; 5]> {
    let mut problem = stirred::<3>(12);
    problem.scheme.precision = precision;
    let mut simulation = start(problem);
    simulation.around.arch = Arch::new(arch, precision);
    advance(&mut simulation, 5);
    let mut particles = simulation.fluid.to_vec();
    particles.sort_by_key(|particle| particle.id);
    let numbers = particles.iter().map(|p| {
        let [x, y, z] = p.position.into();
        [x, y, z, p.density, p.energy]
    });
    numbers.collect()
}

/// Not to the bit: plain numbers do not fuse products with sums, and AVX-512 makes reciprocals of rough ones.
#[test]
fn any_width_of_vectors_gives_the_same_flow_to_round_off() {
    any_width_gives_the_same(Precision::Double, 1e-11);
    any_width_gives_the_same(Precision::Mixed, 1e-5);
}

fn any_width_gives_the_same(precision: Precision, allowed: f64) {
    let plain = with_vectors(pulp::Arch::Scalar, precision);
    let wide = with_vectors(crate::vectors::avx2().unwrap_or_default(), precision);
    for (plain, wide) in plain.iter().flatten().zip(wide.iter().flatten()) {
        assert!((plain - wide).abs() < allowed, "{plain} became {wide}");
    }
}
