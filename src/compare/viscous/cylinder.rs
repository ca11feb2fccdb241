//! A cylinder that gas creeps past, with a steady wake.

use aero_validation::table::{Check, Subject};

use super::NAME;
use crate::context::{CompareError, Context, Level};
use crate::scenes::{Source, scene};

const SCENE: Source = scene!("cylinder-viscous");

/// Per cent.
const ALLOWED: f64 = 3.0;

/// What the cylinder is in, and its drag coefficient there at a Reynolds number of 20.
struct Room {
    name: &'static str,
    settings: &'static [&'static str],
    theory: &'static str,
    drag: f64,
}

const UNBOUNDED: Room = Room {
    name: "32 cells to its diameter",
    settings: &[],
    theory: "incompressible, without bounds (Dennis & Chang 1970)",
    drag: 2.045,
};

const fn channel(name: &'static str, settings: &'static [&'static str]) -> Room {
    Room {
        name,
        settings,
        theory: "incompressible, slip walls 15 diameters apart (Negi, Ramachandran & Haftu 2020)",
        drag: 2.317,
    }
}

const QUICK: Room = channel(
    "in a channel, 16 cells to its diameter",
    &[
        "domain.min=[-5.0, 0.0]",
        "domain.max=[10.0, 7.5]",
        "domain.sides.y_max=symmetry",
        "spacing=0.5",
        "scheme.refine=3",
    ],
);

const FULL: Room = channel(
    "in a channel, 32 cells to its diameter",
    &[
        "domain.min=[-5.0, 0.0]",
        "domain.max=[10.0, 7.5]",
        "domain.sides.y_max=symmetry",
        "spacing=0.5",
        "scheme.refine=4",
    ],
);

pub(super) fn compare(context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    let rooms = match context.level {
        Level::Quick => &[QUICK][..],
        Level::Full => &[QUICK, FULL, UNBOUNDED][..],
    };
    let drag = |room: &Room| {
        let what = format!("cylinder, Re 20, M 0.1, {}: c_d", room.name);
        let subject = Subject::new(NAME, &what, room.theory);
        let settings: Vec<String> = room.settings.iter().map(ToString::to_string).collect();
        let attempt = SCENE.attempt(&settings, context)?;
        Ok(match attempt.outcome() {
            None => subject.unmeasured(room.drag),
            Some(outcome) => {
                let body = &outcome.summary.bodies["cylinder"];
                subject.relative(body.cd.unwrap_or(f64::NAN), room.drag, ALLOWED)
            }
        })
    };
    rooms.iter().map(drag).collect()
}
