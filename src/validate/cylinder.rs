//! The bow shock of a cylinder at Mach 10 against finite volumes, Billig's correlation and the exact
//! stagnation pressure.

mod flow;

use aero_validation::exact::billig::{BowShock, Nose};
use aero_validation::exact::normal::pitot_pressure_ratio;
use aero_validation::pictures::curves::{Curves, Panel, Series, Style};
use aero_validation::pictures::particles::{Overlay, ParticlePicture};
use aero_validation::table::{Check, Subject};

use super::outcome::{Outcome, Source, diameters, run};
use super::{Context, Level, ValidateError};
pub(crate) use flow::wall as wall_departure;
use flow::{Measured, angle, nose, volumes_wall};

pub(crate) const SCENE: Source = Source {
    name: "cylinder",
    text: include_str!("../../cases/cylinder.toml"),
};
const MACH: f64 = 10.0;
const GAMMA: f64 = 1.4;
const VOLUMES: &str = "finite volumes, second order (validation/cylinder)";
/// Stand-off by finite volumes, extrapolated to the axis.
const STAND_OFF: f64 = 0.4017;

/// One run of the scene.
#[derive(Clone, Copy, Debug)]
struct Variant {
    /// Cells per radius.
    cells: u32,
    end_time: f64,
    equations: &'static str,
    extrapolation: &'static str,
    /// None where the scheme is shown for comparison.
    allowed: Option<Allowed>,
    level: Level,
}

/// Largest errors, per cent.
#[derive(Clone, Copy, Debug)]
struct Allowed {
    /// Of the stand-off.
    stand_off: f64,
    /// Of the stagnation pressure.
    stagnation: f64,
    /// Of the shock's position, of the radius.
    shape: f64,
    /// Mean along the nose, of the stagnation pressure.
    wall: f64,
    /// Median behind the shock.
    enthalpy: f64,
}

const PUBLISHED: Variant = Variant {
    cells: 40,
    end_time: 3.5,
    equations: "conservative",
    extrapolation: "wom",
    allowed: Some(Allowed {
        stand_off: 2.0,
        stagnation: 2.0,
        shape: 1.0,
        wall: 2.0,
        enthalpy: 1.0,
    }),
    level: Level::Full,
};

const VARIANTS: [Variant; 4] = [
    // Half the published resolution; errors are of first order, so twice as much is allowed.
    Variant {
        cells: 20,
        allowed: Some(Allowed {
            stand_off: 4.0,
            stagnation: 4.0,
            shape: 2.0,
            wall: 4.0,
            enthalpy: 1.0,
        }),
        level: Level::Quick,
        ..PUBLISHED
    },
    PUBLISHED,
    Variant {
        extrapolation: "wm",
        ..PUBLISHED
    },
    Variant {
        equations: "paper",
        allowed: None,
        ..PUBLISHED
    },
];

/// Runs the variants and compares shock, wall and total enthalpy.
pub fn compare(context: &Context<'_>) -> Result<Vec<Check>, ValidateError> {
    let mut checks = Vec::new();
    for variant in VARIANTS.iter().filter(|v| v.level == context.level) {
        let outcome = run(SCENE, &variant.settings(), context)?;
        let measured =
            Measured::new(&outcome, variant.spacing()).map_err(|error| SCENE.unread(error))?;
        checks.extend(variant.checks(&measured, &outcome)?);
        variant.pictures(&outcome, context)?;
    }
    Ok(checks)
}

impl Variant {
    fn spacing(&self) -> f64 {
        1.0 / f64::from(self.cells)
    }

    fn settings(&self) -> [String; 4] {
        [
            format!("spacing={}", self.spacing()),
            format!("end_time={:?}", self.end_time),
            format!("scheme.equations={}", self.equations),
            format!("scheme.extrapolation={}", self.extrapolation),
        ]
    }

    fn label(&self) -> String {
        let Self {
            cells,
            equations,
            extrapolation,
            ..
        } = self;
        format!("dx R/{cells}, {equations} {extrapolation}")
    }

    fn checks(&self, found: &Measured, outcome: &Outcome) -> Result<Vec<Check>, ValidateError> {
        let label = self.label();
        let quantities = [
            "stand-off / R",
            "stand-off / R, by correlation",
            "stagnation pressure / free stream",
            "shock shape, largest departure / R",
            "wall pressure on the nose, mean departure / stagnation",
            "total enthalpy behind the shock, median departure",
            "particles in the wall",
        ]
        .map(|quantity| format!("{label}: {quantity}"));
        let row = |number: usize, source: &'static str| {
            Subject::new(SCENE.name, &quantities[number], source)
        };
        let near = |subject: Subject<'_>, measured: f64, reference: f64, allowed: Option<f64>| {
            match allowed {
                Some(allowed) => subject.relative(measured, reference, allowed),
                None => subject.informs(measured, reference),
            }
        };
        let below = |subject: Subject<'_>, measured: f64, allowed: Option<f64>| match allowed {
            Some(allowed) => subject.absolute(measured, 0.0, allowed / 100.0),
            None => subject.informs(measured, 0.0),
        };
        let allowed = |pick: fn(&Allowed) -> f64| self.allowed.as_ref().map(pick);
        let billig = BowShock::new(Nose::Cylinder, MACH)?.stand_off;
        let pitot = pitot_pressure_ratio(MACH, GAMMA);
        Ok(vec![
            near(
                row(0, VOLUMES),
                found.stand_off,
                STAND_OFF,
                allowed(|a| a.stand_off),
            ),
            near(
                row(1, "Billig (1967)"),
                found.stand_off,
                billig,
                allowed(|a| a.stand_off),
            ),
            near(
                row(2, "Rayleigh pitot (NACA 1135, 1953)"),
                found.stagnation,
                pitot,
                allowed(|a| a.stagnation),
            ),
            below(row(3, VOLUMES), found.shape, allowed(|a| a.shape)),
            below(row(4, VOLUMES), found.wall, allowed(|a| a.wall)),
            below(
                row(5, "constant in a steady stream"),
                found.enthalpy,
                allowed(|a| a.enthalpy),
            ),
            below(
                row(6, "no penetration"),
                outcome.summary.leaked as f64,
                self.allowed.map(|_| 0.0),
            ),
        ])
    }

    /// Density with the two shocks, and the wall pressure.
    fn pictures(&self, outcome: &Outcome, context: &Context<'_>) -> Result<(), ValidateError> {
        let name = format!(
            "cylinder-{}-{}-{}",
            self.cells, self.equations, self.extrapolation
        );
        let gas = &outcome.gas;
        let diameter = diameters(gas);
        let title = format!("Cylinder, Mach {MACH}: {}", self.label());
        let mut picture = ParticlePicture::new(
            &title,
            &gas.position,
            &diameter,
            &gas.density,
            "density / free stream",
        );
        let billig = BowShock::new(Nose::Cylinder, MACH)?;
        let correlation = (0..=56).map(|k| f64::from(k) / 20.0);
        picture.overlays = vec![
            Overlay::outline(nose()),
            Overlay::theory(
                "shock, Billig (1967)",
                correlation.map(|y| [-billig.x(y), y]).collect(),
            ),
        ];
        picture.save(&context.out.join(format!("{name}.png")))?;

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
        Ok(Curves::single(&title, panel).save(&context.out.join(format!("{name}-wall.svg")))?)
    }
}
