//! The swinging square at Mach 5.95 against the published forces of the Eilmer flow solver.

use aero_geometry::kernel::SMOOTHING_RATIO;
use aero_validation::metrics::MetricError;
use aero_validation::metrics::window::{rms_difference, statistics};
use aero_validation::pictures::BLACK;
use aero_validation::pictures::curves::{Curves, Panel, Series, Style};
use aero_validation::pictures::particles::{Overlay, ParticlePicture};
use aero_validation::reference::{Table, rotating_square};
use aero_validation::table::{Check, Subject};

use super::outcome::{Keep, Outcome, Source, run_keeping};
use super::{Context, Level, ValidateError};

const SCENE: Source = Source {
    name: "square",
    text: include_str!("../../cases/square.toml"),
};
const EILMER: &str = "Eilmer example set, digitised (doi:10.1016/j.cpc.2022.108551)";
/// From here the impulsive start is over and the reference's digits are its own, ms.
const FROM: f64 = 0.3;
/// Milliseconds over which the pictured loads are averaged.
const INTERVAL: f64 = 0.02;
/// Half the side and the radius of the corners, m.
const HALF: f64 = 0.01;
const CORNER: f64 = 0.001;
/// Greatest angular velocity, rad/s, and period, s.
const SWING: [f64; 2] = [2000.0, 0.002];

/// One run of the scene.
#[derive(Clone, Copy, Debug)]
struct Variant {
    /// Cells per side.
    cells: u32,
    /// Spacing of the ghosts over the stream's.
    ghosts: f64,
    end_time: f64,
    equations: &'static str,
    extrapolation: &'static str,
    shield: bool,
    /// Largest root mean square departure of the force along the stream, per cent of its mean; none
    /// where the scheme is shown for comparison.
    allowed: Option<f64>,
    level: Level,
}

const PUBLISHED: Variant = Variant {
    cells: 10,
    ghosts: 0.5,
    end_time: 2e-3,
    equations: "conservative",
    extrapolation: "wom",
    shield: false,
    allowed: Some(4.0),
    level: Level::Full,
};

