//! What cannot be flown on points that stay where they are.

use super::cells::{Cells, WallOwner};
use crate::method::Time;
use crate::problem::{Problem, Side, side_name};

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
                let name = format!("side `{}`", side_name(axis, end));
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

    /// Refuses a side that bodies are to close where none of them meets its `cells`.
    ///
    /// # Errors
    /// Which side, where, and the remedy.
    pub(super) fn check_closed(&self, cells: &Cells<D>) -> Result<(), String> {
        for wall in &cells.walls {
            let WallOwner::Side { axis, end } = wall.owner else {
                continue;
            };
            let (axis, end) = (usize::from(axis), usize::from(end));
            if self.domain.side_at(axis, end, &wall.foot) == Side::Body {
                let place: Vec<String> = wall.foot.iter().map(|x| format!("{x:.4}")).collect();
                return Err(format!(
                    "side `{}` is to be closed by a body, and there is none at ({}); let a body reach across the side, or say what is there, \
                     `\"wall\"` for one",
                    side_name(axis, end),
                    place.join(", ")
                ));
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

/// Refuses more points than memory holds.
pub fn no_room(who: &str, count: u64, room: u64) -> String {
    format!(
        "{who} for about {} million points by halvings of the spacing, and there is memory for {}; take fewer halvings, or give a number \
         of points: `scheme.refine = {{ points = {} }}`",
        millions(count),
        millions(room),
        room / 2
    )
}

/// Rounded to three digits.
fn millions(count: u64) -> String {
    let millions = count as f64 * 1e-6;
    let digits = (2 - millions.log10().floor() as i32).clamp(0, 6) as usize;
    format!("{millions:.digits$}")
}
