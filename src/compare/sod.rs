//! The reflecting shock tube against the exact solution.

use aero::run::{Keep, Outcome};
use aero_solver::frame::Frame;
use aero_validation::exact::State;
use aero_validation::exact::sod_tube::ClosedTube;
use aero_validation::metrics::profile::profile_error;

use super::comparison::{Comparison, Flow};
use super::context::CompareError;
use super::profiles::{Profiles, median};
use super::row::Row;
use super::scenes::{Source, scene};
use super::variant::Variant;

/// Its scene.
pub const SCENE: Source = scene!("sod");
const THEORY: &str = "exact Riemann solution with reflection (Toro 2009)";
const GAMMA: f64 = 1.4;

/// When the flow is compared, and the largest particle-mean error of the density there.
#[derive(Clone, Copy, Debug)]
pub struct Moment {
    time: f64,
    allowed: f64,
    /// Of the total energy, by the walls alone.
    drift: f64,
}

const MOMENTS: [Moment; 2] = [
    Moment {
        time: 0.15,
        allowed: 5e-3,
        drift: 1e-12,
    },
    Moment {
        time: 0.375,
        allowed: 6e-3,
        drift: 2e-4,
    },
];

/// At the scene's spacing.
pub const SOD: Comparison<Moment> = Comparison {
    case: "sod",
    scene: SCENE,
    length: 1.0,
    keep: Keep::End,
    variants: || {
        let of = |change: fn(Variant<Moment>) -> Variant<Moment>| {
            MOMENTS.map(|moment| change(Variant::new(500, moment)))
        };
        let [early, late] = MOMENTS.map(|moment| Variant::new(500, moment).wm());
        [
            of(Variant::both),
            // Before the shock has met the wall mirrors there change nothing.
            [early, late.both()],
            of(|v| v.marched().cells(200).both()),
            of(Variant::paper),
            of(|v| v.wm().paper()),
        ]
        .concat()
    },
    label: |v| format!("{}, t {}", v.scheme, v.own.time),
    settings: |v, _| {
        let mut settings = vec![format!("end_time={}", v.own.time)];
        if v.scheme.is_of_points() {
            // Particles need the start smoothed over a few spacings, cells do not.
            settings.push("initial.riemann.smooth=false".into());
        }
        settings
    },
    rows,
    pictures,
    together: None,
};

fn rows(flow: &Flow<'_, Moment>) -> Result<Vec<Row>, CompareError> {
    let tube = ClosedTube::sod()?;
    let outcome = flow.outcome;
    let Moment {
        time,
        allowed,
        drift: most,
    } = flow.variant.own;
    let error = density_error(outcome, &tube)?;
    let drift = outcome
        .summary
        .conservation
        .map_or(f64::NAN, |drift| drift.energy);
    let mut rows = vec![
        Row::error("mean density error", THEORY, error, allowed),
        Row::error("drift of total energy", THEORY, drift, most),
    ];
    if time > tube.wall_time() {
        let behind = tube.reflected();
        let density = plateau(outcome, &tube, |gas| &gas.density);
        let pressure = plateau(outcome, &tube, |gas| &gas.pressure);
        rows.extend([
            Row::relative("density at the wall", THEORY, density, behind.density, 0.5),
            Row::relative(
                "pressure at the wall",
                THEORY,
                pressure,
                behind.pressure,
                0.5,
            ),
        ]);
    }
    rows.push(flow.no_leaks());
    Ok(rows)
}

/// Mean departure of the density from the exact solution, over the particles.
pub fn density_error(outcome: &Outcome, tube: &ClosedTube) -> Result<f64, CompareError> {
    let gas = &outcome.gas;
    let x: Vec<f64> = gas.position.iter().map(|p| p[0]).collect();
    let exact = |x: f64| tube.at(x, gas.time).ok().map(|state| state.density);
    Ok(profile_error(&x, &gas.density, exact)?.l1)
}

/// Median between the reflected shock and the wall, a quarter of the way off either.
fn plateau(outcome: &Outcome, tube: &ClosedTube, values: fn(&Frame) -> &Vec<f64>) -> f64 {
    let gas = &outcome.gas;
    let shock = tube.shock_position(gas.time).unwrap_or(1.0);
    let margin = 0.25 * (1.0 - shock);
    let judged = gas.position.iter().zip(values(gas));
    let judged = judged.filter(|(at, _)| (shock + margin..1.0 - margin).contains(&at[0]));
    median(judged.map(|(_, value)| *value))
}

/// Profiles against the exact ones, behind the reflected shock.
fn pictures(flow: &Flow<'_, Moment>) -> Result<(), CompareError> {
    let tube = ClosedTube::sod()?;
    let gas = &flow.outcome.gas;
    if flow.variant.own.time <= tube.wall_time() {
        return Ok(());
    }
    let nowhere = State::new(f64::NAN, f64::NAN, f64::NAN);
    let profiles = Profiles {
        title: format!("Reflecting shock tube at t = {}", gas.time),
        range: [0.0, 1.0],
        gamma: GAMMA,
        exact: &|x| tube.at(x, gas.time).unwrap_or(nowhere),
    };
    flow.save(profiles.of(gas), "", "png")
}
