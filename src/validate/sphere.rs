//! The sphere at Mach 3 in three dimensions against Billig's bow shock, and its tessellation against
//! itself.

use aero_validation::exact::billig::{BowShock, Nose};
use aero_validation::exact::normal::{normal_shock, pitot_pressure_ratio};
use aero_validation::metrics::stand_off::{StagnationLine, stand_off};
use aero_validation::pictures::particles::{ParticlePicture, Slab};
use aero_validation::table::{Check, Subject};

use super::outcome::{Outcome, Source, diameters, run};
use super::{Context, Level, ValidateError};

const ANALYTIC: Source = Source {
    name: "sphere",
    text: include_str!("../../cases/sphere.toml"),
};
const TESSELLATED: Source = Source {
    name: "sphere-stl",
    text: include_str!("../../cases/sphere-stl.toml"),
};
const MACH: f64 = 3.0;
const GAMMA: f64 = 1.4;

/// One run of the scene.
#[derive(Clone, Copy, Debug)]
struct Variant {
    /// Spacings to the radius.
    per_radius: u32,
    extrapolation: &'static str,
    /// Largest error of the stand-off, per cent; none where it only informs.
    allowed: Option<f64>,
    level: Level,
}

const COARSE: Variant = Variant {
    per_radius: 10,
    extrapolation: "wom",
    allowed: Some(10.0),
    level: Level::Quick,
};

const VARIANTS: [Variant; 5] = [
    COARSE,
    Variant {
        level: Level::Full,
        ..COARSE
    },
    Variant {
        extrapolation: "wm",
        allowed: None,
        level: Level::Full,
        ..COARSE
    },
    Variant {
        per_radius: 15,
        level: Level::Full,
        ..COARSE
    },
    Variant {
        per_radius: 15,
        extrapolation: "wm",
        level: Level::Full,
        ..COARSE
    },
];

/// Compares stand-off, stagnation pressure and the drag of the tessellated sphere.
pub fn compare(context: &Context<'_>) -> Result<Vec<Check>, ValidateError> {
    let mut checks = Vec::new();
    for variant in VARIANTS.iter().filter(|v| v.level == context.level) {
        let exact = run(ANALYTIC, &variant.settings(), context)?;
        checks.extend(variant.flow(&exact, context)?);
        let mesh = run(TESSELLATED, &variant.settings(), context)?;
        let drag = |outcome: &Outcome| outcome.summary.bodies["sphere"].force_mean[0];
        let quantity = variant.label("drag of the STL, per drag of the exact sphere");
        let subject = Subject::new(ANALYTIC.name, &quantity, "the same body");
        checks.push(subject.relative(drag(&mesh) / drag(&exact), 1.0, 2.0));
    }
    Ok(checks)
}

impl Variant {
    fn spacing(&self) -> f64 {
        1.0 / f64::from(self.per_radius)
    }

    fn settings(&self) -> [String; 2] {
        [
            format!("spacing={}", self.spacing()),
            format!("scheme.extrapolation={}", self.extrapolation),
        ]
    }

    fn label(&self, quantity: &str) -> String {
        format!(
            "dx R/{}, {}: {quantity}",
            self.per_radius, self.extrapolation
        )
    }

    /// Stand-off, stagnation pressure and particles in the wall, and a picture.
    fn flow(&self, outcome: &Outcome, context: &Context<'_>) -> Result<Vec<Check>, ValidateError> {
        let gas = &outcome.gas;
        let line = StagnationLine {
            nose: [-1.0, 0.0, 0.0],
            upstream: [-1.0, 0.0, 0.0],
            radius: 3.0 * self.spacing(),
            spacing: self.spacing(),
            ahead: 1.0,
            behind: normal_shock(MACH, GAMMA)?.density_ratio,
        };
        let shock = stand_off(&gas.position, &gas.density, &line)
            .map_err(|error| ANALYTIC.unread(error))?;
        self.picture(outcome, context)?;

        let billig = BowShock::new(Nose::Sphere, MACH)?;
        let stand_off = self.label("stand-off / R");
        let pressure = self.label("stagnation pressure / free stream");
        let leaked = self.label("particles in the wall");
        let stand_off = Subject::new("sphere", &stand_off, "Billig (1967)");
        let stand_off = match self.allowed {
            Some(allowed) => stand_off.relative(shock.distance, billig.stand_off, allowed),
            None => stand_off.informs(shock.distance, billig.stand_off),
        };
        Ok(vec![
            stand_off,
            Subject::new("sphere", &pressure, "Rayleigh pitot (NACA 1135)").informs(
                stagnation_pressure(outcome) * GAMMA,
                pitot_pressure_ratio(MACH, GAMMA),
            ),
            Subject::new("sphere", &leaked, "no penetration")
                .informs(outcome.summary.leaked as f64, 0.0),
        ])
    }

    /// Density in the slab next to the symmetry plane.
    fn picture(&self, outcome: &Outcome, context: &Context<'_>) -> Result<(), ValidateError> {
        let frame = &outcome.frame;
        let diameter = diameters(frame);
        let mut picture = ParticlePicture::new(
            "Sphere at Mach 3: density beside the symmetry plane",
            &frame.position,
            &diameter,
            &frame.density,
            "density / free stream",
        );
        picture.slab = Some(Slab {
            axis: 2,
            centre: 0.5 * self.spacing(),
            half: 0.5 * self.spacing(),
        });
        Ok(picture.save(&context.out.join(format!(
            "sphere-{}-{}.png",
            self.per_radius, self.extrapolation
        )))?)
    }
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
