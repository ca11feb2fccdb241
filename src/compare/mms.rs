//! Orders of convergence against manufactured solutions, arrangement by arrangement, and mistakes planted in the equations, which
//! must show.

mod planted;
mod series;

use aero_validation::table::{Check, Subject};

use super::comparison::Compare;
use super::context::{CompareError, Context, Level};
use super::scenes::{Source, scene};
use super::variant::{Motion, Scheme};
use series::{QUANTITIES, Series};

const NAME: &str = "mms";
const THEORY: &str = "manufactured solution (Roache 2002; Negi & Ramachandran 2021)";

const PLANE: Source = scene!("mms");
const SPACE: Source = scene!("mms-3d");

/// Flows that sources keep to a solution made up beforehand.
pub struct Manufactured;

impl Compare for Manufactured {
    fn compare(&self, context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
        let mut checks = Vec::new();
        for scheme in schemes(context) {
            for study in studies(scheme, context.level) {
                checks.extend(study.compare(context)?);
            }
        }
        for scheme in schemes(context) {
            checks.extend(planted::compare(scheme, context)?);
        }
        Ok(checks)
    }
}

/// How the particles or points lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Arrangement {
    /// On a lattice, for a quarter of the time that sound takes through the box.
    Lattice,
    /// On a lattice that the flow deforms until sound is through the box.
    Carried,
    /// Displaced at random by a fifth of a spacing.
    Disordered,
}

impl Arrangement {
    fn name(self, scheme: Scheme) -> &'static str {
        match (self, scheme.is_of_points()) {
            (Self::Lattice, _) => "lattice",
            (Self::Carried, false) => "lattice that the flow deforms",
            (Self::Carried, true) => "lattice, to t = 1",
            (Self::Disordered, _) => "disorder 0.2",
        }
    }

    fn settings(self) -> &'static [&'static str] {
        match self {
            Self::Lattice => &[],
            Self::Carried => &["end_time=1.0"],
            Self::Disordered => &["initial.disorder=0.2"],
        }
    }
}

/// Runs of one solution at three spacings.
#[derive(Clone, Copy, Debug)]
struct Study {
    scene: Source,
    scheme: Scheme,
    arrangement: Arrangement,
    /// Spacings to the box.
    cells: [u32; 3],
    /// Least orders of velocity, density and pressure; none where they only inform.
    least: [Option<f64>; 3],
}

impl Study {
    fn label(&self) -> String {
        let [coarse, middle, fine] = self.cells;
        let dimension = if self.scene.name == PLANE.name {
            "2D"
        } else {
            "3D"
        };
        let laws = self.scheme.laws();
        let arrangement = self.arrangement.name(self.scheme);
        format!("{laws}, {dimension}, {arrangement}, {coarse}-{middle}-{fine}")
    }

    fn compare(&self, context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
        let settings = self.arrangement.settings();
        let series = Series::run(
            self.scene,
            self.scheme,
            settings,
            &self.cells,
            None,
            context,
        )?;
        let label = self.label();
        if let Some(stopped) = &series.stopped {
            let what = format!("{label}: {stopped}");
            return Ok(vec![Subject::new(NAME, &what, THEORY).unmeasured(0.0)]);
        }
        let mut checks = Vec::new();
        for (k, name) in QUANTITIES.into_iter().enumerate() {
            let quantity =
                format!("{label}: error of the {name} at the finest, L2 in % of its own");
            let error = 100.0 * series.error(k);
            checks.push(Subject::new(NAME, &quantity, THEORY).informs(error, 0.0));
            let quantity = format!("{label}: order of the last pair, {name}");
            let subject = Subject::new(NAME, &quantity, THEORY);
            let order = series.order(k);
            checks.push(match self.least[k] {
                Some(least) => subject.at_least(order, least),
                None => subject.informs(order, 2.0),
            });
        }
        Ok(checks)
    }
}

/// Both motions; particles alone where something is tried of their schemes, which is no key of points that stay.
fn schemes(context: &Context<'_>) -> Vec<Scheme> {
    let is_tried = |setting: &String| setting.starts_with("scheme.");
    let mut schemes = vec![Scheme::USUAL];
    if !context.settings.iter().any(is_tried) {
        schemes.push(Scheme::USUAL.by_points(Motion::Marched));
    }
    schemes
}

fn studies(scheme: Scheme, level: Level) -> Vec<Study> {
    let in_plane = |arrangement| match (level, arrangement) {
        (Level::Quick, _) => [16, 32, 64],
        (Level::Full, Arrangement::Carried) => [32, 64, 128],
        (Level::Full, _) => [64, 128, 256],
    };
    let in_space = match level {
        Level::Quick => [10, 14, 20],
        Level::Full => [16, 24, 36],
    };
    let study = |scene, arrangement, cells| Study {
        scene,
        scheme,
        arrangement,
        cells,
        least: [None; 3],
    };
    let arrangements = [
        Arrangement::Lattice,
        Arrangement::Carried,
        Arrangement::Disordered,
    ];
    let plane = arrangements.map(|how| study(PLANE, how, in_plane(how)));
    let space = study(SPACE, Arrangement::Lattice, in_space);
    plane.into_iter().chain([space]).collect()
}
