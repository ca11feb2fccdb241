//! The expansion corner in space about points that stay: an edge across the stream and one askew to it, against Prandtl and Meyer.

use aero::run::{Keep, Outcome};
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
const THEORY: &str = "Prandtl-Meyer (NACA 1135, 1953), of the stream across the edge";
const AIR: f64 = 1.4;
const MACH: f64 = 2.0;
/// Turn, degrees.
const ANGLE: f64 = 15.0;
/// Angles between the edge and the normal of the stream, degrees.
const SWEEPS: [f64; 2] = [0.0, 10.0];
const SPACING: f64 = 0.05;
/// Where in its cell the edge lies, spacings.
const OFF: [f64; 3] = [0.3, 0.7, 0.2];
/// Behind the edge, spacings, up to where the gas turns within cells.
const FIRST: f64 = 4.0;
/// Half of what is looked at along the edge.
const MIDDLE: f64 = 0.16;

/// Corners in space.
pub const EDGES: Suite = Suite::of(&[(Levels::Both, compare)]);

fn compare(context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    let mut checks = Vec::new();
    for sweep in SWEEPS {
        let label =
            format!("in space, M {MACH}, {ANGLE} deg, swept {sweep}, dx 1/20, points, settled");
        let heading = Heading {
            case: CASE,
            label: &label,
            only_informs: false,
            is_quick: context.level == Level::Quick,
        };
        let outcome = SCENE.run(&settings(sweep, context)?, Keep::End, context)?;
        let rows = rows(&outcome, sweep)?;
        checks.extend(rows.into_iter().map(|row| row.check(heading)));
    }
    Ok(checks)
}

fn settings(sweep: f64, context: &Context<'_>) -> Result<Vec<String>, CompareError> {
    let fall = 3.0 * ANGLE.to_radians().tan();
    let section = [
        [0.0, 0.0],
        [-3.0, 0.0],
        [-3.0, -3.0],
        [3.0, -3.0],
        [3.0, -fall],
    ];
    let facets = prism(&section, [-3.0, 3.0], |[x, y], z| [x, y, z]);
    let shape = as_shape("corner", context.out, "expansion-edge", &facets)?;
    // What planes of symmetry do to an edge askew is not known in the middle yet.
    let deep = if sweep == 0.0 { 0.15 } else { 0.4 };
    let mut settings = Scheme::USUAL.by_points(Motion::Settled).settings();
    settings.extend([
        "dimension=3".into(),
        format!("spacing={SPACING:?}"),
        format!("free_stream.mach={MACH:?}"),
        format!("domain.min=[-0.3, -0.4, {:?}]", -deep),
        format!("domain.max=[0.6, 0.7, {deep:?}]"),
        "domain.sides.z_min=symmetry".into(),
        "domain.sides.z_max=symmetry".into(),
        shape,
        format!(
            "body.corner.place={{ rotate = {{ axis = [0.0, 1.0, 0.0], angle = {sweep:?} }}, translate = {:?} }}",
            OFF.map(|part| part * SPACING)
        ),
    ]);
    Ok(settings)
}

/// Mean and farthest departure of the wall pressure in the first spacings behind the edge.
fn rows(outcome: &Outcome, sweep: f64) -> Result<Vec<Row>, CompareError> {
    let (sine, cosine) = sweep.to_radians().sin_cos();
    let (down, along) = ANGLE.to_radians().sin_cos();
    let exact = expand(MACH * cosine, ANGLE.to_radians(), AIR)?.pressure_ratio;
    let is_there = |foot: &[f64; 3]| {
        let [x, y, z] = [0, 1, 2].map(|k| foot[k] / SPACING - OFF[k]);
        let behind = (x * cosine - z * sine) * along - y * down;
        (0.1..FIRST).contains(&behind) && foot[2].abs() < MIDDLE
    };
    let found = pressed(&outcome.surface, SPACING, exact / AIR, is_there);
    let [mean, farthest] = found.map(|pressure| pressure * AIR);
    let row = |what: &str, measured: f64, allowed: f64| {
        let quantity =
            format!("wall pressure in the first {FIRST} spacings behind the edge, {what}");
        Row::relative(quantity, THEORY, measured, exact, allowed).always()
    };
    Ok(vec![
        row("mean", mean, 0.2),
        row("farthest off", farthest, 1.5),
    ])
}
