//! The cone at Mach 3, as rings about its axis and as a quarter in space, against Taylor and Maccoll.

use aero_geometry::kernel::SMOOTHING_RATIO;
use aero_validation::exact::cone::{ConeFlow, cone_flow};
use aero_validation::metrics::plateau::Ramp;
use aero_validation::metrics::shock_line::{ShockSearch, fit_shock_line};
use aero_validation::pictures::particles::{Overlay, ParticlePicture};
use aero_validation::table::{Check, Subject};

use super::outcome::{Outcome, Source, diameters, run};
use super::{Context, Level, ValidateError};
use aero_solver::frame::Frame;

pub(crate) const SCENE: Source = Source {
    name: "cone",
    text: include_str!("../../cases/cone.toml"),
};
const THEORY: &str = "Taylor and Maccoll (1933)";
pub(crate) const MACH: f64 = 3.0;
pub(crate) const HALF_ANGLE: f64 = 20.0;
const GAMMA: f64 = 1.4;
/// Where along the axis the surface is read: far from the tip, which the kernel rounds, and from the outlet.
const STATIONS: [f64; 2] = [1.0, 1.4];
/// Distance from tip and ends at which the shock is read, in smoothing lengths.
const CLEARANCE: f64 = 6.0;

/// One run of the scene.
#[derive(Clone, Copy, Debug)]
struct Variant {
    /// How the flow about the axis is modelled.
    model: Model,
    /// Cells per unit length.
    cells: u32,
    extrapolation: &'static str,
    /// Largest error of the surface pressure, per cent.
    allowed: f64,
    level: Level,
}

/// A flow about an axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Model {
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

const FINE: Variant = Variant {
    model: Model::Rings,
    cells: 100,
    extrapolation: "wom",
    allowed: 2.0,
    level: Level::Full,
};

const VARIANTS: [Variant; 5] = [
    // The error of the pressure is of first order in spacing over radius: what this resolution gives.
    Variant {
        cells: 50,
        allowed: 4.0,
        level: Level::Quick,
        ..FINE
    },
    FINE,
    Variant {
        extrapolation: "wm",
        ..FINE
    },
    Variant {
        model: Model::Quarter,
        cells: 30,
        ..FINE
    },
    Variant {
        model: Model::Quarter,
        cells: 30,
        extrapolation: "wm",
        ..FINE
    },
];

/// Compares shock angle and surface pressure.
pub fn compare(context: &Context<'_>) -> Result<Vec<Check>, ValidateError> {
    let theory = cone_flow(MACH, HALF_ANGLE.to_radians(), GAMMA)?;
    let mut checks = Vec::new();
    for variant in VARIANTS.iter().filter(|v| v.level == context.level) {
        let outcome = run(SCENE, &variant.settings(), context)?;
        checks.extend(variant.checks(&outcome, &theory)?);
        variant.picture(&outcome, &theory, context)?;
    }
    Ok(checks)
}

/// Pressures along the judged part of the surface.
pub(crate) fn surface_pressures(outcome: &Outcome) -> impl Iterator<Item = f64> {
    let wall = &outcome.surface;
    let points = wall.position.iter().zip(&wall.pressure);
    let judged = points.filter(|(foot, _)| (STATIONS[0]..STATIONS[1]).contains(&foot[0]));
    judged.map(|(_, pressure)| *pressure)
}

impl Variant {
    fn settings(&self) -> Vec<String> {
        let mut settings = vec![
            format!("spacing={}", self.spacing()),
            format!("scheme.extrapolation={}", self.extrapolation),
        ];
        let model = self.model.settings().iter();
        settings.extend(model.map(ToString::to_string));
        settings
    }

    fn spacing(&self) -> f64 {
        1.0 / f64::from(self.cells)
    }

    fn checks(&self, outcome: &Outcome, theory: &ConeFlow) -> Result<Vec<Check>, ValidateError> {
        let label = |quantity: &str| {
            format!(
                "{}, dx 1/{}, {}: {quantity}",
                self.model.name(),
                self.cells,
                self.extrapolation
            )
        };
        let ramp = Ramp {
            corner: [0.0, 0.0],
            angle: theory.cone_angle,
            end_x: 1.5,
        };
        // Just behind the shock the gas is thinner than on the surface.
        let sine = MACH * theory.shock_angle.sin();
        let behind = (GAMMA + 1.0) * sine * sine / ((GAMMA - 1.0) * sine * sine + 2.0);
        let clearance = CLEARANCE * SMOOTHING_RATIO * self.spacing();
        let search = ShockSearch::above_ramp(&ramp, 1.1, clearance, [1.0, behind], self.spacing());
        let gas = &outcome.gas;
        let line = fit_shock_line(&meridian(gas), &gas.density, &search)
            .map_err(|error| SCENE.unread(error))?;
        let read: Vec<f64> = surface_pressures(outcome).collect();
        let pressure = read.iter().sum::<f64>() / read.len() as f64;
        let names = [
            label("half-jump shock angle, deg"),
            label("surface pressure / free stream"),
            label("particles in the wall"),
        ];
        let row = |number: usize| Subject::new(SCENE.name, &names[number], THEORY);
        Ok(vec![
            row(0).relative(
                line.angle.to_degrees(),
                theory.shock_angle.to_degrees(),
                1.0,
            ),
            row(1).relative(GAMMA * pressure, theory.pressure_ratio, self.allowed),
            row(2).informs(outcome.summary.leaked as f64, 0.0),
        ])
    }

    /// Pressure, with the cone and the theoretical shock.
    fn picture(
        &self,
        outcome: &Outcome,
        theory: &ConeFlow,
        context: &Context<'_>,
    ) -> Result<(), ValidateError> {
        let gas = &outcome.gas;
        let diameter = diameters(gas);
        let title = format!(
            "Cone of 20 degrees at Mach 3, {}: dx 1/{}, {}",
            self.model.name(),
            self.cells,
            self.extrapolation
        );
        let meridian = meridian(gas);
        let mut picture =
            ParticlePicture::new(&title, &meridian, &diameter, &gas.pressure, "pressure");
        let line = |angle: f64| vec![[0.0, 0.0], [1.5, 1.5 * angle.tan()]];
        picture.overlays = vec![
            Overlay::outline(line(theory.cone_angle)),
            Overlay::theory("shock, theory", line(theory.shock_angle)),
        ];
        let model = match self.model {
            Model::Rings => "",
            Model::Quarter => "-quarter",
        };
        let name = format!("cone{model}-{}-{}.png", self.cells, self.extrapolation);
        Ok(picture.save(&context.out.join(name))?)
    }
}

/// Positions along the axis and off it.
fn meridian(gas: &Frame) -> Vec<[f64; 3]> {
    let radius = |[_, y, z]: [f64; 3]| f64::hypot(y, z);
    let positions = gas.position.iter();
    positions.map(|&at| [at[0], radius(at), 0.0]).collect()
}
