//! Flows around bodies, settled and marched: noses, thin plates, boxes and fins.

use std::sync::Arc;

use aero_geometry::{Bounds, Placed, Placement, Shape, Vector, bodies};

use super::lattice::problem;
use crate::fixed::FixedSimulation;
use crate::frame::Totals;
use crate::problem::{Problem, Side, State};
use crate::tests::slip_body;

/// A stream along the first axis, of density and sound one, around bodies in a box with open sides.
pub(in crate::fixed) fn stream<const D: usize>(
    mach: f64,
    [min, max]: [[f64; D]; 2],
    spacing: f64,
    bodies: Vec<Arc<dyn Shape<D>>>,
) -> Problem<D> {
    let mut problem = problem([1; D], spacing, [[Side::FreeStream; 2]; D]);
    problem.domain.bounds = Bounds::new(Vector::from(min), Vector::from(max));
    problem.domain.sides[0] = [Side::Inlet, Side::Outlet];
    let mut velocity = Vector::zeros();
    velocity[0] = mach;
    problem.free_stream = State {
        density: 1.0,
        velocity,
        pressure: 1.0 / 1.4,
    };
    problem.bodies = bodies.into_iter().map(slip_body).collect();
    problem
}

/// Ahead of a circle of radius one, above its axis of symmetry.
fn nose(mach: f64, cells: f64) -> FixedSimulation<2> {
    let nose = Arc::new(bodies::blunt_wedge(1.0, 14.04, 3.0).unwrap());
    let bounds = [[-1.75, 0.0], [0.25, 3.0]];
    let mut problem = stream(mach, bounds, 1.0 / cells, vec![nose]);
    problem.domain.sides[1][0] = Side::Symmetry;
    FixedSimulation::new(problem).unwrap()
}

/// Pressure behind a stream that is stopped behind a normal shock, over that before it: NACA Report 1135 (1953), eq. 100.
fn pitot(mach: f64) -> f64 {
    let square = mach * mach;
    (1.2 * square).powf(3.5) * (6.0 / (7.0 * square - 1.0)).powf(2.5)
}

/// The shock of a blunt nose is captured and comes to rest, at any strength: forces within a millionth, a stagnation pressure near
/// Rayleigh's, and no dent in the wall pressure, which falls from the nose on.
#[test]
fn bow_shocks_come_to_rest_without_a_dent() {
    for mach in [3.0, 6.0, 10.0, 20.0] {
        let mut flow = nose(mach, 12.0);
        let rested = (0..2000).any(|_| flow.settle_step().unwrap().change < 1e-6);
        assert!(rested, "Mach {mach}");
        let surface = flow.surface();
        let mut wall: Vec<(f64, f64)> = surface
            .position
            .iter()
            .zip(&surface.pressure)
            .map(|(foot, p)| (foot[1].atan2(-foot[0]), p * 1.4 / pitot(mach)))
            .filter(|(angle, _)| *angle < 1.2)
            .collect();
        wall.sort_by(|a, b| a.0.total_cmp(&b.0));
        assert!((wall[0].1 - 1.0).abs() < 0.04, "Mach {mach}: {:?}", wall[0]);
        for pair in wall.windows(2) {
            let rise = pair[1].1 - pair[0].1;
            assert!(rise < 0.03, "Mach {mach}: {pair:?}");
        }
    }
}

fn plate(thickness: f64) -> Problem<2> {
    let dx = 1.0 / 40.0;
    let shape = bodies::rectangle(1.0, thickness * dx, 0.0).unwrap();
    let place = Placement::<2>::default().rotated(f64::to_radians(-5.0));
    let placed = Placed::new(Arc::new(shape) as Arc<dyn Shape<2>>, place);
    stream(2.0, [[-0.8, -0.6], [0.8, 0.6]], dx, vec![Arc::new(placed)])
}

