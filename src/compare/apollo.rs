//! The Apollo command module at Mach 2.5 against axisymmetric finite volumes: drag of the forebody, and
//! of the whole.

use std::f64::consts::PI;

use aero::run::{Keep, Outcome};
use aero_validation::exact::normal::pitot_pressure_ratio;

use super::comparison::{Comparison, Flow};
use super::context::CompareError;
use super::row::Row;
use super::scenes::scene;
use super::variant::Variant;

const VOLUMES: &str = "finite volumes, second order, axisymmetric (validation/apollo)";
const MACH: f64 = 2.5;
const GAMMA: f64 = 1.4;
/// Pressure of the free stream, Pa.
const PRESSURE: f64 = 70_233.2;
/// Largest radius of the body, m.
const RADIUS: f64 = 1.9558;
/// Drag coefficients: forebody up to the largest radius, whole body.
const FOREBODY: f64 = 1.329;
const WHOLE: f64 = 1.501;
/// Largest error of the forebody's drag, per cent to a metre of spacing: errors are of first order.
const ALLOWED: f64 = 40.0;
/// The same at the quick level: in space, and by rings.
const QUICK: [f64; 2] = [20.0, 35.0];
/// The same of points that stay, at either level: all of one spacing, and added where the flow asks.
const POINTS: [f64; 2] = [28.0, 10.0];
/// Lift over drag, and moment over drag and diameter, that are allowed of the whole capsule.
const UNBALANCED: [f64; 2] = [1e-4; 2];

/// What is run of the flow.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// A quarter in space, in the paper's box.
    Quarter,
    /// A quarter in space, in a box that ends behind the shoulder, where the flow is supersonic.
    Front,
    /// All of it in space, its axis beside the lattice's lines, in a box that ends behind the shoulder: a quarter has no lift whatever
    /// is wrong.
    WholeFront,
    /// Rings about the axis, in the paper's box.
    Rings,
    /// The same, with points added where the flow asks, by two halvings.
    Halved,
}

/// In space. The published resolution has ten cells to a metre, the quick level three.
pub const QUARTER: Comparison<Part> = Comparison {
    scene: scene!("apollo"),
    variants: || {
        let published = Variant::new(10, Part::Front);
        vec![
            published.wm().cells(3).quick(),
            published.wm(),
            published,
            published.cells(5).wm(),
            published.cells(5).wm().with(Part::Quarter),
            published.cells(3).wm().with(Part::WholeFront).quick(),
            published.cells(4).with(Part::WholeFront),
            published.cells(4).wm().with(Part::WholeFront),
        ]
    },
    settings: |v, _| match v.own {
        Part::Front => vec![
            "domain.min=[-2.0, 0.0, 0.0]".into(),
            "domain.max=[1.25, 5.0, 5.0]".into(),
            "end_time=0.04".into(),
        ],
        Part::WholeFront => vec![
            "domain.min=[-2.0, -5.0, -5.0]".into(),
            "domain.max=[1.25, 5.0, 5.0]".into(),
            "domain.sides.y_min=free-stream".into(),
            "domain.sides.z_min=free-stream".into(),
            "body.capsule.place={ translate = [0.0, 0.031, -0.057] }".into(),
            "end_time=0.04".into(),
        ],
        _ => Vec::new(),
    },
    ..RINGS
};

/// About the axis.
pub const RINGS: Comparison<Part> = Comparison {
    case: "apollo",
    scene: scene!("apollo-axisymmetric"),
    length: 1.0,
    keep: Keep::End,
    variants: || {
        let published = Variant::new(10, Part::Rings);
        vec![
            published.settled().both(),
            published.settled().with(Part::Halved).both(),
            published.cells(20).settled(),
            published.wm().cells(7).quick(),
            published.wm(),
            published.cells(20).wm(),
            published.cells(20),
        ]
    },
    label: |v| {
        let part = match v.own {
            Part::Quarter => "quarter",
            Part::WholeFront => "whole to the shoulder",
            Part::Front => "quarter to the shoulder",
            Part::Rings => "axisymmetric",
            Part::Halved => "axisymmetric, halved twice",
        };
        let spacing = 1.0 / f64::from(v.cells);
        format!("dx {spacing} m, {}, {part}", v.scheme.brief())
    },
    settings: |v, _| match v.own {
        Part::Halved => vec!["scheme.refine=2".into()],
        _ => Vec::new(),
    },
    rows,
    pictures,
    together: None,
};

