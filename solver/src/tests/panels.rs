//! Panels: they cover the surface, gas at rest presses them with its pressure, and what they show adds up to the loads.

use aero_geometry::{Placed, Placement, Shape, bodies};
use nalgebra::Vector3;

use super::seam::body_on_the_lattice;
use super::*;
use crate::method::{FixedPoints, Method, Refine};
use crate::panels::Panels;

fn boxed(shape: impl Shape<2> + 'static, at: [f64; 2]) -> Problem<2> {
    let mut problem = cube::<2>(30, WALL);
    let place = Placement::default().moved(Vector::from(at));
    let body = body_on_the_lattice(&problem, Arc::new(Placed::new(shape, place)));
    problem.bodies.push(body);
    problem
}

/// Sum of `(friction - pressure normal) area` over a body.
fn integral(simulation: &Simulation<2>, body: u32) -> Vector3<f64> {
    let shown = simulation.panels();
    let mut force = Vector3::zeros();
    for n in (0..shown.body.len()).filter(|&n| shown.body[n] == body) {
        let pressed = Vector3::from(shown.normal[n]) * shown.pressure[n];
        force += (Vector3::from(shown.friction[n]) - pressed) * shown.area[n];
    }
    force
}

#[test]
fn gas_at_rest_presses_every_panel_with_its_pressure() {
    let square = bodies::rectangle(0.8, 0.8, 0.0).expect("a square");
    let shown = start(boxed(square, [1.5, 1.5])).panels();
    assert!(shown.body.len() > 4 * 30 + 4 * 8);
    for (n, pressure) in shown.pressure.iter().enumerate() {
        let place = shown.points[2 * n];
        assert!(
            (pressure - 1.0).abs() < 0.01,
            "{pressure} at {place:?}, in corners too"
        );
    }
    let length: f64 = shown
        .area
        .iter()
        .zip(&shown.body)
        .filter(|(_, b)| **b == 0)
        .map(|(a, _)| a)
        .sum();
    assert!((length - 3.2).abs() < 1e-12, "{length}");
}

#[test]
fn gas_at_rest_shows_its_pressure_on_a_body_that_stands_on_a_wall() {
    let post = bodies::rectangle(0.8, 1.2, 0.0).expect("a post");
    let shown = start(boxed(post, [1.5, 0.6])).panels();
    let mut count = 0;
    for (pressure, ends) in shown.pressure.iter().zip(shown.points.chunks(2)) {
        // What is buried between post and wall shows the pressure of the stream.
        count += 1;
        assert!((pressure - 1.0).abs() < 0.01, "{pressure} at {ends:?}");
    }
    assert!(count > 4 * 30);
}

#[test]
fn what_panels_show_adds_up_to_the_load() {
    let square = bodies::rectangle(0.8, 0.8, 0.0).expect("a square");
    adds_up(boxed(square, [1.5, 1.5]));
    // A notch of a right angle.
    let corners = [
        [-0.4, -0.4],
        [0.4, -0.4],
        [0.4, 0.0],
        [0.0, 0.0],
        [0.0, 0.4],
        [-0.4, 0.4],
    ];
    let notched = bodies::polygon(&corners.map(Vector::<2>::from)).expect("a notched square");
    adds_up(boxed(notched, [1.5, 1.5]));
}

fn adds_up(mut problem: Problem<2>) {
    problem.initial = Initial::Field(Field(Arc::new(|position: &Vector<2>| State {
        density: 1.4,
        velocity: Vector::<2>::new(0.4, 0.1),
        pressure: 1.0 + 0.3 * position[0] + 0.2 * position[1],
    })));
    let mut simulation = start(problem);
    advance(&mut simulation, 10);
    let load = Vector3::from(simulation.loads()[0].force);
    let shown = integral(&simulation, 0);
    let error = (shown - load).norm() / load.norm();
    assert!(error < 1e-3, "{shown:?} {load:?}");
}

