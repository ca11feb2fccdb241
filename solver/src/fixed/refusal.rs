//! What cannot be flown on points that stay where they are.

use crate::method::Time;
use crate::problem::{Problem, Side};

/// The remedy for what moves.
const REMEDY: &str =
    "points that stay where they are cannot follow it; use `scheme.motion = \"with-the-gas\"`";

impl<const D: usize> Problem<D> {
    /// Refuses by name what moves, what gas without viscosity would stick to, and sources that change while the flow settles.
    ///
    /// # Errors
    /// What it is and the remedy.
    pub fn check_fixed(&self) -> Result<(), String> {
        let settles = (self.method.fixed()).is_some_and(|points| points.time == Time::Settle);
        if settles
            && self
                .source
                .as_ref()
                .is_some_and(|source| !source.is_steady())
        {
            return Err(
                "what is added to the equations changes with time, and is marched through time alone; \
                 use `scheme.time = \"accurate\"`"
                    .into(),
            );
        }
        for body in &self.bodies {
            let name = &body.name;
            if body.motion.is_moving() {
                return Err(format!("body `{name}` moves; {REMEDY}"));
            }
            if body.wall.sticks() && !self.gas.is_viscous() {
                return Err(sticks(&format!("body `{name}`")));
            }
        }
        for (axis, sides) in self.domain.sides.iter().enumerate() {
            for (end, side) in sides.iter().enumerate() {
                let name = format!("side `{}_{}`", ["x", "y", "z"][axis], ["min", "max"][end]);
                let Side::Wall {
                    kind,
                    velocity,
                    acceleration,
                } = side
                else {
                    continue;
                };
                if *velocity != 0.0 || *acceleration != 0.0 {
                    return Err(format!("{name} moves; {REMEDY}"));
                }
                if kind.sticks() && !self.gas.is_viscous() {
                    return Err(sticks(&name));
                }
            }
        }
        Ok(())
    }
}

fn sticks(what: &str) -> String {
    format!(
        "{what} is `no-slip`, but gas without viscosity slides on points that stay where they are; give the gas a viscosity, or use `slip`"
    )
}

/// Refuses a vacuum.
pub fn vacuum(place: &[f64]) -> String {
    let place: Vec<String> = place.iter().map(|x| format!("{x:.6}")).collect();
    format!(
        "there is a vacuum at ({}) at the start; {REMEDY}",
        place.join(", ")
    )
}
