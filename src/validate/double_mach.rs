//! The double Mach reflection against finite volumes, in the frame of Woodward and Colella: where the
//! Mach stem stands on the wall, where the triple point is.

use aero_geometry::kernel::SMOOTHING_RATIO;
use aero_validation::metrics::MetricError;
use aero_validation::metrics::crossing::level_crossings;
use aero_validation::pictures::particles::{Overlay, ParticlePicture};
use aero_validation::table::{Check, Subject};

use super::outcome::{Outcome, Source, run};
use super::{Context, Level, ValidateError};

const SCENE: Source = Source {
    name: "double-mach",
    text: include_str!("../../cases/double-mach.toml"),
};
const VOLUMES: &str = "finite volumes, second order, 240 cells (validation/double_mach)";
const EXACT: &str = "state behind the shock (Woodward & Colella 1984)";
/// Mach stem on the wall, triple point, mean wall pressure over [`PLATEAU`].
const FOOT: f64 = 2.782;
const TRIPLE: [f64; 2] = [2.733, 0.440];
const PRESSURE: f64 = 310.0;
const PLATEAU: [f64; 2] = [1.3, 1.9];
/// Density ahead of and behind the shock.
const DENSITY: [f64; 2] = [1.4, 8.0];
/// Heights between which the stem and the shock above it are straight.
const STEM: [f64; 2] = [0.1, 0.36];
const SHOCK: [f64; 2] = [0.6, 0.9];
/// The uniform gas between the shock and the reflected one, and heights of it.
const UNIFORM: [[f64; 2]; 2] = [[2.2, 2.6], [0.6, 0.9]];

/// One run of the scene.
#[derive(Clone, Copy, Debug)]
struct Variant {
    /// Cells per unit length.
    cells: u32,
    equations: &'static str,
    extrapolation: &'static str,
    /// Largest error of a position; none where the scheme is shown for comparison.
    allowed: Option<f64>,
    level: Level,
}

const PUBLISHED: Variant = Variant {
    cells: 80,
    equations: "conservative",
    extrapolation: "wom",
    allowed: Some(0.02),
    level: Level::Full,
};

