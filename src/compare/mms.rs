//! Orders of convergence against manufactured solutions, arrangement by arrangement, and mistakes planted in the equations, which
//! must show.

mod mistake;
mod planted;
mod series;

use aero_validation::table::{Check, Subject};

use super::context::{CompareError, Context, Level};
use super::scenes::{Source, scene};
use super::suite::Suite;
use super::variant::{Levels, Motion, Scheme};
use series::{QUANTITIES, Series};

const NAME: &str = "mms";
const THEORY: &str = "manufactured solution (Roache 2002; Negi & Ramachandran 2021)";

const PLANE: Source = scene!("mms");
const SPACE: Source = scene!("mms-3d");

/// Viscosity that changes with the temperature, as strong as what the gas carries past.
const VISCOSITY: [&str; 2] = [
    "gas.gas_constant=1.0",
    "gas.viscosity={ power = { viscosity = 0.05, temperature = 0.7, exponent = 0.8 } }",
];

/// Flows that sources keep to a solution made up beforehand.
pub const MANUFACTURED: Suite = Suite::of(&[(Levels::Both, compare)]);

fn compare(context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
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

/// How the particles or points lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Arrangement {
    /// On a lattice, for a quarter of the time that sound takes through the box.
    Lattice,
    /// On a lattice, for half that time: particles' is sheared by then, and still one.
    Deformed,
    /// On a lattice, for all that time: particles' has broken up.
    Broken,
    /// Displaced at random by a fifth of a spacing.
    Disordered,
}

impl Arrangement {
    fn name(self, scheme: Scheme) -> &'static str {
        match (self, scheme.is_of_points()) {
            (Self::Lattice, _) => "lattice",
            (Self::Deformed, false) => "lattice deformed by the flow, t = 0.5",
            (Self::Broken, false) => "disorder from the run, t = 1",
            (Self::Deformed, true) => "lattice, t = 0.5",
            (Self::Broken, true) => "lattice, t = 1",
            (Self::Disordered, _) => "disorder 0.2",
        }
    }

    /// Least order that is asked for; it is told, not judged, where particles or points are in disorder.
    fn least(self, scheme: Scheme) -> (f64, bool) {
        match self {
            Self::Lattice => (1.8, true),
            Self::Deformed => (1.7, true),
            Self::Broken if scheme.is_of_points() => (1.7, true),
            Self::Broken | Self::Disordered => (1.0, false),
        }
    }

    fn settings(self) -> &'static [&'static str] {
        match self {
            Self::Lattice => &[],
            Self::Deformed => &["end_time=0.5"],
            Self::Broken => &["end_time=1.0"],
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
    /// Least order that is asked for.
    least: f64,
    /// False where that is only told.
    is_judged: bool,
    is_viscous: bool,
}

impl Study {
    /// True of a quantity whose order is judged: of particles the velocity alone, because density and pressure fall to 1.5 on fine
    /// lattices.
    fn judges(&self, quantity: usize) -> bool {
        self.is_judged && (self.scheme.is_of_points() || quantity == 0)
    }

    fn label(&self) -> String {
        let [coarse, middle, fine] = self.cells;
        let dimension = if self.scene.name == PLANE.name {
            "2D"
        } else {
            "3D"
        };
        let laws = self.scheme.laws();
        let arrangement = self.arrangement.name(self.scheme);
        let gas = if self.is_viscous { "viscous, " } else { "" };
        format!("{laws}, {gas}{dimension}, {arrangement}, {coarse}-{middle}-{fine}")
    }

    fn compare(&self, context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
        let viscosity: &[&str] = if self.is_viscous { &VISCOSITY } else { &[] };
        let settings = [self.arrangement.settings(), viscosity].concat();
        let series = Series::run(
            self.scene,
            self.scheme,
            &settings,
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
            checks.push(if self.judges(k) {
                subject.at_least(order, self.least)
            } else {
                subject.informs(order, self.least)
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
        (Level::Quick, Arrangement::Lattice) if !scheme.is_of_points() => [24, 48, 96],
        (Level::Quick, _) => [16, 32, 64],
        (Level::Full, Arrangement::Broken) => [32, 64, 128],
        (Level::Full, _) => [64, 128, 256],
    };
    let study = |scene: Source, arrangement: Arrangement, cells| {
        let (least, is_judged) = arrangement.least(scheme);
        Study {
            scene,
            scheme,
            arrangement,
            cells,
            least,
            // In space the spacings that can be paid for are too wide to tell.
            is_judged: is_judged && scene.name == PLANE.name,
            is_viscous: false,
        }
    };
    let quick = [
        Arrangement::Lattice,
        Arrangement::Deformed,
        Arrangement::Disordered,
    ];
    let in_full = [Arrangement::Broken];
    let mut studies: Vec<Study> = quick.map(|how| study(PLANE, how, in_plane(how))).into();
    if level == Level::Full {
        studies.extend(in_full.map(|how| study(PLANE, how, in_plane(how))));
        studies.push(study(SPACE, Arrangement::Lattice, [16, 24, 36]));
    }
    studies.extend(
        viscous(scheme, level).map(|(scene, arrangement, cells)| Study {
            is_viscous: true,
            ..study(scene, arrangement, cells)
        }),
    );
    studies
}

/// What is flown of viscous gas, whose steps are as short as the square of the spacing.
fn viscous(scheme: Scheme, level: Level) -> impl Iterator<Item = (Source, Arrangement, [u32; 3])> {
    let (plane, space): (_, &[_]) = match level {
        Level::Quick if scheme.is_of_points() => ([8, 16, 32], &[]),
        Level::Quick => ([12, 24, 48], &[]),
        Level::Full => ([32, 64, 128], &[[12, 18, 27]]),
    };
    let in_plane: &[_] = match level {
        Level::Quick => &[Arrangement::Lattice],
        Level::Full => &[Arrangement::Lattice, Arrangement::Disordered],
    };
    let in_space = space
        .iter()
        .map(|cells| (SPACE, Arrangement::Lattice, *cells));
    in_plane
        .iter()
        .map(move |how| (PLANE, *how, plane))
        .chain(in_space)
}
