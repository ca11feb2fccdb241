//! Runs of one solution at several spacings: errors and orders.

use std::sync::Arc;

use aero::case::{AnyCase, Case};
use aero::run::{Keep, Outcome, Stopwatch, run_in_memory};
use aero::scene::Scene;
use aero::scene::manufactured::Manufactured;
use aero_geometry::Vector;
use aero_solver::frame::Frame;
use aero_solver::problem::State;

use super::mistake::{Mistake, Mistaken};
use crate::context::{CompareError, Context};
use crate::scenes::Source;
use crate::variant::Scheme;

/// What errors are measured of.
pub const QUANTITIES: [&str; 3] = ["velocity", "density", "pressure"];

/// Errors of the same flow at several spacings, coarse to fine.
#[derive(Clone, Debug)]
pub struct Series {
    cells: Vec<u32>,
    /// Of velocity, density and pressure: root of the mean square, over that of the value itself.
    errors: Vec<[f64; 3]>,
    /// Why a run came to no end.
    pub stopped: Option<String>,
}

impl Series {
    /// Runs `scene` by `scheme` with so many `cells` to its box, with a `mistake` in its sources if there is one.
    ///
    /// # Errors
    /// A scene that is wrong.
    pub fn run(
        scene: Source,
        scheme: Scheme,
        settings: &[&str],
        cells: &[u32],
        mistake: Option<Mistake>,
        context: &Context<'_>,
    ) -> Result<Self, CompareError> {
        let mut series = Self {
            cells: cells.to_vec(),
            errors: Vec::new(),
            stopped: None,
        };
        for &count in cells {
            let mut all = vec![format!("spacing={}", 1.0 / f64::from(count))];
            all.extend(scheme.settings());
            all.extend(settings.iter().map(|&setting| setting.to_owned()));
            all.extend_from_slice(context.settings);
            let called = mistake.map_or(String::new(), |mistake| format!(" with {mistake}"));
            (context.announce)(&format!("{}{called}: {}", scene.name, all.join(" ")));
            let scene = scene.scene(&all)?;
            let errors = match scene.dimension() {
                1 => errors_of(&scene, mistake, |case| AnyCase::One(Box::new(case)))?,
                2 => errors_of(&scene, mistake, |case| AnyCase::Two(Box::new(case)))?,
                _ => errors_of(&scene, mistake, |case| AnyCase::Three(Box::new(case)))?,
            };
            match errors {
                Ok(errors) => series.errors.push(errors),
                Err(stopped) => {
                    series.stopped = Some(stopped);
                    break;
                }
            }
        }
        Ok(series)
    }

    /// Error of a quantity at the finest spacing.
    pub fn error(&self, quantity: usize) -> f64 {
        self.errors.last().map_or(f64::NAN, |last| last[quantity])
    }

    /// Order of a quantity between the two finest spacings.
    pub fn order(&self, quantity: usize) -> f64 {
        self.orders(quantity).last().copied().unwrap_or(f64::NAN)
    }

    /// Orders of a quantity between neighbouring spacings, from the coarsest pair to the finest.
    pub fn orders(&self, quantity: usize) -> Vec<f64> {
        let pairs = self.errors.windows(2).zip(self.cells.windows(2));
        let order = |(errors, cells): (&[[f64; 3]], &[u32])| {
            let finer = f64::from(cells[1]) / f64::from(cells[0]);
            (errors[0][quantity] / errors[1][quantity]).ln() / finer.ln()
        };
        pairs.map(order).collect()
    }
}

/// Errors at the end of the run of `scene`; why it came to no end is an error of its own.
fn errors_of<const D: usize>(
    scene: &Scene,
    mistake: Option<Mistake>,
    any: impl Fn(Case<D>) -> AnyCase,
) -> Result<Result<[f64; 3], String>, CompareError> {
    let mut case = scene.build::<D>()?;
    let Some(solution) = scene.solution::<D>()? else {
        return Ok(Err("the scene has no manufactured solution".into()));
    };
    if let Some(mistake) = mistake {
        let solution = solution.clone();
        case.problem.source = Some(Arc::new(Mistaken { solution, mistake }));
    }
    let outcome = run_in_memory(any(case), Keep::End, Stopwatch::start());
    Ok(match outcome {
        Ok(Outcome { gas, .. }) => Ok(errors(&solution, &gas)),
        Err(error) => Err(error.to_string()),
    })
}

fn errors<const D: usize>(solution: &Manufactured<D>, gas: &Frame) -> [f64; 3] {
    let (mut missed, mut all) = ([0.0; 3], [0.0; 3]);
    for i in 0..gas.position.len() {
        let position = Vector::from_fn(|k, _| gas.position[i][k]);
        let State {
            density,
            velocity,
            pressure,
        } = solution.state(&position, gas.time);
        let found = Vector::from_fn(|k, _| gas.velocity[i][k]);
        let square = |value: f64| value * value;
        missed[0] += (found - velocity).norm_squared();
        missed[1] += square(gas.density[i] - density);
        missed[2] += square(gas.pressure[i] - pressure);
        all[0] += velocity.norm_squared();
        all[1] += square(density);
        all[2] += square(pressure);
    }
    std::array::from_fn(|k| (missed[k] / all[k]).sqrt())
}