#[test]
fn a_pressure_of_one_presses_a_closed_body_with_nothing() {
    let disc = bodies::circle(0.5).expect("a disc");
    let simulation = start(boxed(disc, [1.4, 1.6]));
    let loads = simulation.uniform_loads();
    assert!(
        loads[0].force.iter().all(|f| f.abs() < 1e-12),
        "{:?}",
        loads[0]
    );
    // The lower x side is pressed to the left, all along its 3 metres.
    assert!((loads[1].force[0] + 3.0).abs() < 1e-12, "{:?}", loads[1]);
}

#[test]
fn a_pressure_of_one_presses_a_post_on_a_wall_from_above_alone() {
    let post = bodies::rectangle(0.83, 1.2, 0.0).expect("a post");
    let [body, floor] = [0, 3].map(|n| {
        let problem = boxed(post.clone(), [1.5, 0.6]);
        Panels::new(&problem).uniform_loads(&problem)[n].force[1]
    });
    assert!((body + 0.83).abs() < 1e-9, "{body}");
    assert!((floor + 3.0 - 0.83).abs() < 1e-9, "{floor}");
}

/// A bar that sticks out through a side, whole or above a symmetry plane along it: one end of it is pressed, 0.8 high and 1.1 above the
/// centre.
#[test]
fn a_pressure_of_one_presses_what_the_domain_holds_of_a_body_and_all_of_what_a_plane_cuts() {
    let [whole, half] = [false, true].map(|is_half| {
        let mut problem = cube::<2>(30, WALL);
        problem.domain.sides[0] = [Side::Inlet, Side::Outlet];
        let bar = bodies::rectangle(4.0, 0.8, 0.0).expect("a bar");
        let place = Placement::default().moved(Vector::<2>::new(3.5, 1.5));
        if is_half {
            problem.domain.bounds.min[1] = 1.5;
            problem.domain.sides[1][0] = Side::Symmetry;
        }
        let mut body = body_on_the_lattice(&problem, Arc::new(Placed::new(bar, place)));
        body.moment_centre = Vector::<2>::new(0.3, 0.4);
        problem.bodies.push(body);
        Panels::new(&problem).uniform_loads(&problem)[0]
    });
    assert!((whole.force[0] - 0.8).abs() < 1e-12, "{whole:?}");
    assert!((whole.moment[2] + 1.1 * 0.8).abs() < 1e-12, "{whole:?}");
    for k in 0..3 {
        let apart = (whole.force[k] - half.force[k]).abs();
        assert!(apart < 1e-12, "{whole:?} {half:?}");
        let apart = (whole.moment[k] - half.moment[k]).abs();
        assert!(apart < 1e-12, "{whole:?} {half:?}");
    }
}

#[test]
fn panels_under_more_than_the_free_streams_pressure_have_a_positive_coefficient() {
    for (pressure, expected) in [(3.8, 1.0), (0.3, -0.25)] {
        let square = bodies::rectangle(0.8, 0.8, 0.0).expect("a square");
        let mut problem = boxed(square, [1.5, 1.5]);
        // Dynamic pressure 2.8.
        problem.free_stream.velocity[0] = 2.0;
        problem.initial = Initial::Field(Field(Arc::new(move |_| State {
            density: 1.4,
            velocity: Vector::zeros(),
            pressure,
        })));
        for coefficient in start(problem).panels().pressure_coefficient {
            let error = coefficient / expected - 1.0;
            assert!(error.abs() < 0.02, "coefficient {coefficient}");
        }
    }
}

#[test]
fn gas_at_rest_shows_its_pressure_on_walls_as_far_as_periodic_sides() {
    let mut problem = cube::<2>(20, Side::Periodic);
    problem.domain.sides[1] = [WALL; 2];
    let shown = start(problem).panels();
    assert!(shown.pressure.len() > 2 * 20);
    for (pressure, ends) in shown.pressure.iter().zip(shown.points.chunks(2)) {
        assert!((pressure - 1.0).abs() < 1e-3, "{pressure} at {ends:?}");
    }
}