#[allow(clippy::unnecessary_wraps)] // what a comparison asks for
fn rows(flow: &Flow<'_, Part>) -> Result<Vec<Row>, CompareError> {
    if flow.variant.own == Part::WholeFront {
        let mut rows = vec![flow.no_leaks(), no_warnings(flow)];
        rows.extend(flow.no_lift("capsule", UNBALANCED));
        return Ok(rows);
    }
    let outcome = flow.outcome;
    let is_round = matches!(flow.variant.own, Part::Rings | Part::Halved);
    let front = forebody(outcome, is_round);
    let quick = match flow.variant.own {
        Part::Rings | Part::Halved => QUICK[1],
        Part::Front | Part::Quarter | Part::WholeFront => QUICK[0],
    };
    let mut rows = vec![
        Row::relative(
            "forebody drag coefficient",
            VOLUMES,
            front,
            FOREBODY,
            [quick * flow.spacing, ALLOWED * flow.spacing],
        )
        .by_points(
            flow.variant.scheme.is_of_points(),
            POINTS[usize::from(flow.variant.own == Part::Halved)] * flow.spacing,
        ),
    ];
    if flow.variant.own != Part::Front {
        let body = &outcome.summary.bodies["capsule"];
        let whole = body.cd_mean.unwrap_or(f64::NAN);
        let (base, expected) = (whole - front, WHOLE - FOREBODY);
        rows.extend([
            Row::informs("drag coefficient", VOLUMES, whole, WHOLE),
            Row::informs("afterbody drag coefficient", VOLUMES, base, expected),
        ]);
    }
    if flow.variant.own == Part::Front {
        rows.push(no_warnings(flow));
    }
    rows.extend([
        Row::informs(
            "stagnation pressure / free stream",
            "Rayleigh pitot (NACA 1135, 1953)",
            stagnation(outcome, flow.spacing),
            pitot_pressure_ratio(MACH, GAMMA),
        ),
        flow.no_leaks(),
    ]);
    Ok(rows)
}

/// The row of what the run warns of, in a box that is ours and not the paper's: that a shock stands on its sides, for one.
fn no_warnings(flow: &Flow<'_, Part>) -> Row {
    let warnings = flow.outcome.summary.warnings.len() as f64;
    Row::at_most("warnings", "a box that is large enough", warnings, 0.0)
}

/// Drag coefficient of the wall that faces the stream.
fn forebody(outcome: &Outcome, is_round: bool) -> f64 {
    let panels = &outcome.panels;
    let faces = panels.normal.iter().zip(&panels.area);
    let forces = faces
        .zip(&panels.pressure_coefficient)
        .zip(&panels.body)
        .filter(|(((normal, _), _), body)| **body == 0 && normal[0] < 0.0)
        .map(|(((normal, area), coefficient), _)| -normal[0] * area * coefficient);
    // In space there is a quarter of it.
    let parts = if is_round { 1.0 } else { 4.0 };
    parts * forces.sum::<f64>() / (PI * RADIUS * RADIUS)
}

/// Mean wall pressure within two spacings of the axis, over the free stream's.
fn stagnation(outcome: &Outcome, spacing: f64) -> f64 {
    let wall = &outcome.surface;
    let near: Vec<f64> = wall
        .position
        .iter()
        .zip(&wall.pressure)
        .filter(|(foot, _)| foot[0] < 0.5 && foot[1].hypot(foot[2]) < 2.0 * spacing)
        .map(|(_, pressure)| pressure / PRESSURE)
        .collect();
    near.iter().sum::<f64>() / near.len() as f64
}

/// The density, in space beside the symmetry plane.
fn pictures(flow: &Flow<'_, Part>) -> Result<(), CompareError> {
    let density = &flow.outcome.gas.density;
    let mut view = flow.view("Apollo, Mach 2.5", density, "density, kg/m^3");
    view.axis_labels = ["x, m", "y, m"];
    if !matches!(flow.variant.own, Part::Rings | Part::Halved) {
        view = view.beside_symmetry(flow.spacing);
    }
    view.save()
}
