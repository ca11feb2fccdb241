//! A cylinder whose wake sheds vortices, marched in time.

use aero::run::{Keep, Outcome};
use aero_validation::metrics::MetricError;
use aero_validation::metrics::shedding::{Shedding, shedding};
use aero_validation::table::{Check, Subject};

use super::NAME;
use crate::context::{CompareError, Context};
use crate::scenes::{Source, scene};

const SCENE: Source = scene!("cylinder-shedding");

/// As in the scene, whose stream has a density and a speed of sound of 1 and whose cylinder a diameter of 1.
const MACH: f64 = 0.2;

/// Whole periods, the last ones of a run, that are read.
const PERIODS: usize = 3;

/// How far beside the band of what others find, per cent.
const ALLOWED: f64 = 5.0;

/// Drag coefficient, amplitude of the lift coefficient, Strouhal number: each from the least to the largest that others find.
type Bands = [[f64; 2]; 3];

/// A run.
struct Wake {
    name: &'static str,
    settings: &'static [&'static str],
    source: &'static str,
    bands: Bands,
    is_judged: bool,
}

const WAKES: [Wake; 2] = [
    Wake {
        name: "Re 200, 24 cells to its diameter",
        settings: &[],
        source: "incompressible (Marrone et al., Guerrero, Tafuni et al., as Negi, Ramachandran & Haftu 2020, table 8, has them)",
        bands: [[1.38, 1.46], [0.68, 0.73], [0.20, 0.21]],
        is_judged: true,
    },
    Wake {
        name: "Re 100, 16 cells to its diameter",
        settings: &["gas.viscosity.reynolds=100.0", "spacing=1.0"],
        source: "incompressible, as many others find it",
        bands: [[1.33, 1.36], [0.33, 0.33], [0.165, 0.165]],
        is_judged: false,
    },
];

pub(super) fn compare(context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    let mut checks = Vec::new();
    for wake in &WAKES {
        checks.extend(of(wake, context)?);
    }
    Ok(checks)
}

fn of(wake: &Wake, context: &Context<'_>) -> Result<[Check; 3], CompareError> {
    let settings: Vec<String> = wake.settings.iter().map(ToString::to_string).collect();
    let found = match SCENE.run(&settings, Keep::Loads, context) {
        // A wake that does not swing has nothing to be measured.
        Ok(outcome) => read(&outcome).ok(),
        Err(CompareError::Run { .. }) => None,
        Err(error) => return Err(error),
    };
    let what = |quantity: &str| format!("cylinder, M {MACH}, {}: {quantity}", wake.name);
    let values = found.map(|found| {
        let Shedding {
            frequency,
            drag,
            lift_amplitude,
            ..
        } = found;
        [drag, lift_amplitude, frequency / MACH]
    });
    let names = ["mean c_d", "amplitude of c_l", "Strouhal number"].map(what);
    Ok(std::array::from_fn(|k| {
        let subject = Subject::new(NAME, &names[k], wake.source);
        let [low, high] = wake.bands[k];
        match values {
            None => subject.unmeasured(low),
            Some(values) if wake.is_judged => {
                subject.relative(values[k], values[k].clamp(low, high), ALLOWED)
            }
            Some(values) => subject.informs(values[k], values[k].clamp(low, high)),
        }
    }))
}

/// Loads over the last periods, as coefficients.
fn read(outcome: &Outcome) -> Result<Shedding, MetricError> {
    let history = &outcome.history;
    let along = |axis: usize| -> Vec<f64> {
        let loads = history.load.iter();
        loads
            .map(|load| load.force[axis] / (0.5 * MACH * MACH))
            .collect()
    };
    shedding(&history.time, &along(0), &along(1), PERIODS)
}
