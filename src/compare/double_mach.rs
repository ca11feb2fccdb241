//! The double Mach reflection against finite volumes, in the frame of Woodward and Colella: where the
//! Mach stem stands on the wall, where the triple point is.

mod reflection;

use aero::run::{Keep, Outcome};
use aero_validation::pictures::particles::Overlay;

use super::comparison::{Comparison, Flow};
use super::context::CompareError;
use super::row::Row;
use super::scenes::{Source, scene};
use super::variant::Variant;
use reflection::{Reflection, TRIPLE, turned};

/// Its scene.
pub const SCENE: Source = scene!("double-mach");
const VOLUMES: &str = "finite volumes, second order, 240 cells (validation/double_mach)";
const EXACT: &str = "state behind the shock (Woodward & Colella 1984)";
/// Mach stem on the wall, and mean wall pressure between 1.3 and 1.9.
const FOOT: f64 = 2.782;
const PRESSURE: f64 = 310.0;

/// At the quick level half the published resolution, and about twice what that gives.
///
/// What varies is how often points that stay are added where the flow asks, halving their spacing.
pub const DOUBLE_MACH: Comparison<u32> = Comparison {
    case: "double-mach",
    scene: SCENE,
    length: 1.0,
    keep: Keep::End,
    variants: || {
        let published = Variant::new(80, 0);
        vec![
            published.cells(40).quick(),
            published.cells(40).marched().quick(),
            published.marched(),
            published.cells(40).marched().with(2),
            published,
            published.wm(),
            published.paper(),
        ]
    },
    label: |v| {
        let halved = if v.own > 0 { ", halved twice" } else { "" };
        format!("dx 1/{}{halved}, {}", v.cells, v.scheme)
    },
    settings: |v, _| {
        let refined = (v.own > 0).then(|| format!("scheme.refine={}", v.own));
        refined.into_iter().collect()
    },
    rows,
    pictures,
    together: None,
};

fn rows(flow: &Flow<'_, u32>) -> Result<Vec<Row>, CompareError> {
    let spacing = flow.spacing / f64::from(1_u32 << flow.variant.own);
    let found = Reflection::new(flow.outcome, spacing).measure()?;
    let full = if flow.variant.own > 0 { 0.01 } else { 0.02 };
    let place = |quantity: &str, measured, reference, quick: f64| {
        Row::absolute(quantity, VOLUMES, measured, reference, [quick, full])
    };
    let is_of_points = flow.variant.scheme.is_of_points();
    Ok(vec![
        place("Mach stem on the wall, x'", found.foot, FOOT, 0.05),
        place("triple point, x'", found.triple[0], TRIPLE[0], 0.012)
            .by_points(is_of_points, [0.025, full]),
        place("triple point, y'", found.triple[1], TRIPLE[1], 0.012)
            .by_points(is_of_points, [0.1, full]),
        Row::informs(
            "wall pressure, 1.3 < x' < 1.9",
            VOLUMES,
            found.pressure,
            PRESSURE,
        ),
        Row::informs("stem, departure from straight", VOLUMES, found.kink, 0.0),
        Row::informs(
            "spots: density of the uniform gas, rms departure",
            EXACT,
            found.spots,
            0.0,
        ),
        flow.no_leaks(),
    ])
}

/// How far stem and triple point are from where they should be, the mean of both, with so many `cells` to the unit.
pub fn displacement(outcome: &Outcome, cells: u32) -> Result<f64, CompareError> {
    let found = Reflection::new(outcome, 1.0 / f64::from(cells)).measure()?;
    let [x, y] = found.triple;
    let triple = f64::hypot(x - TRIPLE[0], y - TRIPLE[1]);
    Ok(0.5 * ((found.foot - FOOT).abs() + triple))
}

/// The density, the wall and the reference points.
fn pictures(flow: &Flow<'_, u32>) -> Result<(), CompareError> {
    let mut view = flow.view(
        "Double Mach reflection",
        &flow.outcome.gas.density,
        "density",
    );
    view.drawn_at = turned;
    view.window = Some([[0.0, 3.0], [0.0, 1.0]]);
    view.axis_labels = ["x'", "y'"];
    let [x, y] = TRIPLE;
    view.overlays = vec![
        Overlay::outline(vec![[1.0 / 6.0, 0.0], [3.0, 0.0]]),
        Overlay::theory("stem, finite volumes", vec![[FOOT, 0.0], [x, y]]),
    ];
    view.save()
}
