//! Schemes put together from parts that no named scheme combines.

use super::*;
use crate::scheme::{Conduction, Density, Energy, Integrator, StepBound, StepRule, Viscosity};

/// Every integrator with every density, viscosity and rule of the step; heat in exchange.
fn combinations() -> Vec<Scheme> {
    let mut schemes = Vec::new();
    for integrator in [Integrator::PredictorCorrector, Integrator::Leapfrog] {
        for density in [Density::Continuity, Density::Summation] {
            for viscosity in [Viscosity::Bare, Viscosity::Softened, Viscosity::Limited] {
                for rule in [StepRule::Extremes, StepRule::EachParticle] {
                    schemes.push(Scheme {
                        integrator,
                        density,
                        viscosity,
                        step: StepBound {
                            rule,
                            ..Scheme::PAPER.step
                        },
                        conduction: Conduction::Pairwise,
                        energy: Energy::Settled,
                        ..Scheme::PAPER
                    });
                }
            }
        }
    }
    schemes
}

#[test]
fn energy_that_is_settled_stays_to_round_off_whatever_else_the_scheme_does() {
    for scheme in combinations() {
        let mut problem = stirred::<2>(20);
        problem.scheme = scheme;
        let mut simulation = start(problem);
        let before = simulation.totals();
        advance(&mut simulation, 20);
        let after = simulation.totals();
        let drift = after.energy / before.energy - 1.0;
        assert!(drift.abs() < 1e-12, "{scheme:?} drifts by {drift:.1e}");
    }
}

/// A sound wave that a box of 100 spacings holds once, a fifth of a period later.
fn wave(scheme: Scheme) -> Vec<f64> {
    let mut problem = cube::<1>(100, Side::Periodic);
    problem.scheme = scheme;
    let wave = std::f64::consts::TAU / problem.domain.bounds.max[0];
    problem.initial = Initial::Field(Field(Arc::new(move |position: &Vector<1>| {
        let sine = 0.01 * (wave * position[0]).sin();
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
    particles.iter().map(|p| p.velocity[0]).collect()
}

#[test]
fn sound_travels_alike_in_all_of_them() {
    let usual = wave(Scheme::CONSERVATIVE);
    for scheme in combinations() {
        let waves = wave(scheme).into_iter().zip(&usual);
        let furthest = waves.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        // Viscosity that spares nothing damps the wave a little.
        assert!(furthest < 0.05 * 0.01, "{scheme:?}: off by {furthest:.1e}");
    }
}
