//! Wings in space about points that stay, settled: what gas does at edges that part it, straight and swept, and in a hollow. Where nothing
//! changes along the span, it is what it does in the plane.

use aero::run::{Keep, Outcome};
use aero_validation::exact::diamond::diamond;
use aero_validation::exact::oblique::{Strength, oblique_shock};
use aero_validation::table::Check;

use super::context::{CompareError, Context, Level};
use super::row::{Heading, Row};
use super::scenes::{Source, scene};
use super::suite::Suite;
use super::surface::{Facet, as_shape, pressed, prism};
use super::variant::Levels;

const CASE: &str = "diamond";
const SCENE: Source = scene!("diamond");
const EXPANSION: &str = "shock-expansion theory (Anderson, Modern Compressible Flow, 4.15), exact";
const SHOCKS: &str = "oblique shock theory (NACA 1135, 1953)";
const CARET: &str = "oblique shock theory (Nonweiler 1959)";
const AIR: f64 = 1.4;
/// From an edge, in spacings, the walls that are looked at.
const LOOK: f64 = 4.0;

/// Wings.
pub const WINGS: Suite = Suite::of(&[
    (Levels::Both, straight),
    (Levels::Both, swept),
    (Levels::Both, hollow),
]);

/// A flow about one of them.
struct Wing {
    label: &'static str,
    file: &'static str,
    mach: f64,
    incidence: f64,
    facets: Vec<Facet>,
    domain: [[f64; 3]; 2],
    has_ends: bool,
}

impl Wing {
    /// At this many cells to the chord.
    fn run(&self, cells: u32, context: &Context<'_>) -> Result<Outcome, CompareError> {
        let [min, max] = self.domain;
        let far = if self.has_ends {
            "free-stream"
        } else {
            "symmetry"
        };
        let settings = [
            "dimension=3".into(),
            format!("spacing={:?}", 1.0 / f64::from(cells)),
            format!("free_stream.mach={:?}", self.mach),
            format!("free_stream.incidence={:?}", self.incidence),
            format!("domain.min={min:?}"),
            format!("domain.max={max:?}"),
            "domain.sides.z_min=symmetry".into(),
            format!("domain.sides.z_max={far}"),
            "body.diamond.place={ translate = [0.0137, 0.0071, 0.0] }".into(),
            "body.diamond.reference_area=0.125".into(),
            as_shape("diamond", context.out, self.file, &self.facets)?,
        ];
        SCENE.run(&settings, Keep::End, context)
    }

    /// The checks of `rows` at these spacings.
    fn checks(
        &self,
        context: &Context<'_>,
        rows: impl Fn(&Outcome, f64) -> Result<Vec<Row>, CompareError>,
    ) -> Result<Vec<Check>, CompareError> {
        let is_quick = context.level == Level::Quick;
        let cells: &[u32] = if is_quick { &[40] } else { &[40, 80] };
        let mut checks = Vec::new();
        for &cells in cells {
            let label = format!("{}, dx c/{cells}, points, settled", self.label);
            let heading = Heading {
                case: CASE,
                label: &label,
                only_informs: false,
                is_quick,
            };
            let outcome = self.run(cells, context)?;
            let rows = rows(&outcome, 1.0 / f64::from(cells))?;
            checks.extend(rows.into_iter().map(|row| row.check(heading)));
        }
        Ok(checks)
    }
}

/// The diamond with sides of fifteen degrees at Mach 6, from plane to plane.
fn straight(context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    let [half, incidence] = [15.0_f64, 2.0];
    let thick = 0.5 * half.to_radians().tan();
    let section = [[0.0, 0.0], [0.5, -thick], [1.0, 0.0], [0.5, thick]];
    let wing = Wing {
        label: "in space, M 6, 2 degrees, sides of 15",
        file: "diamond-in-space",
        mach: 6.0,
        incidence,
        facets: prism(&section, [-1.0, 1.0], |[x, y], z| [x, y, z]),
        domain: [[-0.2, -0.5, 0.0], [1.2, 0.5, 0.125]],
        has_ends: false,
    };
    let theory = diamond(half.to_radians(), wing.mach, incidence.to_radians(), AIR)?;
    wing.checks(context, |outcome, _| {
        let body = &outcome.summary.bodies["diamond"];
        let loads = [
            ("lift coefficient", body.cl_mean, theory.loads.lift),
            ("drag coefficient", body.cd_mean, theory.loads.drag),
        ];
        let row = |(what, measured, exact): (&str, Option<f64>, f64)| {
            Row::relative(what, EXPANSION, measured.unwrap_or(f64::NAN), exact, 1.0)
        };
        Ok(loads.into_iter().map(row).collect())
    })
}

