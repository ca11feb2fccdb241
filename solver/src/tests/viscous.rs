//! Viscous particles between plane walls, against exact solutions, and their balances.

use super::*;
use crate::gas::{IdealGas, Transport, Viscosity};
use crate::problem::{NoSlip, Resolution, Slide, WallHeat};

/// Speed of the upper wall.
const SPEED: f64 = 0.5;
const VISCOSITY: f64 = 0.02;
const PRANDTL: f64 = 0.72;
/// Heat capacity at constant pressure of gas whose gas constant is one.
const HEAT_CAPACITY: f64 = 3.5;

fn viscous() -> Gas {
    Gas::Ideal(IdealGas {
        gamma: 1.4,
        constant: 1.0,
        transport: Some(Transport {
            viscosity: Viscosity::Constant(VISCOSITY),
            prandtl: PRANDTL,
        }),
    })
}

fn wall(heat: WallHeat, speed: f64) -> Side {
    Side::Wall {
        kind: WallKind::NoSlip(NoSlip {
            heat,
            slide: Slide {
                velocity: [speed, 0.0, 0.0],
                ..Slide::default()
            },
        }),
        velocity: 0.0,
        acceleration: 0.0,
    }
}

/// Gas of temperature and pressure one between a wall at rest with this `heat` and one that slides, one apart: velocity and
/// temperature at the start as a straight line and this `temperature` have them.
fn couette(
    cells: usize,
    extrapolation: Extrapolation,
    heats: [WallHeat; 2],
    temperature: impl Fn(f64) -> f64 + Send + Sync + 'static,
) -> Problem<2> {
    let mut problem = cube::<2>(cells, Side::Periodic);
    problem.resolution = Resolution::uniform(1.0 / cells as f64);
    problem.domain.bounds = Bounds::new(Vector::zeros(), Vector::from([12.0 / cells as f64, 1.0]));
    problem.domain.sides[1] = [wall(heats[0], 0.0), wall(heats[1], SPEED)];
    problem.gas = viscous();
    problem.scheme = problem.scheme.of_viscous_gas();
    problem.scheme.wall.extrapolation = extrapolation;
    problem.initial = Initial::Field(Field(Arc::new(move |position: &Vector<2>| State {
        density: 1.0 / temperature(position[1]),
        velocity: Vector::from([SPEED * position[1], 0.0]),
        pressure: 1.0,
    })));
    problem
}

/// Temperature between walls of temperature one: heat of friction alone bends it.
fn warmed(y: f64) -> f64 {
    1.0 + PRANDTL * SPEED * SPEED * y * (1.0 - y) / (2.0 * HEAT_CAPACITY)
}

/// Largest error of the velocity over the wall's, and of the temperature over its own rise; friction over the exact one.
fn errors(simulation: &Simulation<2>, exact: impl Fn(f64) -> f64) -> [f64; 3] {
    let rise = exact(0.5) - 1.0;
    let worst = simulation.fluid.iter().fold([0.0_f64; 2], |[u, t], p| {
        let y = p.position[1];
        let temperature = 0.4 * p.energy;
        [
            u.max((p.velocity[0] / SPEED - y).abs()),
            t.max(((temperature - exact(y)) / rise).abs()),
        ]
    });
    let width = simulation.problem.domain.bounds.max[0];
    let friction = simulation.loads()[0].force[0] / (VISCOSITY * SPEED * width);
    [worst[0], worst[1], friction]
}

#[test]
fn gas_between_sliding_walls_keeps_its_exact_profile_of_speed_and_heat() {
    let held = [WallHeat::Temperature(1.0); 2];
    for (extrapolation, [u, t, friction]) in [
        (Extrapolation::Wom, [1.5e-3, 0.04, 4e-3]),
        (Extrapolation::Wm, [1.5e-3, 0.04, 4e-3]),
    ] {
        let mut simulation = start(couette(20, extrapolation, held, warmed));
        advance_to(&mut simulation, 6.0);
        let errors = errors(&simulation, warmed);
        assert!(errors[0] < u, "velocity {errors:?}");
        assert!(errors[1] < t, "temperature {errors:?}");
        assert!((errors[2] - 1.0).abs() < friction, "friction {errors:?}");
    }
}