const VARIANTS: [Variant; 9] = [
    // Half of the period, and a margin for it.
    Variant {
        end_time: 1e-3,
        allowed: Some(6.0),
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
    // As published: ghosts as far apart as the gas, and so none in the corners.
    Variant {
        ghosts: 1.0,
        allowed: None,
        ..PUBLISHED
    },
    Variant {
        ghosts: 1.0,
        extrapolation: "wm",
        allowed: None,
        ..PUBLISHED
    },
    Variant {
        cells: 20,
        ..PUBLISHED
    },
    Variant {
        cells: 20,
        extrapolation: "wm",
        ..PUBLISHED
    },
    Variant {
        cells: 20,
        shield: true,
        ..PUBLISHED
    },
];

/// Runs the variants and compares forces and moment over time.
pub fn compare(context: &Context<'_>) -> Result<Vec<Check>, ValidateError> {
    let keep = Keep {
        loads: true,
        ..Keep::default()
    };
    let mut checks = Vec::new();
    let mut histories = Vec::new();
    for variant in VARIANTS.iter().filter(|v| v.level == context.level) {
        let outcome = run_keeping(keep, SCENE, &variant.settings(), context)?;
        let loads = Loads::new(&outcome);
        let rows = variant.checks(&loads, &outcome);
        checks.extend(rows.map_err(|error| SCENE.unread(error))?);
        variant.picture(&outcome, context)?;
        histories.push((variant.label(), loads));
    }
    picture_histories(&histories, context)?;
    Ok(checks)
}

/// Forces and moment per metre of span over time.
struct Loads {
    /// Milliseconds.
    time: Vec<f64>,
    /// Along the stream, across it, moment.
    values: [Vec<f64>; 3],
}

/// Columns of the reference, and what they are.
const COLUMNS: [[&str; 2]; 3] = [
    ["Fx_N_per_m", "force along the stream"],
    ["Fy_N_per_m", "force across the stream"],
    ["Mz_Nm_per_m", "moment"],
];

impl Loads {
    /// Means of the load `k` over short intervals, from half of [`FROM`] on: particles that strike the
    /// wall make it noisy.
    fn smoothed(&self, k: usize) -> Vec<[f64; 2]> {
        let points = self.time.iter().zip(&self.values[k]);
        let later: Vec<_> = points.filter(|(t, _)| **t >= 0.5 * FROM).collect();
        later
            .chunk_by(|(a, _), (b, _)| (*a / INTERVAL).floor() == (*b / INTERVAL).floor())
            .map(|chunk| {
                let add = |[a, b]: [f64; 2], (t, v): &(&f64, &f64)| [a + **t, b + **v];
                let sums = chunk.iter().fold([0.0; 2], add);
                sums.map(|sum| sum / chunk.len() as f64)
            })
            .collect()
    }

    fn new(outcome: &Outcome) -> Self {
        let history = &outcome.history;
        let pick =
            |value: fn(&aero_solver::frame::Load) -> f64| history.load.iter().map(value).collect();
        Self {
            time: history.time.iter().map(|time| 1e3 * time).collect(),
            values: [
                pick(|load| load.force[0]),
                pick(|load| load.force[1]),
                pick(|load| load.moment[2]),
            ],
        }
    }

    fn window(&self) -> [f64; 2] {
        [FROM, self.time.last().copied().unwrap_or(FROM)]
    }
}

impl Variant {
    fn settings(&self) -> [String; 6] {
        let spacing = 2.0 * HALF / f64::from(self.cells);
        [
            format!("spacing={spacing}"),
            format!("body.square.spacing={}", self.ghosts * spacing),
            format!("end_time={:?}", self.end_time),
            format!("scheme.equations={}", self.equations),
            format!("scheme.extrapolation={}", self.extrapolation),
            format!("scheme.shield={}", self.shield),
        ]
    }

    fn label(&self) -> String {
        let Self {
            cells,
            equations,
            extrapolation,
            ..
        } = self;
        let shield = if self.shield { ", shield" } else { "" };
        let ghosts = if self.ghosts < 1.0 {
            ""
        } else {
            ", ghosts at dx"
        };
        format!("dx a/{cells}, {equations} {extrapolation}{shield}{ghosts}")
    }

    /// Departures of the loads: of a force over the mean force along the stream, of the moment over the
    /// root mean square moment.
    fn checks(&self, loads: &Loads, outcome: &Outcome) -> Result<Vec<Check>, MetricError> {
        let label = self.label();
        let table = rotating_square();
        let times = table.column("t_ms").unwrap_or_default();
        let window = loads.window();
        let of_reference = |column: &str| {
            let values = table.column(column).unwrap_or_default();
            statistics(times, values, window)
        };
        let force = of_reference(COLUMNS[0][0])?.mean;
        let moment = of_reference(COLUMNS[2][0])?.rms;
        let mut checks = Vec::new();
        for (k, [column, what]) in COLUMNS.into_iter().enumerate() {
            let reference = (times, table.column(column).unwrap_or_default());
            let rms = rms_difference(&loads.time, &loads.values[k], reference, window)?;
            let (scale, over) = match k {
                2 => (moment, "rms moment"),
                _ => (force, "mean force along it"),
            };
            let quantity = format!("{label}: {what}, rms departure / {over}");
            let subject = Subject::new(SCENE.name, &quantity, EILMER);
            checks.push(match self.allowed {
                Some(allowed) if k == 0 => subject.absolute(rms / scale, 0.0, allowed / 100.0),
                _ => subject.informs(rms / scale, 0.0),
            });
        }
        let mean = statistics(&loads.time, &loads.values[0], window)?.mean;
        let quantity = format!("{label}: mean force along the stream, N/m");
        checks.push(Subject::new(SCENE.name, &quantity, EILMER).informs(mean, force));
        let quantity = format!("{label}: particles in the wall");
        let subject = Subject::new(SCENE.name, &quantity, "no penetration");
        checks.push(subject.informs(outcome.summary.leaked as f64, 0.0));
        Ok(checks)
    }

    /// The density around the square where it ends.
    fn picture(&self, outcome: &Outcome, context: &Context<'_>) -> Result<(), ValidateError> {
        let gas = &outcome.gas;
        let millimetres = |length: &f64| 1e3 * length;
        let position: Vec<[f64; 3]> = gas
            .position
            .iter()
            .map(|at| at.each_ref().map(millimetres))
            .collect();
        let diameter: Vec<f64> = gas
            .smoothing_length
            .iter()
            .map(|h| 1e3 * h / SMOOTHING_RATIO)
            .collect();
        let title = format!("Swinging square, Mach 5.95: {}", self.label());
        let mut picture = ParticlePicture::new(
            &title,
            &position,
            &diameter,
            &gas.density,
            "density, kg/m^3",
        );
        picture.axis_labels = ["x, mm", "y, mm"];
        picture.overlays = vec![Overlay::outline(outline(outcome.gas.time))];
        Ok(picture.save(&context.out.join(format!("{}.png", self.file())))?)
    }

    fn file(&self) -> String {
        let shield = if self.shield { "-shield" } else { "" };
        let ghosts = if self.ghosts < 1.0 { "" } else { "-ghosts-dx" };
        format!(
            "square-{}-{}-{}{shield}{ghosts}",
            self.cells, self.equations, self.extrapolation
        )
    }
}

/// The square at `time`, in millimetres.
fn outline(time: f64) -> Vec<[f64; 2]> {
    let frequency = std::f64::consts::TAU / SWING[1];
    let (sin, cos) = (SWING[0] / frequency * (frequency * time).sin()).sin_cos();
    let middle = HALF - CORNER;
    let corners = [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)];
    let arc = |k: usize| {
        (0..=6).map(move |step| {
            let angle = (k as f64 + f64::from(step) / 6.0) * std::f64::consts::FRAC_PI_2;
            let (x, y) = corners[k];
            [
                x * middle + CORNER * angle.cos(),
                y * middle + CORNER * angle.sin(),
            ]
        })
    };
    let mut points: Vec<[f64; 2]> = (0..corners.len()).flat_map(arc).collect();
    points.extend(points.first().copied());
    points
        .iter()
        .map(|[x, y]| [1e3 * (x * cos - y * sin), 1e3 * (x * sin + y * cos)])
        .collect()
}

