//! Which walls gas sticks to.

use aero_geometry::Vector;

use super::super::net::Net;
use super::super::stick::{Heat, Stick};
use super::Viscous;
use crate::problem::{NoSlip, Problem, Side, WallHeat, WallKind, side_name};
use crate::walls::wall_sides;

/// Part of its speed up to which the surface of a wall may move across itself: faces are flat where bodies are round.
const ACROSS: f64 = 0.2;

/// Tells the walls of `net`, whose cells have these `points`, that gas sticks to them, where it does in `problem`.
///
/// # Errors
/// A surface that is said to move across itself.
pub fn stick<const D: usize>(
    net: &mut Net<D>,
    points: &[Vector<D>],
    problem: &Problem<D>,
) -> Result<(), String> {
    if Viscous::of(&problem.gas).is_none() {
        return Ok(());
    }
    let bodies = problem
        .bodies
        .iter()
        .map(|body| (body.wall, body.name.clone()));
    let sides = wall_sides(&problem.domain).into_iter().map(|(axis, end)| {
        let name = side_name(axis, end);
        match problem.domain.sides[axis][end] {
            Side::Wall { kind, .. } => (kind, name),
            _ => (WallKind::Slip, name),
        }
    });
    let kinds: Vec<(WallKind, String)> = bodies.chain(sides).collect();
    for wall in net.blocks.iter_mut().flat_map(|block| &mut block.walls) {
        let (WallKind::NoSlip(kind), name) = &kinds[wall.owner as usize] else {
            continue;
        };
        let NoSlip { heat, slide } = kind;
        let normal = Vector::from(wall.image.normal);
        let velocity = slide.at(&wall.foot);
        let across = velocity.dot(&normal);
        if across.abs() > ACROSS * velocity.norm() {
            return Err(format!(
                "the surface of `{name}` is to move across itself near {:?}; give its wall a velocity along it, or the body a motion",
                wall.foot.as_slice()
            ));
        }
        let beside = slide.at(&points[wall.i as usize]);
        wall.stick = Some(Stick {
            velocity: (velocity - normal * across).into(),
            beside: (beside - normal * beside.dot(&normal)).into(),
            heat: match heat {
                WallHeat::Adiabatic => Heat::Flux(0.0),
                WallHeat::Flux(heat) => Heat::Flux(*heat),
                WallHeat::Temperature(temperature) => Heat::Temperature(*temperature),
            },
        });
    }
    Ok(())
}
