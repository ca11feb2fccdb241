//! Waves that a march follows over lattices: how far crests stay as high as they are, and what is no wave.

use std::f64::consts::TAU;
use std::sync::Arc;

use aero_geometry::{Vector, bodies};

use super::flows::stream;
use super::lattice::{WALL, bent, field, lattice, problem};
use crate::fixed::{Cells, FixedSimulation};
use crate::problem::{Problem, Side, State};

fn march<const D: usize>(flow: &mut FixedSimulation<D>, end: f64) {
    while flow.time() < end {
        flow.step(end).expect("the flow is tame");
    }
}

/// Densities in a stream of unit speed and sound, one length on along a periodic line of so many cells.
fn carried(count: usize, density: fn(f64) -> f64) -> (Vec<f64>, Vec<f64>) {
    let spacing = 1.0 / count as f64;
    let mut problem = problem([count], spacing, [[Side::Periodic; 2]]);
    // Cells hold means.
    problem.initial = field(move |x: &Vector<1>| {
        let places = (0..50).map(|k| x[0] + spacing * ((f64::from(k) + 0.5) / 50.0 - 0.5));
        State {
            density: places.map(density).sum::<f64>() / 50.0,
            velocity: Vector::<1>::new(1.0),
            pressure: 1.0 / 1.4,
        }
    });
    let mut flow = on_cells(lattice(&problem), problem);
    let before = flow.frame().density;
    march(&mut flow, 1.0);
    (before, flow.frame().density)
}

#[test]
fn waves_of_density_are_carried_with_third_order_and_keep_their_crests() {
    let wave = |x: f64| 1.0 + 0.2 * (TAU * x).sin();
    let error = |count| {
        let (before, after) = carried(count, wave);
        let errors = before.iter().zip(&after).map(|(a, b)| (a - b).abs());
        errors.sum::<f64>() / (0.2 * count as f64)
    };
    let errors = [10, 20, 40].map(error);
    let orders = [0, 1].map(|k| (errors[k] / errors[k + 1]).log2());
    assert!(orders.iter().all(|order| *order > 2.8), "{errors:?}");
    assert!(errors[0] < 0.07, "{errors:?}");
    let (before, after) = carried(20, wave);
    let crest = |rho: &[f64]| rho.iter().fold(0.0_f64, |most, rho| most.max(*rho)) - 1.0;
    assert!(crest(&after) > 0.985 * crest(&before), "{after:?}");
}

/// What is too short for cells to follow, or is none, is not taken for a wave: nothing rings at a jump.
#[test]
fn jumps_of_density_do_not_ring() {
    let (_, after) = carried(100, |x| if (0.25..0.75).contains(&x) { 2.0 } else { 1.0 });
    let most = after.iter().fold(0.0_f64, |most, rho| most.max(*rho));
    let least = after
        .iter()
        .fold(f64::INFINITY, |least, rho| least.min(*rho));
    assert!(most < 2.001 && least > 0.999, "{least} {most}");
}

/// A sound that stands between two walls has no side to lean to.
#[test]
fn sound_between_walls_leans_to_no_side() {
    let mut problem = problem([20], 0.05, [[WALL; 2]]);
    problem.initial = field(|x: &Vector<1>| State {
        density: 1.0 + 0.001 * (TAU * x[0]).cos(),
        velocity: Vector::<1>::zeros(),
        pressure: 1.0 / 1.4 + 0.001 * (TAU * x[0]).cos(),
    });
    let mut flow = on_cells(lattice(&problem), problem);
    march(&mut flow, 2.0);
    let rho = flow.frame().density;
    let leans = rho.iter().zip(rho.iter().rev()).map(|(a, b)| (a - b).abs());
    let most = leans.fold(0.0, f64::max);
    assert!(most < 1e-12, "{most}");
}

fn on_cells<const D: usize>(cells: Cells<D>, problem: Problem<D>) -> FixedSimulation<D> {
    FixedSimulation::on(cells, problem).expect("the problem is sound")
}

/// Part of the faces that are between even cells.
fn even_part<const D: usize>(flow: &FixedSimulation<D>) -> f64 {
    let faces = flow.net.blocks.iter().flat_map(|block| &block.faces);
    let evenness = faces.map(|face| flow.net.face_shapes[face.shape as usize].evenness);
    let [sum, count] = evenness.fold([0.0; 2], |[sum, n], even| [sum + even, n + 1.0]);
    sum / count
}

#[test]
fn lattices_are_even_up_to_their_walls_and_no_cells_that_are_askew_are() {
    let flat: Problem<2> = problem([12, 12], 0.1, [[WALL, WALL], [Side::Periodic; 2]]);
    assert_eq!(even_part(&on_cells(lattice(&flat), flat.clone())), 1.0);
    let space: Problem<3> = problem([5, 4, 4], 0.1, [[WALL; 2]; 3]);
    assert_eq!(even_part(&on_cells(lattice(&space), space.clone())), 1.0);
    let walled = problem([12, 12], 0.1, [[WALL; 2]; 2]);
    let askew = bent(&walled, [12, 12], |x, y| {
        Vector::<2>::new(1.2 * x + 0.03 * (5.0 * y).sin(), 1.2 * y + 0.03 * x * x)
    });
    assert_eq!(even_part(&on_cells(askew, walled)), 0.0);
}

/// Where a wall cuts cells they are not even, nor where they are halved; the rest of the lattice is. A flow that settles asks for none.
#[test]
fn cells_that_a_wall_cuts_or_that_are_halved_are_not_even() {
    let part = |settles: bool, halvings: u8| {
        let ramp = Arc::new(bodies::compression_corner(0.0, 15.0).expect("a corner"));
        let mut problem = stream(1.4, [[-0.5, -0.5], [0.5, 0.5]], 0.05, vec![ramp]);
        let points = problem.method.fixed().copied().expect("points");
        problem.method = crate::method::Method::Fixed(crate::method::FixedPoints {
            time: if settles {
                crate::method::Time::Settle
            } else {
                crate::method::Time::Accurate
            },
            refine: crate::method::Refine::Levels(halvings),
            ..points
        });
        let mut flow = FixedSimulation::new(problem).expect("the problem is sound");
        for _ in 0..if settles { 0 } else { 5 } {
            flow.step(f64::INFINITY).expect("the flow is tame");
        }
        even_part(&flow)
    };
    let (plain, halved) = (part(false, 0), part(false, 1));
    assert!(
        (0.6..0.95).contains(&plain) && halved > 0.0,
        "{plain} {halved}"
    );
    assert!(halved < plain, "{plain} {halved}");
    assert_eq!(part(true, 0), 0.0);
}