/// Half of a wing under which the shock of a wedge lies in the plane of its swept edges.
fn swept(context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    const LONG: f64 = 1.4;
    const HALF_SPAN: f64 = 0.5;
    let [mach, turn] = [3.0, 10.0_f64.to_radians()];
    let shock = oblique_shock(mach, turn, AIR, Strength::Weak)?;
    let low = |angle: f64| -LONG * angle.tan();
    let tip = [0.0; 3];
    let top = [LONG, 0.0, 0.0];
    let groove = [LONG, low(turn), 0.0];
    let [right, left] = [1.0, -1.0].map(|side| [LONG, low(shock.angle), side * HALF_SPAN * LONG]);
    let wing = Wing {
        label: "caret wing, M 3, half of it",
        file: "caret-wing",
        mach,
        incidence: 0.0,
        facets: vec![
            [tip, right, top],
            [tip, groove, right],
            [tip, top, left],
            [tip, left, groove],
            [top, right, groove],
            [top, groove, left],
        ],
        domain: [[-0.1, -0.75, 0.0], [1.0, 0.25, 0.7]],
        has_ends: true,
    };
    wing.checks(context, |outcome, spacing| {
        let exact = shock.pressure_ratio;
        let size = right.iter().map(|part| part * part).sum::<f64>().sqrt();
        // Under the wing, away from its apex.
        let beside = |foot: &[f64; 3]| {
            let arm = [foot[0] - 0.0137, foot[1] - 0.0071, foot[2]];
            let along: f64 = arm.iter().zip(right).map(|(a, b)| a * b / size).sum();
            let square: f64 = arm.iter().map(|part| part * part).sum();
            // The upper side falls to the same edge as the lower one, from higher up.
            let upper = -shock.angle.tan() / HALF_SPAN * arm[2];
            let is_under = arm[1] < upper - 0.05 * spacing;
            let away = (square - along * along).max(0.0).sqrt() / spacing;
            (is_under && arm[0] > 8.0 * spacing && foot[0] < 0.95).then_some(away)
        };
        let mut rows = Vec::new();
        for (place, from, to, allowed) in [
            ("within 4 spacings of the swept edge", 0.0, LOOK, 1.0),
            ("farther from it", LOOK, f64::INFINITY, 0.5),
        ] {
            let is_there =
                |foot: &[f64; 3]| beside(foot).is_some_and(|away| (from..to).contains(&away));
            let [mean, _] = pressed(&outcome.surface, spacing, exact / AIR, is_there);
            let quantity = format!("pressure under the wing {place}, mean");
            rows.push(Row::relative(quantity, CARET, mean * AIR, exact, allowed));
        }
        Ok(rows)
    })
}

/// A side of 8 degrees, then one of 20.
fn hollow(context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    let [first, second] = [8.0_f64, 20.0].map(f64::to_radians);
    let section = [
        [1.6, 0.0],
        [1.6, 0.8 * (first.tan() + second.tan())],
        [0.8, 0.8 * first.tan()],
        [0.0, 0.0],
    ];
    let wing = Wing {
        label: "in space, M 4, sides of 8 and 20 degrees",
        file: "hollow-in-space",
        mach: 4.0,
        incidence: 0.0,
        facets: prism(&section, [-1.0, 1.0], |[x, y], z| [x, y, z]),
        domain: [[-0.2, -0.2, 0.0], [1.1, 0.7, 0.125]],
        has_ends: false,
    };
    let ahead = oblique_shock(wing.mach, first, AIR, Strength::Weak)?;
    let behind = oblique_shock(ahead.mach, second - first, AIR, Strength::Weak)?;
    wing.checks(context, |outcome, spacing| {
        let bend = 0.8 + 0.0137;
        let mut rows = Vec::new();
        let both = ahead.pressure_ratio * behind.pressure_ratio;
        for (place, exact, way) in [
            ("before", ahead.pressure_ratio, -1.0),
            ("behind", both, 1.0),
        ] {
            let is_there = |foot: &[f64; 3]| {
                foot[1] > 0.05 && (0.0..LOOK * spacing).contains(&(way * (foot[0] - bend)))
            };
            let found = pressed(&outcome.surface, spacing, exact / AIR, is_there);
            for (what, pressure, allowed) in
                [("mean", found[0], 1.0), ("farthest off", found[1], 2.0)]
            {
                let quantity =
                    format!("pressure in the {LOOK} spacings {place} the hollow, {what}");
                rows.push(Row::relative(
                    quantity,
                    SHOCKS,
                    pressure * AIR,
                    exact,
                    allowed,
                ));
            }
        }
        Ok(rows)
    })
}
