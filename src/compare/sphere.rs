//! The sphere at Mach 3 in three dimensions against Billig's bow shock, and its tessellation against
//! itself.

mod rings;

use aero::run::{Keep, Outcome};
use aero_validation::exact::billig::{BowShock, Nose};
use aero_validation::exact::normal::{normal_shock, pitot_pressure_ratio};
use aero_validation::metrics::MetricError;
use aero_validation::metrics::stand_off::{StagnationLine, stand_off};

use super::comparison::{Comparison, Flow};
use super::context::CompareError;
use super::row::Row;
use super::scenes::{Source, scene};
use super::variant::Variant;
pub use rings::RINGS;

/// Its scene.
pub const SCENE: Source = scene!("sphere");
const TESSELLATED: Source = scene!("sphere-stl");
const MACH: f64 = 3.0;
const GAMMA: f64 = 1.4;

/// What mirror images leave of lift and moment.
const ROUND_OFF: [f64; 2] = [1e-9; 2];

/// Largest error of the stand-off, per cent; none where it only informs.
type Allowed = Option<f64>;

/// The sphere in space.
pub const SPHERE: Comparison<Allowed> = Comparison {
    case: "sphere",
    scene: SCENE,
    length: 1.0,
    keep: Keep::End,
    variants: || {
        let coarse = Variant::new(10, Some(10.0));
        vec![
            coarse.with(Some(10.0)).cells(6).quick(),
            coarse,
            coarse.wm().with(None),
            coarse.cells(15),
            coarse.cells(15).wm(),
        ]
    },
    label: |v| format!("dx R/{}, {}", v.cells, v.scheme.brief()),
    settings: |_, _| Vec::new(),
    rows,
    pictures,
    together: None,
};

/// Stand-off, stagnation pressure, particles in the wall, and the drag of the tessellated sphere.
fn rows(flow: &Flow<'_, Allowed>) -> Result<Vec<Row>, CompareError> {
    let gas = &flow.outcome.gas;
    let line = StagnationLine {
        nose: [-1.0, 0.0, 0.0],
        upstream: [-1.0, 0.0, 0.0],
        radius: 3.0 * flow.spacing,
        spacing: flow.spacing,
        ahead: 1.0,
        behind: normal_shock(MACH, GAMMA)?.density_ratio,
    };
    let measured = stand_off(&gas.position, &gas.density, &line)?.distance;
    let billig = BowShock::new(Nose::Sphere, MACH)?.stand_off;
    let (quantity, source) = ("stand-off / R", "Billig (1967)");
    let mesh = flow.run_also(TESSELLATED)?;
    let drag = |outcome: &Outcome| outcome.summary.bodies["sphere"].force_mean[0];
    let mut rows = vec![
        match flow.variant.own {
            Some(allowed) => Row::relative(quantity, source, measured, billig, allowed),
            None => Row::informs(quantity, source, measured, billig),
        },
        Row::informs(
            "stagnation pressure / free stream",
            "Rayleigh pitot (NACA 1135)",
            stagnation_pressure(flow.outcome) * GAMMA,
            pitot_pressure_ratio(MACH, GAMMA),
        ),
        flow.no_leaks(),
        Row::relative(
            "drag of the STL, per drag of the exact sphere",
            "the same body",
            drag(&mesh) / drag(flow.outcome),
            1.0,
            [0.7, 2.0],
        ),
    ];
    rows.extend(flow.no_lift("sphere", ROUND_OFF));
    Ok(rows)
}

/// Size of the departure of the nose pressure from Rayleigh's, in parts of it.
pub fn nose_departure(outcome: &Outcome) -> Result<f64, CompareError> {
    let pitot = pitot_pressure_ratio(MACH, GAMMA);
    let nose = stagnation_pressure(outcome) * GAMMA;
    if nose.is_finite() {
        Ok((nose / pitot - 1.0).abs())
    } else {
        Err(CompareError::Metric(MetricError::TooFew {
            what: "places of the wall around the nose",
            found: 0,
            needed: 1,
            remedy: "refine the spacing",
        }))
    }
}

/// Density in the slab next to the symmetry plane.
fn pictures(flow: &Flow<'_, Allowed>) -> Result<(), CompareError> {
    let density = &flow.outcome.gas.density;
    let view = flow.view("Sphere at Mach 3", density, "density / free stream");
    view.beside_symmetry(flow.spacing).save()
}

/// Mean wall pressure within 20 degrees of the nose, raised to the nose by the modified Newtonian
/// law's own mean there, `(1 + cos^2 20 deg) / 2`.
fn stagnation_pressure(outcome: &Outcome) -> f64 {
    let edge = 20_f64.to_radians().cos();
    let chosen: Vec<f64> = outcome
        .surface
        .position
        .iter()
        .zip(&outcome.surface.pressure)
        .filter(|(foot, _)| -foot[0] > edge)
        .map(|(_, pressure)| *pressure)
        .collect();
    let mean = chosen.iter().sum::<f64>() / chosen.len() as f64;
    mean / (0.5 * (1.0 + edge * edge))
}
