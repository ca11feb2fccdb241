//! A map of where the schemes hold: wedge flows from subsonic to Mach 20, over angle and over spacing.
//!
//! A run is *fine* when it comes to its end without a particle in the wall and close to what is
//! known of it: the pressure on the ramp behind an attached shock, the total enthalpy where the shock is
//! detached or there is none. It is *degraded* when it comes to its end otherwise, *failed* when it stops.

use std::fmt::Write as _;

use aero_validation::exact::oblique::{Strength, detachment, oblique_shock};
use aero_validation::metrics::invariants::total_enthalpy;
use aero_validation::metrics::median;
use aero_validation::pictures::PictureError;
use aero_validation::pictures::mosaic::{Mosaic, Panel, Tile, Verdict};
use aero_validation::table::{Check, Subject};

use aero::run::Outcome;

use super::context::{CompareError, Context, Level};
use super::scenes::Attempt;
use super::suite::Suite;
use super::variant::{Levels, Scheme};
use super::wedge::SCENE;

const NAME: &str = "stability";
const GAMMA: f64 = 1.4;
/// Pressure of the stream, `1 / gamma`: the speed of sound is 1.
const PRESSURE: f64 = 1.0 / GAMMA;
const MACHS: [f64; 10] = [0.3, 0.8, 1.2, 1.5, 2.0, 3.0, 5.0, 8.0, 12.0, 20.0];
/// Degrees.
const ANGLES: [f64; 7] = [2.0, 5.0, 10.0, 15.0, 20.0, 30.0, 40.0];
/// Where along the ramp, which ends at 3, its pressure is read.
const READ: std::ops::Range<f64> = 1.5..2.8;
/// Cells per unit length at the angle below, coarse to fine; the last ones at the full level alone.
const SPACINGS: [(u32, Level); 4] = [
    (4, Level::Quick),
    (8, Level::Quick),
    (16, Level::Full),
    (32, Level::Full),
];
const ANGLE: f64 = 20.0;
/// How often the stream crosses the box, which is four long.
const CROSSINGS: f64 = 3.0;
/// Departure of the ramp's pressure, or the 95th percentile of that of the total enthalpy, beyond which
/// a run is degraded.
const CLOSE: f64 = 0.05;
const SCHEMES: [Scheme; 4] = [
    Scheme::USUAL,
    Scheme::USUAL.wm(),
    Scheme::USUAL.paper(),
    Scheme::USUAL.paper().wm(),
];

/// One wedge.
#[derive(Clone, Copy, Debug)]
struct Wedge {
    mach: f64,
    /// Degrees.
    angle: f64,
    cells: u32,
}

/// What became of one run.
struct Finding {
    wedge: Wedge,
    tile: Tile,
    /// A sentence about it.
    reason: String,
}

/// The map: two pictures, a table of every run, and the counts as rows.
pub const STABILITY: Suite = Suite::of(&[(Levels::Both, compare)]);

/// Flies all wedges by all schemes.
fn compare(context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    let cells = match context.level {
        Level::Quick => 8,
        Level::Full => 16,
    };
    let spacings: Vec<u32> = SPACINGS
        .iter()
        .filter(|(_, level)| *level == Level::Quick || context.level == Level::Full)
        .map(|(cells, _)| *cells)
        .collect();
    let by_angle: Vec<Vec<Wedge>> = ANGLES
        .iter()
        .rev()
        .map(|&angle| row(|mach| Wedge { mach, angle, cells }))
        .collect();
    let by_spacing: Vec<Vec<Wedge>> = spacings
        .iter()
        .rev()
        .map(|&cells| {
            row(|mach| Wedge {
                mach,
                angle: ANGLE,
                cells,
            })
        })
        .collect();
    let mut checks = Vec::new();
    let mut table = String::from("scheme,extrapolation,mach,angle,cells,verdict,reason\n");
    let mut panels = [Vec::new(), Vec::new()];
    for scheme in SCHEMES {
        let mut counts = [0_u32; 3];
        for (wedges, panels) in [&by_angle, &by_spacing].into_iter().zip(&mut panels) {
            let mut rows = Vec::new();
            for line in wedges {
                let findings = line.iter().map(|wedge| wedge.fly(scheme, context));
                let findings = findings.collect::<Result<Vec<_>, _>>()?;
                for finding in &findings {
                    counts[finding.tile.verdict as usize] += 1;
                    finding.write(scheme, &mut table);
                }
                rows.push(findings.into_iter().map(|f| f.tile).collect());
            }
            panels.push(Panel {
                title: format!("{}, {}", scheme.equations, scheme.extrapolation),
                rows,
            });
        }
        checks.extend(count_rows(scheme, counts));
    }
    let path = context.out.join("stability.csv");
    std::fs::write(&path, table).map_err(|error| PictureError::Write {
        path,
        reason: error.to_string(),
    })?;
    let [angles, spacings_panels] = panels;
    let mosaic = |what: &str, down: &str, rows: Vec<String>, panels| Mosaic {
        title: format!("Wedges: {what}"),
        across: "Mach number of the stream".into(),
        columns: MACHS.iter().map(ToString::to_string).collect(),
        down: down.into(),
        rows,
        panels,
    };
    let labels = ANGLES.iter().rev().map(ToString::to_string).collect();
    mosaic(
        &format!("angle by Mach number, dx 1/{cells}; per cent off theory"),
        "angle, degrees",
        labels,
        angles,
    )
    .save(&context.out.join("stability-angles.png"))?;
    let labels = spacings.iter().rev().map(|n| format!("1/{n}")).collect();
    mosaic(
        &format!("spacing by Mach number, {ANGLE} degrees; per cent off theory"),
        "spacing",
        labels,
        spacings_panels,
    )
    .save(&context.out.join("stability-spacings.png"))?;
    Ok(checks)
}

