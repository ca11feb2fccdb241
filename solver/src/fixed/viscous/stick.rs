//! Walls that gas sticks to.

use aero_geometry::Vector;

use super::super::net::Net;
use super::super::state::Primitive;
use super::Viscous;
use crate::problem::{NoSlip, Problem, Side, WallHeat, WallKind};
use crate::walls::wall_sides;

/// Least part of a cell's density that its image behind a hot wall has.
const LEAST_DENSITY: f64 = 0.1;

/// Part of its speed up to which the surface of a wall may move across itself: faces are flat where bodies are round.
const ACROSS: f64 = 0.2;

/// How gas sticks to a face.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stick<const D: usize> {
    /// Velocity of the surface, along the face.
    pub velocity: [f64; D],
    /// What heat does.
    pub heat: Heat,
}

/// What heat does at a face.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Heat {
    /// The gas there has this `p / rho`.
    Level(f64),
    /// So much goes into the gas per area and time.
    Flux(f64),
}

impl<const D: usize> Stick<D> {
    /// The state behind the wall that makes that on it the mean of both, of gas in the state of `cell`.
    pub fn beyond(&self, cell: &Primitive<D>) -> Primitive<D> {
        let mut velocity = self.velocity;
        for k in 0..D {
            velocity[k] += self.velocity[k] - cell.velocity[k];
        }
        let density = match self.heat {
            Heat::Level(level) => {
                (2.0 * cell.pressure / level - cell.density).max(LEAST_DENSITY * cell.density)
            }
            Heat::Flux(_) => cell.density,
        };
        Primitive {
            density,
            velocity,
            pressure: cell.pressure,
        }
    }
}

/// Tells the walls of `net` that gas sticks to them, where it does in `problem`.
///
/// # Errors
/// A surface that is said to move across itself.
pub fn stick<const D: usize>(net: &mut Net<D>, problem: &Problem<D>) -> Result<(), String> {
    let Some(viscous) = Viscous::of(&problem.gas) else {
        return Ok(());
    };
    let bodies = problem
        .bodies
        .iter()
        .map(|body| (body.wall, body.name.clone()));
    let sides = wall_sides(&problem.domain).into_iter().map(|(axis, end)| {
        let name = format!("{}_{}", ["x", "y", "z"][axis], ["min", "max"][end]);
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
        wall.stick = Some(Stick {
            velocity: (velocity - normal * across).into(),
            heat: match heat {
                WallHeat::Adiabatic => Heat::Flux(0.0),
                WallHeat::Flux(heat) => Heat::Flux(*heat),
                WallHeat::Temperature(temperature) => Heat::Level(viscous.heat(*temperature)),
            },
        });
    }
    Ok(())
}
