//! The double Mach reflection against finite volumes, in the frame of Woodward and Colella: where the
//! Mach stem stands on the wall, where the triple point is.

mod reflection;

use aero::run::Keep;
use aero_validation::pictures::particles::Overlay;

use super::comparison::{Comparison, Flow};
use super::context::CompareError;
use super::row::Row;
use super::scenes::scene;
use super::variant::Variant;
use reflection::{Reflection, TRIPLE, turned};

const VOLUMES: &str = "finite volumes, second order, 240 cells (validation/double_mach)";
const EXACT: &str = "state behind the shock (Woodward & Colella 1984)";
/// Mach stem on the wall, and mean wall pressure between 1.3 and 1.9.
const FOOT: f64 = 2.782;
const PRESSURE: f64 = 310.0;

/// At the quick level half the published resolution, and about twice what that gives.
pub const DOUBLE_MACH: Comparison = Comparison {
    case: "double-mach",
    scene: scene!("double-mach"),
    length: 1.0,
    keep: Keep::End,
    variants: || {
        let published = Variant::new(80, ());
        vec![
            published.cells(40).quick(),
            published.cells(40).marched().quick(),
            published.marched(),
            published,
            published.wm(),
            published.paper(),
        ]
    },
    label: |v| format!("dx 1/{}, {}", v.cells, v.scheme),
    settings: |_, _| Vec::new(),
    rows,
    pictures,
    together: None,
};

fn rows(flow: &Flow<'_>) -> Result<Vec<Row>, CompareError> {
    let found = Reflection::new(flow.outcome, flow.spacing).measure()?;
    let place = |quantity: &str, measured, reference, quick: f64| {
        Row::absolute(quantity, VOLUMES, measured, reference, [quick, 0.02])
    };
    let is_of_points = flow.variant.scheme.is_of_points();
    Ok(vec![
        place("Mach stem on the wall, x'", found.foot, FOOT, 0.05),
        place("triple point, x'", found.triple[0], TRIPLE[0], 0.005)
            .by_points(is_of_points, [0.025, 0.02]),
        place("triple point, y'", found.triple[1], TRIPLE[1], 0.012)
            .by_points(is_of_points, [0.1, 0.02]),
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

/// The density, the wall and the reference points.
fn pictures(flow: &Flow<'_>) -> Result<(), CompareError> {
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
