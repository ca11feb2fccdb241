//! The ridge of a wing in space about points that stay, eleven degrees on a span of forty chords: what presses before and behind it, against
//! shock and expansion. Were it taken for a part of a curve, which a bend is that is small beside the body, the gas would feel it all along the
//! chord.

use aero::run::{Keep, Outcome};
use aero_validation::exact::oblique::{Strength, oblique_shock};
use aero_validation::exact::prandtl_meyer::expand;
use aero_validation::table::Check;

use super::context::{CompareError, Context, Level};
use super::row::{Heading, Row};
use super::scenes::{Source, scene};
use super::suite::Suite;
use super::surface::{as_shape, pressed, prism};
use super::variant::{Levels, Motion, Scheme};

const CASE: &str = "expansion";
const SCENE: Source = scene!("stress", "expansion-corner");
const THEORY: &str = "oblique shock, Prandtl-Meyer (NACA 1135, 1953)";
const AIR: f64 = 1.4;
const MACH: f64 = 2.0;
/// Of the diamond, over its chord.
const THICKNESS: f64 = 0.1;
const SPAN: f64 = 40.0;
const SPACING: f64 = 0.04;
/// From the ridge, in spacings, the walls that are looked at, before it and behind.
const LOOK: f64 = 8.0;

/// Wings.
pub const RIDGES: Suite = Suite::of(&[(Levels::Both, compare)]);

fn compare(context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    let label = format!("ridge of a wing in space, M {MACH}, chord/25, points, settled");
    let heading = Heading {
        case: CASE,
        label: &label,
        only_informs: false,
        is_quick: context.level == Level::Quick,
    };
    let outcome = SCENE.run(&settings(context)?, Keep::End, context)?;
    let rows = rows(&outcome)?.into_iter();
    Ok(rows.map(|row| row.check(heading)).collect())
}

fn settings(context: &Context<'_>) -> Result<Vec<String>, CompareError> {
    let half = 0.5 * THICKNESS;
    let section = [[0.0, 0.0], [0.5, -half], [1.0, 0.0], [0.5, half]];
    let ends = [-0.5 * SPAN, 0.5 * SPAN];
    let facets = prism(&section, ends, |[x, y], z| [x, y, z]);
    let mut settings = Scheme::USUAL.by_points(Motion::Settled).settings();
    settings.extend([
        "dimension=3".into(),
        format!("spacing={SPACING:?}"),
        format!("free_stream.mach={MACH:?}"),
        "domain.min=[-0.2, 0.0, 0.0]".into(),
        "domain.max=[1.2, 0.6, 0.16]".into(),
        "domain.sides.y_min=symmetry".into(),
        "domain.sides.z_min=symmetry".into(),
        "domain.sides.z_max=symmetry".into(),
        as_shape("corner", context.out, "expansion-ridge", &facets)?,
    ]);
    Ok(settings)
}

/// Mean and farthest departure of the wall pressure before the ridge and behind it.
fn rows(outcome: &Outcome) -> Result<Vec<Row>, CompareError> {
    let slope = THICKNESS.atan();
    let shock = oblique_shock(MACH, slope, AIR, Strength::Weak)?;
    let before = shock.pressure_ratio;
    let behind = before * expand(shock.mach, 2.0 * slope, AIR)?.pressure_ratio;
    let mut rows = Vec::new();
    for (place, exact, way) in [("before", before, -1.0), ("behind", behind, 1.0)] {
        let is_there = |foot: &[f64; 3]| (0.0..LOOK * SPACING).contains(&(way * (foot[0] - 0.5)));
        let found = pressed(&outcome.surface, SPACING, exact / AIR, is_there);
        let [mean, farthest] = found.map(|pressure| pressure * AIR);
        let row = |what: &str, measured: f64, allowed: f64| {
            let quantity =
                format!("wall pressure in the {LOOK} spacings {place} the ridge, {what}");
            Row::relative(quantity, THEORY, measured, exact, allowed).always()
        };
        rows.push(row("mean", mean, 0.2));
        rows.push(row("farthest off", farthest, 0.6));
    }
    Ok(rows)
}
