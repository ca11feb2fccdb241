use super::*;

fn stays_at_rest<const D: usize>(extrapolation: Extrapolation, scheme: Scheme) {
    let mut problem = cube::<D>(10, WALL);
    problem.scheme = scheme;
    problem.scheme.wall.extrapolation = extrapolation;
    let mut simulation = start(problem);
    advance(&mut simulation, 40);
    for particle in &simulation.fluid {
        assert!(
            particle.velocity.norm() < 1e-12,
            "moves at {}",
            particle.velocity
        );
        assert!(
            (particle.density / 1.4 - 1.0).abs() < 1e-12,
            "density {}",
            particle.density
        );
    }
    assert_eq!(simulation.statistics().leaked, 0);
}

#[test]
fn gas_in_a_closed_box_stays_at_rest_to_round_off() {
    for extrapolation in [Extrapolation::Wom, Extrapolation::Wm] {
        for scheme in [Scheme::PAPER, Scheme::CONSERVATIVE] {
            stays_at_rest::<1>(extrapolation, scheme);
            stays_at_rest::<2>(extrapolation, scheme);
        }
        stays_at_rest::<3>(extrapolation, Scheme::CONSERVATIVE);
    }
}

#[test]
fn a_uniform_stream_through_open_sides_stays_uniform_to_round_off() {
    let mut problem = cube::<2>(12, Side::FreeStream);
    problem.domain.sides[0] = [Side::Inlet, Side::Outlet];
    problem.free_stream.velocity = Vector::<2>::new(2.5, 0.3);
    let mut simulation = start(problem);
    let before = simulation.fluid.len();
    advance_to(&mut simulation, 3.0);
    let after = simulation.fluid.len();
    assert!(
        before.abs_diff(after) <= 2 * 12,
        "{before} particles became {after}"
    );
    for particle in &simulation.fluid {
        assert!((particle.velocity - Vector::<2>::new(2.5, 0.3)).norm() < 1e-11);
        assert!((particle.density / 1.4 - 1.0).abs() < 1e-11);
    }
}

#[test]
fn a_stream_along_a_symmetry_plane_starts_and_stays_on_one_side_of_it() {
    let mut problem = cube::<2>(12, Side::FreeStream);
    problem.domain.sides = [
        [Side::Inlet, Side::Outlet],
        [Side::Symmetry, Side::FreeStream],
    ];
    problem.free_stream.velocity = Vector::<2>::new(2.5, 0.0);
    let mut simulation = start(problem);
    assert_eq!(simulation.fluid.len(), 12 * 12);
    advance_to(&mut simulation, 2.0);
    for particle in &simulation.fluid {
        assert!(particle.position[1] > 0.0);
        assert!((particle.density / 1.4 - 1.0).abs() < 1e-11);
    }
}

#[test]
fn a_particle_that_meets_its_own_image_is_pushed_back_gently() {
    let mut problem = cube::<2>(12, WALL);
    problem.domain.sides[1][0] = Side::Symmetry;
    let mut simulation = start(problem);
    let near_plane = |p: &&mut crate::particles::Particle<2>| p.position[1] < 0.1;
    for particle in simulation.fluid.iter_mut().filter(|p| near_plane(p)) {
        particle.position[1] = 1e-5;
        particle.velocity[1] = -0.3;
    }
    advance(&mut simulation, 5);
    for particle in &simulation.fluid {
        assert!(
            particle.velocity.norm() < 3.0,
            "speed {}",
            particle.velocity.norm()
        );
    }
}
