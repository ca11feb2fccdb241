//! Viscous gas that slides past walls and past itself.

use std::sync::Arc;

use aero_geometry::{Bounds, Placed, Placement, Shape, Vector, bodies};

use super::jumps::around;
use super::lattice::{field, lattice, problem};
use super::viscous::{gas, is_inside, sticky};
use super::{Scene, domain};
use crate::fixed::FixedSimulation;
use crate::gas::{Gas, IdealGas, Transport, Viscosity};
use crate::method::{FixedPoints, Method, Time};
use crate::problem::{NoSlip, Side, Slide, State, WallHeat, WallKind};
use crate::tests::slip_body;

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
                    share.temperature,
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
/// points. That is so of viscous gas, and of any that settles, be it slower or faster than sound.
#[test]
fn a_shear_neither_gathers_nor_thins_where_two_spacings_meet() {
    let settling = Method::Fixed(FixedPoints {
        time: Time::Settle,
        ..FixedPoints::default()
    });
    let marching = Method::Fixed(FixedPoints::default());
    // The last in another unit of length.
    for (gas, method, speed, unit) in [
        (gas(1e-3, 0.72), marching, 1.0, 1.0),
        (Gas::ideal(1.4), settling, 0.6, 1.0),
        (Gas::ideal(1.4), settling, 3.0, 1.0),
        (Gas::ideal(1.4), settling, 3.0, 1e3),
    ] {
        let square = domain([-unit; 2], [unit; 2]);
        let scene = Scene::new(square.clone(), Vec::new(), 0.125 * unit);
        let levels = around(&scene, Vector::<2>::new(-0.1, 0.05) * unit, 2, 2);
        let cells = scene.made_with(&levels).cells;
        let skew = cells.faces.iter().map(|face| face.skew.norm());
        assert!(skew.fold(0.0, f64::max) > 0.01 * unit);
        let mut problem = problem::<2>([16; 2], 0.125 * unit, [[Side::FreeStream; 2]; 2]);
        problem.domain = square;
        problem.gas = gas;
        problem.method = method;
        problem.free_stream = State {
            density: 1.0,
            velocity: [speed, 0.25].into(),
            pressure: 1.0,
        };
        problem.initial = field(move |x: &Vector<2>| State {
            density: 1.0,
            velocity: [speed + 0.5 * x[1] / unit, 0.25].into(),
            pressure: 1.0,
        });
        let mut flow = FixedSimulation::on(cells, problem.clone()).unwrap();
        flow.find_slopes();
        flow.exchange(|_, part, gains| part.before.copy_from_slice(&gains.cells));
        let mut seen = 0;
        for (i, gain) in flow.columns.before.iter().enumerate() {
            if is_inside(&problem, &flow.points[i], 2.0) {
                seen += 1;
                let rate = gain.mass / flow.net.cell(i).volume * unit;
                assert!(rate.abs() < 1e-12, "{speed} {:?} {rate:e}", flow.points[i]);
            }
        }
        assert!(seen > 150);
    }
}

