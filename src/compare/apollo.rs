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
/// The same at the quick level: in space, where spacings from 0.24 to 0.26 m miss by 1.8 to 6.6 per cent as their few ghosts happen to lie, and by
/// rings.
const QUICK: [f64; 2] = [32.0, 35.0];
/// The same of points that stay, at either level: all of one spacing, and added where the flow asks.
const POINTS: [f64; 2] = [28.0, 10.0];
/// What mirror images leave of lift and moment.
const ROUND_OFF: [f64; 2] = [1e-9; 2];

/// What is run of the flow.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// A quarter in space, in the paper's box.
    Whole,
    /// A quarter in space, in a box that ends behind the shoulder, where the flow is supersonic.
    Front,
    /// Rings about the axis, in the paper's box.
    Rings,
    /// The same, with points added where the flow asks, by two halvings.
    Halved,
}

/// In space. The published resolution has ten cells to a metre, the quick level four.
pub const QUARTER: Comparison<Part> = Comparison {
    scene: scene!("apollo"),
    variants: || {
        let published = Variant::new(10, Part::Front);
        vec![
            published.wm().cells(4).quick(),
            published.wm(),
            published,
            published.cells(5).wm(),
            published.cells(5).wm().with(Part::Whole),
        ]
    },
    settings: |v, _| match v.own {
        Part::Front => vec![
            "domain.min=[-1.5, 0.0, 0.0]".into(),
            "domain.max=[1.25, 5.0, 5.0]".into(),
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
            published.wm().quick(),
            published.wm(),
            published.cells(20).wm(),
            published.cells(20),
        ]
    },
    label: |v| {
        let part = match v.own {
            Part::Whole => "quarter",
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
    let outcome = flow.outcome;
    let front = if flow.variant.scheme.is_of_points() {
        forebody_by_area(outcome)
    } else {
        forebody(outcome, flow.spacing)
    };
    let quick = match flow.variant.own {
        Part::Rings | Part::Halved => QUICK[1],
        Part::Front | Part::Whole => QUICK[0],
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
    rows.extend([
        Row::informs(
            "stagnation pressure / free stream",
            "Rayleigh pitot (NACA 1135, 1953)",
            stagnation(outcome, flow.spacing),
            pitot_pressure_ratio(MACH, GAMMA),
        ),
        flow.no_leaks(),
    ]);
    rows.extend(flow.no_lift("capsule", ROUND_OFF));
    Ok(rows)
}

/// Drag coefficient of the wall that faces the stream, by the mean pressure coefficient of rings about
/// the axis as wide as a spacing.
fn forebody(outcome: &Outcome, spacing: f64) -> f64 {
    let count = (RADIUS / spacing).round() as usize;
    let mut rings = vec![(0.0, 0.0); count];
    let wall = &outcome.surface;
    for (i, foot) in wall.position.iter().enumerate() {
        let place = foot[1].hypot(foot[2]) / RADIUS * count as f64;
        if wall.normal[i][0] < 0.0 && (place as usize) < count {
            let ring = &mut rings[place as usize];
            ring.0 += wall.pressure_coefficient[i];
            ring.1 += 1.0;
        }
    }
    let square = |k: usize| (k as f64 / count as f64).powi(2);
    rings
        .iter()
        .enumerate()
        .map(|(k, (sum, points))| sum / points * (square(k + 1) - square(k)))
        .sum()
}

/// The same of points that stay, whose pressures hold on areas: at the shoulder, that is what counts.
fn forebody_by_area(outcome: &Outcome) -> f64 {
    let wall = &outcome.surface;
    let walls = wall.normal.iter().zip(&wall.area);
    let forces = walls
        .zip(&wall.pressure_coefficient)
        .filter(|((normal, _), _)| normal[0] < 0.0)
        .map(|((normal, area), coefficient)| -normal[0] * area * coefficient);
    forces.sum::<f64>() / (PI * RADIUS * RADIUS)
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
