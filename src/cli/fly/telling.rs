//! What is said of a flight while it goes on, and at its end.

use aero::fly::{Costs, Extent, Flight, Level, minutes};

/// Seconds from which a flight without a budget is told how to have one.
const LONG: f64 = 1800.0;

/// True of seconds that nobody waits for unasked.
pub(super) fn is_long(seconds: f64) -> bool {
    seconds > LONG
}

/// What came of a run.
pub(super) fn tell(level: &Level, seconds: f64) {
    say!(
        "spacing {:.3e}: cd {:.5}, cl {:.5}, cm {:.5}, {} points, {}, {}",
        level.spacing,
        level.coefficients.cd,
        level.coefficients.cl,
        level.coefficients.cm,
        level.points,
        minutes(seconds),
        if level.settled {
            "settled"
        } else {
            "NOT settled"
        }
    );
}

/// How long the rest of a fixed family will take, now that a run of it is known to have taken `seconds`.
pub(super) fn tell_rest(costs: Costs, seconds: f64, to_come: usize) {
    let rest: f64 = (1..=to_come as i32)
        .map(|n| seconds * costs.step().powi(n))
        .sum();
    if to_come > 0 && is_long(rest) {
        note!("the {to_come} finer ones will take about {}", minutes(rest));
    }
}

/// What of the flight as a whole is to be told.
pub fn warnings(flight: &Flight) -> Vec<String> {
    let mut warnings = Vec::new();
    if flight.attitude.is_guess {
        warnings.push(format!(
            "how the body lies was guessed: its nose points along {} of the file, up is {}; mend with --axis",
            flight.attitude.nose, flight.attitude.up
        ));
    }
    warnings.extend(half(flight));
    warnings.extend(flight.nearly.iter().map(|(axis, off)| {
        let halves = match axis {
            1 => "upper and lower half",
            _ => "left and right half",
        };
        format!(
            "{halves} of the body are mirror images but for {off:.2e} m: both are computed; if they were meant to be the same, mend the file, and \
             half the points will do"
        )
    }));
    if let Extent::Meridian(_) = flight.extent
        && flight.wishes.roll != 0.0
    {
        warnings.push("a roll makes no difference to a body of revolution along the stream".into());
    }
    warnings
}

/// That the body may be half of one.
pub fn half(flight: &Flight) -> Option<String> {
    flight.flat.map(|way| {
        format!(
            "the body is flat where it ends toward {way} of the file, as half of one is where it was cut; if it is, `--half {way}` joins the other half"
        )
    })
}
