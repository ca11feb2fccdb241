use super::*;
use std::f64::consts::PI;

/// A pipe of radius one around the axis, closed by the given sides along it.
fn pipe(ends: [Side; 2], outer: Side) -> Problem<2> {
    let mut problem = cube::<2>(10, WALL);
    problem.domain.sides = [ends, [Side::Axis, outer]];
    problem
}

#[test]
fn gas_in_a_closed_pipe_stays_at_rest_to_round_off() {
    for scheme in [Scheme::PAPER, Scheme::CONSERVATIVE] {
        for extrapolation in [Extrapolation::Wom, Extrapolation::Wm] {
            let mut problem = pipe([WALL; 2], WALL);
            problem.scheme = scheme;
            problem.scheme.wall.extrapolation = extrapolation;
            let mut simulation = start(problem);
            advance(&mut simulation, 40);
            for particle in &simulation.fluid {
                assert!(particle.velocity.norm() < 1e-12);
                assert!((particle.density / 1.4 - 1.0).abs() < 1e-12);
            }
        }
    }
}

#[test]
fn the_rings_of_a_pipe_hold_its_mass_and_push_on_its_end() {
    let simulation = start(pipe([WALL; 2], WALL));
    assert!((simulation.totals().mass / (1.4 * PI) - 1.0).abs() < 1e-12);
    // Wall sides in the order of the axes: lower end, upper end, mantle.
    let loads = simulation.loads();
    assert!(
        (loads[1].force[0] / PI - 1.0).abs() < 1e-2,
        "{:?}",
        loads[1]
    );
    assert!(
        (loads[0].force[0] / PI + 1.0).abs() < 1e-2,
        "{:?}",
        loads[0]
    );
}

#[test]
fn a_stream_along_the_axis_stays_uniform_to_round_off() {
    let mut problem = pipe([Side::Inlet, Side::Outlet], Side::FreeStream);
    problem.free_stream.velocity = Vector::<2>::new(2.5, 0.0);
    let mut simulation = start(problem);
    advance_to(&mut simulation, 2.0);
    for particle in &simulation.fluid {
        assert!(particle.position[1] > 0.0);
        assert!((particle.density / 1.4 - 1.0).abs() < 1e-11);
    }
}

/// Gas that expands evenly, `u = (x, r) / (1 + t)`, thins as `(1 + t)^-3` without a gradient of pressure: a
/// ring's growth counts once in `x`, once in `r` and once around.
#[test]
fn gas_that_expands_evenly_thins_in_three_dimensions() {
    let mut problem = pipe([Side::Symmetry, Side::FreeStream], Side::FreeStream);
    problem.domain.bounds.max = Vector::<2>::repeat(3.0);
    // Cold, so that the edge's rarefaction does not reach the middle.
    problem.initial = Initial::Field(Field(Arc::new(|position: &Vector<2>| State {
        density: 1.4,
        velocity: *position,
        pressure: 1e-4,
    })));
    let mut simulation = start(problem);
    let time = 0.2;
    advance_to(&mut simulation, time);
    let thinner = (1.0 + time).powi(3);
    let cooler = (1.0 + time).powf(3.0 * 0.4);
    let middle = simulation.fluid.iter().filter(|p| p.position.norm() < 1.5);
    for particle in middle {
        let density = particle.density * thinner / 1.4;
        assert!(
            (density - 1.0).abs() < 0.01,
            "{density} at {}",
            particle.position
        );
        let energy = particle.energy * cooler / (1e-4 / (0.4 * 1.4));
        assert!(
            (energy - 1.0).abs() < 0.02,
            "{energy} at {}",
            particle.position
        );
    }
}
