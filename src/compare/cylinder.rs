//! The bow shock of a cylinder at Mach 10 against finite volumes, Billig's correlation and the exact
//! stagnation pressure.

mod flow;

use aero::run::Keep;
use aero_validation::exact::billig::{BowShock, Nose};
use aero_validation::exact::normal::pitot_pressure_ratio;
use aero_validation::pictures::curves::{Curves, Panel, Series, Style};
use aero_validation::pictures::particles::Overlay;

use super::comparison::{Comparison, Flow};
use super::context::CompareError;
use super::row::Row;
use super::scenes::{Source, scene};
use super::variant::Variant;
pub use flow::wall as wall_departure;
use flow::{GAMMA, MACH, Measured, angle, nose, volumes_wall};

/// Its scene.
pub const SCENE: Source = scene!("cylinder");
const VOLUMES: &str = "finite volumes, second order (validation/cylinder)";
/// Stand-off by finite volumes, extrapolated to the axis.
const STAND_OFF: f64 = 0.4017;

/// Errors are of first order, so that half the published resolution may be twice as far off.
pub const CYLINDER: Comparison = Comparison {
    case: "cylinder",
    scene: SCENE,
    length: 1.0,
    keep: Keep::End,
    variants: || {
        let published = Variant::new(40, ());
        vec![
            published.cells(20).quick(),
            published.cells(20).settled().quick(),
            published.settled(),
            published,
            published.wm(),
            published.paper(),
        ]
    },
    label: |v| format!("dx R/{}, {}", v.cells, v.scheme),
    settings: |_, _| Vec::new(),
    rows,
    pictures,
    together: None,
};

fn rows(flow: &Flow<'_>) -> Result<Vec<Row>, CompareError> {
    let found = Measured::new(flow.outcome, flow.spacing)?;
    let billig = BowShock::new(Nose::Cylinder, MACH)?.stand_off;
    let pitot = pitot_pressure_ratio(MACH, GAMMA);
    let is_of_points = flow.variant.scheme.is_of_points();
    Ok(vec![
        Row::relative(
            "stand-off / R",
            VOLUMES,
            found.stand_off,
            STAND_OFF,
            [2.5, 2.0],
        ),
        Row::relative(
            "stand-off / R, by correlation",
            "Billig (1967)",
            found.stand_off,
            billig,
            [4.0, 2.0],
        )
        .by_points(is_of_points, [0.9, 2.0]),
        Row::relative(
            "stagnation pressure / free stream",
            "Rayleigh pitot (NACA 1135, 1953)",
            found.stagnation,
            pitot,
            [0.5, 2.0],
        )
        .by_points(is_of_points, [5.2, 2.0]),
        Row::absolute(
            "shock shape, largest departure / R",
            VOLUMES,
            found.shape,
            0.0,
            [0.03, 0.01],
        )
        .by_points(is_of_points, [0.015, 0.01]),
        Row::absolute(
            "wall pressure on the nose, mean departure / stagnation",
            VOLUMES,
            found.wall,
            0.0,
            [0.017, 0.02],
        ),
        Row::absolute(
            "total enthalpy behind the shock, median departure",
            "constant in a steady stream",
            found.enthalpy,
            0.0,
            [0.004, 0.01],
        )
        .by_points(is_of_points, [0.008, 0.01]),
        flow.no_leaks(),
    ])
}

/// Density with the two shocks, and the wall pressure.
fn pictures(flow: &Flow<'_>) -> Result<(), CompareError> {
    let outcome = flow.outcome;
    let mut view = flow.view(
        "Cylinder, Mach 10",
        &outcome.gas.density,
        "density / free stream",
    );
    let billig = BowShock::new(Nose::Cylinder, MACH)?;
    let correlation = (0..=56).map(|k| f64::from(k) / 20.0);
    let correlation = correlation.map(|y| [-billig.x(y), y]).collect();
    view.overlays = vec![
        Overlay::outline(nose()),
        Overlay::theory("shock, Billig (1967)", correlation),
    ];
    view.save()?;

    let pitot = pitot_pressure_ratio(MACH, GAMMA);
    let wall = &outcome.surface;
    let measured = wall
        .position
        .iter()
        .zip(&wall.pressure)
        .map(|(foot, pressure)| [angle(foot), pressure * GAMMA / pitot])
        .filter(|[angle, _]| *angle < 90.0)
        .collect();
    let panel = Panel::new(
        "degrees from the stagnation point",
        "wall pressure / stagnation pressure",
        vec![
            Series::new("finite volumes", Style::Line, volumes_wall()),
            Series::new("particles", Style::Dots, measured),
        ],
    );
    flow.save(Curves::single("Cylinder, Mach 10", panel), "wall", "svg")
}
