//! Pair sums around a thin plate in lanes, of every width, against the scalar reference: gas above and gas below it are worlds of
//! their own, and to each the plate is a wall as thick as any.

use super::agreement::{agree, agree_on_loads, array, matrix, randomise, world};
use super::reference::step::{Asked, World};
use super::reference::{Point, Rate, Wall};
use super::seam::{DEFAULT, Setup, Solver, instructions};
use super::thin::{ABOVE, plate_2d};
use super::*;

/// Heights of both faces of a plate so many spacings of 0.1 thick, the lower first.
fn faces(thickness: usize) -> [f64; 2] {
    [ABOVE, ABOVE + thickness].map(|cells| cells as f64 * 0.1)
}

/// What `side`, 0 or 1, of the plate knows: the gas there, the wall there, and the plate as it is seen from there.
fn world_beside(whole: &World<2>, side: usize, faces: [f64; 2]) -> World<2> {
    let middle = f64::midpoint(faces[0], faces[1]);
    let is_here = |point: &Point<2>| (point.position[1] > middle) == (side == 1);
    let out = [-1.0, 1.0][side];
    let mut here = whole.clone();
    here.gas.retain(is_here);
    here.walls
        .retain(|wall| wall.body == 0 || is_here(&wall.point));
    here.walls = here
        .walls
        .iter()
        .flat_map(|wall| match wall.body {
            0 => seen_from(wall, faces[side], out, faces[1] - faces[0]),
            _ => vec![*wall],
        })
        .collect();
    here
}

/// A ghost of the plate below the face that looks `out`, and what continues it beyond the other face, again and again, five layers deep.
fn seen_from(wall: &Wall<2>, face: f64, out: f64, thickness: f64) -> Vec<Wall<2>> {
    let own = (face - wall.point.position[1]) * out;
    let depths = (0..5).map(|times| own + f64::from(times) * thickness);
    depths
        .take_while(|depth| *depth < 0.5)
        .map(|depth| {
            let mut seen = *wall;
            seen.point.position[1] = face - out * depth;
            seen.normal = Vector::from([0.0, out]);
            seen.depth = depth;
            seen
        })
        .collect()
}

/// Numbers of all gas as both worlds have them, in the order of the whole.
fn joined<T: Clone>(whole: &World<2>, middle: f64, both: [&[T]; 2]) -> Vec<T> {
    let mut both = both.map(<[T]>::iter);
    let next = |i: &Point<2>| both[usize::from(i.position[1] > middle)].next().cloned();
    whole.gas.iter().filter_map(next).collect()
}

fn compare(setup: Setup, thickness: usize) {
    let problem = setup.of(plate_2d(thickness));
    let faces = faces(thickness);
    let middle = f64::midpoint(faces[0], faces[1]);
    for instructions in instructions() {
        let mut solver = Solver::new(problem.clone(), instructions);
        randomise(&mut solver);
        solver.list();
        let start = world(&solver, &problem);
        solver.read_densities();
        let densities = [0, 1].map(|side| world_beside(&start, side, faces).densities());
        let densities = joined(&start, middle, [&densities[0], &densities[1]]);
        agree(
            "density",
            solver.gas().iter().map(|p| [p.density]),
            densities.iter().map(|&density| [density]),
        );
        let start = world(&solver, &problem);
        solver.evaluate();
        let asked = Asked {
            laws: setup.laws(),
            mirrors: setup.mirrors,
            shield: setup.shield,
            shifting: setup.shifting,
        };
        let each = [0, 1].map(|side| {
            let world = world_beside(&start, side, faces);
            world.evaluate(asked, |_| f64::INFINITY)
        });
        let rates = joined(&start, middle, [&each[0].rates, &each[1].rates]);
        agree_on_rates(&solver.rates(), &rates);
        let walls = [0, 1].map(|side| each[side].walls.as_slice()).concat();
        let on_ghosts = [0, 1].map(|side| each[side].on_ghosts.as_slice()).concat();
        agree_on_loads(&solver, &walls, &on_ghosts);
    }
}

fn agree_on_rates(lanes: &[Rate<2>], expected: &[Rate<2>]) {
    let both = |what: &str, get: &dyn Fn(&Rate<2>) -> [f64; 9]| {
        agree(what, lanes.iter().map(get), expected.iter().map(get));
    };
    let padded = |vector: &Vector<2>| {
        let [x, y, z] = array(vector);
        [x, y, z, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
    };
    both("acceleration", &|r| padded(&r.acceleration));
    both("acceleration by walls", &|r| padded(&r.wall_acceleration));
    both("energy gradient", &|r| padded(&r.energy_gradient));
    both("shift", &|r| padded(&r.shift));
    both("velocity gradient", &|r| matrix(&r.velocity_gradient));
    both("rate of energy", &|r| {
        padded(&Vector::from([r.energy, 0.0]))
    });
}

#[test]
fn gas_sees_and_presses_its_own_side_of_a_thin_plate_alone() {
    for thickness in [1, 2, 3] {
        compare(DEFAULT, thickness);
    }
    compare(
        Setup {
            shifting: true,
            viscous: true,
            ..DEFAULT
        },
        2,
    );
}
