//! How coefficients came to rest, and how they go with the spacing.

use std::path::Path;

use aero_validation::pictures::curves::{Curves, Panel, Series, Style};

use super::error::FlyError;
use super::flight::Flight;
use super::level::{Coefficients, Level};
use super::polar_point::Point;
use super::read;

/// Points of a line at most.
const MOST: usize = 600;

/// What a coefficient is called, which it is, its value and half the width of its band.
type Column = (&'static str, fn(&Coefficients) -> f64, f64, f64);

/// Draws the curves into `convergence.svg` in `folder`, and returns their text.
pub(super) fn draw(
    flight: &Flight,
    levels: &[Level],
    point: &Point,
    folder: &Path,
) -> Result<String, FlyError> {
    let mut panels = Vec::new();
    let keys: &[&str] = if flight.dimension() == 2 {
        &["cd"]
    } else {
        &["cd", "cl", "cm"]
    };
    for key in keys {
        panels.push(over_steps(flight, levels, key)?);
    }
    let columns: [Column; 4] = [
        ("cd", |c| c.cd, point.bands.cd.value, point.bands.cd.band),
        (
            "cd of the forebody",
            |c| c.cd_forebody,
            point.cd_forebody,
            point.cd_forebody_band,
        ),
        ("cl", |c| c.cl, point.cl, point.cl_band),
        ("cm", |c| c.cm, point.cm, point.cm_band),
    ];
    let count = if flight.dimension() == 2 { 2 } else { 4 };
    for (label, of, value, band) in columns.into_iter().take(count) {
        let found: Vec<[f64; 2]> = levels
            .iter()
            .map(|l| [l.finest, of(&l.coefficients)])
            .collect();
        let mut series = vec![
            Series::new("runs", Style::Dots, found.clone()),
            Series::new("", Style::Line, found),
        ];
        series[1].colour = Some([0, 114, 178]);
        if band.is_finite() {
            let widest = levels.first().map_or(1.0, |level| level.finest);
            for (name, y) in [("band", value - band), ("", value + band)] {
                let mut line = Series::new(name, Style::Dashed, vec![[0.0, y], [widest, y]]);
                line.colour = Some([120, 122, 128]);
                series.push(line);
            }
        }
        panels.push(Panel::new("finest spacing, m", label, series));
    }
    let curves = Curves {
        title: format!("{}: convergence", flight.name),
        panels,
        columns: 2,
    };
    let path = folder.join("convergence.svg");
    let files = |error: &dyn std::fmt::Display| FlyError::Files(error.to_string());
    curves.save(&path).map_err(|error| files(&error))?;
    std::fs::read_to_string(&path).map_err(|error| files(&error))
}

/// A coefficient over the steps of all runs, one after the other.
fn over_steps(flight: &Flight, levels: &[Level], key: &str) -> Result<Panel, FlyError> {
    let mut series = Vec::new();
    let mut from = 0.0;
    let mut settled: Vec<f64> = Vec::new();
    for level in levels {
        let history = read::history(&level.folder.join("history.csv"))?;
        let values = history.get(&format!("{}.{key}", flight.name));
        let values = values.map_or(&[][..], Vec::as_slice);
        let every = values.len().div_ceil(MOST).max(1);
        let points = values.iter().enumerate().step_by(every);
        let points = points.map(|(n, value)| [from + n as f64, *value]).collect();
        settled.extend(&values[values.len() / 3..]);
        let label = format!("spacing {:.3e}", level.spacing);
        series.push(Series::new(&label, Style::Line, points));
        from += values.len() as f64;
    }
    let mut panel = Panel::new("iterations", key, series);
    // The first iterations would flatten all that follows.
    settled.sort_by(f64::total_cmp);
    if let (Some(low), Some(high)) = (settled.first(), settled.last()) {
        let room = 0.6 * (high - low) + 0.02 * high.abs().max(low.abs()) + 1e-6;
        panel.window[1] = Some([low - room, high + room]);
    }
    Ok(panel)
}
