use aero_geometry::{Placed, Placement, Shape, bodies};
use aero_packer::{Ghosts, PackReport};

use super::seam::body_on_the_lattice;
use super::*;
use crate::lattice;
use crate::problem::{Body, Motion, Turning};

/// Spacings of gas above and below the plate: the mirrors of the walls' ghosts do not reach across it.
pub const ABOVE: usize = 8;

/// A plate at rest, `thickness` spacings of 0.1 thick, in the middle of a box that is periodic along it; its ghosts
/// lie on the gas's own lattice.
fn plate<const D: usize>(
    [along, above, thickness]: [usize; 3],
    shape: Arc<dyn Shape<D>>,
) -> Problem<D> {
    let mut problem = cube::<D>(along, Side::Periodic);
    problem.domain.bounds.max[1] = (2 * above + thickness) as f64 * problem.resolution.lattice();
    problem.domain.sides[1] = [WALL; 2];
    let mut last = [along as i64; D];
    last[1] = (2 * above + thickness) as i64;
    let mut ghosts = Ghosts::default();
    for index in lattice::points([0; D], last) {
        let position = lattice::position(
            &problem.domain.bounds.min,
            problem.resolution.lattice(),
            &index,
        );
        let surface = shape.closest(&position);
        if surface.distance > 0.0 {
            continue;
        }
        ghosts.position.push(position);
        ghosts.normal.push(surface.normal);
        ghosts.distance.push(surface.distance);
        ghosts
            .volume
            .push(problem.resolution.lattice().powi(D as i32));
        ghosts
            .layer
            .push((-surface.distance / problem.resolution.lattice()).floor() as u32);
        ghosts.face.push(surface.face);
    }
    problem.bodies.push(Body {
        name: "plate".into(),
        shape,
        wall: WallKind::Slip,
        motion: Motion::none(),
        ghosts,
        packed_fluid: None,
        report: PackReport {
            spacing: problem.resolution.lattice(),
            ..PackReport::default()
        },
        reference_area: 1.0,
        reference_length: 1.0,
        moment_centre: Vector::zeros(),
    });
    let middle = 0.5 * problem.domain.bounds.max[1];
    problem.initial = Initial::Field(Field(Arc::new(move |position: &Vector<D>| {
        let is_above = position[1] > middle;
        State {
            density: if is_above { 1.4 } else { 2.1 },
            velocity: Vector::zeros(),
            pressure: if is_above { 1.0 } else { 3.0 },
        }
    })));
    problem
}

pub fn plate_2d(thickness: usize) -> Problem<2> {
    let height = thickness as f64 * 0.1;
    let place =
        Placement::default().moved(Vector::<2>::new(0.5, 0.1 * ABOVE as f64 + 0.5 * height));
    let slab = bodies::rectangle(20.0, height, 0.0).expect("a rectangle");
    plate([10, ABOVE, thickness], Arc::new(Placed::new(slab, place)))
}

fn plate_3d(thickness: usize) -> Problem<3> {
    let height = thickness as f64 * 0.1;
    let centre = Vector::<3>::new(0.5, 0.1 * ABOVE as f64 + 0.5 * height, 0.5);
    let slab = bodies::cuboid([20.0, height, 20.0]).expect("a cuboid");
    let place = Placement::default().moved(centre);
    plate([10, ABOVE, thickness], Arc::new(Placed::new(slab, place)))
}

fn greatest_speed<const D: usize>(simulation: &Simulation<D>) -> f64 {
    let speeds = simulation.fluid.iter().map(|p| p.velocity.norm());
    speeds.fold(0.0, f64::max)
}

fn stays_at_rest<const D: usize>(
    mut problem: Problem<D>,
    extrapolation: Extrapolation,
    steps: usize,
) {
    problem.scheme.wall.extrapolation = extrapolation;
    let mut simulation = start(problem);
    advance(&mut simulation, steps);
    let speed = greatest_speed(&simulation);
    assert!(speed < 1e-11, "{extrapolation:?}: gas moves at {speed}");
    let force = simulation.loads()[0].force[1];
    let area = simulation.problem.domain.bounds.max[0].powi(D as i32 - 1);
    assert!((force / area - 2.0).abs() < 1e-10, "force {force}");
}