/// Forces and moment of all variants over time.
fn picture_histories(
    histories: &[(String, Loads)],
    context: &Context<'_>,
) -> Result<(), ValidateError> {
    let table: Table = rotating_square();
    let times = table.column("t_ms").unwrap_or_default();
    let panels = COLUMNS
        .into_iter()
        .enumerate()
        .map(|(k, [column, what])| {
            let values = table.column(column).unwrap_or_default();
            let reference = times.iter().zip(values).map(|(t, v)| [*t, *v]);
            let reference = reference.filter(|point| point[0] >= FROM).collect();
            let mut series: Vec<Series> = histories
                .iter()
                .map(|(label, loads)| {
                    // Two spacings share a palette: the finer ones are dashed.
                    let style = if label.contains("a/20") {
                        Style::Dashed
                    } else {
                        Style::Line
                    };
                    Series::new(label, style, loads.smoothed(k))
                })
                .collect();
            series.push(Series {
                colour: Some(BLACK),
                ..Series::new("Eilmer", Style::Dots, reference)
            });
            let unit = if k == 2 { "N m/m" } else { "N/m" };
            Panel::new("t, ms", &format!("{what}, {unit}"), series)
        })
        .collect();
    let curves = Curves {
        title: "Swinging square: loads per metre of span".into(),
        panels,
        columns: 1,
    };
    Ok(curves.save(&context.out.join("square-loads.png"))?)
}
