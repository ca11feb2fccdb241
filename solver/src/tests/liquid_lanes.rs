//! The passes of liquids in lanes, of every width, against the scalar reference: disordered boxes of random states.

use super::agreement::{Random, agree, agree_on_loads, agree_on_walls, array, matrix, world};
use super::liquids::{DENSITY, SOUND, boxed};
use super::reference::gas::{Renormalised, density, renormalise};
use super::reference::step::{OnGhost, World};
use super::reference::{Matrix, Point, diffusion, liquids};
use super::seam::{Solver, instructions};
use super::*;
use crate::problem::{NoSlip, Slide};
use crate::scheme::{Damping, PressureGradient};

/// A wall that goes on and ever faster.
const PISTON: Side = Side::Wall {
    kind: WallKind::Slip,
    velocity: 0.4,
    acceleration: 30.0,
};

/// A wall that liquid sticks to, and whose surface moves along itself.
fn belt() -> Side {
    Side::Wall {
        kind: WallKind::NoSlip(NoSlip {
            slide: Slide {
                velocity: [0.0, 0.7, 0.2],
                ..Slide::default()
            },
            ..NoSlip::default()
        }),
        velocity: 0.0,
        acceleration: 0.0,
    }
}

/// All that the reference knows after an evaluation: what ghosts show; volumes, pressures, gradients, renormalisations of the liquid.
fn known<const D: usize>(
    law: liquids::Liquid,
    solver: &Solver<D>,
    problem: &Problem<D>,
) -> (World<D>, Vec<Renormalised<D>>) {
    let mut world = world(solver, problem);
    for i in &mut world.gas {
        i.pressure = law.pressure(i.density);
    }
    let all = world.all_gas();
    let mirrors = problem.scheme.wall.extrapolation == Extrapolation::Wm;
    for wall in &mut world.walls {
        *wall = liquids::show(law, wall, &all, mirrors);
    }
    let ghosts = world.all_ghosts();
    for i in &mut world.gas {
        i.volume = i.mass / density(i, &i.near(&all), &i.near(&ghosts));
    }
    let all = world.all_gas();
    let each = world.gas.iter();
    let each = each.map(|i| renormalise(i, &i.near(&all), &i.near(&ghosts)));
    let renormalised: Vec<_> = each.collect();
    let both = world.gas.iter_mut().zip(&renormalised);
    for ((i, found), rates) in both.zip(solver.rates()) {
        let inverse = found.matrix.try_inverse().expect("a regular matrix");
        (i.renormalisation, i.density_gradient) = if law.pairwise {
            (Matrix::identity(), inverse * found.density_gradient)
        } else {
            (found.matrix, found.density_gradient)
        };
        i.shift = rates.shift;
    }
    let everything = [world.all_gas(), ghosts].concat();
    for i in &mut world.gas {
        i.strain = liquids::velocity_gradient(i, &i.near(&everything));
    }
    (world, renormalised)
}

/// With the gradients of the velocity beyond walls.
fn with_gradients<const D: usize>(law: liquids::Liquid, world: &World<D>) -> World<D> {
    let mut world = world.clone();
    let all = world.all_gas();
    for wall in &mut world.walls {
        wall.point = diffusion::with_gradients(law.viscous(), wall, &wall.point.near(&all));
    }
    world
}

/// What the liquid does to the ghosts.
fn on_ghosts<const D: usize>(law: liquids::Liquid, world: &World<D>) -> Vec<OnGhost<D>> {
    let all = world.all_gas();
    let each = world.walls.iter().map(|wall| {
        let near = wall.point.near(&all);
        let friction = liquids::friction(law, &wall.point, &near);
        OnGhost {
            force: liquids::thrust(law, &wall.point, &near) + friction,
            friction,
            heat: 0.0,
        }
    });
    each.collect()
}

fn law<const D: usize>(problem: &Problem<D>) -> liquids::Liquid {
    let scheme = &problem.scheme;
    liquids::Liquid {
        pairwise: scheme.operators.pressure == PressureGradient::Averaged,
        damped: scheme.operators.damping != Damping::None,
        sound: SOUND,
        density: DENSITY,
        viscosity: problem.gas.coefficients(DENSITY, SOUND * SOUND).viscosity,
    }
}

fn randomise<const D: usize>(solver: &mut Solver<D>) {
    let mut random = Random::new();
    solver.set_gas(|_, point: &mut Point<D>| {
        point.velocity = random.vector();
        point.density = DENSITY * (1.0 + 0.05 * random.next());
    });
}

