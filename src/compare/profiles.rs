//! Flows along a line: their profiles beside the exact ones.

use aero_solver::frame::Frame;
use aero_validation::exact::State;
use aero_validation::pictures::curves::{Curves, Panel, Series};

/// The exact profiles that a flow is drawn beside.
pub struct Profiles<'a> {
    /// Title of the picture.
    pub title: String,
    /// The part of the line that is drawn.
    pub range: [f64; 2],
    /// Ratio of specific heats.
    pub gamma: f64,
    /// The exact state at a place.
    pub exact: &'a dyn Fn(f64) -> State,
}

impl Profiles<'_> {
    /// Density, pressure, velocity and internal energy of `gas` with the exact ones.
    pub fn of(&self, gas: &Frame) -> Curves {
        let x: Vec<f64> = gas.position.iter().map(|p| p[0]).collect();
        let velocity: Vec<f64> = gas.velocity.iter().map(|u| u[0]).collect();
        let panel = |label: &str, values: &[f64], pick: &dyn Fn(&State) -> f64| {
            let series = vec![
                Series::particles("particles", &x, values),
                Series::exact(self.range, 1000, |x| pick(&(self.exact)(x))),
            ];
            Panel::new("x", label, series)
        };
        Curves {
            title: self.title.clone(),
            panels: vec![
                panel("density", &gas.density, &|state| state.density),
                panel("pressure", &gas.pressure, &|state| state.pressure),
                panel("velocity", &velocity, &|state| state.velocity),
                panel("internal energy", &gas.energy, &|state| {
                    state.energy(self.gamma)
                }),
            ],
            columns: 2,
        }
    }
}

/// Middle value, the upper one of two; NaN where there is none.
pub fn median(values: impl IntoIterator<Item = f64>) -> f64 {
    let mut values: Vec<f64> = values.into_iter().collect();
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
}
