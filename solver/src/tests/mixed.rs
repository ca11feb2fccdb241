//! Pairs in `f32`: how far that is from `f64`. Bounds are two to four times what was measured.

use super::*;
use crate::particles::Particle;
use crate::scheme::Precision;

fn mixed<const D: usize>(mut problem: Problem<D>) -> Problem<D> {
    problem.scheme.precision = Precision::Mixed;
    problem
}

fn by_id<const D: usize>(simulation: &Simulation<D>) -> Vec<Particle<D>> {
    let mut particles = simulation.fluid.to_vec();
    particles.sort_by_key(|particle| particle.id);
    particles
}

/// Largest difference of velocity and of density between two runs, one of which moves `drift` faster.
fn furthest<const D: usize>(a: &Simulation<D>, b: &Simulation<D>, drift: &Vector<D>) -> [f64; 2] {
    assert_eq!(a.fluid.len(), b.fluid.len());
    let pairs = by_id(a).into_iter().zip(by_id(b));
    pairs.fold([0.0; 2], |[speed, density], (a, b)| {
        [
            (b.velocity - drift - a.velocity).norm().max(speed),
            (b.density - a.density).abs().max(density),
        ]
    })
}

fn keeps<const D: usize>(cells: usize, shifting: bool) {
    let mut problem = mixed(stirred::<D>(cells));
    problem.scheme.transport_velocity.shifting = shifting;
    let mut simulation = start(problem);
    let before = simulation.totals();
    advance(&mut simulation, 50);
    let after = simulation.totals();
    assert!((after.mass / before.mass - 1.0).abs() < 1e-14);
    for k in 0..D {
        let drift = (after.momentum[k] - before.momentum[k]) / before.mass;
        assert!(drift.abs() < 5e-8, "{D}D: momentum drifts by {drift:.1e}");
    }
    let drift = after.energy / before.energy - 1.0;
    assert!(drift.abs() < 1e-8, "{D}D: energy drifts by {drift:.1e}");
}

#[test]
fn mass_stays_and_momentum_and_energy_drift_by_less_than_a_part_in_ten_million() {
    for shifting in [false, true] {
        keeps::<1>(40, shifting);
        keeps::<2>(20, shifting);
        keeps::<3>(11, shifting);
    }
}

fn follows<const D: usize>(cells: usize, scheme: Scheme, shifting: bool) {
    let mut problem = stirred::<D>(cells);
    problem.scheme = scheme;
    problem.scheme.transport_velocity.shifting = shifting;
    let (mut double, mut mixed) = (start(problem.clone()), start(mixed(problem)));
    advance(&mut double, 20);
    advance(&mut mixed, 20);
    let off = furthest(&double, &mixed, &Vector::zeros());
    assert!(off.iter().all(|&off| off < 1e-5), "{D}D: off by {off:?}");
}

#[test]
fn the_flow_is_that_of_double_precision_to_single_round_off() {
    for scheme in [Scheme::PAPER, Scheme::CONSERVATIVE] {
        for shifting in [false, true] {
            follows::<1>(40, scheme, shifting);
            follows::<2>(20, scheme, shifting);
        }
    }
    follows::<3>(11, Scheme::PAPER, false);
    follows::<3>(11, Scheme::CONSERVATIVE, true);
}

fn rests<const D: usize>(extrapolation: Extrapolation) {
    let mut problem = mixed(cube::<D>(10, WALL));
    problem.scheme.wall.extrapolation = extrapolation;
    let mut simulation = start(problem);
    advance(&mut simulation, if D == 3 { 40 } else { 100 });
    let noise = simulation.fluid.iter().fold([0.0_f64; 2], |noise, p| {
        let density = (p.density / 1.4 - 1.0).abs();
        [noise[0].max(p.velocity.norm()), noise[1].max(density)]
    });
    assert!(noise.iter().all(|&noise| noise < 1e-5), "{D}D: {noise:?}");
}

#[test]
fn gas_in_a_closed_box_rests_to_single_round_off() {
    for extrapolation in [Extrapolation::Wom, Extrapolation::Wm] {
        rests::<1>(extrapolation);
        rests::<2>(extrapolation);
        rests::<3>(extrapolation);
    }
}

#[test]
fn a_uniform_stream_stays_uniform_to_single_round_off() {
    let mut problem = mixed(cube::<2>(12, Side::FreeStream));
    problem.domain.sides[0] = [Side::Inlet, Side::Outlet];
    problem.free_stream.velocity = Vector::<2>::new(2.5, 0.3);
    problem.scheme.skip_undisturbed = false;
    let mut simulation = start(problem);
    advance_to(&mut simulation, 3.0);
    for particle in &simulation.fluid {
        let speed = (particle.velocity - Vector::<2>::new(2.5, 0.3)).norm();
        assert!(speed < 1e-5, "off by {speed:.1e}");
        assert!((particle.density / 1.4 - 1.0).abs() < 1e-5);
    }
}

#[test]
fn rounding_wakes_no_undisturbed_stream() {
    let run = |skips| {
        let mut problem = mixed(cube::<2>(40, Side::Symmetry));
        problem.domain.sides[0] = [Side::Inlet, WALL];
        problem.free_stream.velocity = Vector::<2>::new(2.0, 0.0);
        problem.scheme.skip_undisturbed = skips;
        let mut simulation = start(problem);
        advance(&mut simulation, 60);
        simulation
    };
    let (all, part) = (run(false), run(true));
    let calm = part.fluid.iter().filter(|p| p.is_calm).count();
    assert!(calm > 200, "{calm} particles are calm");
    let off = furthest(&all, &part, &Vector::zeros());
    assert!(off.iter().all(|&off| off < 1e-5), "off by {off:?}");
}

#[test]
fn a_moving_frame_gives_the_same_flow_to_single_round_off() {
    let drift = Vector::<2>::new(3.0, -2.0);
    let problem = mixed(stirred::<2>(20));
    let (mut still, mut moving) = (start(problem.clone()), start(problem));
    for particle in &mut moving.fluid {
        particle.velocity += drift;
    }
    advance(&mut still, 15);
    advance(&mut moving, 15);
    let off = furthest(&still, &moving, &drift);
    assert!(off.iter().all(|&off| off < 1e-5), "off by {off:?}");
}

/// The same where coordinates are a thousand times the box.
#[test]
fn the_flow_is_the_same_far_from_the_origin() {
    let problem = mixed(stirred::<2>(20));
    let mut far = problem.clone();
    let away = Vector::repeat(1000.0 * problem.domain.bounds.max[0]);
    far.domain.bounds.min += away;
    far.domain.bounds.max += away;
    let (mut near, mut far) = (start(problem), start(far));
    advance(&mut near, 15);
    advance(&mut far, 15);
    let off = furthest(&near, &far, &Vector::zeros());
    assert!(off.iter().all(|&off| off < 1e-5), "off by {off:?}");
}
