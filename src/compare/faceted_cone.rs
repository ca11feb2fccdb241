//! A cone as few long facets, some more, and exact, in space: the drag of its forebody and what its surface shows, by a quarter; the side
//! force, which there is none of, by the whole.

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
const DRAG: [f64; 2] = [6.0, 3.0];

/// The same of the pressure on the surface.
const PRESSURE: [f64; 2] = [2.0; 2];
/// What particles show swings by 0.4 % from instant to instant: a mean over ten is judged.
const FRAMES: &str = "output.frames=20";
/// At the usual step gas moves by nine tenths of a spacing, always the same places beside the ghosts are met again, and which those are (the
/// length of a step, a ghost moved by a hair) makes 1 % either way of what is shown at six cells to the radius, at half the step 0.4 % at
/// eight, and 0.1 % at ten.
const STEP: &str = "scheme.cfl=0.25";
/// Cells to the radius below which that is taken.
const FEW: u32 = 10;

/// Where along the axis the surface is read: from a quarter of the outlet's radius on.
const STATIONS: [f64; 2] = [0.5, 1.75];

/// Side force over drag, and moment over drag and length, that are allowed.
const SIDE: f64 = 0.01;

/// The same by points, which stand alike on all sides.
const SIDE_BY_POINTS: f64 = 1e-4;

/// A cone, and how much of it is flown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cone {
    surface: Surface,
    /// All of it, its axis beside the lattice's lines; a quarter between two planes of symmetry otherwise.
    is_whole: bool,
}

impl Cone {
    const fn quarter(surface: Surface) -> Self {
        Self {
            surface,
            is_whole: false,
        }
    }

    /// Settings of the scene, which is a quarter's.
    fn settings(self) -> Vec<String> {
        let mut settings = vec![self.surface.setting()];
        if self.is_whole {
            settings.extend(WHOLE.map(str::to_owned));
        }
        settings
    }
}

/// What makes the scene of a quarter that of a whole cone off the lattice.
const WHOLE: [&str; 4] = [
    "domain.min=[-0.3, -1.2, -1.2]",
    "domain.sides.y_min=free-stream",
    "domain.sides.z_min=free-stream",
    "body.cone.place={ translate = [0.0, 0.013, -0.021] }",
];

/// What is flown.
const SURFACES: [Surface; 3] = [Surface::Facets(24), Surface::Facets(96), Surface::Exact];

/// What a cone is made of.
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

pub const FACETED_CONE: Comparison<Cone> = Comparison {
    case: "cone-faceted",
    scene: scene!("cone-faceted"),
    length: RADIUS,
    keep: Keep::Panels,
    variants: || {
        let of = |surface| Variant::new(15, Cone::quarter(surface));
        let [few, more, exact] = SURFACES.map(of);
        let whole = |of: Variant<Cone>| {
            of.cells(10).with(Cone {
                is_whole: true,
                ..of.own
            })
        };
        vec![
            few.cells(8).quick(),
            few.cells(6).settled().quick(),
            few,
            more,
            exact,
            few.cells(10).settled(),
            more.cells(10).settled(),
            whole(few).cells(6).settled().both(),
            whole(few),
            whole(more),
            whole(exact),
        ]
    },
    label: |v| {
        let surface = match v.own.surface {
            Surface::Exact => "exact".to_owned(),
            Surface::Facets(around) => format!("{around} facets"),
        };
        let part = if v.own.is_whole { ", whole" } else { "" };
        format!(
            "{surface}{part}, {} dx in radius, {}",
            v.cells,
            v.scheme.brief()
        )
    },
    settings: |v, _| {
        let mut settings = v.own.settings();
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

fn rows(flow: &Flow<'_, Cone>) -> Result<Vec<Row>, CompareError> {
    if flow.variant.own.is_whole {
        let loads = &flow.outcome.summary.bodies["cone"];
        // The stream's density and speed of sound are 1.
        let pressed = 0.5 * MACH * MACH * loads.reference_area;
        let drag = loads.cd_mean.unwrap_or(f64::NAN) * pressed;
        let side = loads.force_mean[1].hypot(loads.force_mean[2]) / drag;
        let moment = loads.moment.iter().map(|m| m * m).sum::<f64>().sqrt();
        let moment = moment / (drag * loads.reference_length);
        let is_of_points = flow.variant.scheme.is_of_points();
        let judged = |quantity, value| {
            Row::at_most(quantity, "symmetry", value, SIDE).by_points(is_of_points, SIDE_BY_POINTS)
        };
        return Ok(vec![
            judged("side force / forebody drag, gauge", side),
            judged("moment / (forebody drag, gauge, x length)", moment),
            flow.no_leaks(),
        ]);
    }
    let (angle, area) = flow.variant.own.surface.angle_and_area();
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
fn pictures(flow: &Flow<'_, Cone>) -> Result<(), CompareError> {
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
