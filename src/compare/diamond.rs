//! A diamond at an incidence, the whole of it: what gas does at the tip that parts it.

use aero::run::{Keep, Outcome};
use aero_validation::exact::diamond::{Diamond, diamond};
use aero_validation::table::Check;

use super::context::{CompareError, Context, Level};
use super::row::{Heading, Row};
use super::scenes::{Source, scene};
use super::suite::Suite;
use super::variant::Levels;

const CASE: &str = "diamond";
const SCENE: Source = scene!("diamond");
const THEORY: &str = "shock-expansion theory (Anderson, Modern Compressible Flow, 4.15), exact";
const MACH: f64 = 3.0;
/// Inclination of its sides, degrees, and where its tip is.
const HALF_ANGLE: f64 = 8.0;
const TIP: f64 = 0.0137;
/// Degrees: a shock on both sides of the leading edge, and a fan on the upper one.
const INCIDENCES: [f64; 2] = [3.0, 10.0];
/// Cells to the chord.
const QUICK: [u32; 1] = [40];
const FULL: [u32; 3] = [40, 80, 160];
/// Farthest departure that is allowed on the front sides, from the tip on, at any spacing.
const FRONT: f64 = 5e-3;
/// Of lift and drag at 40 cells, and the order with which it falls.
const LOADS: [(f64, f64); 2] = [(0.3e-2, 1.0), (0.3e-2, 1.0)];

/// The diamond, from coarse to fine.
pub const DIAMOND: Suite = Suite::of(&[(Levels::Both, compare)]);

fn compare(context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    let is_quick = context.level == Level::Quick;
    let cells: &[u32] = if is_quick { &QUICK } else { &FULL };
    let mut checks = Vec::new();
    for incidence in INCIDENCES {
        let [half, turned] = [HALF_ANGLE, incidence].map(f64::to_radians);
        let theory = diamond(half, MACH, turned, 1.4)?;
        for &cells in cells {
            let label = format!("{incidence} degrees, dx c/{cells}, points, settled");
            let heading = Heading {
                case: CASE,
                label: &label,
                only_informs: false,
                is_quick,
            };
            let settings = [
                format!("spacing={:?}", 1.0 / f64::from(cells)),
                format!("free_stream.incidence={incidence:?}"),
            ];
            let outcome = SCENE.run(&settings, Keep::End, context)?;
            let rows = rows(&outcome, &theory, cells);
            checks.extend(rows.into_iter().map(|row| row.check(heading)));
        }
    }
    Ok(checks)
}

fn rows(outcome: &Outcome, theory: &Diamond, cells: u32) -> Vec<Row> {
    let off = front_off(outcome, theory, cells);
    let mut rows: Vec<Row> = ["upper", "lower"]
        .into_iter()
        .zip(off)
        .map(|(face, off)| {
            let quantity = format!("pressure on the {face} front side, farthest off");
            Row::at_most(quantity, THEORY, off, FRONT)
        })
        .collect();
    let body = &outcome.summary.bodies["diamond"];
    let loads = [
        ("lift coefficient", body.cl_mean, theory.loads.lift),
        ("drag coefficient", body.cd_mean, theory.loads.drag),
    ];
    for ((what, measured, exact), (allowed, order)) in loads.into_iter().zip(LOADS) {
        let allowed = 100.0 * allowed * (40.0 / f64::from(cells)).powf(order);
        let measured = measured.unwrap_or(f64::NAN);
        rows.push(Row::relative(what, THEORY, measured, exact, [allowed; 2]));
    }
    rows
}

/// Farthest departure of the pressure on the front of the upper and of the lower face, up to the cell that holds the shoulder.
fn front_off(outcome: &Outcome, theory: &Diamond, cells: u32) -> [f64; 2] {
    let panels = &outcome.panels;
    let shoulder = TIP + 0.5 - 1.0 / f64::from(cells);
    let mut off = [0.0_f64; 2];
    for n in 0..panels.area.len() {
        let ends = [0, 1].map(|k| panels.points[2 * n + k][0]);
        if ends[0].max(ends[1]) < shoulder {
            let is_lower = panels.normal[n][1] < 0.0;
            let exact = if is_lower { theory.lower } else { theory.upper };
            let ratio = 1.4 * panels.pressure[n] / exact[0];
            let most = &mut off[usize::from(is_lower)];
            *most = most.max((ratio - 1.0).abs());
        }
    }
    off
}
