//! A spheroid slower than sound, which has no drag, and at an incidence a moment without a lift.

use std::path::Path;

use aero::fly::extrapolate;
use aero_validation::exact::spheroid::pitching_moment;
use aero_validation::table::{Check, Subject};
use serde_json::Value;

use super::{Flight, MINUTES, NAME, bodies};
use crate::context::{CompareError, Context, Level};

/// Length over thickness.
const FINENESS: f64 = 4.0;
const MACH: f64 = 0.5;
const DEGREES: f64 = 4.0;
/// The finest spacing of the flight along its axis, of a body one long.
const SPACING: &str = "0.01";
/// Drag over frontal area and dynamic pressure that is made by cells alone.
const DRAG: f64 = 0.015;
/// Moment, per cent.
const MOMENT: f64 = 5.0;

pub(super) fn compare(context: &Context<'_>, folder: &Path) -> Result<Vec<Check>, CompareError> {
    let mut checks = Vec::new();
    let flown = |label, incidence, finely| {
        (context.announce)(&format!("{NAME}: {label}"));
        Flight {
            label,
            file: "spheroid",
            facets: bodies::spheroid(FINENESS),
            mach: MACH,
            incidence,
            finely,
        }
        .report(folder)
    };
    let along = flown("spheroid, M 0.5", 0.0, ["--spacing", SPACING])?;
    let row = Subject::new(
        NAME,
        "spheroid, M 0.5: drag, without what its base may have",
        "d'Alembert 1752: none",
    );
    checks.push(match limit(&along, "cd") {
        Some([drag, _]) => row.absolute(drag, 0.0, DRAG),
        None => row.unmeasured(0.0),
    });
    if context.level == Level::Full {
        let inclined = flown("spheroid, M 0.5, 4 deg", DEGREES, ["--minutes", MINUTES])?;
        let exact = pitching_moment(FINENESS, MACH, DEGREES);
        let row = |what| Subject::new(NAME, what, "Munk 1924; Göthert 1940");
        let moment = "spheroid, M 0.5, 4 deg: pitching moment";
        let band = "spheroid, M 0.5, 4 deg: distance from the truth, half widths of the band";
        match limit(&inclined, "cm") {
            Some([value, width]) => checks.extend([
                row(moment).relative(value, exact, MOMENT),
                row(band).at_most((value - exact).abs() / width, 1.0),
            ]),
            None => checks.push(row(moment).unmeasured(exact)),
        }
    }
    Ok(checks)
}

/// Value at no spacing of a coefficient, and half the width of its band, the base's share left out.
fn limit(report: &Value, key: &str) -> Option<[f64; 2]> {
    let levels = report["levels"].as_array()?.iter();
    let runs = levels.map(|level| Some((level["spacing"].as_f64()?, level[key].as_f64()?)));
    let found = extrapolate(&runs.collect::<Option<Vec<_>>>()?);
    Some([found.value, found.band])
}
