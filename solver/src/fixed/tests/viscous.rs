//! Viscous flows against their exact solutions: every term of the stress, walls that gas sticks to, rings about an axis.

use std::f64::consts::PI;
use std::sync::Arc;

use aero_geometry::Vector;
use approx::assert_relative_eq;

use super::jumps::around;
use super::lattice::{field, lattice, problem};
use super::{Scene, domain};
use crate::fixed::FixedSimulation;
use crate::fixed::state::Conserved;
use crate::gas::{Gas, IdealGas, Transport, Viscosity};
use crate::method::{FixedPoints, Method, Time};
use crate::problem::{Added, NoSlip, Problem, Side, Slide, Source, State, WallHeat, WallKind};

fn gas(viscosity: f64, prandtl: f64) -> Gas {
    Gas::Ideal(IdealGas {
        gamma: 1.4,
        constant: 1.0,
        transport: Some(Transport {
            viscosity: Viscosity::Constant(viscosity),
            prandtl,
        }),
    })
}

fn sticky(heat: WallHeat, velocity: f64) -> Side {
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

/// What viscosity and heat conduction give each cell per volume: the gains with them less those without.
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
    let (points, with) = gains(problem);
    let mut without = problem.clone();
    without.gas = Gas::ideal(1.4);
    let (_, without) = gains(&without);
    let rubbed = with.iter().zip(&without).map(|(a, b)| a.plus(-1.0, b));
    (points, rubbed.collect())
}

/// Cells at least so many spacings from the sides.
fn is_inside<const D: usize>(problem: &Problem<D>, point: &Vector<D>, depth: f64) -> bool {
    let bounds = &problem.domain.bounds;
    (0..D).all(|k| {
        point[k] - bounds.min[k] > depth * problem.spacing
            && bounds.max[k] - point[k] > depth * problem.spacing
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
        let errors = [8, 16, 32].map(|cells| driven(cells, is_pipe));
        let order = (errors[1] / errors[2]).log2();
        println!("{is_pipe} {errors:?} {order}");
        assert!((1.9..2.15).contains(&order), "{is_pipe} {errors:?} {order}");
        assert!(errors[2] < 5e-3, "{errors:?}");
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

/// Air between a wall at 300 K and one that slides at a Mach number, both of this temperature or the sliding one adiabatic: shear over
/// `mu_w U / H`, and temperature of the sliding wall.
fn couette(mach: f64, is_adiabatic: bool, cells: usize) -> (f64, f64) {
    const R: f64 = 287.05;
    let temperature = 300.0;
    let speed = mach * (1.4 * R * temperature).sqrt();
    let viscosity = Viscosity::AIR.at(temperature);
    let (density, height) = (1.0, 100.0 * viscosity / speed);
    let held = WallHeat::Temperature(temperature);
    let above = if is_adiabatic {
        WallHeat::Adiabatic
    } else {
        held
    };
    let spacing = height / cells as f64;
    let sides = [
        [Side::Periodic; 2],
        [sticky(held, 0.0), sticky(above, speed)],
    ];
    let mut problem = problem([2, cells], spacing, sides);
    problem.gas = Gas::Ideal(IdealGas {
        gamma: 1.4,
        constant: R,
        transport: Some(Transport {
            viscosity: Viscosity::AIR,
            prandtl: 0.72,
        }),
    });
    problem.free_stream = State {
        density,
        velocity: Vector::zeros(),
        pressure: density * R * temperature,
    };
    problem.initial = field(move |x: &Vector<2>| State {
        density,
        velocity: [speed * x[1] / height, 0.0].into(),
        pressure: density * R * temperature,
    });
    problem.method = Method::Fixed(FixedPoints {
        time: Time::Settle,
        ..FixedPoints::default()
    });
    let mut flow = FixedSimulation::on(lattice(&problem), problem).unwrap();
    assert!(flow.settle(20_000).unwrap().is_settled);
    let mut found = (0.0, 0.0);
    for (block, shares) in flow.net.blocks.iter().zip(&flow.columns.shares) {
        for (wall, share) in block.walls.iter().zip(shares) {
            if wall.image.normal[1] > 0.0 {
                found = (
                    share.stress[0] * height / (viscosity * speed),
                    share.level / R,
                );
            }
        }
    }
    found
}

/// `T = T_w + Pr (U u - u^2) / (2 c_p)` whatever the viscosity does, and `tau H = integral of mu du`.
#[test]
fn air_between_walls_one_of_which_slides_heats_up_as_it_should() {
    for (mach, shear) in [(0.5, 1.0046), (2.0, 1.0718), (3.0, 1.1567)] {
        let (found, _) = couette(mach, false, 24);
        println!("Mach {mach}: {found} {shear}");
        assert!((found / shear - 1.0).abs() < 5e-3, "{mach} {found} {shear}");
        // The cell next to the wall alone would be off by a hundredth, and a flow that had settled before its wall is warm by a thousandth.
        let (_, hot) = couette(mach, true, 8);
        let expected = 300.0 * (1.0 + 0.72 * 0.2 * mach * mach);
        println!("Mach {mach}: {hot} {expected}");
        assert!(
            (hot / expected - 1.0).abs() < 2e-4,
            "{mach} {hot} {expected}"
        );
    }
}

/// Gas that slides past gas gathers nowhere, whatever the faces look like that it goes through: askew ones lie aside of the line between their
/// points.
#[test]
fn a_shear_neither_gathers_nor_thins_where_two_spacings_meet() {
    let square = domain([-1.0, -1.0], [1.0, 1.0]);
    let scene = Scene::new(square.clone(), Vec::new(), 0.125);
    let levels = around(&scene, Vector::<2>::new(-0.1, 0.05), 2, 2);
    let cells = scene.made_with(&levels).cells;
    let skew = cells.faces.iter().map(|face| face.skew.norm());
    assert!(skew.fold(0.0, f64::max) > 0.01);
    let mut problem = problem::<2>([16; 2], 0.125, [[Side::FreeStream; 2]; 2]);
    problem.domain = square;
    problem.gas = gas(1e-3, 0.72);
    problem.initial = field(|x: &Vector<2>| State {
        density: 1.0,
        velocity: [1.0 + 0.5 * x[1], 0.25].into(),
        pressure: 1.0,
    });
    let mut flow = FixedSimulation::on(cells, problem.clone()).unwrap();
    flow.find_slopes();
    flow.exchange(|_, part, gains| part.before.copy_from_slice(&gains.cells));
    let mut seen = 0;
    for (i, gain) in flow.columns.before.iter().enumerate() {
        if is_inside(&problem, &flow.points[i], 2.0) {
            seen += 1;
            let rate = gain.mass / flow.net.cell(i).volume;
            assert!(rate.abs() < 1e-12, "{:?} {rate:e}", flow.points[i]);
        }
    }
    assert!(seen > 150);
}