/// Facets of a circle about a point of the plane end in that, but for rounding.
#[test]
fn a_side_that_cuts_a_body_leaves_no_slivers_of_its_surface() {
    for at in [1.5, 1.5 + 1e-15, 1.5 - 1e-15] {
        let mut problem = cube::<2>(30, WALL);
        problem.domain.bounds.min[1] = 1.5;
        problem.domain.sides[1][0] = Side::Symmetry;
        let circle = bodies::circle(1.0).expect("a circle");
        let place = Placement::default().moved(Vector::<2>::new(1.5, at));
        let body = body_on_the_lattice(&problem, Arc::new(Placed::new(circle, place)));
        problem.bodies.push(body);
        let panels = Panels::new(&problem);
        let least = panels.all().iter().map(|panel| panel.size);
        let least = least.fold(f64::INFINITY, f64::min);
        assert!(least > 1e-10, "{at}: {least}");
    }
}

/// Gas flows along walls that sides cut, unevenly: a corner of two walls, and a nose, half of it and about the axis.
#[test]
fn what_panels_show_of_what_sides_cut_adds_up_to_the_load() {
    let corner: Arc<dyn Shape<2>> =
        Arc::new(bodies::compression_corner(1.0, 0.35).expect("a corner"));
    let place = Placement::default().moved(Vector::<2>::new(2.0, 0.0));
    let nose: Arc<dyn Shape<2>> =
        Arc::new(Placed::new(bodies::circle(0.6).expect("a circle"), place));
    for (shape, lower) in [
        (corner, Side::Body),
        (nose.clone(), Side::Symmetry),
        (nose, Side::Axis),
    ] {
        let mut problem = cube::<2>(20, Side::FreeStream);
        problem.free_stream.velocity[0] = 2.5;
        problem.domain.sides = [[Side::Inlet, Side::Outlet], [lower, Side::FreeStream]];
        let mut wider = problem.clone();
        (wider.domain.bounds.min[0], wider.domain.bounds.max[0]) = (-1.0, 3.0);
        if lower == Side::Body {
            wider.domain.bounds.min[1] -= 1.0;
        }
        problem.bodies.push(body_on_the_lattice(&wider, shape));
        let mut simulation = start(problem);
        advance(&mut simulation, 40);
        let load = simulation.loads()[0].force;
        let halves = if lower == Side::Symmetry { 2.0 } else { 1.0 };
        let shown = integral(&simulation, 0) * halves;
        // Across a plane of symmetry both halves together bear nothing.
        let axes = if lower == Side::Body { 2 } else { 1 };
        for axis in 0..axes {
            let off = (shown[axis] - load[axis]) / load[0];
            assert!(off.abs() < 1e-9, "{lower:?}: {shown:?} {load:?}");
        }
    }
}

/// In a lattice wider than a wing, as a slow stream's box has, its long triangles are parted as finely as the flow may be halved.
#[test]
fn panels_of_a_body_in_a_wide_lattice_are_finer_than_its_cells() {
    let longest = |flow: u8| {
        let sides = [[Side::FreeStream; 2]; 3];
        let mut wide = crate::fixed::tests::lattice::problem([6; 3], 2.0, sides);
        let wing = bodies::cuboid([1.0, 0.1, 2.0]).expect("a wing");
        let place = Placement::default().moved(Vector::from([6.0; 3]));
        wide.bodies = vec![slip_body(Arc::new(Placed::new(wing, place)))];
        wide.method = Method::Fixed(FixedPoints {
            refine: Refine::Levels(flow),
            ..FixedPoints::default()
        });
        let panels = Panels::new(&wide);
        let edges = panels.all().iter().flat_map(|panel| {
            let corners = panel.corners;
            (0..3).map(move |n| (corners[n] - corners[(n + 1) % 3]).norm())
        });
        edges.fold(0.0, f64::max)
    };
    let [coarse, fine, finest] = [1, 4, 9].map(longest);
    assert!(coarse > 0.5 && coarse <= 1.0, "{coarse}");
    assert!(fine > 0.06 && fine <= 0.125 + 1e-12, "{fine}");
    // No finer than a hundredth of the body.
    assert!(finest > 0.01 && finest <= 0.02 + 1e-12, "{finest}");
}
