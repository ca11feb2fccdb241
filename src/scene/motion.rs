//! From a body's `motion` to what the solver moves it by.

use aero_geometry::Vector;
use nalgebra::Vector3;

use super::error::SceneError;
use super::file::MotionEntry;
use super::freedom::freedom;
use super::number::Finite;
use super::spin::{Rate, Spin, TableEntry};
use super::vector::{vector, vector_or_zero};
use aero_solver::problem::{Motion, Turning};

/// Motion of body `name`, which turns about its moment centre where the scene names no pivot.
pub(super) fn motion<const D: usize>(
    name: &str,
    entry: Option<&MotionEntry>,
    moment_centre: Vector<D>,
) -> Result<Motion<D>, SceneError> {
    let place = |key: &str| format!("body.{name}.motion.{key}");
    let spin = entry.and_then(|entry| entry.angular_velocity.as_ref());
    let free = entry.and_then(|entry| entry.free.as_ref());
    let (key, pivot) = match (free, entry.and_then(|entry| entry.pivot.as_ref())) {
        (Some(_), Some(_)) => {
            return Err(SceneError::value(
                place("pivot"),
                "is of a motion that is prescribed; a free body turns about `free.centre`",
            ));
        }
        (Some(free), None) => ("free.centre", free.centre.as_ref()),
        (None, pivot) => ("pivot", pivot),
    };
    if free.is_some() && !matches!(spin, None | Some(Spin::Steady(_))) {
        return Err(SceneError::value(
            place("angular_velocity"),
            "is prescribed over time, but the gas turns a free body; give the rate at time zero, or leave out `free`",
        ));
    }
    Ok(Motion {
        velocity: vector_or_zero(
            &place("velocity"),
            entry.and_then(|entry| entry.velocity.as_ref()),
        )?,
        acceleration: vector_or_zero(
            &place("acceleration"),
            entry.and_then(|entry| entry.acceleration.as_ref()),
        )?,
        turning: match spin {
            None => Turning::Steady(Vector3::zeros()),
            Some(spin) => turning::<D>(&place("angular_velocity"), spin)?,
        },
        pivot: pivot.map_or(Ok(moment_centre), |point| vector(&place(key), point))?,
        free: free
            .map(|free| freedom::<D>(&place("free"), free))
            .transpose()?,
    })
}

fn turning<const D: usize>(place: &str, spin: &Spin) -> Result<Turning, SceneError> {
    match spin {
        Spin::Steady(rate) => Ok(Turning::Steady(rotation::<D>(place, rate)?)),
        Spin::Cosine(entry) => Ok(Turning::Cosine {
            amplitude: rotation::<D>(&format!("{place}.cosine.amplitude"), &entry.amplitude)?,
            period: entry.period.get(),
            phase: entry.phase.map_or(0.0, Finite::get).to_radians(),
        }),
        Spin::Table(entry) => table::<D>(&format!("{place}.table"), entry),
    }
}

/// A rotation vector of the scene's dimension.
pub(super) fn rotation<const D: usize>(
    place: &str,
    rate: &Rate,
) -> Result<Vector3<f64>, SceneError> {
    match (rate, D) {
        (Rate::Plane(rate), 2) => Ok(Vector3::new(0.0, 0.0, *rate)),
        (Rate::Vector(numbers), 3) => vector::<3>(place, numbers),
        _ => Err(SceneError::value(
            place,
            "is a number in 2D and a list of three numbers in 3D, in rad/s",
        )),
    }
}

fn table<const D: usize>(place: &str, entry: &TableEntry) -> Result<Turning, SceneError> {
    let numbers = |list: &[Finite]| list.iter().map(|number| number.get()).collect::<Vec<_>>();
    let (times, rates) = (numbers(&entry.times), numbers(&entry.rates));
    if times.is_empty() || times.len() != rates.len() {
        return Err(SceneError::value(
            place,
            format!(
                "has {} times and {} rates; give as many of both, one at least",
                times.len(),
                rates.len()
            ),
        ));
    }
    if let Some(k) = (1..times.len()).find(|&k| times[k] <= times[k - 1]) {
        return Err(SceneError::value(
            format!("{place}.times"),
            format!(
                "{} comes after {}; times must increase",
                times[k],
                times[k - 1]
            ),
        ));
    }
    let axis = match (&entry.axis, D) {
        (None, 2) => Vector3::z(),
        (Some(axis), 3) => {
            let place = format!("{place}.axis");
            vector::<3>(&place, axis)?
                .try_normalize(0.0)
                .ok_or_else(|| {
                    SceneError::value(place, "is zero; give what the body turns about")
                })?
        }
        _ => {
            return Err(SceneError::value(
                format!("{place}.axis"),
                "is left out in 2D, and a list of three numbers in 3D",
            ));
        }
    };
    Ok(Turning::Table { axis, times, rates })
}
