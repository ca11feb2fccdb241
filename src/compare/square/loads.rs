//! Forces and moment of the square over time, and the picture of those of all runs.

use aero::run::History;
use aero_solver::frame::Load;
use aero_validation::pictures::BLACK;
use aero_validation::pictures::curves::{Curves, Panel, Series, Style};
use aero_validation::reference::rotating_square;

use crate::context::{CompareError, Context};

/// From here the impulsive start is over and the reference's digits are its own, ms.
const FROM: f64 = 0.3;
/// Milliseconds over which the pictured loads are averaged.
const INTERVAL: f64 = 0.02;

/// Forces and moment per metre of span over time.
pub struct Loads {
    /// Milliseconds.
    pub time: Vec<f64>,
    /// Along the stream, across it, moment.
    pub values: [Vec<f64>; 3],
}

/// Columns of the reference, and what they are.
pub const COLUMNS: [[&str; 2]; 3] = [
    ["Fx_N_per_m", "force along the stream"],
    ["Fy_N_per_m", "force across the stream"],
    ["Mz_Nm_per_m", "moment"],
];

impl Loads {
    /// Means of the load `k` over short intervals, from half of [`FROM`] on: particles that strike the
    /// wall make it noisy.
    pub fn smoothed(&self, k: usize) -> Vec<[f64; 2]> {
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

    pub fn new(history: &History) -> Self {
        let pick = |value: fn(&Load) -> f64| history.load.iter().map(value).collect();
        Self {
            time: history.time.iter().map(|time| 1e3 * time).collect(),
            values: [
                pick(|load| load.force[0]),
                pick(|load| load.force[1]),
                pick(|load| load.moment[2]),
            ],
        }
    }

    pub fn window(&self) -> [f64; 2] {
        [FROM, self.time.last().copied().unwrap_or(FROM)]
    }
}

/// Forces and moment of all runs over time.
pub fn draw(runs: &[(String, History)], context: &Context<'_>) -> Result<(), CompareError> {
    let table = rotating_square();
    let times = table.column("t_ms").unwrap_or_default();
    let runs: Vec<(&str, Loads)> = runs
        .iter()
        .map(|(label, history)| (label.as_str(), Loads::new(history)))
        .collect();
    let panels = COLUMNS.into_iter().enumerate().map(|(k, [column, what])| {
        let values = table.column(column).unwrap_or_default();
        let reference = times.iter().zip(values).map(|(t, v)| [*t, *v]);
        let reference = reference.filter(|point| point[0] >= FROM).collect();
        let mut series: Vec<Series> = runs
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
    });
    let curves = Curves {
        title: "Swinging square: loads per metre of span".into(),
        panels: panels.collect(),
        columns: 1,
    };
    Ok(curves.save(&context.out.join("square-loads.png"))?)
}
