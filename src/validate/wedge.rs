//! The compression corner against oblique shock theory.

use aero_geometry::kernel::SMOOTHING_RATIO;
use aero_validation::exact::oblique::{ObliqueShock, Strength, oblique_shock};
use aero_validation::metrics::MetricError;
use aero_validation::metrics::gradient::{Cloud, gradient};
use aero_validation::metrics::gradient_angle::{SHARE, gradient_angle};
use aero_validation::metrics::plateau::{Plateau, Ramp, Stream, plateau};
use aero_validation::metrics::shock_line::{ShockLine, ShockSearch, fit_shock_line};
use aero_validation::pictures::particles::{Overlay, ParticlePicture};
use aero_validation::table::{Check, Subject};

use super::outcome::{Outcome, Source, diameters, run};
use super::{Context, Level, ValidateError};
use aero_solver::frame::Frame;

pub(crate) const SCENE: Source = Source {
    name: "wedge",
    text: include_str!("../../cases/wedge.toml"),
};
const THEORY: &str = "oblique shock theory (NACA 1135, 1953)";
const GAMMA: f64 = 1.4;
/// Distance from corner, wall and shock at which the flow is read, in smoothing lengths.
const CLEARANCE: f64 = 6.0;
/// Largest error of density and energy at the wall behind a strong shock, per cent.
const WALL: f64 = 3.0;

/// One run of the scene.
#[derive(Clone, Copy, Debug)]
struct Variant {
    mach: f64,
    gamma: f64,
    /// Degrees.
    angle: f64,
    /// Cells per unit length.
    cells: u32,
    end_time: f64,
    equations: &'static str,
    extrapolation: &'static str,
    /// Largest error of the plateau, per cent; none where the scheme is shown for comparison.
    plateau: Option<f64>,
    level: Level,
}

const fn conservative(mach: f64, cells: u32, end_time: f64, plateau: f64) -> Variant {
    Variant {
        mach,
        gamma: GAMMA,
        angle: 20.0,
        cells,
        end_time,
        equations: "conservative",
        extrapolation: "wom",
        plateau: Some(plateau),
        level: Level::Quick,
    }
}

const fn full(variant: Variant) -> Variant {
    Variant {
        level: Level::Full,
        ..variant
    }
}

const fn wm(variant: Variant) -> Variant {
    Variant {
        extrapolation: "wm",
        ..variant
    }
}

const fn paper(variant: Variant) -> Variant {
    Variant {
        equations: "paper",
        plateau: None,
        ..variant
    }
}

const MILD: Variant = conservative(2.5, 16, 10.0, 1.0);
const STRONG: Variant = conservative(5.0, 32, 5.0, 1.0);
const HYPERSONIC: Variant = conservative(10.0, 32, 4.0, 2.0);

/// A row of the published table 1, at the spacing with which the published scheme shows the published
/// angles (theirs is not given).
const fn row(mach: f64, angle: f64, gamma: f64, end_time: f64) -> Variant {
    Variant {
        angle,
        gamma,
        level: Level::Full,
        ..conservative(mach, 32, end_time, 1.5)
    }
}

/// Table 1 of Villodi & Ramachandran 2024 without its third row, which is [`STRONG`].
const TABLE: [Variant; 5] = [
    row(5.0, 10.0, GAMMA, 5.0),
    row(5.0, 15.0, GAMMA, 5.0),
    row(5.0, 25.0, GAMMA, 5.0),
    row(2.0, 10.0, GAMMA, 10.0),
    row(5.0, 20.0, 1.3, 5.0),
];

/// Mach number, ramp angle, gamma, and the shock angles that the same table lists with `wom` and `wm`,
/// all in degrees.
const PUBLISHED: [[f64; 5]; 6] = [
    [5.0, 10.0, 1.4, 19.20, 19.24],
    [5.0, 15.0, 1.4, 24.10, 24.12],
    [5.0, 20.0, 1.4, 29.54, 29.55],
    [5.0, 25.0, 1.4, 35.48, 35.49],
    [2.0, 10.0, 1.4, 39.16, 39.19],
    [5.0, 20.0, 1.3, 28.55, 28.54],
];

const VARIANTS: [Variant; 12] = [
    MILD,
    wm(MILD),
    paper(MILD),
    full(paper(wm(MILD))),
    STRONG,
    full(wm(STRONG)),
    full(paper(STRONG)),
    full(paper(wm(STRONG))),
    full(HYPERSONIC),
    full(wm(HYPERSONIC)),
    full(paper(HYPERSONIC)),
    full(paper(wm(HYPERSONIC))),
];

