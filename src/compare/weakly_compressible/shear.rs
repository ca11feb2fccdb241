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
/// Least order of that of a scheme of liquids.
const ORDER: f64 = 1.8;

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
        for mover in [Mover::Wall, Mover::Force] {
            let mut errors = Vec::new();
            for &cells in cells {
                let error = mover.error(scheme, cells, context)?;
                checks.push(mover.check(scheme, cells, error));
                errors.push(error);
            }
            if let [Some(coarse), Some(fine)] = errors[..] {
                let order = (coarse / fine).log2();
                checks.push(mover.order(scheme, [cells[0], cells[1]], order));
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

    fn name(self) -> &'static str {
        match self {
            Self::Wall => "shear",
            Self::Force => "channel",
        }
    }

    fn check(self, scheme: &str, cells: u32, error: Option<f64>) -> Check {
        let name = self.name();
        let what = format!(
            "{scheme}, {name} that starts, {cells} cells: largest error of the velocity, per cent"
        );
        let subject = Subject::new(NAME, &what, THEORY);
        match error {
            None => subject.unmeasured(ALLOWED),
            Some(error) => subject.at_most(100.0 * error, ALLOWED),
        }
    }

    /// What conserves momentum to round-off is not of second order among particles that have moved, and is told.
    fn order(self, scheme: &str, [coarse, fine]: [u32; 2], order: f64) -> Check {
        let name = self.name();
        let what =
            format!("{scheme}, {name} that starts, {coarse} to {fine} cells: order of that error");
        let subject = Subject::new(NAME, &what, THEORY);
        if scheme == "conservative" {
            subject.informs(order, 2.0)
        } else {
            subject.at_least(order, ORDER)
        }
    }

    /// Largest error of the velocity over the speed that all comes to; none of a run that fails.
    fn error(
        self,
        scheme: &str,
        cells: u32,
        context: &Context<'_>,
    ) -> Result<Option<f64>, CompareError> {
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
        if let Self::Force = self {
            settings.push("domain.sides.y_max={ wall = { kind = \"no-slip\" } }".into());
        }
        let attempt = SCENE.attempt(&settings, context)?;
        Ok(attempt.outcome().map(|outcome| {
            let gas = &outcome.gas;
            let errors = gas.position.iter().zip(&gas.velocity);
            let errors = errors.map(|(place, found)| (found[0] - self.speed(place[1])).abs());
            errors.fold(0.0, f64::max)
        }))
    }
}
