//! Manufactured solutions: a state of the gas as formulas of position and time, and what the equations lack to have it for their
//! solution [Roache 2002, J. Fluids Eng. 124, 4-10, DOI 10.1115/1.1436090; Negi & Ramachandran 2021, DOI 10.1063/5.0072383].

mod check;
mod terms;

use std::sync::Arc;

use aero_geometry::Vector;
use aero_solver::problem::{Added, Field, Initial, Source, State};
use num_dual::DualSVec64;

use super::error::SceneError;
use super::file::ManufacturedEntry;
use super::formula::{Number, Place, TimedFormula};
pub use terms::{Share, Terms};

pub(super) use check::check;

/// Variables that a solution is differentiated by: three coordinates and the time.
const VARIABLES: usize = 4;

/// The time among them.
const TIME: usize = 3;

/// A solution of the equations of an ideal gas with sources.
#[derive(Clone, Debug)]
pub struct Manufactured<const D: usize> {
    density: TimedFormula,
    pressure: TimedFormula,
    velocity: [TimedFormula; D],
    spacing: f64,
    gamma: f64,
}

/// A state in any kind of number.
struct Values<T, const D: usize> {
    density: T,
    pressure: T,
    velocity: [T; D],
}

impl<const D: usize> Manufactured<D> {
    /// The solution of `entry`, for gas of this ratio of specific heats.
    ///
    /// # Errors
    /// Too few or too many velocities.
    pub(super) fn new(
        entry: &ManufacturedEntry,
        spacing: f64,
        gamma: f64,
    ) -> Result<Self, SceneError> {
        let velocity = entry.velocity.clone().try_into();
        let velocity = velocity.map_err(|given: Vec<TimedFormula>| {
            SceneError::value(
                "manufactured.velocity",
                format!(
                    "holds {} formulas, but the scene has dimension {D}; give {D}",
                    given.len()
                ),
            )
        })?;
        Ok(Self {
            density: entry.density.clone(),
            pressure: entry.pressure.clone(),
            velocity,
            spacing,
            gamma,
        })
    }

    /// The state there and then.
    pub fn state(&self, position: &Vector<D>, time: f64) -> State<D> {
        let values = self.values(std::array::from_fn(|k| at(position, k)), time);
        State {
            density: values.density,
            velocity: values.velocity.into(),
            pressure: values.pressure,
        }
    }

    /// What each term of the equations comes to there and then.
    pub fn terms(&self, position: &Vector<D>, time: f64) -> Terms<D> {
        let variable = |value: f64, k: usize| DualSVec64::<VARIABLES>::from_re(value).derivative(k);
        let position = std::array::from_fn(|k| variable(at(position, k), k));
        let Values {
            density,
            pressure,
            velocity,
        } = self.values(position, variable(time, TIME));
        let energy = pressure / density / (self.gamma - 1.0);
        let u = velocity.map(|u| u.re);
        let divergence: f64 = (0..D).map(|k| slope(&velocity[k], k)).sum();
        let along = |value: &DualSVec64<VARIABLES>| (0..D).map(|k| u[k] * slope(value, k)).sum();
        let sizes = (0..D).map(|k| (density.re * slope(&velocity[k], k)).abs());
        Terms {
            density: Share {
                unsteady: slope(&density, TIME),
                carried: along(&density),
                pressed: density.re * divergence,
            },
            dilation: sizes.sum(),
            velocity: Share {
                unsteady: Vector::from_fn(|k, _| slope(&velocity[k], TIME)),
                carried: Vector::from_fn(|k, _| along(&velocity[k])),
                pressed: Vector::from_fn(|k, _| slope(&pressure, k) / density.re),
            },
            energy: Share {
                unsteady: slope(&energy, TIME),
                carried: along(&energy),
                pressed: pressure.re * divergence / density.re,
            },
        }
    }