fn compare<const D: usize>(problem: &Problem<D>) {
    let scheme = &problem.scheme;
    let law = law(problem);
    let mut summed = None;
    for instructions in instructions() {
        let mut solver = Solver::new(problem.clone(), instructions);
        randomise(&mut solver);
        solver.list();
        solver.evaluate();
        let (world, expected, on_ghosts) = summed.get_or_insert_with(|| {
            let (world, _) = known(law, &solver, problem);
            let rubbed = with_gradients(law, &world);
            let (gas, ghosts) = (rubbed.all_gas(), rubbed.all_ghosts());
            let each = rubbed.gas.iter();
            let each = each.map(|i| liquids::rate(law, i, &i.near(&gas), &i.near(&ghosts)));
            let expected: Vec<_> = each.collect();
            let on_ghosts = on_ghosts(law, &rubbed);
            (world, expected, on_ghosts)
        });
        agree_on_walls(&solver, &world.walls);
        if scheme.wall.extrapolation == Extrapolation::Wm {
            let mirrored = solver.mirrored();
            assert!(mirrored > 0.5, "{mirrored} of the ghosts have mirrors");
        }
        let rates = solver.rates();
        let name = scheme.name;
        let matrices = solver.renormalisations();
        agree(
            &format!("{name}: renormalisation"),
            matrices.iter().map(|r| matrix(&r.matrix)),
            world.gas.iter().map(|i| matrix(&i.renormalisation)),
        );
        agree(
            &format!("{name}: velocity gradient"),
            rates.iter().map(|r| matrix(&r.velocity_gradient)),
            expected.iter().map(|r| matrix(&r.velocity_gradient)),
        );
        agree(
            &format!("{name}: acceleration"),
            rates.iter().map(|r| array(&r.acceleration)),
            expected.iter().map(|r| array(&r.acceleration)),
        );
        agree(
            &format!("{name}: acceleration by walls"),
            rates.iter().map(|r| array(&r.wall_acceleration)),
            expected.iter().map(|r| array(&r.wall_acceleration)),
        );
        agree(
            &format!("{name}: rate of density"),
            rates.iter().map(|r| [r.density]),
            expected.iter().map(|r| [r.density]),
        );
        if scheme.transport_velocity.at_rest {
            agree(
                "drift of particles at rest",
                rates.iter().map(|r| array(&r.shift)),
                solver.gas().iter().map(|i| array(&-i.velocity)),
            );
        }
        agree_on_loads(&solver, &world.walls, on_ghosts);
    }
}

/// Beside walls, with and without friction and mirrors, and rubbed in a box without.
fn agrees(scheme: Scheme) {
    compare(&boxed::<1>(scheme, WALL, 0.0));
    compare(&boxed::<2>(scheme, WALL, 0.0));
    let mut problem = boxed::<2>(scheme, Side::Periodic, 0.3);
    compare(&problem);
    problem.domain.sides = [[PISTON, belt()], [WALL, Side::Symmetry]];
    compare(&problem);
    problem.scheme.wall.extrapolation = Extrapolation::Wm;
    compare(&problem);
}

#[test]
fn density_evolved_is_that_of_the_reference() {
    agrees(Scheme::L_IPST_C);
}

#[test]
fn pressure_evolved_is_that_of_the_reference() {
    agrees(Scheme::PE_IPST_C);
    compare(&boxed::<3>(Scheme::PE_IPST_C, Side::Periodic, 0.3));
}

#[test]
fn a_transport_velocity_is_that_of_the_reference() {
    agrees(Scheme::TV_C);
}

#[test]
fn what_passes_particles_at_rest_is_that_of_the_reference() {
    agrees(Scheme::E_C);
}

#[test]
fn means_of_pairs_are_those_of_the_reference() {
    agrees(Scheme::EDAC);
    compare(&boxed::<3>(Scheme::EDAC, Side::Periodic, 0.3));
}

#[test]
fn particles_are_moved_apart_as_the_reference_moves_them() {
    for scheme in [Scheme::L_IPST_C, Scheme::PE_IPST_C] {
        let mut problem = boxed::<2>(scheme, WALL, 0.0);
        problem.domain.sides[0][1] = Side::Symmetry;
        for instructions in instructions() {
            let mut solver = Solver::new(problem.clone(), instructions);
            randomise(&mut solver);
            solver.list();
            solver.evaluate();
            let (world, renormalised) = known(law(&problem), &solver, &problem);
            let both = world.gas.iter().zip(&renormalised);
            let expected: Vec<_> = both.map(|(i, r)| liquids::evened_out(i, r)).collect();
            assert!(solver.move_apart());
            let gas = solver.gas();
            let both = |what: &str, get: &dyn Fn(&Point<2>) -> [f64; 3]| {
                agree(what, gas.iter().map(get), expected.iter().map(get));
            };
            both("position", &|i| array(&i.position));
            both("velocity", &|i| array(&i.velocity));
            both("density", &|i| [i.density, 0.0, 0.0]);
        }
    }
}