/// Means of the pressure over that of the stream on the middle of the lower and the upper side.
fn sides_of(flow: &FixedSimulation<2>) -> [f64; 2] {
    let surface = flow.surface();
    [-1.0, 1.0].map(|side| {
        let walls = surface.position.iter().zip(&surface.normal);
        let chosen = walls
            .zip(&surface.pressure)
            .filter(|((foot, normal), _)| foot[0].abs() < 0.2 && normal[1] * side > 0.9);
        let pressures: Vec<f64> = chosen.map(|(_, p)| p * 1.4).collect();
        assert!(pressures.len() > 8);
        pressures.iter().sum::<f64>() / pressures.len() as f64
    })
}

/// Plates thinner and thicker than a cell at Mach 2 and 5 degrees. On a thin one the pressures are those of an oblique shock, 1.3154,
/// and of a Prandtl-Meyer fan, 0.7473 (NACA Report 1135, 1953).
#[test]
fn plates_of_any_thickness_keep_two_sides() {
    for thickness in [0.3, 0.5, 2.0, 8.0] {
        let mut flow = FixedSimulation::new(plate(thickness)).unwrap();
        flow.settle(400).unwrap();
        let [below, above] = sides_of(&flow);
        if thickness < 1.0 {
            assert!((below / 1.3154 - 1.0).abs() < 0.015, "{thickness}: {below}");
            assert!((above / 0.7473 - 1.0).abs() < 0.025, "{thickness}: {above}");
        } else {
            assert!(below > 1.25 * above, "{thickness}: {below} {above}");
        }
    }
    for thickness in [0.3, 2.0] {
        let mut flow = FixedSimulation::new(plate(thickness)).unwrap();
        while flow.time() < 0.4 {
            flow.step(0.4).unwrap();
        }
        let [below, above] = sides_of(&flow);
        assert!(below > 1.1 * above, "{thickness}: {below} {above}");
    }
}

fn block(edges: [f64; 3], place: [f64; 3]) -> Arc<dyn Shape<3>> {
    let block: Arc<dyn Shape<3>> = Arc::new(bodies::cuboid(edges).unwrap());
    let place = Placement::default().moved(Vector::from(place));
    Arc::new(Placed::new(block, place))
}

fn in_space(shapes: Vec<Arc<dyn Shape<3>>>) -> Problem<3> {
    stream(2.0, [[-1.0; 3], [1.0; 3]], 1.0 / 10.0, shapes)
}

/// Middle pressures on the sides of blunt parts that face the stream and that turn away from it, over its own: slivers of a side, in cells
/// that lie around its edge, have others.
fn front_and_back(flow: &FixedSimulation<3>) -> [f64; 2] {
    let surface = flow.surface();
    [-1.0, 1.0].map(|side| {
        let walls = surface.position.iter().zip(&surface.normal);
        let chosen = walls
            .zip(&surface.pressure)
            .filter(|((foot, normal), _)| normal[0] * side > 0.9 && foot[0].abs() < 0.5);
        let mut pressures: Vec<f64> = chosen.map(|(_, p)| p * 1.4).collect();
        assert!(pressures.iter().all(|p| p.is_finite() && *p > 0.0));
        pressures.sort_by(f64::total_cmp);
        pressures[pressures.len() / 2]
    })
}

/// A box on a floor, and a body with fins thinner than a cell.
fn blunt_and_thin() -> [Problem<3>; 2] {
    let floor = block([9.0, 9.0, 1.0], [0.0, 0.0, -1.03]);
    let mut on_floor = in_space(vec![floor, block([0.5, 0.4, 0.5], [0.013, 0.0, -0.28])]);
    on_floor.domain.sides[2][0] = Side::Body;
    let finned = in_space(vec![
        block([0.8, 0.3, 0.3], [0.013, 0.007, 0.0]),
        block([0.4, 1.0, 0.04], [0.013, 0.007, 0.0]),
        block([0.4, 0.04, 1.0], [0.013, 0.007, 0.0]),
    ]);
    [on_floor, finned]
}

