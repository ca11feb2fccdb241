//! Liquid that a wall or a force sets in motion: flows of Couette and Poiseuille as they start.

use aero_validation::exact::channel::Channel;
use aero_validation::table::{Check, Subject};

use super::NAME;
use crate::context::{CompareError, Context, Level};
use crate::scenes::{Source, scene};

const SCENE: Source = scene!("cavity");
const THEORY: &str = "channel flow from rest (Morris, Fox & Zhu 1997, eqs 35 and 36)";
const CHANNEL: Channel = Channel {
    height: 1.0,
    viscosity: 1.0,
};
/// By then the far wall has felt it.
const END: f64 = 0.1;
/// Cells along the walls; particles would meet their own images on fewer.
const WIDTH: u32 = 12;
/// Largest error over the speed of the wall, per cent.
const ALLOWED: f64 = 1.0;

pub(super) fn compare(context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    let (schemes, cells): (&[&str], &[u32]) = match context.level {
        Level::Quick => (&["L-IPST-C", "EDAC"], &[20]),
        Level::Full => (
            &[
                "L-IPST-C",
                "PE-IPST-C",
                "TV-C",
                "E-C",
                "EDAC",
                "conservative",
            ],
            &[20, 40],
        ),
    };
    let mut checks = Vec::new();
    for scheme in schemes {
        for &cells in cells {
            for mover in [Mover::Wall, Mover::Force] {
                checks.push(mover.check(scheme, cells, context)?);
            }
        }
    }
    Ok(checks)
}

/// What sets the liquid in motion, to a speed of one in the end.
#[derive(Clone, Copy, Debug)]
enum Mover {
    /// The upper wall, which slides.
    Wall,
    /// A force along the walls.
    Force,
}

impl Mover {
    /// The force per mass.
    fn force(self) -> f64 {
        match self {
            Self::Wall => 0.0,
            Self::Force => 8.0 * CHANNEL.viscosity / CHANNEL.height.powi(2),
        }
    }

    fn speed(self, y: f64) -> f64 {
        match self {
            Self::Wall => CHANNEL.dragged(1.0, y, END),
            Self::Force => CHANNEL.driven(self.force(), y, END),
        }
    }

    fn check(self, scheme: &str, cells: u32, context: &Context<'_>) -> Result<Check, CompareError> {
        let spacing = CHANNEL.height / f64::from(cells);
        let mut settings = vec![
            format!("scheme.equations={scheme}"),
            format!("spacing={spacing:?}"),
            format!("end_time={END:?}"),
            format!("gas.viscosity={:?}", CHANNEL.viscosity),
            format!("domain.max=[{:?}, 1.0]", f64::from(WIDTH) * spacing),
            "domain.sides.x_min=periodic".into(),
            "domain.sides.x_max=periodic".into(),
            format!("body_force=[{:?}, 0.0]", self.force()),
        ];
        let name = match self {
            Self::Wall => "shear",
            Self::Force => {
                settings.push("domain.sides.y_max={ wall = { kind = \"no-slip\" } }".into());
                "channel"
            }
        };
        let what = format!(
            "{scheme}, {name} that starts, {cells} cells: largest error of the velocity, per cent"
        );
        let subject = Subject::new(NAME, &what, THEORY);
        let attempt = SCENE.attempt(&settings, context)?;
        Ok(match attempt.outcome() {
            None => subject.unmeasured(ALLOWED),
            Some(outcome) => {
                let gas = &outcome.gas;
                let errors = gas.position.iter().zip(&gas.velocity);
                let errors = errors.map(|(place, found)| (found[0] - self.speed(place[1])).abs());
                subject.at_most(100.0 * errors.fold(0.0, f64::max), ALLOWED)
            }
        })
    }
}