#[test]
fn gas_on_both_sides_of_a_thin_plate_stays_at_rest_at_two_pressures() {
    for extrapolation in [Extrapolation::Wom, Extrapolation::Wm] {
        for thickness in [1, 2, 3] {
            stays_at_rest(plate_2d(thickness), extrapolation, 40);
        }
        stays_at_rest(plate_3d(2), extrapolation, 10);
    }
    stays_at_rest(plate_3d(1), Extrapolation::Wom, 10);
}

/// A plate `thickness` spacings of 0.1 thick that ends within a closed box of gas at rest, on the gas's own lattice.
fn short_plate<const D: usize>(thickness: usize, shape: impl Shape<D> + 'static) -> Problem<D> {
    let mut problem = cube::<D>(20, WALL);
    let mut centre = problem.domain.bounds.max * 0.5;
    centre[1] += if thickness % 2 == 1 { 0.05 } else { 0.0 };
    let place = Placement::default().moved(centre);
    let body = body_on_the_lattice(&problem, Arc::new(Placed::new(shape, place)));
    problem.bodies.push(body);
    problem
}

/// Density of the gas at the start, of what it should be: least and most.
fn density_range<const D: usize>(problem: Problem<D>) -> [f64; 2] {
    let mut simulation = start(problem);
    advance(&mut simulation, 1);
    let densities = simulation.fluid.iter().map(|p| p.density / 1.4);
    densities.fold([f64::INFINITY, 0.0], |[low, high], d| {
        [low.min(d), high.max(d)]
    })
}

#[test]
fn gas_at_rest_around_the_ends_of_a_thin_plate_has_its_density() {
    for thickness in 1..=4 {
        let plate = bodies::rectangle(0.8, 0.1 * thickness as f64, 0.0).expect("a plate");
        let [low, high] = density_range(short_plate(thickness, plate));
        assert!(
            low > 1.0 - 1e-9 && high < 1.0 + 1e-9,
            "{thickness}: {low} to {high}"
        );
    }
    let plate = bodies::cuboid([0.8, 0.1, 0.8]).expect("a plate");
    let [low, high] = density_range(short_plate(1, plate));
    assert!(low > 1.0 - 1e-9 && high < 1.0 + 1e-9, "{low} to {high}");
}

#[test]
fn without_tags_a_thin_plate_lets_the_pressure_through() {
    let mut problem = plate_2d(2);
    problem.scheme.wall.surface_tags = false;
    let mut simulation = start(problem);
    advance(&mut simulation, 10);
    assert!(greatest_speed(&simulation) > 0.01);
}

#[test]
fn a_thick_plate_has_no_thin_parts() {
    let problem = plate_2d(12);
    assert!(start(problem).walls.faces().is_none());
}

/// Flow that is symmetric about the middle of a thin plate, and its upper half above a symmetry plane.
fn cut_pair(thickness: usize) -> [Problem<2>; 2] {
    let flow = |problem: &mut Problem<2>| {
        let middle = 0.5 * problem.domain.bounds.max[1];
        problem.initial = Initial::Field(Field(Arc::new(move |position: &Vector<2>| State {
            density: 1.4,
            velocity: Vector::<2>::new(0.0, 0.5 * (position[1] - middle)),
            pressure: 1.0 + 0.2 * (position[0] * std::f64::consts::TAU).cos(),
        })));
    };
    let mut whole = plate_2d(thickness);
    flow(&mut whole);
    let middle = 0.5 * whole.domain.bounds.max[1];
    let mut half = whole.clone();
    half.domain.bounds.min[1] = middle;
    half.domain.sides[1][0] = Side::Symmetry;
    let ghosts = &mut half.bodies[0].ghosts;
    let kept: Vec<usize> = (0..ghosts.position.len())
        .filter(|&g| ghosts.position[g][1] > middle - 1e-9)
        .collect();
    *ghosts = Ghosts {
        position: kept.iter().map(|&g| ghosts.position[g]).collect(),
        normal: kept.iter().map(|&g| ghosts.normal[g]).collect(),
        distance: kept.iter().map(|&g| ghosts.distance[g]).collect(),
        volume: kept.iter().map(|&g| ghosts.volume[g]).collect(),
        layer: kept.iter().map(|&g| ghosts.layer[g]).collect(),
        face: kept.iter().map(|&g| ghosts.face[g]).collect(),
    };
    [whole, half]
}

