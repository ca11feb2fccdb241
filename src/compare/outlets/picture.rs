//! What a probe saw, treatment by treatment.

use aero_validation::pictures::curves::{Curves, Panel, Series, Style};
use aero_validation::pictures::{BLACK, Colour};

use super::cases::{Case, Record, Suite};
use super::treatments::ALL;
use crate::context::{CompareError, Context};

/// Of the treatments in their order: those of Okabe & Ito 2008.
const COLOURS: [Colour; ALL.len()] = [
    [0, 114, 178],
    [230, 159, 0],
    [213, 94, 0],
    [204, 121, 167],
    [86, 180, 233],
    [0, 158, 115],
];
/// Pressures so many times the largest of the long duct are not drawn.
const MOST: f64 = 2.5;

/// Draws the records of the treatments and of the long duct into `outlets-CASE.png`.
///
/// # Errors
/// A file that cannot be written.
pub fn draw(
    suite: &Suite,
    reference: &Record,
    records: &[Record],
    context: &Context<'_>,
) -> Result<(), CompareError> {
    let labels = ["2 p / (rho U^2)", "u / U", "v / U"];
    let shown = if suite.case == Case::Vortex { 3 } else { 2 };
    let panel = |k: usize| {
        let points = |record: &Record| {
            let numbered = record.iter().enumerate();
            numbered.map(|(i, now)| [suite.time(i), now[k]]).collect()
        };
        let lines = ALL.iter().zip(records).zip(COLOURS);
        let lines = lines.map(|((treatment, record), colour)| Series {
            colour: Some(colour),
            ..Series::new(treatment.name(), Style::Line, points(record))
        });
        let long = Series {
            colour: Some(BLACK),
            ..Series::new("long duct", Style::Dashed, points(reference))
        };
        let series = lines.chain([long]).collect();
        let mut panel = Panel::new("time, s", labels[k], series);
        let all = reference.iter().map(|now| now[k]);
        let low = all.clone().fold(f64::INFINITY, f64::min);
        let high = all.fold(f64::NEG_INFINITY, f64::max);
        let room = (MOST - 1.0) * (high - low);
        panel.window[1] = Some([low - room, high + room]);
        panel
    };
    let picture = Curves {
        title: format!("At the probe, {}", suite.name()),
        panels: (0..shown).map(panel).collect(),
        columns: 1,
    };
    let file = format!("outlets-{}.png", suite.case.name());
    picture.save(&context.out.join(file))?;
    Ok(())
}