/// Runs the variants and compares plateau and shock angle with theory.
pub fn compare(context: &Context<'_>) -> Result<Vec<Check>, ValidateError> {
    let mut checks = Vec::new();
    let table = TABLE
        .into_iter()
        .flat_map(|row| [row, wm(row), paper(row), paper(wm(row))]);
    for variant in VARIANTS
        .into_iter()
        .chain(table)
        .filter(|v| context.level == Level::Full || v.level == Level::Quick)
    {
        let outcome = run(SCENE, &variant.settings(), context)?;
        checks.extend(variant.check(&outcome, context)?);
    }
    checks.push(leak(context)?);
    Ok(checks)
}

/// Without constant ghost volumes particles leak through the ramp, as Villodi & Ramachandran 2024
/// show in their figure 2a; a row to look at.
fn leak(context: &Context<'_>) -> Result<Check, ValidateError> {
    let mut settings = MILD.settings();
    settings.push("scheme.constant_ghost_volume=false".into());
    let outcome = run(SCENE, &settings, context)?;
    picture(&outcome, &MILD, "wedge-without-constant-volume", context)?;
    let quantity = "M 2.5, ghost volumes not constant: particles in the wall";
    let source = "leaks (Villodi & Ramachandran 2024, fig. 2a)";
    Ok(Subject::new("wedge", quantity, source).informs(outcome.summary.leaked as f64, 0.0))
}

impl Variant {
    fn settings(&self) -> Vec<String> {
        vec![
            format!("gas.gamma={:?}", self.gamma),
            format!("free_stream.mach={}", self.mach),
            format!("free_stream.pressure={}", 1.0 / self.gamma),
            format!("body.ramp.shape.compression_corner.angle={:?}", self.angle),
            format!("spacing={}", self.spacing()),
            format!("end_time={:?}", self.end_time),
            format!("scheme.equations={}", self.equations),
            format!("scheme.extrapolation={}", self.extrapolation),
        ]
    }

    fn spacing(&self) -> f64 {
        1.0 / f64::from(self.cells)
    }

    fn shock(&self) -> Result<ObliqueShock, ValidateError> {
        Ok(oblique_shock(
            self.mach,
            self.angle.to_radians(),
            self.gamma,
            Strength::Weak,
        )?)
    }

    fn label(&self) -> String {
        let Self {
            mach,
            gamma,
            angle,
            cells,
            equations,
            extrapolation,
            ..
        } = self;
        let gas = if *gamma == GAMMA {
            String::new()
        } else {
            format!("gamma {gamma}, ")
        };
        format!("M {mach}, {gas}{angle} deg, dx 1/{cells}, {equations} {extrapolation}")
    }

    /// The angle that the publication lists for this corner, degrees.
    fn published_angle(&self) -> Option<f64> {
        let key = [self.mach, self.angle, self.gamma];
        let [.., wom, wm] = PUBLISHED.into_iter().find(|row| row[..3] == key)?;
        Some(if self.extrapolation == "wm" { wm } else { wom })
    }

    fn check(&self, outcome: &Outcome, context: &Context<'_>) -> Result<Vec<Check>, ValidateError> {
        let shock = self.shock()?;
        let measured = Measured::new(self, outcome, &shock).map_err(|error| SCENE.unread(error))?;
        let name = format!(
            "wedge-M{}-{}-{}-{}-{}",
            self.mach, self.angle, self.gamma, self.equations, self.extrapolation
        );
        picture(outcome, self, &name, context)?;

        let label = self.label();
        let row = |quantity: &str, measured: f64, reference: f64, allowed: Option<f64>| {
            let quantity = format!("{label}: {quantity}");
            let subject = Subject::new(SCENE.name, &quantity, THEORY);
            match allowed {
                Some(allowed) => subject.relative(measured, reference, allowed),
                None => subject.informs(measured, reference),
            }
        };
        let when_cured = |allowed: f64| self.plateau.map(|_| allowed);
        let degrees = shock.angle.to_degrees();
        let pressure = shock.pressure_ratio / self.gamma;
        let mut checks = vec![
            row(
                "plateau density",
                measured.plateau.density,
                shock.density_ratio,
                self.plateau,
            ),
            row(
                "plateau pressure",
                measured.plateau.pressure,
                pressure,
                self.plateau,
            ),
            row(
                "plateau Mach number",
                measured.plateau.mach,
                shock.mach,
                self.plateau,
            ),
            row(
                "half-jump shock angle, deg",
                measured.line.angle.to_degrees(),
                degrees,
                when_cured(0.5),
            ),
            row(
                "shock angle by eq. (36), deg",
                measured.published.to_degrees(),
                degrees,
                when_cured(1.2),
            ),
        ];
        if let Some(angle) = self.published_angle() {
            let quantity = format!("{label}: shock angle by eq. (36) as published, deg");
            let source = "Villodi & Ramachandran 2024, table 1, against theory";
            checks.push(Subject::new(SCENE.name, &quantity, source).informs(angle, degrees));
        }
        let strong = self.mach > 2.5;
        if strong {
            let heated = self.plateau.map(|_| WALL);
            let energy = pressure / shock.density_ratio / (self.gamma - 1.0);
            checks.push(row(
                "density at the wall",
                measured.wall[0],
                shock.density_ratio,
                heated,
            ));
            checks.push(row("energy at the wall", measured.wall[1], energy, heated));
        }
        if self.plateau.is_some() {
            let quantity = format!("{label}: particles in the wall");
            let subject = Subject::new(SCENE.name, &quantity, "no penetration");
            checks.push(subject.at_most(outcome.summary.leaked as f64, 0.0));
        }
        Ok(checks)
    }
}

