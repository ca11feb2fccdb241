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

/// Lift over drag, and moment over drag and diameter, that are allowed of the whole sphere.
const UNBALANCED: [f64; 2] = [1e-4; 2];

/// What is flown.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Part {
    /// A quarter between two planes of symmetry, with the largest error of its stand-off, per cent; none where it only informs.
    Quarter(Option<f64>),
    /// All of it, its centre beside the lattice's lines: a quarter has no lift whatever is wrong.
    Whole,
}

/// What makes the scene of a quarter that of a whole sphere off the lattice.
const WHOLE: [&str; 4] = [
    "domain.min=[-1.6, -3.0, -3.0]",
    "domain.sides.y_min=free-stream",
    "domain.sides.z_min=free-stream",
    "body.sphere.place={ translate = [0.0, 0.031, -0.057] }",
];

/// The sphere in space.
pub const SPHERE: Comparison<Part> = Comparison {
    case: "sphere",
    scene: SCENE,
    length: 1.0,
    keep: Keep::End,
    variants: || {
        let coarse = Variant::new(10, Part::Quarter(Some(10.0)));
        vec![
            coarse.cells(6).quick(),
            coarse,
            coarse.wm().with(Part::Quarter(None)),
            coarse.cells(15),
            coarse.cells(15).wm(),
            coarse.with(Part::Whole).cells(5).quick(),
            coarse.with(Part::Whole).cells(6),
            coarse.with(Part::Whole).cells(6).wm(),
        ]
    },
    label: |v| {
        let part = if v.own == Part::Whole { ", whole" } else { "" };
        format!("dx R/{}, {}{part}", v.cells, v.scheme.brief())
    },
    settings: |v, _| match v.own {
        Part::Quarter(_) => Vec::new(),
        Part::Whole => WHOLE.map(str::to_owned).into(),
    },
    rows,
    pictures,
    together: None,
};

/// Stand-off, stagnation pressure, particles in the wall, and the drag of the tessellated sphere; lift and moment of the whole one.
fn rows(flow: &Flow<'_, Part>) -> Result<Vec<Row>, CompareError> {
    let Part::Quarter(allowed) = flow.variant.own else {
        let mut rows = vec![flow.no_leaks()];
        rows.extend(flow.no_lift("sphere", UNBALANCED));
        return Ok(rows);
    };
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
    Ok(vec![
        match allowed {
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
    ])
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
fn pictures(flow: &Flow<'_, Part>) -> Result<(), CompareError> {
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
