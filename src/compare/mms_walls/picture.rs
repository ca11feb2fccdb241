//! Error against spacing, a panel for each condition.

use aero_validation::pictures::curves::{Curves, Panel, Series, Style};

use super::solution::Condition;
use super::study::{Errors, Study};
use crate::compare::context::{CompareError, Context};

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
    let panels = conditions.iter().map(|(condition, lines)| {
        let series = lines.iter().map(|(name, errors)| {
            let style = if *name == OWN {
                Style::Dashed
            } else {
                Style::Line
            };
            Series::new(name, style, errors.points(*condition))
        });
        let kept = condition.name();
        let of = if *condition == Condition::Neumann {
            "pressure, Pa"
        } else {
            "velocity, m/s"
        };
        Panel {
            log: [true, true],
            ..Panel::new("spacing, m", &format!("{kept}: {of}"), series.collect())
        }
    });
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

/// Name of the line of the scheme itself.
pub const OWN: &str = "the scheme itself";
