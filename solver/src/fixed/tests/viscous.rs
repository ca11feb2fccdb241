//! Viscous flows against their exact solutions: every term of the stress, walls that gas sticks to, rings about an axis.

use std::f64::consts::PI;
use std::sync::Arc;

use aero_geometry::Vector;
use approx::assert_relative_eq;

use super::lattice::{field, lattice, problem};
use crate::fixed::FixedSimulation;
use crate::fixed::state::Conserved;
use crate::gas::{Gas, IdealGas, Transport, Viscosity};
use crate::problem::{Added, NoSlip, Problem, Side, Slide, Source, State, WallHeat, WallKind};

pub fn gas(viscosity: f64, prandtl: f64) -> Gas {
    Gas::Ideal(IdealGas {
        gamma: 1.4,
        constant: 1.0,
        transport: Some(Transport {
            viscosity: Viscosity::Constant(viscosity),
            prandtl,
        }),
    })
}

pub fn sticky(heat: WallHeat, velocity: f64) -> Side {
    Side::Wall {
        kind: WallKind::NoSlip(NoSlip {
            heat,
            slide: Slide {
                velocity: [velocity, 0.0, 0.0],
                ..Slide::default()
            },
        }),
        velocity: 0.0,
        acceleration: 0.0,
    }
}

/// The same acceleration everywhere.
#[derive(Debug)]
struct Push<const D: usize>(Vector<D>);

impl<const D: usize> Source<D> for Push<D> {
    fn at(&self, _: &Vector<D>, _: f64) -> Added<D> {
        Added {
            density: 0.0,
            acceleration: self.0,
            heating: 0.0,
        }
    }
}

/// What viscosity and heat conduction give each cell per volume: the gains with twice as much of both less those with what `problem` has.
fn rubbed<const D: usize>(problem: &Problem<D>) -> (Vec<Vector<D>>, Vec<Conserved<D>>) {
    let gains = |problem: &Problem<D>| {
        let cells = lattice(problem);
        let mut flow = FixedSimulation::on(cells, problem.clone()).unwrap();
        flow.find_slopes();
        flow.exchange(|net, part, gains| {
            for (k, gain) in gains.cells.iter().enumerate() {
                part.before[k] = Conserved::ZERO.plus(1.0 / net.cell(part.start + k).volume, gain);
            }
        });
        (flow.points.clone(), flow.columns.before.clone())
    };
    let mut thicker = problem.clone();
    if let Gas::Ideal(IdealGas {
        transport: Some(Transport { viscosity, .. }),
        ..
    }) = &mut thicker.gas
    {
        *viscosity = Viscosity::Constant(2.0 * viscosity.at(1.0));
    }
    let (points, once) = gains(problem);
    let (_, twice) = gains(&thicker);
    let rubbed = twice.iter().zip(&once).map(|(a, b)| a.plus(-1.0, b));
    (points, rubbed.collect())
}

/// Cells at least so many spacings from the sides.
pub fn is_inside<const D: usize>(problem: &Problem<D>, point: &Vector<D>, depth: f64) -> bool {
    let bounds = &problem.domain.bounds;
    (0..D).all(|k| {
        point[k] - bounds.min[k] > depth * problem.resolution.lattice()
            && bounds.max[k] - point[k] > depth * problem.resolution.lattice()
    })
}

/// `div tau = mu (lap u + grad div u / 3)`, which second-order differences of a quadratic velocity give exactly.
#[test]
fn all_terms_of_the_stress_are_there_in_space() {
    const MU: f64 = 0.7;
    let mut problem = problem::<3>([7; 3], 0.1, [[Side::FreeStream; 2]; 3]);
    problem.gas = gas(MU, 0.72);
    problem.initial = field(|x: &Vector<3>| State {
        density: 1.0,
        velocity: [
            0.3 * x[0] * x[0] + 0.5 * x[1] * x[1] - 0.2 * x[2] * x[2]
                + 0.7 * x[0] * x[1]
                + 0.4 * x[0] * x[2],
            -0.6 * x[1] * x[1] + 0.9 * x[0] * x[1] + 0.25 * x[1] * x[2] + 0.1 * x[0] * x[0],
            0.8 * x[2] * x[2] + 0.35 * x[0] * x[2] - 0.45 * x[1] * x[2] + 0.15 * x[0] * x[1],
        ]
        .into(),
        pressure: 1.0,
    });
    // Laplacians 2 (0.3 + 0.5 - 0.2), 2 (-0.6 + 0.1), 2 * 0.8; div u = (0.6 + 0.9 + 0.35) x + (0.7 - 1.2 - 0.45) y + (0.4 + 0.25 + 1.6) z.
    let expected = [
        MU * (1.2 + 1.85 / 3.0),
        MU * (-1.0 - 0.95 / 3.0),
        MU * (1.6 + 2.25 / 3.0),
    ];
    let (points, gains) = rubbed(&problem);
    let mut seen = 0;
    for (point, gain) in points.iter().zip(&gains) {
        if is_inside(&problem, point, 2.0) {
            seen += 1;
            assert_eq!(gain.mass, 0.0);
            for k in 0..3 {
                assert_relative_eq!(gain.momentum[k], expected[k], epsilon = 1e-10);
            }
        }
    }
    assert_eq!(seen, 27);
}