#[test]
fn boxes_on_floors_and_fins_are_flown_settled_and_marched() {
    for problem in blunt_and_thin() {
        let mut flow = FixedSimulation::new(problem.clone()).unwrap();
        for _ in 0..60 {
            flow.settle_step().unwrap();
        }
        let drag: f64 = flow.loads().iter().map(|load| load.force[0]).sum();
        assert!(drag > 0.1, "{drag}");
        // Stopped behind a normal shock the stream's pressure is 5.64 of what it was (NACA Report 1135); a fin thinner than its cell feels
        // the stream that runs past it too.
        let [front, back] = front_and_back(&flow);
        assert!((2.5..9.0).contains(&front) && back < 1.0, "{front} {back}");
        let mut flow = FixedSimulation::new(problem).unwrap();
        while flow.time() < 0.3 {
            flow.step(0.3).unwrap();
        }
        let [front, back] = front_and_back(&flow);
        // The shock of the start is still on its way, and presses harder.
        assert!(front > 2.5 && back < 1.0, "{front} {back}");
        assert!(flow.statistics().min_density > 1e-3);
    }
}

#[test]
fn iterations_have_the_same_bits_for_any_number_of_threads() {
    let [_, finned] = blunt_and_thin();
    let run = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
        pool.build().unwrap().install(|| {
            let mut flow = FixedSimulation::new(finned.clone()).unwrap();
            for _ in 0..10 {
                flow.settle_step().unwrap();
            }
            flow.frame().pressure
        })
    };
    assert!(run(1) == run(3));
}

/// Ahead of a sphere, as rings about its axis.
fn ball(mach: f64, cells: f64) -> FixedSimulation<2> {
    let ball = Arc::new(bodies::circle(1.0).unwrap());
    let bounds = [[-1.5, 0.0], [0.0, 2.5]];
    let mut problem = stream(mach, bounds, 1.0 / cells, vec![ball]);
    problem.domain.sides[1][0] = Side::Axis;
    FixedSimulation::new(problem).unwrap()
}

/// Next to the axis nothing grows that the rings' images would have stopped: the bow shock of a sphere comes to rest, without a spike on
/// the axis, where the stagnation pressure is Rayleigh's.
#[test]
fn the_bow_shock_of_a_sphere_comes_to_rest_on_its_axis() {
    for (mach, within) in [(3.0, 0.07), (10.0, 0.05)] {
        let mut flow = ball(mach, 20.0);
        let settled = flow.settle(800).unwrap();
        assert!(settled.is_settled, "Mach {mach}: {settled:?}");
        let surface = flow.surface();
        let walls = surface.position.iter().zip(&surface.pressure);
        let (_, nose) = walls.min_by(|a, b| a.0[1].total_cmp(&b.0[1])).unwrap();
        let nose = nose * 1.4 / pitot(mach);
        assert!((nose - 1.0).abs() < within, "Mach {mach}: {nose}");
    }
}

/// In the ring next to the axis the slope of the pressure is that between its neighbour and its own image.
#[test]
fn rings_next_to_the_axis_have_their_image_for_a_neighbour() {
    let mut problem = stream::<2>(0.0, [[0.0; 2], [1.0; 2]], 0.1, Vec::new());
    problem.domain.sides[1][0] = Side::Axis;
    problem.initial = super::lattice::field(|place: &Vector<2>| State {
        density: 1.0,
        velocity: Vector::from([0.0, 0.3 * place[1]]),
        pressure: 1.0 + place[1],
    });
    let flow = FixedSimulation::new(problem).unwrap();
    for (point, slopes) in flow.points.iter().zip(&flow.columns.slopes) {
        if point[1] < 0.1 && (0.2..0.8).contains(&point[0]) {
            let radial = &slopes.along[1];
            assert!((radial.pressure - 0.5).abs() < 1e-12, "{radial:?}");
            assert!((radial.velocity[1] - 0.3).abs() < 1e-12, "{radial:?}");
        }
    }
}

