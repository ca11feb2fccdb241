//! How much finer thin and bent parts of a body are resolved than the flow.

use std::path::Path;

use aero::fly::{Costs, Flight};
use aero::run::{Burst, burst};
use aero::scene::Scene;

use super::super::CommandError;
use super::super::scene::checked;

/// Cells across a part of which fewer do not show its shape.
const SEEN: f64 = 2.0;

/// So many times the points are worth it where the thinnest part is not seen.
const UNSEEN_IS_WORTH: f64 = 3.0;

/// So many times the seconds before the first step one more halving takes.
const GROWS: f64 = 4.0;

/// So many times the points that a halving adds the next one adds at least: those along edges are twice as many.
const ADDS: f64 = 2.0;

/// Part of the time within which one more is tried.
const TRIED: f64 = 0.03;

/// The coarsest run is no coarser than the look by more than this: its box is still a few cells wide.
const COARSEST: f64 = 2.0;

/// Gives the body as many halvings of its own as make no more points, at the spacing of the look, than all of the box would hold if it had the
/// flow's finest `cells` everywhere: its share shrinks as spacings do; and as
/// leave `seconds` enough for a family whose coarsest run still shows the flow.
///
/// # Errors
/// A scene that makes no sense; a flow that fails at once has the halvings that went before.
pub(super) fn resolve(
    flight: &mut Flight,
    look: f64,
    cells: f64,
    seconds: f64,
) -> Result<(), CommandError> {
    let costs = Costs::new(flight.dimension(), false);
    let each = f64::from(1_u32 << flight.near_halvings()).powi(flight.dimension() as i32);
    let mut points = Vec::new();
    loop {
        let finest = look / f64::from(1_u32 << flight.body_halvings());
        let is_seen = flight.thinnest.is_none_or(|thin| thin > SEEN * finest);
        let worth = if is_seen { 1.0 } else { UNSEEN_IS_WORTH };
        let most = worth * each * cells;
        if least_next(&points).is_some_and(|next| next > most) || !flight.come_closer() {
            return Ok(());
        }
        let text = flight.scene(look, None).map_err(CommandError::wrong)?;
        let scene =
            Scene::parse(&text, &flight.name, Path::new(".")).map_err(CommandError::wrong)?;
        let seen = burst(checked(&scene)?, 0.0);
        let is_worth_it = |seen: &Burst| {
            let seconds_of = [seen.seconds_before, seen.seconds_per_step];
            let took = Costs::of_burst(seconds_of, seen.steps_to_go, seen.settles);
            seen.gas as f64 <= most && costs.fit(took, seconds) <= COARSEST
        };
        let Some(seen) = seen.ok().filter(is_worth_it) else {
            flight.stand_back();
            return Ok(());
        };
        points.push(seen.gas as f64);
        // It would take much of the time only to see that the next is too much.
        if GROWS * seen.seconds_before > TRIED * seconds {
            return Ok(());
        }
    }
}

/// Points with one more halving than the last of these have, at least.
fn least_next(points: &[f64]) -> Option<f64> {
    let [.., before, last] = points else {
        return None;
    };
    Some(last + ADDS * (last - before))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_halving_adds_twice_what_the_last_one_added() {
        assert_eq!(least_next(&[100.0]), None);
        assert_eq!(least_next(&[50.0, 100.0, 130.0]), Some(190.0));
    }
}
