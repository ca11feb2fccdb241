//! Bodies flown from their files by `aero fly`: whether what is known of each lies in the band that it is given, and how wide that is.

mod bodies;
mod slow;
mod truth;

use std::path::Path;

use aero::fly::extrapolate;
use aero_validation::table::{Check, Subject};
use serde_json::Value;

use super::context::{CompareError, Context, Level};
use super::program;
use super::suite::Suite;
use super::variant::Levels;
use bodies::Facet;
use truth::{Known, Quantity, TWELVE};

const NAME: &str = "fly";
/// Minutes that each of the twelve may take.
const MINUTES: &str = "2";
/// The finest spacing of the quick flights, of a cone one long and a sphere one wide.
const SPACING: &str = "0.008";
/// Of the twelve, those that are flown quickly: one with a flat base, one that is round behind.
const QUICK: [usize; 2] = [0, 2];
/// Bodies whose truth may lie outside, of twelve.
const OUTSIDE: f64 = 1.0;
/// Half widths of the bands, per cent of the truth: the one in the middle.
const MIDDLE: f64 = 3.0;

/// The flights.
pub const FLIGHTS: Suite = Suite::alone(&[(Levels::Both, compare)]);

fn compare(context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    let folder = context.out.join(NAME);
    let (known, finely) = match context.level {
        Level::Quick => (QUICK.map(|n| TWELVE[n]).to_vec(), ["--spacing", SPACING]),
        Level::Full => (TWELVE.to_vec(), ["--minutes", MINUTES]),
    };
    let mut checks = Vec::new();
    let mut flown = Vec::new();
    for known in &known {
        (context.announce)(&format!("{NAME}: {}", known.label));
        let truth = known.truth()?;
        let flight = Flight {
            label: known.label,
            file: known.file,
            facets: (known.body)(),
            mach: known.mach,
            incidence: known.incidence,
            finely,
        };
        let found = known.found(&flight.report(&folder)?);
        let judged = |what: &str, judge: &dyn Fn(Subject<'_>) -> Check| {
            let what = format!("{}: {what}", known.label);
            judge(Subject::new(NAME, &what, known.source))
        };
        let quantity = known.quantity.name();
        let Some([value, band]) = found else {
            checks.push(judged(quantity, &|row| row.unmeasured(truth)));
            continue;
        };
        let [off, width] = [(value - truth).abs() / band, 100.0 * band / truth];
        flown.push([off, width]);
        checks.extend([
            judged(quantity, &|row| row.informs(value, truth)),
            judged("distance from the truth, half widths of the band", &|row| {
                row.informs(off, 0.0)
            }),
            judged("half the width of the band, per cent", &|row| {
                row.informs(width, 0.0)
            }),
        ]);
    }
    checks.extend(together(&flown, known.len()));
    checks.extend(slow::compare(context, &folder)?);
    Ok(checks)
}

/// Of all bodies, with distance from the truth over half the width, and half the width in per cent.
fn together(flown: &[[f64; 2]], all: usize) -> Vec<Check> {
    let inside = flown.iter().filter(|[off, _]| *off <= 1.0).count();
    let mut widths: Vec<f64> = flown.iter().map(|[_, width]| *width).collect();
    widths.resize(all, f64::INFINITY);
    widths.sort_by(f64::total_cmp);
    let middle = widths[all / 2];
    let are_all = all == TWELVE.len();
    let allowed = if are_all { OUTSIDE } else { 0.0 };
    let outside = format!("of {all}: bodies whose truth lies outside the band");
    let width = format!("of {all}: half the width of the band, per cent, the one in the middle");
    let outside = Subject::new(NAME, &outside, "theory, finer runs");
    let mut checks = vec![outside.at_most((all - inside) as f64, allowed)];
    // Two bodies have no middle.
    if are_all {
        checks.push(Subject::new(NAME, &width, "theory, finer runs").at_most(middle, MIDDLE));
    }
    checks
}

/// A body, its stream and how finely it is flown.
struct Flight {
    label: &'static str,
    /// Stem of its file.
    file: &'static str,
    facets: Vec<Facet>,
    mach: f64,
    /// Degrees.
    incidence: f64,
    finely: [&'static str; 2],
}

impl Flight {
    /// Flies it as it would be typed, and reads `fly.json`.
    fn report(&self, folder: &Path) -> Result<Value, CompareError> {
        let file = folder.join(format!("{}.stl", self.file));
        let file = program::given(&file, &bodies::stl(&self.facets))?;
        let out = folder.join(self.label.replace([' ', ','], "-"));
        let [mach, incidence] = [self.mach, self.incidence].map(|number| number.to_string());
        let threads = rayon::current_num_threads().to_string();
        let typed = [
            &["fly", &file, "--unit", "m", "--axis=-x,+y", "--overwrite"][..],
            &[
                "--altitude",
                "12km",
                "--mach",
                &mach,
                "--incidence",
                &incidence,
            ],
            &["--threads", &threads, "--out", &program::typed(&out)],
            &self.finely,
        ];
        program::run(&typed.concat())?;
        program::json(&out.join("fly.json"))
    }
}

impl Known {
    /// Value and half the width of its band, from a flight's report.
    fn found(&self, report: &Value) -> Option<[f64; 2]> {
        let point = report["points"].get(0)?;
        let number = |key: &str| point[key].as_f64();
        match self.quantity {
            Quantity::Forebody => Some([number("cd_forebody")?, number("cd_forebody_band")?]),
            Quantity::Lift => Some([number("cl")?, number("cl_band")?]),
            // Of lift and drag together: what the base adds to both is along the body.
            Quantity::Normal => {
                let (sin, cos) = self.incidence.to_radians().sin_cos();
                let levels = report["levels"].as_array()?.iter();
                let runs = levels.map(|level| {
                    let [lift, drag] = ["cl", "cd"].map(|key| level[key].as_f64());
                    Some((level["spacing"].as_f64()?, lift? * cos + drag? * sin))
                });
                let runs: Option<Vec<(f64, f64)>> = runs.collect();
                let found = extrapolate(&runs?);
                let swing = number("settled_percent")? / 100.0 * number("cd")? * sin;
                Some([found.value, found.band + swing])
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_of_twelve_may_lie_outside_and_none_of_one() {
        let mut flown = vec![[0.5, 1.0]; 12];
        assert!(together(&flown, 12).iter().all(|check| check.pass));
        flown[3] = [1.2, 40.0];
        assert!(together(&flown, 12).iter().all(|check| check.pass));
        flown[4] = [7.0, 0.1];
        assert!(!together(&flown, 12)[0].pass);
        // One that could not be flown lies outside, and its band is as wide as can be.
        assert!(!together(&flown[..10], 12)[0].pass);
        assert!(!together(&flown[3..4], 1)[0].pass);
        let wide = vec![[0.5, 3.5]; 12];
        assert!(!together(&wide, 12)[1].pass);
    }
}
