//! Mistakes planted in every term of every equation, each of which must show.

use aero_validation::table::{Check, Subject};

use super::mistake::{Equation, Mistake, Term};
use super::series::Series;
use super::{NAME, PLANE, VISCOSITY};
use crate::context::{CompareError, Context, Level};
use crate::variant::Scheme;

/// A mistake is caught where the order of the error of what its equation is for falls below this.
const CAUGHT: f64 = 1.5;

/// The terms of viscosity and heat conduction.
const VISCOUS: [(Equation, Term); 5] = [
    (Equation::Velocity, Term::Rubbed),
    (Equation::Velocity, Term::Spread),
    (Equation::Velocity, Term::Thickened),
    (Equation::Energy, Term::Rubbed),
    (Equation::Energy, Term::Spread),
];

/// Every term of every equation with the wrong sign and with one per cent too much.
pub fn compare(scheme: Scheme, context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    let cells: &[u32] = match context.level {
        Level::Quick => &[16, 32],
        Level::Full => &[32, 64, 128],
    };
    let factors: &[f64] = match context.level {
        Level::Quick => &[-1.0],
        Level::Full => &[-1.0, 1.01],
    };
    let mut checks = Vec::new();
    for equation in [Equation::Density, Equation::Velocity, Equation::Energy] {
        if equation == Equation::Density && !scheme.is_of_points() {
            continue;
        }
        for term in [Term::Unsteady, Term::Carried, Term::Pressed] {
            for &factor in factors {
                let mistake = Mistake {
                    equation,
                    term,
                    factor,
                };
                checks.push(caught(mistake, scheme, &[], cells, context)?);
            }
        }
    }
    // Steps are as short as the square of the spacing.
    let cells: &[u32] = match (context.level, scheme.is_of_points()) {
        (Level::Quick, true) => &[8, 16],
        (Level::Quick, false) => &[12, 24],
        (Level::Full, _) => &[16, 32, 64],
    };
    for (equation, term) in VISCOUS {
        for &factor in factors {
            let mistake = Mistake {
                equation,
                term,
                factor,
            };
            checks.push(caught(mistake, scheme, &VISCOSITY, cells, context)?);
        }
    }
    Ok(checks)
}

/// The row of a mistake: the order of the last pair, with those before in its name.
fn caught(
    mistake: Mistake,
    scheme: Scheme,
    settings: &[&str],
    cells: &[u32],
    context: &Context<'_>,
) -> Result<Check, CompareError> {
    // The error of the energy is that of the pressure.
    let quantity = match mistake.equation {
        Equation::Velocity => 0,
        Equation::Density => 1,
        Equation::Energy => 2,
    };
    let series = Series::run(PLANE, scheme, settings, cells, Some(mistake), context)?;
    let orders = series.orders(quantity);
    let first = cells[1..]
        .iter()
        .zip(&orders)
        .find(|(_, order)| **order < CAUGHT);
    let seen = match (&series.stopped, first) {
        (Some(_), _) => "stops".to_owned(),
        (None, Some((cells, _))) => format!("seen from {cells} on"),
        (None, None) => "not seen".to_owned(),
    };
    let what = format!(
        "planted: {}, lattice, {mistake}, {seen}: order of the last pair",
        scheme.laws()
    );
    let subject = Subject::new(NAME, &what, "must not converge");
    Ok(match series.stopped {
        // A run that the mistake ends is one that is caught.
        Some(_) => subject.informs(0.0, CAUGHT),
        // One per cent is less than what some of the particles' terms are off by at these spacings.
        None if mistake.factor > 0.0 && !scheme.is_of_points() => {
            subject.informs(series.order(quantity), CAUGHT)
        }
        None => subject.at_most(series.order(quantity), CAUGHT),
    })
}