/// A wall counts as long as it is in the plane of rings, whatever pieces it is put together from: next to the axis, where the outer piece goes
/// much farther around than the inner one, surfaces showed a twentieth less than pressed there.
#[test]
fn walls_of_rings_are_as_long_as_the_curve_that_they_follow() {
    let flow = ball(3.0, 20.0);
    let each = flow.walls().map(|(wall, _)| wall);
    let walls: Vec<_> = each.filter(|wall| wall.owner == 0).collect();
    let length: f64 = walls.iter().map(|wall| wall.image.share).sum();
    let quarter = std::f64::consts::FRAC_PI_2;
    assert!((length / quarter - 1.0).abs() < 5e-4, "{length}");
    // On the axis the middle of a wall from there is half its length away.
    let first = walls
        .iter()
        .min_by(|a, b| a.foot[1].total_cmp(&b.foot[1]))
        .unwrap();
    let off = first.foot[1] / (0.5 * first.image.share) - 1.0;
    assert!(off.abs() < 1e-3, "{off}");
}

/// A disc in a stream, whole or above a symmetry plane at `y = 3`; moments refer to a point off the plane.
fn disc(is_half: bool) -> FixedSimulation<2> {
    let place = Placement::default().moved(Vector::<2>::new(0.05, 3.0));
    let disc: Arc<dyn Shape<2>> = Arc::new(bodies::circle(0.4).unwrap());
    let low = if is_half { 3.0 } else { 2.0 };
    let disc = Arc::new(Placed::new(disc, place));
    let mut problem = stream(2.0, [[-1.0, low], [1.0, 4.0]], 0.1, vec![disc]);
    if is_half {
        problem.domain.sides[1][0] = Side::Symmetry;
    }
    problem.bodies[0].moment_centre = Vector::from([0.3, 0.7]);
    FixedSimulation::new(problem).unwrap()
}

#[test]
fn a_disc_cut_by_a_plane_has_the_force_the_moment_and_the_coefficients_of_the_whole() {
    let [whole, half] = [false, true].map(|is_half| {
        let mut flow = disc(is_half);
        for _ in 0..20 {
            flow.step(1e9).unwrap();
        }
        let surface = flow.surface();
        let shown = surface.pressure.iter().zip(&surface.pressure_coefficient);
        // Dynamic pressure 2.
        for (pressure, coefficient) in shown {
            let expected = (pressure - 1.0 / 1.4) / 2.0;
            assert!((coefficient - expected).abs() < 1e-14, "{coefficient}");
        }
        flow.loads()[0]
    });
    // The drag passes 2.3 above the centre; cells beside a disc are cut and joined nearly symmetrically.
    let drag = whole.force[0];
    assert!(drag > 0.5, "drag {drag}");
    assert!((whole.moment[2] + 2.3 * drag).abs() < 1e-3, "{whole:?}");
    for k in 0..3 {
        let apart = (whole.force[k] - half.force[k]).abs();
        assert!(apart < 1e-3, "{whole:?} {half:?}");
        let apart = (whole.moment[k] - half.moment[k]).abs();
        assert!(apart < 1e-3, "{whole:?} {half:?}");
    }
}

/// Neither mass, momentum nor energy is made in a flow that had `before` at its start.
#[track_caller]
pub fn nothing_is_made<const D: usize>(flow: &FixedSimulation<D>, before: &Totals) {
    let (after, inflow) = (flow.totals(), flow.inflow());
    assert!((after.mass - before.mass - inflow.mass).abs() < 1e-11);
    assert!((after.energy - before.energy - inflow.energy).abs() < 1e-11);
    for k in 0..D {
        let made = after.momentum[k] - before.momentum[k] - inflow.momentum[k];
        assert!(made.abs() < 1e-11, "{k}: {made}");
    }
}
