//! Error against spacing, a panel for each condition.

use aero_validation::pictures::curves::{Curves, Panel, Series, Style};
use aero_validation::pictures::{BLACK, Colour};

use super::solution::Condition;
use super::study::{Errors, Study};
use super::treatments::ALL;
use crate::context::{CompareError, Context};

/// Lines of one condition, by name.
pub type Lines = Vec<(&'static str, Errors)>;

/// Draws what treatments add at one wall, and the error of the scheme itself, into `mms-walls-PLACE.png`.
///
/// # Errors
/// A file that cannot be written.
pub fn draw(
    study: &Study,
    conditions: &[(Condition, Lines)],
    context: &Context<'_>,
) -> Result<(), CompareError> {
    let panels = conditions
        .iter()
        .map(|(condition, lines)| panel(*condition, lines));
    let lie = study.arrangement.name();
    let picture = Curves {
        title: format!("What wall treatments add to the error: {lie}"),
        panels: panels.collect(),
        columns: 3,
    };
    let file = lie.replace(", ", "-").replace(' ', "-");
    picture.save(&context.out.join(format!("mms-walls-{file}.png")))?;
    Ok(())
}

fn panel(condition: Condition, lines: &Lines) -> Panel {
    let series = lines.iter().map(|(name, errors)| {
        let number = ALL.iter().position(|treatment| treatment.name() == *name);
        let style = number.map_or(Style::Dashed, |_| Style::Line);
        Series {
            colour: Some(number.map_or(BLACK, |k| COLOURS[k])),
            ..Series::new(name, style, errors.points(condition))
        }
    });
    let series: Vec<Series> = series.collect();
    let of = if condition == Condition::Neumann {
        "pressure, Pa"
    } else {
        "velocity, m/s"
    };
    let mut panel = Panel::new("spacing, m", &format!("{}: {of}", condition.name()), series);
    panel.log = [true, true];
    panel.window[1] = room(&panel.series);
    panel
}

/// Ends of the axis of errors, with room for the legend above; what broke up is left out.
fn room(series: &[Series]) -> Option<[f64; 2]> {
    let own = series.first()?.points.first()?[1];
    let points = series.iter().flat_map(|series| &series.points);
    let shown = points
        .map(|point| point[1])
        .filter(|error| *error > 0.0 && *error < MOST * own);
    let (low, high) = shown.fold((own, own), |(low, high), error| {
        (low.min(error), high.max(error))
    });
    Some([low / 2.0, high * 8.0])
}

/// Errors so many times the scheme's own at the coarsest spacing are not drawn.
const MOST: f64 = 1e3;

/// Of the treatments in their order, the same in every panel: those of Okabe & Ito 2008, violet and grey.
const COLOURS: [Colour; ALL.len()] = [
    [0, 114, 178],
    [213, 94, 0],
    [0, 158, 115],
    [204, 121, 167],
    [230, 159, 0],
    [86, 180, 233],
    [110, 60, 160],
    [130, 130, 130],
];

/// Name of the line of the scheme itself.
pub const OWN: &str = "the scheme itself";