/// What is read off the flow.
struct Measured {
    plateau: Plateau,
    line: ShockLine,
    /// Shock angle by the steepest gradients, radians.
    published: f64,
    /// Mean density and energy of the gas next to the wall.
    wall: [f64; 2],
}

/// Mean density and energy of what lies within a spacing of the middle of the ramp, where errors that
/// were made at its corner stay.
fn next_to_the_wall(gas: &Frame, ramp: &Ramp, spacing: f64) -> [f64; 2] {
    let (sin, cos) = ramp.angle.sin_cos();
    let length = (ramp.end_x - ramp.corner[0]) / cos;
    let (mut sums, mut count) = ([0.0; 2], 0.0);
    for (n, position) in gas.position.iter().enumerate() {
        let (x, y) = (position[0] - ramp.corner[0], position[1] - ramp.corner[1]);
        let (along, above) = (x * cos + y * sin, y * cos - x * sin);
        if above < spacing && (0.5 * length..0.75 * length).contains(&along) {
            sums[0] += gas.density[n];
            sums[1] += gas.energy[n];
            count += 1.0;
        }
    }
    sums.map(|sum| sum / count)
}

impl Measured {
    fn new(
        variant: &Variant,
        outcome: &Outcome,
        shock: &ObliqueShock,
    ) -> Result<Self, MetricError> {
        let gas = &outcome.gas;
        let ramp = Ramp {
            corner: [0.0, 0.0],
            angle: variant.angle.to_radians(),
            end_x: 3.0,
        };
        let stream = Stream {
            position: &gas.position,
            density: &gas.density,
            pressure: &gas.pressure,
            mach: &gas.mach,
        };
        // Behind the shock the particles are closer and the kernels narrower.
        let h = SMOOTHING_RATIO * variant.spacing();
        let h_behind = h / shock.density_ratio.sqrt();
        let search = ShockSearch::above_ramp(
            &ramp,
            3.0,
            CLEARANCE * h,
            [1.0, shock.density_ratio],
            variant.spacing(),
        );
        let volume: Vec<f64> = gas
            .smoothing_length
            .iter()
            .map(|h| (h / SMOOTHING_RATIO).powi(2))
            .collect();
        let cloud = Cloud {
            position: &gas.position,
            volume: &volume,
            smoothing_length: &gas.smoothing_length,
            dimension: 2,
        };
        let gradients = gradient(&cloud, &gas.density)?;
        Ok(Self {
            plateau: plateau(&stream, &ramp, shock.angle, h_behind)?,
            wall: next_to_the_wall(gas, &ramp, variant.spacing()),
            line: fit_shock_line(&gas.position, &gas.density, &search)?,
            published: gradient_angle(&gas.position, &gradients, SHARE)?.angle,
        })
    }
}

/// The density of the gas, the wall and the theoretical shock.
fn picture(
    outcome: &Outcome,
    variant: &Variant,
    name: &str,
    context: &Context<'_>,
) -> Result<(), ValidateError> {
    let gas = &outcome.gas;
    let diameter = diameters(gas);
    let title = format!("Compression corner: {}", variant.label());
    let mut picture = ParticlePicture::new(
        &title,
        &gas.position,
        &diameter,
        &gas.density,
        "density / free stream",
    );
    let wall = 3.0 * variant.angle.to_radians().tan();
    let shock = 3.0 * variant.shock()?.angle.tan();
    picture.overlays = vec![
        Overlay::outline(vec![[-1.0, 0.0], [0.0, 0.0], [3.0, wall]]),
        Overlay::theory("shock, theory", vec![[0.0, 0.0], [3.0, shock]]),
    ];
    Ok(picture.save(&context.out.join(format!("{name}.png")))?)
}
