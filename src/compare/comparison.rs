//! A comparison as data, and how any of them is made: run the variants of the level, read the flow,
//! judge the rows, draw.

use std::path::PathBuf;

use aero::run::{History, Keep, Outcome};
use aero_validation::pictures::curves::Curves;
use aero_validation::table::{Check, Subject};

use super::context::{CompareError, Context, Level};
use super::row::{Heading, Row};
use super::scenes::Source;
use super::variant::Variant;
use super::view::View;

/// What is run, and what is read off it. `P` is what the case varies beside spacing and scheme.
pub struct Comparison<P: 'static = ()> {
    /// Name of the case.
    pub case: &'static str,
    /// What is run.
    pub scene: Source,
    /// The length that a variant's cells divide, in the scene's unit.
    pub length: f64,
    /// What is kept of the runs.
    pub keep: Keep,
    /// The runs, in order.
    pub variants: fn() -> Vec<Variant<P>>,
    /// What stands before each quantity, and after the title of each picture.
    pub label: fn(&Variant<P>) -> String,
    /// What a variant sets beside spacing and scheme, given its spacing.
    pub settings: fn(&Variant<P>, f64) -> Vec<String>,
    /// Rows that a flow gives.
    pub rows: fn(&Flow<'_, P>) -> Result<Vec<Row>, CompareError>,
    /// Pictures of a flow.
    pub pictures: fn(&Flow<'_, P>) -> Result<(), CompareError>,
    /// A picture of all runs together, by their labels.
    pub together: Option<Together>,
}

/// Draws the runs of a case, by their labels, into one picture.
pub type Together = fn(&[(String, History)], &Context<'_>) -> Result<(), CompareError>;

/// The end of one run, as the functions of a case see it.
pub struct Flow<'a, P = ()> {
    /// What was run.
    pub variant: &'a Variant<P>,
    /// Its spacing, in the scene's unit.
    pub spacing: f64,
    /// The result.
    pub outcome: &'a Outcome,
    case: &'static str,
    label: &'a str,
    settings: &'a [String],
    context: &'a Context<'a>,
}

/// What the list of all cases holds.
pub trait Compare: Sync {
    /// Runs what there is to run at the level of the context, and compares it.
    ///
    /// # Errors
    /// A scene of the project that is wrong; files that cannot be written. A run that stops, or that does
    /// not show what is to be measured, is a row that fails.
    fn compare(&self, context: &Context<'_>) -> Result<Vec<Check>, CompareError>;

    /// True of what another comparison at the same time would change.
    fn wants_all_threads(&self) -> bool {
        false
    }
}

impl<P> Compare for Comparison<P> {
    fn compare(&self, context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
        let mut checks = Vec::new();
        let mut histories = Vec::new();
        for variant in (self.variants)() {
            // What is tried of the particles' schemes is no key of points that stay.
            let is_tried = |setting: &String| setting.starts_with("scheme.");
            let is_asked = !variant.scheme.is_of_points() || !context.settings.iter().any(is_tried);
            if !variant.levels.contain(context.level) || !is_asked {
                continue;
            }
            let label = context.called((self.label)(&variant));
            match self.run(&variant, &label, context) {
                Ok((rows, history)) => {
                    checks.extend(rows);
                    histories.extend(self.together.map(|_| (label, history)));
                }
                Err(error) => checks.push(failed(self.case, &label, error, checks.len())?),
            }
        }
        if let Some(together) = self.together {
            together(&histories, context)?;
        }
        Ok(checks)
    }
}

impl<P> Comparison<P> {
    fn run(
        &self,
        variant: &Variant<P>,
        label: &str,
        context: &Context<'_>,
    ) -> Result<(Vec<Check>, History), CompareError> {
        let spacing = self.length / f64::from(variant.cells);
        let mut settings = vec![format!("spacing={spacing}")];
        settings.extend(variant.scheme.settings());
        settings.extend((self.settings)(variant, spacing));
        let outcome = self.scene.run(&settings, self.keep, context)?;
        let flow = Flow {
            variant,
            spacing,
            outcome: &outcome,
            case: self.case,
            label,
            settings: &settings,
            context,
        };
        let heading = Heading {
            case: self.case,
            label,
            only_informs: !variant.is_judged,
            is_quick: context.level == Level::Quick,
        };
        let rows = (self.rows)(&flow)?;
        (self.pictures)(&flow)?;
        let checks = rows.into_iter().map(|row| row.check(heading)).collect();
        Ok((checks, outcome.history))
    }
}

/// The row of a run that has none of its own, after so many `rows` of others. An error of anything but the flow stays one; but a scene that
/// is refused after others have been run, perhaps for an hour, takes no rows of theirs away.
fn failed(
    case: &str,
    label: &str,
    error: CompareError,
    rows: usize,
) -> Result<Check, CompareError> {
    let is_of_one_run = match error {
        CompareError::Run { .. } | CompareError::Metric(_) => true,
        CompareError::Scene(_) => rows > 0,
        _ => false,
    };
    if !is_of_one_run {
        return Err(error);
    }
    let what = format!("{label}: {error}");
    Ok(Subject::new(case, &what, "a run to its end").unmeasured(0.0))
}

impl<'a, P> Flow<'a, P> {
    /// The row of particles in the wall, where none may be.
    pub fn no_leaks(&self) -> Row {
        Row::at_most(
            "particles in the wall",
            "no penetration",
            self.leaked(),
            0.0,
        )
    }

    /// The rows of a body in a flow that is symmetric about its axis: its lift over its drag, and its moment over drag and
    /// reference length.
    pub fn no_lift(&self, body: &str, most: [f64; 2]) -> [Row; 2] {
        let loads = &self.outcome.summary.bodies[body];
        let [drag, across @ ..] = loads.force_mean;
        let lift = across[0].hypot(across[1]) / drag;
        let moment = loads.moment.iter().map(|m| m * m).sum::<f64>().sqrt();
        let moment = moment / (loads.force[0] * loads.reference_length);
        [
            Row::error("lift / drag", "symmetry", lift, most[0]),
            Row::error("moment / (drag x length)", "symmetry", moment, most[1]),
        ]
    }

    /// Number of particles in the wall.
    pub fn leaked(&self) -> f64 {
        self.outcome.summary.leaked as f64
    }

    /// How often walls sent gas back that a step had carried into them.
    pub fn returned(&self) -> f64 {
        self.outcome.summary.returned as f64
    }

    /// The end of another scene's run with the settings of this one.
    pub fn run_also(&self, scene: Source) -> Result<Outcome, CompareError> {
        scene.run(self.settings, Keep::End, self.context)
    }

    /// A picture of the gas, coloured by `value`.
    pub fn view(&self, title: &str, value: &'a [f64], value_label: &'a str) -> View<'a> {
        let title = format!("{title}: {}", self.label);
        View::new(
            title,
            self.file("", "png"),
            &self.outcome.gas,
            (value, value_label),
        )
    }

    /// Saves curves as `CASE-LABEL-SUFFIX.ENDING`, under a title that ends with the label.
    pub fn save(&self, mut curves: Curves, suffix: &str, ending: &str) -> Result<(), CompareError> {
        curves.title = format!("{}: {}", curves.title, self.label);
        Ok(curves.save(&self.file(suffix, ending))?)
    }

    fn file(&self, suffix: &str, ending: &str) -> PathBuf {
        let name = file_name(&format!("{} {} {suffix}", self.case, self.label));
        self.context.out.join(format!("{name}.{ending}"))
    }
}

/// The words of a label, with dashes between them.
fn file_name(label: &str) -> String {
    let is_part = |c: char| c.is_alphanumeric() || c == '.' || c == '-';
    let words = label.split(|c| !is_part(c)).filter(|word| !word.is_empty());
    words.collect::<Vec<_>>().join("-")
}

#[cfg(test)]
mod tests {
    use aero::scene::SceneError;

    use super::*;

    #[test]
    fn a_scene_that_is_refused_takes_no_rows_of_other_runs_away() {
        let refused = || {
            CompareError::Scene(SceneError::Value {
                place: "scheme.motion".to_owned(),
                message: "no such motion".to_owned(),
            })
        };
        assert!(failed("wedge", "dx 1/16", refused(), 0).is_err());
        let row = failed("wedge", "dx 1/16", refused(), 7).expect("a row that fails");
        assert!(!row.pass && row.quantity.contains("no such motion"));
    }

    #[test]
    fn files_are_called_by_the_words_of_their_label() {
        let label = "wedge M 2.5, 20 deg, dx 1/16, conservative wom ";
        assert_eq!(
            file_name(label),
            "wedge-M-2.5-20-deg-dx-1-16-conservative-wom"
        );
    }
}
