//! From `[initial.field]` to a state of the gas as a function of position.

use std::sync::Arc;

use aero_geometry::Vector;

use super::error::SceneError;
use super::file::FieldEntry;
use super::formula::{Formula, Place};
use aero_solver::gas::{Gas, Liquid};
use aero_solver::problem::{Domain, Field, Initial, State};

/// The field of `entry`, with the free stream where it says nothing.
pub(super) fn initial<const D: usize>(
    entry: &FieldEntry,
    gas: &Gas,
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
    let state = match gas.liquid() {
        Some(liquid) => of_liquid(entry, *liquid, free_stream)?,
        None => of_gas(entry, free_stream),
    };
    let field = move |position: &Vector<D>| {
        let place = place(position, spacing);
        let [density, pressure] = state(&place);
        State {
            density,
            velocity: Vector::from_fn(|k, _| velocity[k].at(&place)),
            pressure,
        }
    };
    Ok(Initial::Field(Field(Arc::new(field))))
}

/// Density and pressure at a place.
type Pair = Box<dyn Fn(&Place) -> [f64; 2] + Send + Sync>;

/// Those of a gas, whose density and pressure both are given.
fn of_gas<const D: usize>(entry: &FieldEntry, free_stream: &State<D>) -> Pair {
    let density = entry.density.clone();
    let density = density.unwrap_or_else(|| free_stream.density.into());
    let pressure = entry.pressure.clone();
    let pressure = pressure.unwrap_or_else(|| free_stream.pressure.into());
    Box::new(move |place| [density.at(place), pressure.at(place)])
}

/// Those of a liquid, one of which follows from the other.
fn of_liquid<const D: usize>(
    entry: &FieldEntry,
    liquid: Liquid,
    free_stream: &State<D>,
) -> Result<Pair, SceneError> {
    match (entry.density.clone(), entry.pressure.clone()) {
        (Some(_), Some(_)) => Err(SceneError::value(
            "initial.field.pressure",
            "follows from the density, as gas.equation_of_state says; leave one of the two out",
        )),
        (None, Some(pressure)) => Ok(Box::new(move |place| {
            let pressure = pressure.at(place);
            [liquid.density(pressure), pressure]
        })),
        (density, None) => {
            let density = density.unwrap_or_else(|| free_stream.density.into());
            Ok(Box::new(move |place| {
                let density = density.at(place);
                [density, liquid.pressure(density)]
            }))
        }
    }
}

/// The state in the lowest corner, which stands for the undisturbed gas where no free stream is
/// given.
pub(super) fn reference<const D: usize>(
    entry: &FieldEntry,
    gas: &Gas,
    domain: &Domain<D>,
    spacing: f64,
) -> Result<State<D>, SceneError> {
    let corner = domain.bounds.min.add_scalar(0.5 * spacing);
    let place = place(&corner, spacing);
    let value = |formula: Option<&Formula>| formula.map(|formula| formula.at(&place));
    let least = gas.least_pressure();
    let mut density = value(entry.density.as_ref());
    let mut pressure = value(entry.pressure.as_ref());
    if let Some(liquid) = gas.liquid() {
        pressure = pressure.or_else(|| density.map(|density| liquid.pressure(density)));
        density = density.or_else(|| pressure.map(|pressure| liquid.density(pressure)));
    }
    let density = density.filter(|&density| density.is_finite() && density > 0.0);
    let pressure = pressure.filter(|&pressure| pressure.is_finite() && pressure > least);
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

/// Where formulas are evaluated.
pub(super) fn place<const D: usize>(position: &Vector<D>, spacing: f64) -> Place {
    Place {
        position: std::array::from_fn(|k| if k < D { position[k] } else { 0.0 }),
        time: 0.0,
        spacing,
    }
}