/// A wall that keeps its heat is as warm as the friction of all gas makes it; heat that a wall gives goes through.
#[test]
fn walls_that_keep_heat_or_give_it_show_in_the_temperature() {
    let (prandtl, capacity) = (PRANDTL, HEAT_CAPACITY);
    let recovered = move |y: f64| {
        let from_above = 1.0 - y * y;
        1.0 + prandtl * SPEED * SPEED * from_above / (2.0 * capacity)
    };
    let kept = [WallHeat::Adiabatic, WallHeat::Temperature(1.0)];
    let mut simulation = start(couette(20, Extrapolation::Wom, kept, recovered));
    advance_to(&mut simulation, 6.0);
    let [u, t, friction] = errors(&simulation, recovered);
    assert!(
        u < 2e-3 && t < 0.04 && (friction - 1.0).abs() < 5e-3,
        "{u} {t} {friction}"
    );

    let conductivity = VISCOSITY * capacity / prandtl;
    let slope = 0.1;
    let heated = move |y: f64| recovered(y) + slope * (1.0 - y);
    let given = [
        WallHeat::Flux(conductivity * slope),
        WallHeat::Temperature(1.0),
    ];
    let mut simulation = start(couette(20, Extrapolation::Wom, given, heated));
    advance_to(&mut simulation, 6.0);
    let [u, t, _] = errors(&simulation, heated);
    assert!(u < 2e-3 && t < 0.02, "{u} {t}");
}

/// Heat that walls give is what the gas gains, and what the books have.
#[test]
fn heat_that_walls_give_is_booked() {
    let flux = 0.05;
    let mut problem = couette(16, Extrapolation::Wom, [WallHeat::Flux(flux); 2], |_| 1.0);
    problem.initial = Initial::FreeStream;
    problem.domain.sides[1] = [wall(WallHeat::Flux(flux), 0.0); 2];
    let mut simulation = start(problem);
    let before = simulation.totals().energy;
    advance_to(&mut simulation, 0.5);
    let gained = simulation.totals().energy - before;
    let given = 2.0 * flux * simulation.problem.domain.bounds.max[0] * simulation.time();
    assert!((gained / given - 1.0).abs() < 0.03, "{gained} of {given}");
    let booked = simulation.inflow().energy;
    // What pressure does at walls at rest is drift.
    assert!((booked / gained - 1.0).abs() < 0.02, "{booked} of {gained}");
    let width = simulation.problem.domain.bounds.max[0];
    for load in simulation.loads() {
        assert!((load.heat / (flux * width) - 1.0).abs() < 0.05, "{load:?}");
    }
}

/// A step is no longer than diffusion allows.
#[test]
fn steps_of_thick_gas_are_as_short_as_diffusion_asks() {
    let held = [WallHeat::Temperature(1.0); 2];
    let mut problem = couette(12, Extrapolation::Wom, held, |_| 1.0);
    let Gas::Ideal(gas) = &mut problem.gas else {
        unreachable!("it flows as an ideal gas")
    };
    gas.transport = Some(Transport {
        viscosity: Viscosity::Constant(5.0),
        prandtl: PRANDTL,
    });
    let mut simulation = start(problem);
    advance(&mut simulation, 300);
    // Friction has drawn the straight line that it began with, nothing else.
    let worst = simulation.fluid.iter().fold(0.0_f64, |worst, p| {
        worst.max((p.velocity[0] / SPEED - p.position[1]).abs())
    });
    assert!(worst < 0.01, "{worst}");
}

#[test]
fn viscous_gas_in_a_periodic_box_keeps_momentum_and_energy_to_round_off() {
    let mut problem = stirred::<2>(20);
    problem.gas = viscous();
    let mut inviscid = stirred::<2>(20);
    inviscid.gas = Gas::ideal(1.4);
    let mut simulations = [problem, inviscid].map(start);
    let before = simulations[0].totals();
    for simulation in &mut simulations {
        advance_to(simulation, 0.5);
    }
    let after = simulations[0].totals();
    assert!((after.energy / before.energy - 1.0).abs() < 1e-12);
    for k in 0..2 {
        let drift = after.momentum[k] - before.momentum[k];
        assert!(drift.abs() < 1e-12 * before.mass, "momentum drift {drift}");
    }
    // Friction has taken of the motion.
    let [viscous, inviscid] = simulations.map(|simulation| {
        let each = simulation.fluid.iter();
        each.map(|p| p.mass * p.velocity.norm_squared())
            .sum::<f64>()
    });
    assert!(viscous < 0.97 * inviscid, "{viscous} {inviscid}");
}

#[test]
fn viscous_gas_has_the_same_bits_for_any_number_of_threads() {
    let held = [WallHeat::Temperature(1.0); 2];
    let bits = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
        pool.build().expect("threads").install(|| {
            let mut simulation = start(couette(12, Extrapolation::Wom, held, warmed));
            advance(&mut simulation, 30);
            let each = simulation.fluid.iter();
            each.flat_map(|p| [p.velocity[0].to_bits(), p.energy.to_bits()])
                .collect::<Vec<_>>()
        })
    };
    assert_eq!(bits(1), bits(3));
}