fn row(wedge: impl Fn(f64) -> Wedge) -> Vec<Wedge> {
    MACHS.iter().map(|&mach| wedge(mach)).collect()
}

/// How many runs were fine, degraded and failed. The conservative scheme is not to fail anywhere.
fn count_rows(scheme: Scheme, counts: [u32; 3]) -> [Check; 3] {
    let words = ["fine", "degraded", "failed"];
    let total: u32 = counts.iter().sum();
    std::array::from_fn(|k| {
        let quantity = format!("{scheme}: runs {}, of {total}", words[k]);
        let subject = Subject::new(NAME, &quantity, "every run comes to its end");
        if k == 2 && scheme.is_conservative() {
            subject.at_most(f64::from(counts[k]), 0.0)
        } else {
            subject.informs(
                f64::from(counts[k]),
                f64::from(if k == 0 { total } else { 0 }),
            )
        }
    })
}

impl Finding {
    fn write(&self, scheme: Scheme, table: &mut String) {
        let Wedge { mach, angle, cells } = self.wedge;
        let verdict = self.tile.verdict.word();
        let Scheme {
            equations,
            extrapolation,
            ..
        } = scheme;
        let reason = self.reason.replace('"', "'");
        let _ = writeln!(
            table,
            "{equations},{extrapolation},{mach},{angle},{cells},{verdict},\"{reason}\""
        );
    }
}

impl Wedge {
    fn fly(self, scheme: Scheme, context: &Context<'_>) -> Result<Finding, CompareError> {
        let settings = self.settings(scheme);
        let (tile, reason) = match SCENE.attempt(&settings, context)? {
            Attempt::Stopped(reason, _) => {
                let tile = Tile {
                    verdict: Verdict::Failed,
                    note: "stops".into(),
                };
                (tile, reason)
            }
            Attempt::Ended(outcome) => self.judge(&outcome)?,
        };
        Ok(Finding {
            wedge: self,
            tile,
            reason,
        })
    }

    fn settings(self, scheme: Scheme) -> Vec<String> {
        let mut settings = vec![
            format!("free_stream.mach={}", self.mach),
            format!("body.ramp.shape.compression_corner.angle={:?}", self.angle),
            format!("spacing={}", self.spacing()),
            format!("end_time={}", CROSSINGS * 4.0 / self.mach),
        ];
        settings.extend(scheme.settings());
        settings
    }

    fn spacing(self) -> f64 {
        1.0 / f64::from(self.cells)
    }

    /// How a run that came to its end turned out.
    fn judge(self, outcome: &Outcome) -> Result<(Tile, String), CompareError> {
        let (departure, what) = self.departure(outcome)?;
        let leaked = outcome.summary.leaked;
        let fine = departure <= CLOSE && leaked == 0;
        let note = if leaked > 0 && departure <= CLOSE {
            format!("{leaked} in")
        } else if departure.is_finite() {
            format!("{:.1}", 100.0 * departure)
        } else {
            "?".into()
        };
        let verdict = if fine {
            Verdict::Fine
        } else {
            Verdict::Degraded
        };
        let percent = 100.0 * departure;
        let reason = format!("{what} off by {percent:.2} per cent, {leaked} particles in the wall");
        Ok((Tile { verdict, note }, reason))
    }

    /// Departure from what is known of the flow, and of what.
    fn departure(self, outcome: &Outcome) -> Result<(f64, &'static str), CompareError> {
        let gas = &outcome.gas;
        let angle = self.angle.to_radians();
        let attached = self.mach > 1.0 && angle < detachment(self.mach, GAMMA)?.deflection;
        if !attached {
            let stream = GAMMA / (GAMMA - 1.0) * PRESSURE + 0.5 * self.mach * self.mach;
            let found = total_enthalpy(&gas.velocity, &gas.density, &gas.pressure, stream, GAMMA);
            return Ok((found?.percentile_95, "total enthalpy"));
        }
        let shock = oblique_shock(self.mach, angle, GAMMA, Strength::Weak)?;
        let wall = &outcome.surface;
        let mut pressures: Vec<f64> = wall
            .position
            .iter()
            .zip(&wall.pressure)
            .filter(|(foot, _)| READ.contains(&foot[0]))
            .map(|(_, pressure)| *pressure)
            .collect();
        let departure = median(&mut pressures) / PRESSURE / shock.pressure_ratio - 1.0;
        Ok((departure.abs(), "pressure on the ramp"))
    }
}