#[test]
fn a_cut_through_the_middle_of_a_thin_plate_changes_nothing() {
    let [whole, half] = cut_pair(2);
    let (mut whole, mut half) = (start(whole), start(half));
    assert!(whole.walls.faces().is_some() && half.walls.faces().is_some());
    advance(&mut whole, 20);
    advance(&mut half, 20);
    let [pushed, lifted] = [&whole, &half].map(|simulation| simulation.loads()[0].force);
    assert!(pushed[1].abs() < 1e-9 && (pushed[0] - lifted[0]).abs() < 1e-9);
    for particle in &half.fluid {
        let distance = |p: &crate::particles::Particle<2>| (p.position - particle.position).norm();
        let twin = whole
            .fluid
            .iter()
            .min_by(|a, b| distance(a).total_cmp(&distance(b)))
            .expect("the whole has particles");
        assert!((twin.position - particle.position).norm() < 1e-10);
        assert!((twin.velocity - particle.velocity).norm() < 1e-10);
    }
}

#[test]
fn ghosts_on_a_symmetry_plane_share_their_volume_with_their_images() {
    let [whole, half] = cut_pair(1).map(start);
    let volume = |simulation: &Simulation<2>| {
        let own = simulation.walls.own().iter();
        own.filter(|g| g.body == 0).map(|g| g.volume).sum::<f64>()
    };
    assert!((volume(&half) / volume(&whole) - 0.5).abs() < 1e-12);
}

/// A short plate that turns in a closed box: gas passes around both of its ends.
fn turning_plate() -> Problem<2> {
    let mut problem = plate_2d(2);
    let centre = problem.domain.bounds.max * 0.5;
    let place = Placement::default().moved(centre);
    let short = bodies::rectangle(0.4, 0.2, 0.0).expect("a rectangle");
    let shape = Placed::new(short, place);
    problem.domain.sides = [[WALL; 2]; 2];
    let body = &mut problem.bodies[0];
    let all = body.ghosts.clone();
    body.ghosts = Ghosts::default();
    for (&position, &volume) in all.position.iter().zip(&all.volume) {
        let surface = shape.closest(&position);
        if surface.distance < 0.0 {
            let ghosts = &mut body.ghosts;
            ghosts.position.push(position);
            ghosts.normal.push(surface.normal);
            ghosts.distance.push(surface.distance);
            ghosts.volume.push(volume);
            ghosts.layer.push(0);
            ghosts.face.push(surface.face);
        }
    }
    body.shape = Arc::new(shape);
    body.motion.pivot = centre;
    body.motion.turning = Turning::Steady(nalgebra::Vector3::new(0.0, 0.0, 0.8));
    problem
}

fn bits(simulation: &Simulation<2>) -> Vec<u64> {
    let numbers = |p: &crate::particles::Particle<2>| {
        [p.position[0], p.velocity[1], p.density, p.energy].map(f64::to_bits)
    };
    simulation.fluid.iter().flat_map(numbers).collect()
}

#[test]
fn a_turning_thin_plate_gives_the_same_bits_for_any_number_of_threads_and_after_a_pause() {
    let run = |threads: usize, pause: bool| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
        pool.build().expect("a pool").install(|| {
            let mut simulation = start(turning_plate());
            advance(&mut simulation, 8);
            if pause {
                let memory = simulation.memory();
                simulation = Simulation::resume(turning_plate(), memory).expect("the same problem");
            }
            advance(&mut simulation, 8);
            assert!(simulation.walls.faces().is_some());
            assert!(greatest_speed(&simulation) > 0.01);
            assert_eq!(simulation.statistics().leaked, 0);
            bits(&simulation)
        })
    };
    let one = run(1, false);
    assert_eq!(one, run(2, false));
    assert_eq!(one, run(2, true));
}