    /// The state at the start.
    pub(super) fn initial(&self) -> Initial<D> {
        let solution = self.clone();
        Initial::Field(Field(Arc::new(move |position| {
            solution.state(position, 0.0)
        })))
    }

    fn values<T: Number>(&self, position: [T; 3], time: T) -> Values<T, D> {
        let place = Place {
            position,
            time,
            spacing: self.spacing,
        };
        Values {
            density: self.density.at(&place),
            pressure: self.pressure.at(&place),
            velocity: std::array::from_fn(|k| self.velocity[k].at(&place)),
        }
    }
}

impl<const D: usize> Source<D> for Manufactured<D> {
    fn at(&self, position: &Vector<D>, time: f64) -> Added<D> {
        self.terms(position, time).added()
    }
}

/// Coordinate `k`, zero where there is none.
fn at<const D: usize>(position: &Vector<D>, k: usize) -> f64 {
    position.get(k).copied().unwrap_or(0.0)
}

/// Derivative by variable `k`; numbers that depend on nothing carry none.
fn slope(value: &DualSVec64<VARIABLES>, k: usize) -> f64 {
    value.eps.0.map_or(0.0, |slopes| slopes[k])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn solution() -> Manufactured<2> {
        let entry: ManufacturedEntry = toml::from_str(
            r#"density = "1 + 0.3 * sin(x + 2 * y - t)"
               pressure = "exp(0.2 * x) * (1 + t * y)"
               velocity = ["x * y + t", "cos(x) - t^2 * y"]"#,
        )
        .unwrap();
        Manufactured::new(&entry, 0.1, 1.4).unwrap()
    }

    /// Central difference of `value` along variable `k` of x, y, t.
    fn difference(value: impl Fn([f64; 3]) -> f64, at: [f64; 3], k: usize) -> f64 {
        const STEP: f64 = 1e-5;
        let moved = |by: f64| {
            let mut at = at;
            at[k] += by;
            value(at)
        };
        (moved(STEP) - moved(-STEP)) / (2.0 * STEP)
    }

    /// In conserved variables, from fluxes: what is checked is also that both forms of the equations agree.
    #[test]
    fn sources_are_what_the_conserved_equations_lack() {
        let solution = solution();
        let at = [0.4, -0.7, 0.3];
        let place = |[x, y, t]: [f64; 3]| (Vector::from([x, y]), t);
        // Mass, momentum and energy per volume, and their fluxes along x and y.
        let parts = |at: [f64; 3], axis: Option<usize>| -> [f64; 4] {
            let (position, time) = place(at);
            let State {
                density,
                velocity: u,
                pressure,
            } = solution.state(&position, time);
            let energy = pressure / 0.4 + 0.5 * density * u.norm_squared();
            let held = [density, density * u[0], density * u[1], energy];
            let Some(axis) = axis else { return held };
            let mut flux = held.map(|held| held * u[axis]);
            flux[1 + axis] += pressure;
            flux[3] += pressure * u[axis];
            flux
        };
        let lacks: [f64; 4] = std::array::from_fn(|k| {
            difference(|at| parts(at, None)[k], at, 2)
                + difference(|at| parts(at, Some(0))[k], at, 0)
                + difference(|at| parts(at, Some(1))[k], at, 1)
        });
        let (position, time) = place(at);
        let state = solution.state(&position, time);
        let added = solution.at(&position, time);
        let (rho, u, a) = (state.density, state.velocity, added.acceleration);
        let total = state.pressure / (0.4 * rho) + 0.5 * u.norm_squared();
        let expected = [
            added.density,
            rho * a[0] + u[0] * added.density,
            rho * a[1] + u[1] * added.density,
            rho * (added.heating + u.dot(&a)) + total * added.density,
        ];
        for k in 0..4 {
            assert!(
                (lacks[k] - expected[k]).abs() < 1e-8,
                "{lacks:?} {expected:?}"
            );
        }
    }
}