/// `div (tau u) + k lap T`: in a shear `u = y^2` of constant density and `p = 1 + y^2 / 2`, `mu (u u')' = 6 mu y^2` and, with
/// `k T = mu gamma / ((gamma - 1) Pr) p / rho`, that times one.
#[test]
fn friction_works_and_heat_is_conducted() {
    const MU: f64 = 0.7;
    let mut problem = problem::<2>([8, 8], 0.1, [[Side::FreeStream; 2]; 2]);
    problem.gas = gas(MU, 0.5);
    problem.initial = field(|x: &Vector<2>| State {
        density: 1.0,
        velocity: [x[1] * x[1], 0.0].into(),
        pressure: 1.0 + 0.5 * x[1] * x[1],
    });
    let conduction = MU * 1.4 / (0.4 * 0.5);
    let (points, gains) = rubbed(&problem);
    for (point, gain) in points.iter().zip(&gains) {
        if is_inside(&problem, point, 2.0) {
            let y = point[1];
            let expected = MU * 6.0 * y * y + conduction;
            // Differences of u u' make y^2 + h^2 / 4 and the like of y^2.
            assert_relative_eq!(gain.energy, expected, epsilon = 0.02 * MU);
        }
    }
}

/// About an axis `v = a r` strains all the same and gives no force, `v = r^2` gives `mu d/dr (1/r d(r v)/dr) 4/3 = 4 mu`.
#[test]
fn rings_are_drawn_out_as_the_gas_goes_outwards() {
    const MU: f64 = 0.3;
    let sides = [[Side::Periodic; 2], [Side::Axis, Side::FreeStream]];
    for (power, expected) in [(1, 0.0), (2, 4.0 * MU)] {
        let mut problem = problem::<2>([6, 12], 0.1, sides);
        problem.gas = gas(MU, 0.72);
        problem.initial = field(move |x: &Vector<2>| State {
            density: 1.0,
            velocity: [0.0, x[1].powi(power)].into(),
            pressure: 1.0,
        });
        let (points, gains) = rubbed(&problem);
        for (point, gain) in points.iter().zip(&gains) {
            if point[1] > 0.25 && point[1] < 1.0 {
                // Cells of rings are of second order.
                let slack = if power == 1 {
                    1e-10
                } else {
                    0.02 * 4.0 * MU * (0.1 / point[1]).max(0.1)
                };
                assert!(
                    (gain.momentum[1] - expected).abs() < slack,
                    "{power} {point} {} {expected}",
                    gain.momentum[1]
                );
                assert_relative_eq!(gain.momentum[0], 0.0, epsilon = 1e-12);
            }
        }
    }
}

fn marched<const D: usize>(problem: Problem<D>, end: f64) -> FixedSimulation<D> {
    let cells = lattice(&problem);
    let mut flow = FixedSimulation::on(cells, problem).unwrap();
    while flow.time() < end {
        flow.step(end).unwrap();
    }
    flow
}

