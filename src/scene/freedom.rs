//! From a body's `motion.free` to what the gas moves it by.

use aero_solver::problem::Freedom;
use nalgebra::Matrix3;

use super::error::SceneError;
use super::file::{ConstraintWord, FreeEntry};
use super::number::Finite;
use super::spin::Inertia;

/// What the gas moves a body by; `place` is where the scene says so.
pub(super) fn freedom<const D: usize>(
    place: &str,
    entry: &FreeEntry,
) -> Result<Freedom, SceneError> {
    let words = entry.constraints.as_deref().unwrap_or_default();
    // Axes that the scene does not have are held.
    let (mut is_held, mut keeps_turn) = ([false, D < 2, D < 3], [D < 3, D < 3, D < 2]);
    for word in words {
        match word {
            ConstraintWord::X => is_held[0] = true,
            ConstraintWord::Y => is_held[1] = true,
            ConstraintWord::Z => is_held[2] = true,
            ConstraintWord::Turn => keeps_turn = [true; 3],
            ConstraintWord::TurnX => keeps_turn[0] = true,
            ConstraintWord::TurnY => keeps_turn[1] = true,
            ConstraintWord::TurnZ => keeps_turn[2] = true,
        }
    }
    if is_held == [true; 3] && keeps_turn == [true; 3] {
        return Err(SceneError::value(
            format!("{place}.constraints"),
            "hold the body altogether; take one away, or leave out `free`",
        ));
    }
    Ok(Freedom {
        mass: entry.mass.get(),
        inertia: inertia::<D>(place, entry.inertia.as_ref(), keeps_turn)?,
        is_held,
        keeps_turn,
    })
}

fn inertia<const D: usize>(
    place: &str,
    entry: Option<&Inertia>,
    keeps_turn: [bool; 3],
) -> Result<Matrix3<f64>, SceneError> {
    let fail = |message: &str| Err(SceneError::value(format!("{place}.inertia"), message));
    let numbers = |list: &[Finite]| list.iter().map(|number| number.get()).collect::<Vec<_>>();
    let matrix = match (entry, D) {
        (None, _) if keeps_turn == [true; 3] => Matrix3::identity(),
        (None, _) => {
            return fail(
                "is needed for a body that can turn; give its moments of inertia, or `constraints = [\"turn\"]`",
            );
        }
        (Some(Inertia::Plane(number)), 2) => Matrix3::identity() * *number,
        (Some(Inertia::List(list)), 3) => match numbers(list)[..] {
            [xx, yy, zz] => Matrix3::from_diagonal(&[xx, yy, zz].into()),
            [xx, yy, zz, xy, xz, yz] => Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz),
            _ => return fail("has to be a list of three or six numbers"),
        },
        _ => {
            return fail(
                "is a number in 2D and a list of three or six numbers in 3D, in kg m^2; in 1D nothing turns",
            );
        }
    };
    if matrix.cholesky().is_none() {
        return fail(
            "is no inertia: moments about all axes have to be above zero (its matrix is not positive definite)",
        );
    }
    Ok(matrix)
}
