//! `PySPH` among the lines: the published equations at its measured speed.

use aero_validation::pictures::speed::{SpeedPoint, SpeedSeries};
use aero_validation::reference::wedge_pysph;

use super::Costs;

/// The line whose equations `PySPH` runs.
const SAME: &str = "paper, wom";

/// The errors of our runs of the published scheme, at the processor time that `PySPH` would take for as
/// many particle updates: it runs the same equations, and what it does per second was measured.
pub(super) fn line(series: &[SpeedSeries], costs: &Costs) -> Option<SpeedSeries> {
    let own = series.iter().find(|line| line.name == SAME)?;
    let table = wedge_pysph();
    let counts = table.column("particles").ok()?;
    let (fewest, most) = (*counts.first()?, *counts.last()?);
    let rate =
        |particles: f64| table.interpolate("particles", "rate", particles.clamp(fewest, most));
    let point = |own: &SpeedPoint| {
        let same = |cost: &&super::Cost| cost.line == SAME && cost.label == own.label;
        let cost = costs.0.iter().find(same)?;
        Some(SpeedPoint {
            label: own.label.clone(),
            cpu_seconds: cost.updates / rate(cost.particles)?,
            error: own.error,
        })
    };
    Some(SpeedSeries {
        name: "PySPH's speed, paper's errors".into(),
        peer: true,
        points: own.points.iter().filter_map(point).collect(),
    })
}
