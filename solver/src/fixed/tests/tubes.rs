//! Waves along a line, in closed boxes and in streams.

use std::f64::consts::{PI, TAU};

use aero_geometry::Vector;

use super::lattice::{WALL, bent, field, lattice, problem};
use crate::fixed::FixedSimulation;
use crate::problem::{Initial, Problem, Side, State};

pub fn state<const D: usize>(density: f64, velocity: [f64; D], pressure: f64) -> State<D> {
    State {
        density,
        velocity: velocity.into(),
        pressure,
    }
}

pub fn flow<const D: usize>(problem: Problem<D>) -> FixedSimulation<D> {
    FixedSimulation::on(lattice(&problem), problem).unwrap()
}

pub fn march<const D: usize>(flow: &mut FixedSimulation<D>, end: f64) {
    while flow.time() < end {
        flow.step(end).unwrap();
    }
}

fn tube(count: usize) -> FixedSimulation<1> {
    let mut problem = problem([count], 1.0 / count as f64, [[WALL, WALL]]);
    problem.initial = Initial::Riemann {
        left: state(1.0, [0.0], 1.0),
        right: state(0.125, [0.0], 0.1),
        position: 0.5,
        smooth: false,
    };
    flow(problem)
}

/// Behind the reflected shock of Sod's tube: pressure 0.780386 and density 0.509395 (exact Riemann solutions), and what it
/// holds is what it held.
#[test]
fn sods_shock_comes_back_from_the_wall_as_it_should() {
    let mut flow = tube(200);
    let before = flow.totals();
    march(&mut flow, 0.375);
    assert_eq!(flow.time(), 0.375);
    let frame = flow.frame();
    let behind = |x: f64| (0.93..0.99).contains(&x);
    let cells = || (0..200).filter(|&i| behind(frame.position[i][0]));
    let mean = |values: &[f64]| cells().map(|i| values[i]).sum::<f64>() / cells().count() as f64;
    assert!((mean(&frame.pressure) / 0.780_386 - 1.0).abs() < 0.005);
    assert!((mean(&frame.density) / 0.509_395 - 1.0).abs() < 0.01);
    let after = flow.totals();
    assert!((after.mass / before.mass - 1.0).abs() < 1e-13);
    assert!((after.energy / before.energy - 1.0).abs() < 1e-13);
    // What the walls gave is what the gas has.
    assert!((after.momentum[0] - flow.inflow().momentum[0]).abs() < 1e-13);
}

/// Right side up and upside down, left to right and back.
#[test]
fn a_flow_and_its_mirror_image_stay_mirror_images() {
    let run = |sign: f64| {
        let mut problem = problem([20, 20], 0.05, [[WALL, WALL], [WALL, WALL]]);
        problem.initial = field(move |x: &Vector<2>| {
            let at = |x: f64| if sign > 0.0 { x } else { 1.0 - x };
            let push = (PI * at(x[0])).sin() * (TAU * x[1]).cos();
            state(1.0 + 0.3 * at(x[0]), [0.4 * sign * push, 0.2 * push], 1.0)
        });
        let mut flow = flow(problem);
        march(&mut flow, 0.3);
        flow.frame()
    };
    let (frame, mirrored) = (run(1.0), run(-1.0));
    let near = |a: [f64; 3], b: [f64; 3]| (0..2).all(|k| (a[k] - b[k]).abs() < 1e-9);
    for (position, density) in frame.position.iter().zip(&frame.density) {
        let image = [1.0 - position[0], position[1], 0.0];
        let there = mirrored.position.iter().position(|x| near(*x, image));
        let other = mirrored.density[there.unwrap()];
        assert!((density / other - 1.0).abs() < 1e-11, "{density} {other}");
    }
}

#[test]
fn gas_at_rest_in_a_box_stays_at_rest_about_an_axis_too() {
    for lower in [WALL, Side::Axis] {
        let problem = problem([12, 9], 0.1, [[WALL, WALL], [lower, WALL]]);
        let mut flow = flow(problem);
        march(&mut flow, 1.0);
        let frame = flow.frame();
        let speeds = frame.velocity.iter().flatten().map(|u| u.abs());
        assert!(speeds.fold(0.0, f64::max) < 1e-13);
    }
}

/// The advected vortex of Shu (1998) comes back after one period; its error falls with the square of the spacing.
#[test]
fn a_vortex_is_carried_with_second_order() {
    let error = |count: usize| {
        let mut problem = problem(
            [count, count],
            10.0 / count as f64,
            [[Side::Periodic; 2]; 2],
        );
        problem.initial = field(|x: &Vector<2>| {
            let (x, y) = (x[0] - 5.0, x[1] - 5.0);
            let hump = (1.0 - x * x - y * y).exp();
            let swirl = 5.0 / TAU * hump.sqrt();
            let heat = 1.0 - 0.4 * 25.0 / (8.0 * 1.4 * PI * PI) * hump;
            let velocity = [1.0 - swirl * y, 1.0 + swirl * x];
            state(heat.powf(2.5), velocity, heat.powf(3.5))
        });
        let mut flow = flow(problem);
        let before = flow.frame().density;
        march(&mut flow, 10.0);
        let after = flow.frame().density;
        let errors = before.iter().zip(&after).map(|(a, b)| (a - b).abs());
        errors.sum::<f64>() / (count * count) as f64
    };
    let order = (error(32) / error(64)).log2();
    assert!(order > 1.8, "order {order}");
}

