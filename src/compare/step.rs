//! The forward-facing step at Mach 3 against finite volumes: where the shocks stand at `t = 2`.

mod shocks;

use aero::run::Keep;
use aero_validation::exact::normal::{normal_shock, pitot_pressure_ratio};
use aero_validation::pictures::particles::Overlay;
use aero_validation::reference::step_shock;

use super::comparison::{Comparison, Flow};
use super::context::CompareError;
use super::row::Row;
use super::scenes::scene;
use super::variant::Variant;
use shocks::{STEP, Shocks};

const MACH: f64 = 3.0;
const GAMMA: f64 = 1.4;
const DENSITY: f64 = 1.4;
const VOLUMES: &str = "finite volumes, second order (validation/step)";
/// Mach stem at the upper wall: position, length; foot of the reflected shock on the step.
const STEM: [f64; 2] = [0.753, 0.055];
const FOOT: f64 = 1.667;

/// At the quick level half the published resolution, and about twice what that gives.
pub const FORWARD_STEP: Comparison = Comparison {
    case: "step",
    scene: scene!("step"),
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
    let shocks = Shocks {
        gas: &flow.outcome.gas,
        spacing: flow.spacing,
    };
    let place = |quantity: &str, measured, reference, quick: f64| {
        Row::absolute(quantity, VOLUMES, measured, reference, [quick, 0.02])
    };
    let is_of_points = flow.variant.scheme.is_of_points();
    let mut rows = Vec::new();
    let table = step_shock();
    let column = |name: &str| table.column(name).unwrap_or_default();
    for (y, x) in column("y").iter().zip(column("x")) {
        let found = shocks.bow_shock(*y)?;
        let quick = if *y > 0.6 { 0.026 } else { 0.014 };
        let quantity = format!("bow shock, x at y {y}");
        rows.push(place(&quantity, found, *x, quick).by_points(
            is_of_points,
            [if *y > 0.6 { quick } else { 0.5 * quick }, 0.02],
        ));
    }
    // Half a cell off the wall, the heights that the strip holds are all on the stem.
    let stem = shocks.bow_shock(1.0)?;
    let length = 1.0 - shocks.triple_point(stem)?;
    let normal = normal_shock(MACH, GAMMA)?;
    rows.extend([
        place("Mach stem, x at the upper wall", stem, STEM[0], 0.03)
            .by_points(is_of_points, [0.05, 0.02]),
        place("Mach stem, length", length, STEM[1], 0.026),
        place("reflection on the step, x", shocks.foot()?, FOOT, 0.035)
            .by_points(is_of_points, [0.006, 0.02]),
        Row::relative(
            "pressure at the foot of the step",
            "Rayleigh pitot (NACA 1135, 1953)",
            stagnation_pressure(flow),
            pitot_pressure_ratio(MACH, GAMMA),
            [0.7, 2.0],
        )
        .by_points(is_of_points, [2.6, 2.0]),
        Row::informs(
            "p / rho^gamma on the step",
            "constant behind the normal shock",
            entropy(flow),
            normal.pressure_ratio / (DENSITY * normal.density_ratio).powf(GAMMA),
        ),
        flow.no_leaks(),
    ]);
    Ok(rows)
}

/// Mean pressure on the lowest part of the step's face.
fn stagnation_pressure(flow: &Flow<'_>) -> f64 {
    let panels = &flow.outcome.panels;
    let is_judged = |n: &usize| {
        let [x, y, _] = panels.middle(*n);
        (x - STEP[0]).abs() < 1e-6 && y < 0.05
    };
    let (mut force, mut area) = (0.0, 0.0);
    for n in (0..panels.area.len()).filter(is_judged) {
        force += panels.area[n] * panels.pressure[n];
        area += panels.area[n];
    }
    force / area
}

/// Mean of `p / rho^gamma` over the gas next to the top of the step.
fn entropy(flow: &Flow<'_>) -> f64 {
    let gas = &flow.outcome.gas;
    let (mut sum, mut count) = (0.0, 0.0);
    for (i, at) in gas.position.iter().enumerate() {
        if (1.0..1.5).contains(&at[0]) && at[1] < STEP[1] + 3.0 * flow.spacing {
            sum += gas.pressure[i] / gas.density[i].powf(GAMMA);
            count += 1.0;
        }
    }
    sum / count
}

/// The density, the step and the reference shock.
fn pictures(flow: &Flow<'_>) -> Result<(), CompareError> {
    let mut view = flow.view(
        "Forward-facing step, Mach 3",
        &flow.outcome.gas.density,
        "density",
    );
    let [foot, height] = STEP;
    let table = step_shock();
    let column = |name: &str| table.column(name).unwrap_or_default();
    let shock = column("x").iter().zip(column("y")).map(|(x, y)| [*x, *y]);
    let shock = shock.chain([[STEM[0], 1.0 - STEM[1]], [STEM[0], 1.0]]);
    view.overlays = vec![
        Overlay::outline(vec![[0.0, 0.0], [foot, 0.0], [foot, height], [3.0, height]]),
        Overlay::theory("shock, finite volumes", shock.collect()),
    ];
    view.save()
}