const VARIANTS: [Variant; 4] = [
    // Half the published resolution; errors are of first order, so twice as much is allowed.
    Variant {
        cells: 40,
        allowed: Some(0.04),
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

/// Runs the variants and compares the positions of the shocks.
pub fn compare(context: &Context<'_>) -> Result<Vec<Check>, ValidateError> {
    let mut checks = Vec::new();
    for variant in VARIANTS.iter().filter(|v| v.level == context.level) {
        let outcome = run(SCENE, &variant.settings(), context)?;
        let flow = Flow::new(&outcome, variant.spacing());
        let found = flow.measure().map_err(|error| SCENE.unread(error))?;
        checks.extend(variant.checks(&found, &outcome));
        variant.picture(&flow, &outcome, context)?;
    }
    Ok(checks)
}

/// The gas in the frame of Woodward and Colella: `x` along the ramp, which begins at a sixth.
struct Flow {
    position: Vec<[f64; 3]>,
    density: Vec<f64>,
    spacing: f64,
    pressure: f64,
}

/// What is read off the flow.
struct Measured {
    foot: f64,
    triple: [f64; 2],
    /// Largest distance of the stem from its straight line.
    kink: f64,
    /// Mean pressure on the wall.
    pressure: f64,
    /// Root mean square departure of the uniform gas from its density, over that.
    spots: f64,
}

/// A point in the frame of Woodward and Colella.
fn turned(at: &[f64; 3]) -> [f64; 3] {
    let (sin, cos) = 30_f64.to_radians().sin_cos();
    [
        1.0 / 6.0 + at[0] * cos + at[1] * sin,
        at[1] * cos - at[0] * sin,
        0.0,
    ]
}

impl Flow {
    fn new(outcome: &Outcome, spacing: f64) -> Self {
        let wall = &outcome.surface;
        let (mut sum, mut count) = (0.0, 0.0);
        for (i, foot) in wall.position.iter().enumerate() {
            if wall.body[i] == 0 && (PLATEAU[0]..PLATEAU[1]).contains(&turned(foot)[0]) {
                sum += wall.pressure[i];
                count += 1.0;
            }
        }
        Self {
            position: outcome.gas.position.iter().map(turned).collect(),
            density: outcome.gas.density.clone(),
            spacing,
            pressure: sum / count,
        }
    }

    /// The foremost fall of the density through half the jump, along a strip at height `y` that leans
    /// with the shock above the triple point.
    fn front(&self, y: f64) -> Result<f64, MetricError> {
        let lean = if y > TRIPLE[1] {
            30_f64.to_radians().tan()
        } else {
            0.0
        };
        let (mut along, mut density) = (Vec::new(), Vec::new());
        for (at, value) in self.position.iter().zip(&self.density) {
            if (at[1] - y).abs() < 2.0 * self.spacing && at[0] > 2.0 {
                along.push(at[0] - lean * (at[1] - y));
                density.push(*value);
            }
        }
        let level = 0.5 * (DENSITY[0] + DENSITY[1]);
        level_crossings(&along, &density, level, 1.5 * self.spacing)
            .into_iter()
            .rfind(|crossing| crossing.rise < 0.0)
            .map(|crossing| crossing.coordinate)
            .ok_or(MetricError::TooFew {
                what: "falls of the density through half the jump at one height",
                found: 0,
                needed: 1,
                remedy: "run to the end",
            })
    }

    /// Heights and places of the front between two heights.
    fn fronts(&self, [low, high]: [f64; 2]) -> Result<Vec<[f64; 2]>, MetricError> {
        const COUNT: usize = 14;
        (0..COUNT)
            .map(|k| low + (high - low) * k as f64 / (COUNT - 1) as f64)
            .map(|y| self.front(y).map(|x| [y, x]))
            .collect()
    }

    fn measure(&self) -> Result<Measured, MetricError> {
        let stem = self.fronts(STEM)?;
        let [a, b] = straight_line(&stem);
        let [c, d] = straight_line(&self.fronts(SHOCK)?);
        let y = (a - c) / (d - b);
        let kink = stem.iter().map(|[y, x]| (x - a - b * y).abs());
        let [x_range, y_range] = UNIFORM;
        let uniform: Vec<f64> = self
            .position
            .iter()
            .zip(&self.density)
            .filter(|(at, _)| {
                (x_range[0]..x_range[1]).contains(&at[0])
                    && (y_range[0]..y_range[1]).contains(&at[1])
            })
            .map(|(_, density)| (density / DENSITY[1] - 1.0).powi(2))
            .collect();
        Ok(Measured {
            foot: self.front(0.0)?,
            triple: [c + d * y, y],
            kink: kink.fold(0.0, f64::max),
            pressure: self.pressure,
            spots: (uniform.iter().sum::<f64>() / uniform.len() as f64).sqrt(),
        })
    }
}

/// Offset and slope of the straight line `y = offset + slope x` nearest to the points.
fn straight_line(points: &[[f64; 2]]) -> [f64; 2] {
    let count = points.len() as f64;
    let mean = |k: usize| points.iter().map(|p| p[k]).sum::<f64>() / count;
    let middle = [mean(0), mean(1)];
    let moment = |k: usize| -> f64 {
        let arm = |p: &[f64; 2], k: usize| p[k] - middle[k];
        points.iter().map(|p| arm(p, 0) * arm(p, k)).sum()
    };
    let slope = moment(1) / moment(0);
    [middle[1] - slope * middle[0], slope]
}

impl Variant {
    fn spacing(&self) -> f64 {
        1.0 / f64::from(self.cells)
    }

    fn settings(&self) -> [String; 3] {
        [
            format!("spacing={}", self.spacing()),
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
        format!("dx 1/{cells}, {equations} {extrapolation}")
    }

    fn checks(&self, found: &Measured, outcome: &Outcome) -> Vec<Check> {
        let label = self.label();
        let row = |quantity: &str, measured: f64, reference: f64| {
            let quantity = format!("{label}: {quantity}");
            let subject = Subject::new(SCENE.name, &quantity, VOLUMES);
            match self.allowed {
                Some(allowed) => subject.absolute(measured, reference, allowed),
                None => subject.informs(measured, reference),
            }
        };
        let informs = |quantity: &str, source, measured: f64, reference: f64| {
            let quantity = format!("{label}: {quantity}");
            Subject::new(SCENE.name, &quantity, source).informs(measured, reference)
        };
        let leaked = outcome.summary.leaked as f64;
        vec![
            row("Mach stem on the wall, x'", found.foot, FOOT),
            row("triple point, x'", found.triple[0], TRIPLE[0]),
            row("triple point, y'", found.triple[1], TRIPLE[1]),
            informs(
                "wall pressure, 1.3 < x' < 1.9",
                VOLUMES,
                found.pressure,
                PRESSURE,
            ),
            informs("stem, departure from straight", VOLUMES, found.kink, 0.0),
            informs(
                "spots: density of the uniform gas, rms departure",
                EXACT,
                found.spots,
                0.0,
            ),
            informs("particles in the wall", "no penetration", leaked, 0.0),
        ]
    }

    /// The density, the wall and the reference points.
    fn picture(
        &self,
        flow: &Flow,
        outcome: &Outcome,
        context: &Context<'_>,
    ) -> Result<(), ValidateError> {
        let diameter: Vec<f64> = outcome
            .gas
            .smoothing_length
            .iter()
            .map(|h| h / SMOOTHING_RATIO)
            .collect();
        let title = format!("Double Mach reflection: {}", self.label());
        let mut picture =
            ParticlePicture::new(&title, &flow.position, &diameter, &flow.density, "density");
        picture.window = Some([[0.0, 3.0], [0.0, 1.0]]);
        picture.axis_labels = ["x'", "y'"];
        let [x, y] = TRIPLE;
        picture.overlays = vec![
            Overlay::outline(vec![[1.0 / 6.0, 0.0], [3.0, 0.0]]),
            Overlay::theory("stem, finite volumes", vec![[FOOT, 0.0], [x, y]]),
        ];
        let name = format!(
            "double-mach-{}-{}-{}.png",
            self.cells, self.equations, self.extrapolation
        );
        Ok(picture.save(&context.out.join(name))?)
    }
}
