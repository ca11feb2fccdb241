//! A cone as few long facets, some more, and exact, a quarter in space: the drag of its forebody, and what its surface shows.

use std::f64::consts::PI;

use aero::run::Keep;
use aero_solver::frame::PanelFrame;
use aero_validation::exact::cone::cone_flow;
use aero_validation::pictures::particles::Overlay;

use super::comparison::{Comparison, Flow};
use super::context::CompareError;
use super::row::Row;
use super::scenes::scene;
use super::variant::Variant;

const THEORY: &str = "Taylor and Maccoll (1933) at the facets' own angle";
const MACH: f64 = 3.0;
const HALF_ANGLE: f64 = 15.0;
const GAMMA: f64 = 1.4;
/// Radius of the section at the outlet.
const RADIUS: f64 = 0.5;
/// Largest errors of the drag, per cent, at the quick level's spacing and at the full one's: it is of first order in spacing over
/// radius.
const DRAG: [f64; 2] = [8.0, 3.0];

/// The same of the pressure on the surface.
const PRESSURE: [f64; 2] = [2.0; 2];
/// What particles show swings by 0.4 % from instant to instant: a mean over ten is judged.
const FRAMES: &str = "output.frames=20";
/// At the usual step gas moves by nine tenths of a spacing, always the same places beside the ghosts are met again, and which those are (the
/// length of a step, a ghost moved by a hair) makes 1 % either way of what is shown at six cells to the radius and 0.1 % at ten; at half
/// the step 0.2 % at six.
const STEP: &str = "scheme.cfl=0.25";
/// Cells to the radius below which that is taken.
const FEW: u32 = 10;

/// Where along the axis the surface is read: from a quarter of the outlet's radius on.
const STATIONS: [f64; 2] = [0.5, 1.75];

/// What the cone is made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Surface {
    /// A round one.
    Exact,
    /// Triangles from tip to base, so many around the axis.
    Facets(u32),
}

impl Surface {
    fn setting(self) -> String {
        let cone = format!("{{ cone = {{ half_angle = {HALF_ANGLE:?}, length = 2.6 }} }}");
        match self {
            Self::Exact => format!("body.cone.shape={cone}"),
            Self::Facets(around) => {
                format!(
                    "body.cone.shape={{ tessellated = {{ body = {cone}, around = {around} }} }}"
                )
            }
        }
    }

    /// Half-angle, radians, and area of the section over that of the circle around it.
    fn angle_and_area(self) -> (f64, f64) {
        let tangent = HALF_ANGLE.to_radians().tan();
        match self {
            Self::Exact => (HALF_ANGLE.to_radians(), 1.0),
            Self::Facets(around) => {
                let half = PI / f64::from(around);
                let area = half.sin() * half.cos() / half;
                ((tangent * half.cos()).atan(), area)
            }
        }
    }
}

pub const FACETED_CONE: Comparison<Surface> = Comparison {
    case: "cone-faceted",
    scene: scene!("cone-faceted"),
    length: RADIUS,
    keep: Keep::Panels,
    variants: || {
        let few = Variant::new(15, Surface::Facets(24));
        let more = Variant::new(15, Surface::Facets(96));
        vec![
            few.cells(6).quick(),
            few.cells(6).settled().quick(),
            few,
            more,
            Variant::new(15, Surface::Exact),
            few.cells(10).settled(),
            more.cells(10).settled(),
        ]
    },
    label: |v| {
        let surface = match v.own {
            Surface::Exact => "exact".to_owned(),
            Surface::Facets(around) => format!("{around} facets"),
        };
        format!("{surface}, {} dx in radius, {}", v.cells, v.scheme.brief())
    },
    settings: |v, _| {
        let mut settings = vec![v.own.setting()];
        if !v.scheme.is_of_points() {
            settings.push(FRAMES.into());
            settings.extend((v.cells < FEW).then(|| STEP.into()));
        }
        settings
    },
    rows,
    pictures,
    together: None,
};

fn rows(flow: &Flow<'_, Surface>) -> Result<Vec<Row>, CompareError> {
    let (angle, area) = flow.variant.own.angle_and_area();
    let theory = cone_flow(MACH, angle, GAMMA)?;
    let drag = flow.outcome.summary.bodies["cone"].cd_mean;
    let is_of_points = flow.variant.scheme.is_of_points();
    Ok(vec![
        Row::relative(
            "forebody drag, gauge",
            THEORY,
            drag.unwrap_or(f64::NAN),
            theory.pressure_coefficient * area,
            DRAG,
        )
        .by_points(is_of_points, [1.1, DRAG[1]]),
        Row::relative(
            "pressure shown on the surface / free stream",
            THEORY,
            GAMMA * shown_pressure(&flow.outcome.history.panels),
            theory.pressure_ratio,
            PRESSURE,
        )
        .by_points(is_of_points, [1.7, PRESSURE[1]]),
        flow.no_leaks(),
    ])
}

/// Mean over the kept times.
fn shown_pressure(kept: &[PanelFrame]) -> f64 {
    kept.iter().map(shown_at).sum::<f64>() / kept.len() as f64
}

/// Mean over the area of the judged part of the surface.
fn shown_at(panels: &PanelFrame) -> f64 {
    let corners = panels.points.chunks(panels.corners);
    let along =
        corners.map(|corners| corners.iter().map(|p| p[0]).sum::<f64>() / corners.len() as f64);
    let judged = along.zip(panels.area.iter().zip(&panels.pressure));
    let judged = judged.filter(|(along, _)| (STATIONS[0]..STATIONS[1]).contains(along));
    let [area, force] = judged.fold([0.0; 2], |[area, force], (_, (a, p))| {
        [area + a, force + a * p]
    });
    force / area
}

/// The pressure beside a plane of symmetry.
fn pictures(flow: &Flow<'_, Surface>) -> Result<(), CompareError> {
    let pressure = &flow.outcome.gas.pressure;
    let mut view = flow.view("Cone of 15 degrees at Mach 3", pressure, "pressure");
    let line = |angle: f64| vec![[0.0, 0.0], [1.8, 1.8 * angle.tan()]];
    let theory = cone_flow(MACH, HALF_ANGLE.to_radians(), GAMMA)?;
    view.overlays = vec![
        Overlay::outline(line(theory.cone_angle)),
        Overlay::theory("shock, theory", line(theory.shock_angle)),
    ];
    view.beside_symmetry(flow.spacing).save()
}
