use super::*;

/// Amplitude of the wave.
const LOUDNESS: f64 = 0.02;

/// A sound wave as long as 200 spacings, a tenth of a period later.
fn sound(cfl: f64) -> Vec<Vector<1>> {
    let mut problem = cube::<1>(200, Side::Periodic);
    problem.scheme.step.cfl = cfl;
    let wave = std::f64::consts::TAU / problem.domain.bounds.max[0];
    problem.initial = Initial::Field(Field(Arc::new(move |position: &Vector<1>| {
        let sine = LOUDNESS * (wave * position[0]).sin();
        State {
            density: 1.4 * (1.0 + sine),
            velocity: Vector::<1>::new(sine),
            pressure: 1.0 + 1.4 * sine,
        }
    })));
    let mut simulation = start(problem);
    advance_to(&mut simulation, 2.0);
    let mut particles = simulation.fluid.to_vec();
    particles.sort_by_key(|particle| particle.id);
    particles.iter().map(|particle| particle.velocity).collect()
}

#[test]
fn long_steps_change_a_sound_wave_by_thousandths() {
    let exact = sound(0.01);
    // Of the first order is the dissipation alone, which goes by the strain of the step before.
    for (cfl, allowed) in [(0.5, 2e-3), (0.8, 4e-3)] {
        let waves = sound(cfl).into_iter().zip(&exact);
        let furthest = waves.map(|(a, b)| (a - b).norm()).fold(0.0, f64::max);
        assert!(furthest < allowed * LOUDNESS, "{furthest} at cfl {cfl}");
    }
}

#[test]
fn a_step_that_would_cost_a_particle_its_heat_is_taken_again_at_half_the_length() {
    let mut problem = cube::<1>(40, Side::Symmetry);
    // Le Blanc's tube.
    problem.initial = Initial::Field(Field(Arc::new(|position: &Vector<1>| {
        let is_dense = position[0] < 2.0;
        State {
            density: if is_dense { 1.0 } else { 1e-3 },
            velocity: Vector::<1>::zeros(),
            pressure: if is_dense { 0.1 } else { 1e-10 } * (2.0 / 3.0),
        }
    })));
    problem.gas = Gas::ideal(5.0 / 3.0);
    let mut simulation = start(problem);
    let before = simulation.totals().energy;
    simulation.step(f64::INFINITY).expect("half steps suffice");
    let whole = time_step_of_the_start(&simulation);
    assert!(simulation.time() < 0.51 * whole, "no step was taken again");
    advance(&mut simulation, 50);
    let drift = simulation.totals().energy / before - 1.0;
    assert!(drift.abs() < 1e-12, "energy drift {drift}");
}

/// The first step that was tried.
fn time_step_of_the_start(simulation: &Simulation<1>) -> f64 {
    let mut fresh = start(simulation.problem().clone());
    fresh.prepare();
    fresh.evaluate_start();
    fresh.clock.stable_step
}

#[test]
fn the_first_step_of_a_cold_implosion_lists_neighbours_alone() {
    let mut problem = cube::<2>(60, Side::Symmetry);
    let centre = (problem.domain.bounds.min + problem.domain.bounds.max) * 0.5;
    problem.initial = Initial::Field(Field(Arc::new(move |position: &Vector<2>| State {
        density: 1.0,
        velocity: (centre - position).normalize(),
        // Sound would allow a step in which the gas crosses the box many times.
        pressure: 1e-9,
    })));
    let mut simulation = start(problem);
    simulation.prepare();
    let listed = simulation.listed_pairs() as f64 / simulation.fluid.len() as f64;
    assert!(listed < 500.0, "{listed} neighbours listed per particle");
}
