//! The cone at Mach 3, as rings about its axis and as a quarter in space, against Taylor and Maccoll.

use aero::run::{Keep, Outcome};
use aero_geometry::kernel::SMOOTHING_RATIO;
use aero_validation::exact::cone::{ConeFlow, cone_flow};
use aero_validation::metrics::plateau::Ramp;
use aero_validation::metrics::shock_line::{ShockLine, ShockSearch, fit_shock_line};
use aero_validation::pictures::particles::Overlay;

use super::comparison::{Comparison, Flow};
use super::context::CompareError;
use super::row::Row;
use super::scenes::{Source, scene};
use super::variant::Variant;

/// Its scene.
pub const SCENE: Source = scene!("cone");
const THEORY: &str = "Taylor and Maccoll (1933)";
/// Of the stream.
pub const MACH: f64 = 3.0;
/// Between the axis and the wall, degrees.
pub const HALF_ANGLE: f64 = 20.0;
const GAMMA: f64 = 1.4;
/// Where along the axis the surface is read: far from the tip, which the kernel rounds, and from the outlet.
const STATIONS: [f64; 2] = [1.0, 1.4];
/// Distance from tip and ends at which the shock is read, in smoothing lengths.
const CLEARANCE: f64 = 6.0;

/// A flow about an axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Model {
    /// Rings in the meridian plane.
    Rings,
    /// A quarter of space between two symmetry planes.
    Quarter,
}

impl Model {
    const fn name(self) -> &'static str {
        match self {
            Self::Rings => "axisymmetric",
            Self::Quarter => "a quarter in space",
        }
    }

    /// What the scene, which is of rings, needs to be of this model.
    fn settings(self) -> &'static [&'static str] {
        match self {
            Self::Rings => &[],
            Self::Quarter => &[
                "dimension=3",
                "domain.min=[-0.2, 0.0, 0.0]",
                "domain.max=[1.5, 1.1, 1.1]",
                "domain.sides.y_min=symmetry",
                "domain.sides.z_min=symmetry",
                "domain.sides.z_max=free-stream",
                // Twice what the stream takes to cross the box.
                "end_time=1.2",
            ],
        }
    }
}

/// The error of the pressure is of first order in spacing over radius; the quick level allows what its
/// resolution gives.
pub const CONE: Comparison<Model> = Comparison {
    case: "cone",
    scene: SCENE,
    length: 1.0,
    keep: Keep::End,
    variants: || {
        let fine = Variant::new(100, Model::Rings);
        let quarter = Variant::new(30, Model::Quarter);
        vec![
            fine.cells(50).quick(),
            fine.cells(50).settled().quick(),
            fine.settled(),
            fine,
            quarter.settled(),
            fine.wm(),
            quarter,
            quarter.wm(),
        ]
    },
    label: |v| format!("{}, dx 1/{}, {}", v.own.name(), v.cells, v.scheme.brief()),
    settings: |v, _| v.own.settings().iter().map(ToString::to_string).collect(),
    rows,
    pictures,
    together: None,
};

fn theory() -> Result<ConeFlow, CompareError> {
    Ok(cone_flow(MACH, HALF_ANGLE.to_radians(), GAMMA)?)
}

fn rows(flow: &Flow<'_, Model>) -> Result<Vec<Row>, CompareError> {
    let theory = theory()?;
    let line = shock_line(flow, &theory)?;
    let read: Vec<f64> = surface_pressures(flow.outcome).collect();
    let pressure = read.iter().sum::<f64>() / read.len() as f64;
    let is_of_points = flow.variant.scheme.is_of_points();
    let mut rows = vec![
        Row::relative(
            "half-jump shock angle, deg",
            THEORY,
            line.angle.to_degrees(),
            theory.shock_angle.to_degrees(),
            [0.8, 1.0],
        )
        .by_points(is_of_points, [0.4, 1.0]),
        Row::relative(
            "surface pressure / free stream",
            THEORY,
            GAMMA * pressure,
            theory.pressure_ratio,
            [4.0, 2.0],
        )
        .by_points(is_of_points, [0.4, 2.0]),
        Row::relative(
            "forebody drag, gauge",
            THEORY,
            flow.outcome.summary.bodies["cone"]
                .cd_mean
                .unwrap_or(f64::NAN),
            theory.pressure_coefficient,
            [1.0, 2.0],
        ),
        flow.no_leaks(),
    ];
    if is_of_points && flow.variant.own == Model::Rings {
        rows.push(Row::error(
            "surface pressure 2 to 10 spacings behind the tip, farthest off",
            THEORY,
            farthest_off_at_the_tip(flow, theory.pressure_ratio),
            0.02,
        ));
    }
    Ok(rows)
}

/// The shock where the density passes half its jump.
fn shock_line(flow: &Flow<'_, Model>, theory: &ConeFlow) -> Result<ShockLine, CompareError> {
    let ramp = Ramp {
        corner: [0.0, 0.0],
        angle: theory.cone_angle,
        end_x: 1.5,
    };
    // Just behind the shock the gas is thinner than on the surface.
    let sine = MACH * theory.shock_angle.sin();
    let behind = (GAMMA + 1.0) * sine * sine / ((GAMMA - 1.0) * sine * sine + 2.0);
    let clearance = CLEARANCE * SMOOTHING_RATIO * flow.spacing;
    let search = ShockSearch::above_ramp(&ramp, 1.1, clearance, [1.0, behind], flow.spacing);
    let gas = &flow.outcome.gas;
    let positions: Vec<[f64; 3]> = gas.position.iter().copied().map(meridian).collect();
    Ok(fit_shock_line(&positions, &gas.density, &search)?)
}

/// Pressures along the judged part of the surface.
pub fn surface_pressures(outcome: &Outcome) -> impl Iterator<Item = f64> {
    let wall = &outcome.surface;
    let points = wall.position.iter().zip(&wall.pressure);
    let judged = points.filter(|(foot, _)| (STATIONS[0]..STATIONS[1]).contains(&foot[0]));
    judged.map(|(_, pressure)| *pressure)
}

/// How far the pressure is off theory, at most, from the third cell behind the tip to the tenth.
fn farthest_off_at_the_tip(flow: &Flow<'_, Model>, theory: f64) -> f64 {
    let wall = &flow.outcome.surface;
    let points = wall.position.iter().zip(&wall.pressure);
    let first = points.filter(|(foot, _)| (2.0..10.0).contains(&(foot[0] / flow.spacing)));
    let off = first.map(|(_, pressure)| (GAMMA * pressure / theory - 1.0).abs());
    off.fold(f64::NAN, f64::max)
}

/// A place along the axis and off it.
fn meridian([x, y, z]: [f64; 3]) -> [f64; 3] {
    [x, f64::hypot(y, z), 0.0]
}

/// Pressure, with the cone and the theoretical shock.
fn pictures(flow: &Flow<'_, Model>) -> Result<(), CompareError> {
    let theory = theory()?;
    let mut view = flow.view(
        "Cone of 20 degrees at Mach 3",
        &flow.outcome.gas.pressure,
        "pressure",
    );
    view.drawn_at = meridian;
    let line = |angle: f64| vec![[0.0, 0.0], [1.5, 1.5 * angle.tan()]];
    view.overlays = vec![
        Overlay::outline(line(theory.cone_angle)),
        Overlay::theory("shock, theory", line(theory.shock_angle)),
    ];
    view.save()
}
