//! A channel with a bump in a stream slower than sound, settled: nothing is lost, so that there is no drag and the flow before the bump is the
//! mirror image of that behind it.

use aero::run::Keep;
use aero_validation::metrics::invariants;

use super::comparison::{Comparison, Flow};
use super::context::CompareError;
use super::row::Row;
use super::scenes::scene;
use super::variant::Variant;

const THEORY: &str = "isentropic flow";
/// As in the scene.
const GAMMA: f64 = 1.4;
const MACH: f64 = 0.5;
const LENGTH: f64 = 1.0;
const END: f64 = 2.0;

/// Drag coefficient, on the bump's length, that a spacing of one length would leave at most: it falls with the spacing.
const DRAG: f64 = 0.3;

pub const BUMP: Comparison = Comparison {
    case: "bump",
    scene: scene!("bump"),
    length: LENGTH,
    keep: Keep::End,
    variants: || {
        let settled = Variant::new(32, ()).settled();
        vec![settled.both(), settled.cells(64).both()]
    },
    label: |v| format!("M {MACH}, dx 1/{}", v.cells),
    settings: |_, _| Vec::new(),
    rows,
    pictures: |_| Ok(()),
    together: None,
};

fn rows(flow: &Flow<'_>) -> Result<Vec<Row>, CompareError> {
    let gas = &flow.outcome.gas;
    let drag = flow.outcome.summary.bodies["bump"].cd_mean;
    let end: Vec<usize> = (0..gas.kind.len())
        .filter(|&i| gas.position[i][0] > END - 0.1 * LENGTH)
        .collect();
    let flux = |&i: &usize| gas.density[i] * gas.velocity[i][0];
    let mass = end.iter().map(flux).sum::<f64>() / end.len() as f64;
    let [density, pressure] =
        [&gas.density, &gas.pressure].map(|of| end.iter().map(|&i| of[i]).collect::<Vec<_>>());
    let entropy = invariants::entropy(&density, &pressure, 1.0 / GAMMA, GAMMA)?;
    Ok(vec![
        Row::at_most(
            "drag coefficient, on the length",
            THEORY,
            drag.map_or(f64::NAN, f64::abs),
            DRAG * flow.spacing / LENGTH,
        ),
        Row::relative("mass that passes", THEORY, mass, MACH, 0.5),
        Row::at_most(
            "entropy before the outlet, largest departure",
            THEORY,
            entropy.largest,
            0.01,
        ),
        Row::at_most(
            "pressure on the bump, fore against aft, mean, of the dynamic one",
            "symmetry",
            asymmetry(flow),
            2.0 * flow.spacing / LENGTH,
        ),
    ])
}

/// Mean difference of the pressure coefficients on the bump, between each panel and the mirror image of the surface behind it.
fn asymmetry(flow: &Flow<'_>) -> f64 {
    let panels = &flow.outcome.panels;
    let middle = |n: usize| panels.middle(n)[0];
    let on_bump = (0..panels.area.len()).filter(|&n| panels.body[n] == 0);
    let mut wall: Vec<(f64, usize)> = on_bump.map(|n| (middle(n), n)).collect();
    wall.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mirrored = wall.iter().rev();
    let differences = wall.iter().zip(mirrored).map(|(fore, aft)| {
        let pressure = |&(_, n): &(f64, usize)| panels.pressure_coefficient[n];
        panels.area[fore.1] * (pressure(fore) - pressure(aft)).abs()
    });
    differences.sum::<f64>() / wall.iter().map(|&(_, n)| panels.area[n]).sum::<f64>()
}
