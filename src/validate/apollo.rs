//! The Apollo command module at Mach 2.5 against axisymmetric finite volumes: drag of the forebody, and
//! of the whole.

use aero_validation::exact::normal::pitot_pressure_ratio;
use aero_validation::pictures::particles::{ParticlePicture, Slab};
use aero_validation::table::{Check, Subject};

use super::outcome::{Outcome, Source, diameters, run};
use super::{Context, Level, ValidateError};

const SCENE: Source = Source {
    name: "apollo",
    text: include_str!("../../cases/apollo.toml"),
};
const MERIDIAN: Source = Source {
    name: "apollo-axisymmetric",
    text: include_str!("../../cases/apollo-axisymmetric.toml"),
};
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

/// What is run of the flow.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Part {
    /// A quarter in space, in the paper's box.
    Whole,
    /// A quarter in space, in a box that ends behind the shoulder, where the flow is supersonic.
    Front,
    /// Rings about the axis, in the paper's box.
    Rings,
}

/// One run of a scene.
#[derive(Clone, Copy, Debug)]
struct Variant {
    /// Metres.
    spacing: f64,
    extrapolation: &'static str,
    part: Part,
    /// Largest error of the forebody's drag, per cent.
    allowed: f64,
    level: Level,
}

const PUBLISHED: Variant = Variant {
    spacing: 0.1,
    extrapolation: "wm",
    part: Part::Front,
    allowed: 4.0,
    level: Level::Full,
};

const VARIANTS: [Variant; 9] = [
    // Two and a half times the published spacing; errors are of first order, so is what is allowed.
    Variant {
        spacing: 0.25,
        allowed: 10.0,
        level: Level::Quick,
        ..PUBLISHED
    },
    PUBLISHED,
    Variant {
        extrapolation: "wom",
        ..PUBLISHED
    },
    Variant {
        spacing: 0.2,
        allowed: 8.0,
        ..PUBLISHED
    },
    Variant {
        part: Part::Rings,
        level: Level::Quick,
        ..PUBLISHED
    },
    Variant {
        part: Part::Rings,
        ..PUBLISHED
    },
    Variant {
        part: Part::Rings,
        spacing: 0.05,
        allowed: 2.0,
        ..PUBLISHED
    },
    Variant {
        part: Part::Rings,
        spacing: 0.05,
        extrapolation: "wom",
        allowed: 2.0,
        ..PUBLISHED
    },
    Variant {
        spacing: 0.2,
        part: Part::Whole,
        allowed: 8.0,
        ..PUBLISHED
    },
];

/// Runs the variants and compares drag and stagnation pressure.
pub fn compare(context: &Context<'_>) -> Result<Vec<Check>, ValidateError> {
    let mut checks = Vec::new();
    for variant in VARIANTS.iter().filter(|v| v.level == context.level) {
        let source = if variant.part == Part::Rings {
            MERIDIAN
        } else {
            SCENE
        };
        let outcome = run(source, &variant.settings(), context)?;
        checks.extend(variant.checks(&outcome));
        variant.picture(&outcome, context)?;
    }
    Ok(checks)
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

impl Variant {
    fn settings(&self) -> Vec<String> {
        let mut settings = vec![
            format!("spacing={}", self.spacing),
            format!("scheme.extrapolation={}", self.extrapolation),
        ];
        if self.part == Part::Front {
            settings.extend([
                "domain.min=[-1.5, 0.0, 0.0]".into(),
                "domain.max=[1.25, 5.0, 5.0]".into(),
                "end_time=0.04".into(),
            ]);
        }
        settings
    }

    fn label(&self) -> String {
        let part = match self.part {
            Part::Whole => "quarter",
            Part::Front => "quarter to the shoulder",
            Part::Rings => "axisymmetric",
        };
        format!("dx {} m, {}, {part}", self.spacing, self.extrapolation)
    }

    fn checks(&self, outcome: &Outcome) -> Vec<Check> {
        let label = self.label();
        let front = forebody(outcome, self.spacing);
        let quantity = format!("{label}: forebody drag coefficient");
        let mut checks = vec![Subject::new(SCENE.name, &quantity, VOLUMES).relative(
            front,
            FOREBODY,
            self.allowed,
        )];
        if self.part != Part::Front {
            let body = &outcome.summary.bodies["capsule"];
            let whole = body.cd_mean.unwrap_or(f64::NAN);
            let quantity = format!("{label}: drag coefficient");
            checks.push(Subject::new(SCENE.name, &quantity, VOLUMES).informs(whole, WHOLE));
            let quantity = format!("{label}: afterbody drag coefficient");
            let base = WHOLE - FOREBODY;
            checks.push(Subject::new(SCENE.name, &quantity, VOLUMES).informs(whole - front, base));
        }
        let quantity = format!("{label}: stagnation pressure / free stream");
        let pitot = pitot_pressure_ratio(MACH, GAMMA);
        let subject = Subject::new(SCENE.name, &quantity, "Rayleigh pitot (NACA 1135, 1953)");
        checks.push(subject.informs(stagnation(outcome, self.spacing), pitot));
        let quantity = format!("{label}: particles in the wall");
        let subject = Subject::new(SCENE.name, &quantity, "no penetration");
        checks.push(subject.informs(outcome.summary.leaked as f64, 0.0));
        checks
    }

    /// A cut beside the symmetry plane, coloured by density.
    fn picture(&self, outcome: &Outcome, context: &Context<'_>) -> Result<(), ValidateError> {
        let gas = &outcome.gas;
        let diameter = diameters(gas);
        let title = format!("Apollo, Mach {MACH}: {}", self.label());
        let mut picture = ParticlePicture::new(
            &title,
            &gas.position,
            &diameter,
            &gas.density,
            "density, kg/m^3",
        );
        if self.part != Part::Rings {
            picture.slab = Some(Slab {
                axis: 2,
                centre: 0.5 * self.spacing,
                half: 0.5 * self.spacing,
            });
        }
        picture.axis_labels = ["x, m", "y, m"];
        let part = match self.part {
            Part::Whole => "quarter",
            Part::Front => "front",
            Part::Rings => "rings",
        };
        let name = format!("apollo-{}-{}-{part}.png", self.spacing, self.extrapolation);
        Ok(picture.save(&context.out.join(name))?)
    }
}
