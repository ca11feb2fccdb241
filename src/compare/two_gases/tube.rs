//! Tubes with another gas on either side.

use aero_solver::frame::Frame;
use aero_validation::exact::State;
use aero_validation::exact::riemann::{Riemann, Wave};
use aero_validation::metrics::profile::profile_error;
use aero_validation::table::{Check, Subject};

use super::bubble_gas::{AIR, GAMMAS, HELIUM, MACH};
use super::{NAME, places};
use crate::context::{CompareError, Context, Level};
use crate::profiles::median;
use crate::scenes::{Source, scene};
use aero_validation::exact::normal::normal_shock;

const SCENE: Source = scene!("two-gases");
const THEORY: &str = "exact Riemann solution of two gases (Toro 2009, chapter 4)";

/// Where the gases meet.
const MIDDLE: f64 = 0.5;

/// Per cent that the state on either side may be off, and the mean density over that of the gas on the left.
const ALLOWED: f64 = 0.1;
const ALLOWED_MEAN: [f64; 2] = [0.01, 0.004];

/// Left of here waves come from the end of the tube.
const FROM: f64 = 0.25;

/// Spacings that the interface may be off.
const ALLOWED_PLACE: f64 = 0.2;

/// What meets in the middle.
struct Tube {
    name: &'static str,
    gammas: [f64; 2],
    left: State,
    right: State,
    /// When, and how long after that it is looked at.
    since: f64,
    time: f64,
    settings: Vec<String>,
}

pub(super) fn compare(context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    let (cells, mean) = match context.level {
        Level::Quick => (400, ALLOWED_MEAN[0]),
        Level::Full => (1600, ALLOWED_MEAN[1]),
    };
    let mut checks = Vec::new();
    for tube in [driven(), struck()?] {
        let mut settings = tube.settings.clone();
        settings.push(format!("spacing={:?}", 1.0 / f64::from(cells)));
        settings.push(format!("end_time={:?}", tube.since + tube.time));
        let attempt = SCENE.attempt(&settings, context)?;
        let gas = attempt.outcome().map(|outcome| &outcome.gas);
        checks.extend(judged(&tube, gas, (cells, mean))?);
    }
    Ok(checks)
}

/// Air at twice the pressure drives helium, as in the scene.
fn driven() -> Tube {
    Tube {
        name: "air drives helium",
        gammas: [1.4, 1.667],
        left: State::new(1.2, 0.0, 1.0e5),
        right: State::new(0.08, 0.0, 5.0e4),
        since: 0.0,
        time: 4e-4,
        settings: Vec::new(),
    }
}

/// A shock in air meets helium.
fn struck() -> Result<Tube, CompareError> {
    let shock = normal_shock(MACH, GAMMAS[0])?;
    let front = MACH * AIR.sound_speed(GAMMAS[0]);
    let behind = State::new(
        AIR.density * shock.density_ratio,
        front * (1.0 - 1.0 / shock.density_ratio),
        AIR.pressure * shock.pressure_ratio,
    );
    let from = 0.4;
    Ok(Tube {
        name: "a shock of Mach 1.22 meets helium",
        gammas: GAMMAS,
        left: behind,
        right: HELIUM,
        since: (MIDDLE - from) / front,
        time: 3e-4,
        settings: vec![
            format!("gas.second.gamma={}", GAMMAS[1]),
            "gas.second.gas_constant=1578.0".into(),
            format!("gas.second.density={}", HELIUM.density),
            format!(
                "initial.riemann={{ position = {from}, left = {{ density = {}, pressure = {}, velocity = [{}] }}, right = {{ density = {}, pressure = {} }} }}",
                behind.density, behind.pressure, behind.velocity, AIR.density, AIR.pressure
            ),
        ],
    })
}

fn judged(
    tube: &Tube,
    gas: Option<&Frame>,
    (cells, mean): (u32, f64),
) -> Result<Vec<Check>, CompareError> {
    let exact = Riemann::of_two_gases(tube.left, tube.right, tube.gammas)?;
    let Some(star) = exact.star() else {
        return Ok(Vec::new());
    };
    let at = |speed: f64| MIDDLE + speed * tube.time;
    let far = |wave: Wave| match wave {
        Wave::Shock(speed) => speed,
        Wave::Fan { tail, .. } => tail,
    };
    let contact = at(star.velocity);
    let left = [at(far(exact.left_wave())), contact];
    let right = [contact, at(far(exact.right_wave()))];
    let label = format!("{}, {cells} to a metre", tube.name);
    let check = |what: &str, found: Option<f64>, expected: f64, allowed: Allowed| {
        let what = format!("{label}: {what}");
        let subject = Subject::new(NAME, &what, THEORY);
        match (found, allowed) {
            (None, _) => subject.unmeasured(expected),
            (Some(found), Allowed::Percent(allowed)) => subject.relative(found, expected, allowed),
            (Some(found), Allowed::By(allowed)) => subject.absolute(found, expected, allowed),
        }
    };
    let read = |[from, to]: [f64; 2], is_second, column: fn(&Frame) -> &Vec<f64>| {
        let margin = 0.25 * (to - from);
        let near = |place: &[f64; 3]| (from + margin..to - margin).contains(&place[0]);
        gas.map(|gas| median(places(gas, is_second, near).iter().map(|&i| column(gas)[i])))
    };
    let error = match gas {
        None => None,
        Some(gas) => {
            let x: Vec<f64> = gas.position.iter().map(|p| p[0]).collect();
            let density = |x: f64| {
                let state = exact.sample((x - MIDDLE) / tube.time);
                (x > FROM).then_some(state.density)
            };
            let scale = tube.left.density;
            Some(profile_error(&x, &gas.density, density)?.l1 / scale)
        }
    };
    let meet = gas.map(|gas| {
        let x = |is_second| {
            places(gas, is_second, |_| true)
                .into_iter()
                .map(|i| gas.position[i][0])
        };
        0.5 * (x(false).fold(0.0, f64::max) + x(true).fold(1.0, f64::min))
    });
    let percent = || Allowed::Percent(ALLOWED);
    Ok(vec![
        check(
            "mean density error over the density on the left",
            error,
            0.0,
            Allowed::By(mean),
        ),
        check(
            "place of the interface, m",
            meet,
            contact,
            Allowed::By(ALLOWED_PLACE / f64::from(cells)),
        ),
        check(
            "pressure behind it",
            read(left, false, |gas| &gas.pressure),
            star.pressure,
            percent(),
        ),
        check(
            "pressure ahead of it",
            read(right, true, |gas| &gas.pressure),
            star.pressure,
            percent(),
        ),
        check(
            "density behind it",
            read(left, false, |gas| &gas.density),
            star.density_left,
            percent(),
        ),
        check(
            "density ahead of it",
            read(right, true, |gas| &gas.density),
            star.density_right,
            percent(),
        ),
    ])
}

/// What a check allows.
enum Allowed {
    Percent(f64),
    By(f64),
}
