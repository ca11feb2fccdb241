use super::*;
use crate::problem::Resolution;
use crate::shifting::FASTEST;

/// A periodic box of disordered gas at rest after some sound crossings.
fn settled(shifting: bool) -> Simulation<2> {
    let mut problem = cube::<2>(20, Side::Periodic);
    problem.disorder = 0.2;
    problem.scheme.transport_velocity.shifting = shifting;
    let mut simulation = start(problem);
    advance_to(&mut simulation, 4.0);
    simulation
}

fn kinetic_energy(simulation: &Simulation<2>) -> f64 {
    let gas = simulation.fluid.iter();
    gas.map(|p| 0.5 * p.mass * p.velocity.norm_squared()).sum()
}

/// Standard deviation over mean.
fn spread(values: impl Iterator<Item = f64> + Clone) -> f64 {
    let count = values.clone().count() as f64;
    let mean = values.clone().sum::<f64>() / count;
    (values.map(|value| (value - mean).powi(2)).sum::<f64>() / count).sqrt() / mean
}

/// Spread of `p / rho^gamma`.
fn entropy_spread(simulation: &Simulation<2>) -> f64 {
    let gas = simulation.fluid.iter();
    spread(gas.map(|p| p.energy / p.density.powf(0.4)))
}

#[test]
fn nothing_drifts_on_a_lattice_within_walls() {
    let mut problem = cube::<2>(12, WALL);
    problem.domain.sides[1][0] = Side::Symmetry;
    problem.scheme.transport_velocity.shifting = true;
    let mut simulation = start(problem);
    advance(&mut simulation, 20);
    for (particle, rates) in simulation.fluid.iter().zip(simulation.fluid.rates()) {
        assert!(rates.shift.norm() < 1e-13, "drifts at {}", rates.shift);
        assert!(particle.velocity.norm() < 1e-12);
    }
}

#[test]
fn nothing_drifts_in_a_uniform_stream() {
    let mut problem = cube::<2>(20, Side::FreeStream);
    problem.free_stream.velocity = Vector::<2>::new(2.5, 0.3);
    problem.scheme.skip_undisturbed = false;
    problem.scheme.transport_velocity.shifting = true;
    let mut simulation = start(problem);
    advance(&mut simulation, 40);
    for (particle, rates) in simulation.fluid.iter().zip(simulation.fluid.rates()) {
        assert!(rates.shift.norm() < 1e-12, "drifts at {}", rates.shift);
        assert!((particle.density / 1.4 - 1.0).abs() < 1e-11);
    }
}

#[test]
fn disordered_gas_at_rest_becomes_more_even_and_quieter() {
    let (plain, shifted) = (settled(false), settled(true));
    let density = |simulation: &Simulation<2>| spread(simulation.fluid.iter().map(|p| p.density));
    assert!(
        density(&shifted) < density(&plain),
        "density spreads by {:.1e}, plain {:.1e}",
        density(&shifted),
        density(&plain)
    );
    assert!(
        kinetic_energy(&shifted) < kinetic_energy(&plain),
        "kinetic energy {:.1e}, plain {:.1e}",
        kinetic_energy(&shifted),
        kinetic_energy(&plain)
    );
    // What the disorder of the start has made is in both runs; shifting may not add to it.
    assert!(
        entropy_spread(&shifted) < 1.1 * entropy_spread(&plain),
        "entropy spreads by {:.1e}, plain {:.1e}",
        entropy_spread(&shifted),
        entropy_spread(&plain)
    );
}

/// Spread of the entropy of a smooth isentropic flow after a time, from a lattice.
fn isentropic(cells: usize, shifting: bool) -> f64 {
    let mut problem = cube::<2>(cells, Side::Periodic);
    problem.resolution = Resolution::uniform(1.0 / cells as f64);
    problem.domain.bounds.max = Vector::repeat(1.0);
    problem.scheme.transport_velocity.shifting = shifting;
    let wave = std::f64::consts::TAU;
    problem.initial = Initial::Field(Field(Arc::new(move |position: &Vector<2>| {
        let density = 1.4 + 0.2 * (wave * position[0]).sin() * (wave * position[1]).cos();
        State {
            density,
            velocity: Vector::<2>::new(0.3 * (wave * position[1]).sin(), 0.0),
            pressure: (density / 1.4).powf(1.4),
        }
    })));
    let mut simulation = start(problem);
    advance_to(&mut simulation, 0.3);
    entropy_spread(&simulation)
}

#[test]
fn shifting_makes_no_entropy_in_smooth_isentropic_flow() {
    for cells in [24, 48] {
        let (plain, shifted) = (isentropic(cells, false), isentropic(cells, true));
        assert!(
            shifted < 1.1 * plain,
            "entropy spreads by {shifted:.2e}, plain {plain:.2e}, {cells} cells"
        );
    }
}

#[test]
fn next_to_a_wall_nothing_drifts_into_it_and_nowhere_faster_than_allowed() {
    let mut problem = stirred::<2>(20);
    problem.domain.sides = [[WALL; 2]; 2];
    problem.scheme.transport_velocity.shifting = true;
    let mut simulation = start(problem);
    advance(&mut simulation, 30);
    let end = simulation.problem.domain.bounds.max[0];
    let mut fastest = 0.0_f64;
    for (particle, rates) in simulation.fluid.iter().zip(simulation.fluid.rates()) {
        let sound = (1.4 * 0.4 * particle.energy).sqrt();
        // Rates and state are half a step apart.
        let mach = rates.shift.norm() / sound;
        assert!(mach < 1.1 * FASTEST, "drifts at Mach {mach}");
        fastest = fastest.max(mach);
        for axis in 0..2 {
            let (low, high) = (particle.position[axis], end - particle.position[axis]);
            let corner = particle.position[1 - axis].min(end - particle.position[1 - axis]) < 0.3;
            if low.min(high) < 0.06 && !corner {
                let into = if low < high { -1.0 } else { 1.0 };
                assert!(
                    into * rates.shift[axis] < 0.1 * FASTEST * sound,
                    "drifts into the wall at {}",
                    rates.shift
                );
            }
        }
    }
    assert!(fastest > 1e-3, "nothing drifts in disordered gas");
}
