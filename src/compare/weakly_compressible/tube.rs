//! Water in a tube: stopped by a wall, and let go from a high pressure.

use aero_validation::exact::liquid::{Liquid, Moving};
use aero_validation::table::{Check, Subject};

use super::NAME;
use crate::context::{CompareError, Context};
use crate::scenes::{Source, scene};

const SCENE: Source = scene!("water-hammer");
const THEORY: &str = "Tait's equation, jumps of mass and momentum (Cole 1948)";
/// As in the scene.
const WATER: Liquid = Liquid {
    density: 998.0,
    sound_speed: 1484.0,
    pressure: 101_325.0,
    exponent: 7.0,
};
const SPEED: f64 = 100.0;
const END: f64 = 3e-4;
/// Density of the water that is let go.
const PRESSED: f64 = 1200.0;
/// Per cent.
const ALLOWED: f64 = 0.5;

pub(super) fn compare(context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    let mut checks = stopped(context)?;
    checks.extend(let_go(context)?);
    Ok(checks)
}

/// Means of rise of the density, and of the velocity, between two places.
fn means(columns: &aero_solver::frame::Frame, [from, to]: [f64; 2]) -> [f64; 2] {
    let inside = (0..columns.density.len()).filter(|&i| {
        let x = columns.position[i][0];
        from < x && x < to
    });
    let (mut sums, mut count) = ([0.0; 2], 0.0);
    for i in inside {
        sums[0] += columns.density[i] - WATER.density;
        sums[1] += columns.velocity[i][0];
        count += 1.0;
    }
    sums.map(|sum| sum / count)
}

/// Behind the shock that runs back from the wall, away from both.
fn stopped(context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    let (behind, front) = WATER.stopped(WATER.density, SPEED);
    let depth = front * END;
    let subject = |what| Subject::new(NAME, what, THEORY);
    let subject = subject("water stopped at 100 m/s: rise of the density behind the shock");
    let attempt = SCENE.attempt(&[], context)?;
    let exact = behind - WATER.density;
    Ok(vec![match attempt.outcome() {
        None => subject.unmeasured(exact),
        Some(outcome) => {
            let [found, _] = means(&outcome.gas, [1.0 - 0.8 * depth, 1.0 - 0.2 * depth]);
            subject.relative(found, exact, ALLOWED)
        }
    }])
}

/// Between the waves of a tube.
fn let_go(context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    let time = 1e-4;
    let [left, right] = [PRESSED, WATER.density].map(|density| Moving {
        density,
        velocity: 0.0,
    });
    let middle = WATER.between(left, right);
    let settings = [
        "domain.sides.x_min=wall".into(),
        format!("end_time={time:?}"),
        format!(
            "initial.riemann={{ position = 0.5, left = {{ density = {PRESSED:?} }}, right = {{ density = {:?} }} }}",
            WATER.density
        ),
    ];
    let what = |quantity: &str| format!("water let go from a density of 1200 kg/m^3: {quantity}");
    let [density, velocity] = ["rise of the density between the waves", "its velocity"].map(what);
    let [density, velocity] = [&density, &velocity].map(|what| Subject::new(NAME, what, THEORY));
    let attempt = SCENE.attempt(&settings, context)?;
    let exact = middle.density - WATER.density;
    Ok(match attempt.outcome() {
        None => vec![
            density.unmeasured(exact),
            velocity.unmeasured(middle.velocity),
        ],
        Some(outcome) => {
            // From the end of the rarefaction to the shock.
            let tail = middle.velocity - WATER.sound_speed(middle.density);
            let front = middle.density * middle.velocity / (middle.density - right.density);
            let [from, to] = [tail, front].map(|speed| 0.5 + speed * time);
            let span = to - from;
            let found = means(&outcome.gas, [from + 0.2 * span, to - 0.2 * span]);
            vec![
                density.relative(found[0], exact, ALLOWED),
                velocity.relative(found[1], middle.velocity, ALLOWED),
            ]
        }
    })
}