/// Gas that a force drives between walls at the same temperature, from its exact profile `u = g y (H - y) / (2 nu)`: the error
/// of its speed after a while, by the number of cells.
fn driven(cells: usize, is_pipe: bool) -> f64 {
    const VISCOSITY: f64 = 0.5;
    const PUSH: f64 = 0.02;
    let spacing = 1.0 / cells as f64;
    let wall = sticky(WallHeat::Temperature(1.0 / 1.4), 0.0);
    let lower = if is_pipe { Side::Axis } else { wall };
    let mut problem = problem([4, cells], spacing, [[Side::Periodic; 2], [lower, wall]]);
    problem.gas = gas(VISCOSITY, 0.72);
    problem.source = Some(Arc::new(Push([PUSH, 0.0].into())));
    let exact = move |y: f64| {
        let form = if is_pipe {
            0.25 * (1.0 - y * y)
        } else {
            0.5 * y * (1.0 - y)
        };
        PUSH / VISCOSITY * form
    };
    problem.initial = field(move |x: &Vector<2>| State {
        density: 1.0,
        velocity: [exact(x[1]), 0.0].into(),
        pressure: 1.0 / 1.4,
    });
    let flow = marched(problem, 1.0);
    let errors = flow.points.iter().zip(&flow.columns.states);
    let (mut sum, mut norm) = (0.0, 0.0);
    for (point, state) in errors {
        let exact = exact(point[1]);
        sum += (state.velocity[0] - exact).powi(2);
        norm += exact * exact;
    }
    (sum / norm).sqrt()
}

#[test]
fn flow_between_plates_and_in_a_pipe_converges_with_second_order() {
    for is_pipe in [false, true] {
        let errors = [5, 10, 20].map(|cells| driven(cells, is_pipe));
        let order = (errors[1] / errors[2]).log2();
        println!("{is_pipe} {errors:?} {order}");
        assert!((1.9..2.15).contains(&order), "{is_pipe} {errors:?} {order}");
        assert!(errors[2] < 1.3e-2, "{errors:?}");
    }
}

/// Vortices decay as `exp(-2 nu k^2 t)` [Taylor & Green 1937].
#[test]
fn vortices_decay_as_fast_as_they_should() {
    const VISCOSITY: f64 = 0.02;
    let wave = 2.0 * PI;
    let cells = 32;
    let mut problem = problem::<2>([cells; 2], 1.0 / cells as f64, [[Side::Periodic; 2]; 2]);
    problem.gas = gas(VISCOSITY, 0.72);
    let speed = 0.05;
    problem.initial = field(move |x: &Vector<2>| {
        let [a, b] = [wave * x[0], wave * x[1]];
        State {
            density: 1.0,
            velocity: [speed * a.sin() * b.cos(), -speed * a.cos() * b.sin()].into(),
            pressure: 1.0 / 1.4 + 0.25 * speed * speed * ((2.0 * a).cos() + (2.0 * b).cos()),
        }
    });
    let energy = |flow: &FixedSimulation<2>| {
        let speeds = flow
            .columns
            .states
            .iter()
            .map(|s| s.velocity[0].powi(2) + s.velocity[1].powi(2));
        speeds.sum::<f64>()
    };
    let before = energy(&FixedSimulation::on(lattice(&problem), problem.clone()).unwrap());
    let end = 0.5;
    let after = energy(&marched(problem, end));
    let rate = (before / after).ln() / (4.0 * VISCOSITY * wave * wave * end);
    println!("decay over exact {rate}");
    assert!((rate - 1.0).abs() < 0.02, "{rate}");
}

/// Temperatures of viscous gas that lie on a line are seen so, up to a wall at its end, whatever densities that makes.
#[test]
fn a_line_of_temperatures_is_one_beside_a_wall_too() {
    const RISE: f64 = 4.0;
    let wall = sticky(WallHeat::Temperature(1.0), 0.0);
    let sides = [[Side::Periodic; 2], [wall, Side::FreeStream]];
    let mut problem = problem::<2>([6, 8], 0.1, sides);
    problem.gas = gas(0.02, 0.72);
    problem.initial = field(|x: &Vector<2>| State {
        density: 1.0 / (1.0 + RISE * x[1]),
        velocity: Vector::zeros(),
        pressure: 1.0,
    });
    let mut flow = FixedSimulation::on(lattice(&problem), problem).unwrap();
    flow.find_slopes();
    for (i, point) in flow.points.iter().enumerate() {
        if point[1] < 0.6 {
            let state = &flow.columns.states[i];
            let [_, up] = flow.columns.slopes[i].along;
            assert_relative_eq!(state.warming(&up), RISE, epsilon = 1e-10);
        }
    }
}
