use super::*;
use crate::frame::Totals;

/// Rates of the fluid's momentum and energy by the pair sums of the last evaluation: zero to round-off in a periodic box.
fn rates_of_totals<const D: usize>(simulation: &Simulation<D>) -> Totals {
    let mut rates = Totals::default();
    for (particle, rate) in simulation.fluid.iter().zip(simulation.fluid.rates()) {
        let acceleration = rate.acceleration + rate.wall_acceleration;
        for k in 0..D {
            rates.momentum[k] += particle.mass * acceleration[k];
        }
        let power = particle.velocity.dot(&acceleration) + rate.energy;
        rates.energy += particle.mass * power;
    }
    rates
}

fn pair_sums_balance<const D: usize>(cells: usize, shifting: bool) {
    let mut problem = stirred::<D>(cells);
    problem.scheme.transport_velocity.shifting = shifting;
    let mut simulation = start(problem);
    let before = simulation.totals();
    let scale: f64 = simulation
        .fluid
        .iter()
        .zip(simulation.fluid.rates())
        .map(|(particle, rates)| particle.mass * rates.acceleration.norm())
        .sum();
    let rates = rates_of_totals(&simulation);
    assert!(
        rates.energy.abs() < 1e-14 * scale,
        "energy rate {}",
        rates.energy
    );
    for k in 0..D {
        assert!(
            rates.momentum[k].abs() < 1e-14 * scale,
            "momentum rate {:?}",
            rates.momentum
        );
    }
    advance(&mut simulation, 20);
    let after = simulation.totals();
    assert!((after.mass / before.mass - 1.0).abs() < 1e-14);
    for k in 0..D {
        let drift = after.momentum[k] - before.momentum[k];
        assert!(drift.abs() < 1e-12 * before.mass, "momentum drift {drift}");
    }
}

#[test]
fn mass_momentum_and_the_rate_of_energy_balance_to_round_off_in_a_periodic_box() {
    for shifting in [false, true] {
        pair_sums_balance::<1>(40, shifting);
        pair_sums_balance::<2>(20, shifting);
        pair_sums_balance::<3>(11, shifting);
    }
}

#[test]
fn the_energy_of_a_periodic_box_stays_to_round_off_at_any_time_step() {
    for (cfl, shifting) in [(0.5, false), (0.25, false), (0.5, true)] {
        let mut problem = stirred::<2>(20);
        problem.scheme.step.cfl = cfl;
        problem.scheme.transport_velocity.shifting = shifting;
        let mut simulation = start(problem);
        let before = simulation.totals().energy;
        advance_to(&mut simulation, 0.5);
        let drift = simulation.totals().energy / before - 1.0;
        assert!(drift.abs() < 1e-12, "drift {drift} at cfl {cfl}");
    }
}
