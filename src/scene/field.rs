//! From `[initial.field]` to a state of the gas as a function of position.

use std::sync::Arc;

use aero_geometry::Vector;

use super::error::SceneError;
use super::file::FieldEntry;
use super::formula::{Formula, Place};
use aero_solver::problem::{Domain, Field, Initial, State};

/// The field of `entry`, with the free stream where it says nothing.
pub(super) fn initial<const D: usize>(
    entry: &FieldEntry,
    free_stream: &State<D>,
    spacing: f64,
) -> Result<Initial<D>, SceneError> {
    let velocity: Vec<Formula> = match &entry.velocity {
        None => free_stream.velocity.iter().map(|&u| u.into()).collect(),
        Some(formulas) if formulas.len() == D => formulas.clone(),
        Some(formulas) => {
            let given = formulas.len();
            return Err(SceneError::value(
                "initial.field.velocity",
                format!("holds {given} formulas, but the scene has dimension {D}; give {D}"),
            ));
        }
    };
    let density = entry.density.clone();
    let density = density.unwrap_or_else(|| free_stream.density.into());
    let pressure = entry.pressure.clone();
    let pressure = pressure.unwrap_or_else(|| free_stream.pressure.into());
    let field = move |position: &Vector<D>| {
        let place = place(position, spacing);
        State {
            density: density.at(&place),
            velocity: Vector::from_fn(|k, _| velocity[k].at(&place)),
            pressure: pressure.at(&place),
        }
    };
    Ok(Initial::Field(Field(Arc::new(field))))
}

/// The state in the lowest corner, which stands for the undisturbed gas where no free stream is
/// given.
pub(super) fn reference<const D: usize>(
    entry: &FieldEntry,
    domain: &Domain<D>,
    spacing: f64,
) -> Result<State<D>, SceneError> {
    let corner = domain.bounds.min.add_scalar(0.5 * spacing);
    let place = place(&corner, spacing);
    let value = |formula: Option<&Formula>| formula.map(|formula| formula.at(&place));
    let good = |value: &f64| value.is_finite() && *value > 0.0;
    let density = value(entry.density.as_ref()).filter(good);
    let pressure = value(entry.pressure.as_ref()).filter(good);
    let (Some(density), Some(pressure)) = (density, pressure) else {
        return Err(SceneError::value(
            "free_stream",
            "missing, and [initial.field] gives no density and pressure in the lowest corner of the domain to take in its place; add the section",
        ));
    };
    let velocity = entry.velocity.as_deref().unwrap_or(&[]);
    Ok(State {
        density,
        velocity: Vector::from_fn(|k, _| value(velocity.get(k)).unwrap_or(0.0)),
        pressure,
    })
}

fn place<const D: usize>(position: &Vector<D>, spacing: f64) -> Place {
    Place {
        position: std::array::from_fn(|k| if k < D { position[k] } else { 0.0 }),
        time: 0.0,
        spacing,
    }
}