/// Oblique shock of 20 degrees at Mach 2.5: 3.2109 times the pressure, 2.2002 times the density.
#[test]
fn a_ramp_settles_where_it_marches_to() {
    let ramp = || {
        let sides = [[Side::Inlet, Side::Outlet], [WALL, Side::FreeStream]];
        let mut problem = problem([32, 24], 0.125, sides);
        problem.free_stream = state(1.0, [2.5, 0.0], 1.0 / 1.4);
        let tangent = 20_f64.to_radians().tan();
        let cells = bent(&problem, [32, 24], |a, b| {
            let rise = (4.0 * a - 1.0).max(0.0) * tangent;
            Vector::<2>::new(4.0 * a, rise + b * (3.0 - rise))
        });
        FixedSimulation::on(cells, problem).unwrap()
    };
    let mut marched = ramp();
    march(&mut marched, 10.0);
    let mut settled = ramp();
    let end = settled.settle(1000).unwrap();
    assert!(end.is_settled, "{end:?}");
    for flow in [marched, settled] {
        let surface = flow.surface();
        let on_ramp = surface.position.iter().zip(&surface.pressure);
        let pressures: Vec<f64> = on_ramp
            .filter(|(x, _)| (2.0..3.5).contains(&x[0]))
            .map(|(_, p)| p * 1.4)
            .collect();
        let mean = pressures.iter().sum::<f64>() / pressures.len() as f64;
        assert!((mean / 3.2109 - 1.0).abs() < 0.005, "{mean}");
    }
}

#[test]
fn a_flow_goes_on_from_its_memory_with_the_same_bits_on_any_number_of_threads() {
    let start = || {
        let mut problem = problem([40, 40], 0.025, [[Side::Inlet, Side::Outlet], [WALL, WALL]]);
        problem.free_stream = state(1.0, [2.0, 0.0], 1.0 / 1.4);
        problem.initial = field(|x: &Vector<2>| state(1.0 + x[1], [2.0, 0.3 * x[0]], 1.0));
        problem
    };
    let pool = |threads| {
        let builder = rayon::ThreadPoolBuilder::new().num_threads(threads);
        builder.build().unwrap()
    };
    let (first, second) = (pool(1), pool(3));
    let mut whole = flow(start());
    first.install(|| {
        (0..6).for_each(|_| {
            whole.step(1e9).unwrap();
        });
    });
    let mut begun = flow(start());
    let mut resumed = second.install(|| {
        (0..3).for_each(|_| {
            begun.step(1e9).unwrap();
        });
        let problem = start();
        FixedSimulation::resume_on(lattice(&problem), problem, begun.memory()).unwrap()
    });
    second.install(|| {
        (0..3).for_each(|_| {
            resumed.step(1e9).unwrap();
        });
    });
    assert_eq!(whole.frame(), resumed.frame());
    assert_eq!(whole.loads(), resumed.loads());
}

/// Two streams that part at Mach 4 leave next to nothing behind, and no floor holds it.
#[test]
fn streams_that_part_stay_positive() {
    let mut problem = problem([400], 0.0025, [[Side::Outlet; 2]]);
    problem.initial = Initial::Riemann {
        left: state(1.0, [-4.0], 1.0 / 1.4),
        right: state(1.0, [4.0], 1.0 / 1.4),
        position: 0.5,
        smooth: false,
    };
    let mut flow = flow(problem);
    march(&mut flow, 0.06);
    let statistics = flow.statistics();
    let least = statistics.min_density;
    assert!(least > 0.0 && least < 0.01, "{least}");
}

#[test]
fn what_moves_sticks_or_is_empty_is_refused_by_name() {
    let piston = Side::Wall {
        kind: crate::problem::WallKind::Slip,
        velocity: 1.0,
        acceleration: 0.0,
    };
    let moving = problem([4], 0.25, [[piston, WALL]]);
    let refused = FixedSimulation::on(lattice(&moving), moving).unwrap_err();
    assert!(refused.starts_with("side `x_min` moves"), "{refused}");
    let mut empty = problem([4], 0.25, [[WALL, WALL]]);
    empty.initial = field(|_: &Vector<1>| state(0.0, [0.0], 0.0));
    let refused = FixedSimulation::on(lattice(&empty), empty).unwrap_err();
    assert!(refused.starts_with("there is a vacuum"), "{refused}");
}

/// A tube as a strip of so many cells, periodic across.
fn strip(across: usize) -> Vec<f64> {
    let count = 40;
    let dx = 1.0 / count as f64;
    let sides = [[WALL, WALL], [Side::Periodic; 2]];
    let mut problem = problem([count, across], dx, sides);
    problem.initial = Initial::Riemann {
        left: state(1.0, [0.0; 2], 1.0),
        right: state(0.125, [0.0; 2], 0.1),
        position: 0.5,
        smooth: false,
    };
    let mut flow = FixedSimulation::new(problem).unwrap();
    march(&mut flow, 0.1);
    let frame = flow.frame();
    let mut row: Vec<(f64, f64)> = (0..frame.position.len())
        .filter(|&i| frame.position[i][1] < dx)
        .map(|i| (frame.position[i][0], frame.density[i]))
        .collect();
    row.sort_by(|a, b| a.0.total_cmp(&b.0));
    assert_eq!(row.len(), count);
    row.into_iter().map(|(_, density)| density).collect()
}

/// Cells that meet their own images across a narrow box do as those of a wide one, and a single row as a line, up to what stands for the
/// neighbours that it has none of.
#[test]
fn a_periodic_box_may_be_as_narrow_as_a_cell() {
    let off = |a: &[f64], b: &[f64]| {
        let pairs = a.iter().zip(b);
        pairs.fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()))
    };
    let mut line = tube(40);
    march(&mut line, 0.1);
    assert!(off(&strip(1), &line.frame().density) < 1e-9);
    let wide = strip(6);
    for across in [2, 3] {
        assert!(off(&strip(across), &wide) < 1e-13, "{across}");
    }
}
