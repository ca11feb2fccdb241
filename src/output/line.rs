//! `line-NAME-NNNNNN.csv`: the gas along a line.

use std::fmt::Write as _;
use std::io::Write as _;
use std::path::Path;

use super::atomic;
use super::error::OutputError;
use crate::sample::{Scale, State};

/// Names of the columns of a state, after whatever says where it is.
pub fn state_columns(scale: &Scale) -> Vec<&'static str> {
    let mut columns = vec![
        "density",
        "pressure",
        "velocity_x",
        "velocity_y",
        "velocity_z",
        "mach",
    ];
    columns.extend(scale.gas_constant.map(|_| "temperature"));
    columns
}

/// A state in those columns, each after a comma; empty ones where there is no gas.
pub fn state_row(scale: &Scale, state: Option<&State>) -> String {
    let Some(state) = state else {
        return ",".repeat(state_columns(scale).len());
    };
    let [u, v, w] = state.velocity;
    let mut row = String::new();
    let known = [state.density, state.pressure, u, v, w, scale.mach(state)];
    for value in known.into_iter().chain(scale.temperature(state)) {
        // Writing to a string cannot fail.
        let _ = write!(row, ",{value:?}");
    }
    row
}

/// Writes the gas at `places` of a line, whose first is where distances begin.
pub fn write_line(
    path: &Path,
    scale: &Scale,
    places: &[[f64; 3]],
    states: &[Option<State>],
) -> Result<(), OutputError> {
    let mut text = format!("distance,x,y,z,{}\n", state_columns(scale).join(","));
    let first = places.first().copied().unwrap_or_default();
    for (place, state) in places.iter().zip(states) {
        let away = (0..3).map(|k| (place[k] - first[k]).powi(2)).sum::<f64>();
        let [x, y, z] = place;
        let _ = writeln!(
            text,
            "{:?},{x:?},{y:?},{z:?}{}",
            away.sqrt(),
            state_row(scale, state.as_ref())
        );
    }
    atomic::write(path, |writer| writer.write_all(text.as_bytes()))
}