/// Gas that is sheared alike along a wall which cuts cells askew gets no faster and no slower anywhere, and is warmed by its friction alone: sheared gas takes
/// momentum through faces askew to it that the gas at their middles does not.
#[test]
fn a_shear_along_a_wall_askew_to_the_lattice_goes_on() {
    const VISCOSITY: f64 = 0.02;
    const SHEAR: f64 = 0.8;
    for degrees in [0.0_f64, 20.0, 45.0, 67.0] {
        let (sin, cos) = degrees.to_radians().sin_cos();
        let [along, up] = [[cos, sin], [-sin, cos]].map(Vector::from);
        let surface = Vector::<2>::new(0.0, 0.013);
        let mut problem = problem::<2>([1; 2], 0.1, [[Side::FreeStream; 2]; 2]);
        problem.domain.bounds = Bounds::new([-1.0; 2].into(), [1.0; 2].into());
        problem.gas = gas(VISCOSITY, 0.72);
        let place = Placement::<2>::default()
            .rotated(degrees.to_radians())
            .moved(surface - up);
        let block = Arc::new(bodies::rectangle(8.0, 2.0, 0.0).unwrap()) as Arc<dyn Shape<2>>;
        let mut body = slip_body(Arc::new(Placed::new(block, place)));
        body.wall = WallKind::NoSlip(NoSlip {
            heat: WallHeat::Adiabatic,
            slide: Slide::default(),
        });
        problem.bodies = vec![body];
        problem.initial = field(move |x: &Vector<2>| State {
            density: 1.0,
            velocity: along * (SHEAR * (x - surface).dot(&up)),
            pressure: 1.0,
        });
        let mut flow = FixedSimulation::new(problem.clone()).unwrap();
        flow.find_slopes();
        flow.exchange(|_, part, gains| part.before.copy_from_slice(&gains.cells));
        let walls = flow.net.blocks.iter().flat_map(|block| &block.walls);
        let mut seen: Vec<usize> = walls.map(|wall| wall.i as usize).collect();
        seen.retain(|&i| is_inside(&problem, &flow.points[i], 3.0));
        assert!(seen.len() > 10, "{degrees}: {}", seen.len());
        for (i, gain) in flow.columns.before.iter().enumerate() {
            if !is_inside(&problem, &flow.points[i], 3.0) {
                continue;
            }
            let [mass, x, y, energy] = [gain.mass, gain.momentum[0], gain.momentum[1], gain.energy]
                .map(|gain| gain / flow.net.cell(i).volume);
            let more = energy - VISCOSITY * SHEAR * SHEAR;
            let most = [mass, x, y, more].map(f64::abs);
            let place = flow.points[i];
            assert!(most.iter().all(|m| *m < 1e-8), "{degrees} {place} {most:?}");
        }
    }
}

/// Gas that turns with its wall is not sheared, be the wall round.
#[test]
fn gas_that_turns_with_its_wall_does_not_rub_on_it() {
    const RATE: f64 = 0.4;
    let mut problem = problem::<2>([1; 2], 0.1, [[Side::FreeStream; 2]; 2]);
    problem.domain.bounds = Bounds::new([-1.0; 2].into(), [1.0; 2].into());
    problem.gas = gas(0.02, 0.72);
    let mut body = slip_body(Arc::new(bodies::circle(0.53).unwrap()) as Arc<dyn Shape<2>>);
    body.wall = WallKind::NoSlip(NoSlip {
        heat: WallHeat::Adiabatic,
        slide: Slide {
            turning: [0.0, 0.0, RATE],
            ..Slide::default()
        },
    });
    problem.bodies = vec![body];
    problem.initial = field(|x: &Vector<2>| State {
        density: 1.0,
        velocity: [-RATE * x[1], RATE * x[0]].into(),
        pressure: 1.0,
    });
    let mut flow = FixedSimulation::new(problem).unwrap();
    flow.find_slopes();
    flow.exchange(|_, _, _| {});
    let mut seen = 0;
    for (block, shares) in flow.net.blocks.iter().zip(&flow.columns.shares) {
        for (wall, share) in block.walls.iter().zip(shares) {
            seen += usize::from(wall.stick.is_some());
            let stress = Vector::from(share.stress).norm();
            assert!(stress < 1e-12, "{:?} {stress:e}", wall.foot);
            assert!((share.temperature - 1.0).abs() < 1e-12);
        }
    }
    assert!(seen > 30, "{seen}");
}

/// Gas between a hot and a cold wall comes to rest with all of its mass: `p = rho R (T_2 - T_1) / ln(T_2 / T_1)` where temperatures lie on a line.
#[test]
fn gas_that_is_closed_in_settles_with_the_mass_that_it_began_with() {
    let [cold, hot] = [0.6, 1.8];
    let walls = [cold, hot].map(|temperature| sticky(WallHeat::Temperature(temperature), 0.0));
    let mut problem = problem([2, 24], 1.0 / 24.0, [[Side::Periodic; 2], walls]);
    problem.gas = gas(0.02, 0.72);
    problem.method = Method::Fixed(FixedPoints {
        time: Time::Settle,
        ..FixedPoints::default()
    });
    let mut flow = FixedSimulation::on(lattice(&problem), problem).unwrap();
    let (before, _) = flow.mass_and_centre();
    assert!(flow.settle(20_000).unwrap().is_settled);
    let (after, _) = flow.mass_and_centre();
    assert!((after / before - 1.0).abs() < 1e-12, "{before} {after}");
    let pressure = (hot - cold) / (hot / cold).ln();
    for state in &flow.columns.states {
        assert!((state.pressure / pressure - 1.0).abs() < 2e-3, "{state:?}");
    }
}
