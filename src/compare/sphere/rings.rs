//! The sphere as rings about its axis, about points that stay, settled and refined at the shock: stagnation pressure, stand-off and
//! total enthalpy at Mach 3 and 10.

use aero::run::Outcome;
use aero_validation::exact::billig::{BowShock, Nose};
use aero_validation::exact::normal::{normal_shock, pitot_pressure_ratio};
use aero_validation::metrics::MetricError;
use aero_validation::metrics::invariants::total_enthalpy;
use aero_validation::metrics::stagnation::stagnation_pressure;

use super::{GAMMA, SPHERE};
use crate::comparison::{Comparison, Flow};
use crate::context::CompareError;
use crate::row::Row;
use crate::scenes::scene;
use crate::variant::Variant;

/// Stand-off of a sphere in a perfect gas at Mach 10, radii.
const STAND_OFF: f64 = 0.136;
/// The wall pressure is extrapolated to the stagnation point from this many degrees around it.
const CAP: f64 = 20.0;
/// How often the cells of the shock are halved.
const HALVINGS: u32 = 2;
/// Density over that behind a normal shock above which gas is behind the bow shock.
const BEHIND: f64 = 0.9;

/// The sphere about the axis.
pub const RINGS: Comparison<f64> = Comparison {
    case: SPHERE.case,
    scene: scene!("sphere-axisymmetric"),
    length: SPHERE.length,
    keep: SPHERE.keep,
    variants: || {
        let fine = Variant::new(40, 10.0).settled();
        vec![fine.both(), fine.with(3.0).both()]
    },
    label: |v| {
        format!(
            "M {}, dx R/{}, halved {HALVINGS} times, axisymmetric, {}",
            v.own,
            v.cells,
            v.scheme.brief()
        )
    },
    settings: |v, _| {
        vec![
            format!("free_stream.mach={}", v.own),
            format!("scheme.refine={HALVINGS}"),
        ]
    },
    rows,
    pictures: |flow| {
        let density = &flow.outcome.gas.density;
        let view = flow.view("Sphere about its axis", density, "density / free stream");
        view.save()
    },
    together: None,
};

fn rows(flow: &Flow<'_, f64>) -> Result<Vec<Row>, CompareError> {
    let mach = flow.variant.own;
    let behind = normal_shock(mach, GAMMA)?.density_ratio;
    let stand_off = stand_off(flow.outcome, flow.spacing, 0.5 * (1.0 + behind))?;
    let billig = BowShock::new(Nose::Sphere, mach)?.stand_off;
    let mut rows = vec![
        Row::relative(
            "stagnation pressure / free stream",
            "Rayleigh pitot (NACA 1135, 1953)",
            stagnation(flow.outcome)?,
            pitot_pressure_ratio(mach, GAMMA),
            1.0,
        ),
        Row::informs("stand-off / R", "Billig (1967)", stand_off, billig),
        Row::absolute(
            "total enthalpy behind the shock, median departure",
            "constant in a steady stream",
            enthalpy(flow.outcome, mach, behind)?,
            0.0,
            0.005,
        ),
    ];
    if mach > 5.0 {
        rows.push(Row::relative(
            "stand-off / R",
            "perfect gas (validation/sphere)",
            stand_off,
            STAND_OFF,
            2.0,
        ));
    }
    rows.push(flow.no_leaks());
    Ok(rows)
}

/// Distance of nose and shock, where the density next to the axis passes `level`.
fn stand_off(outcome: &Outcome, spacing: f64, level: f64) -> Result<f64, MetricError> {
    let gas = &outcome.gas;
    // The lowest point of each column of the finest cells.
    let width = spacing / f64::from(1_u32 << HALVINGS);
    let mut row: Vec<[f64; 3]> = gas
        .position
        .iter()
        .zip(&gas.density)
        .filter(|(place, _)| place[0] < -1.0 && place[1] < spacing)
        .map(|(place, density)| [(place[0] / width).floor(), place[1], *density])
        .collect();
    row.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    row.dedup_by_key(|point| point[0]);
    let crossing = row
        .windows(2)
        .find(|pair| pair[0][2] < level && level <= pair[1][2]);
    let [[x, _, low], [next, _, high]] = *crossing.ok_or(MetricError::TooFew {
        what: "rises of the density through half the jump on the axis",
        found: 0,
        needed: 1,
        remedy: "run longer",
    })?
    else {
        return Ok(f64::NAN);
    };
    let column = x + (level - low) / (high - low) * (next - x);
    Ok(-1.0 - (column + 0.5) * width)
}

/// Wall pressure over the free stream's, at the stagnation point.
fn stagnation(outcome: &Outcome) -> Result<f64, MetricError> {
    let wall = &outcome.surface;
    let walls = wall.position.iter().zip(&wall.pressure);
    stagnation_pressure(
        walls.map(|(foot, pressure)| (foot[1].atan2(-foot[0]).to_degrees(), pressure * GAMMA)),
        CAP,
    )
}

/// Median departure of the total enthalpy of the gas that the shock has compressed.
fn enthalpy(outcome: &Outcome, mach: f64, behind: f64) -> Result<f64, MetricError> {
    let gas = &outcome.gas;
    let chosen: Vec<usize> = (0..gas.density.len())
        .filter(|&i| gas.density[i] > BEHIND * behind)
        .collect();
    let pick = |values: &[f64]| -> Vec<f64> { chosen.iter().map(|&i| values[i]).collect() };
    let velocity: Vec<[f64; 3]> = chosen.iter().map(|&i| gas.velocity[i]).collect();
    // Density and speed of sound of the stream are 1.
    let stream = 1.0 / (GAMMA - 1.0) + 0.5 * mach * mach;
    let (density, pressure) = (pick(&gas.density), pick(&gas.pressure));
    Ok(total_enthalpy(&velocity, &density, &pressure, stream, GAMMA)?.median)
}
