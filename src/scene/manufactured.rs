//! Manufactured solutions: a state of the gas as formulas of position and time, and what the equations lack to have it for their
//! solution [Roache 2002, J. Fluids Eng. 124, 4-10, DOI 10.1115/1.1436090; Negi & Ramachandran 2021, DOI 10.1063/5.0072383].

mod check;
mod rubbed;
mod terms;

use std::sync::Arc;

use aero_geometry::Vector;
use aero_solver::gas::IdealGas;
use aero_solver::problem::{Added, Field, Initial, Source, State};
use num_dual::DualSVec64;

use super::error::SceneError;
use super::file::ManufacturedEntry;
use super::formula::{Number, Place, TimedFormula};
pub use terms::{Rubbed, Share, Terms};

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
    gas: IdealGas,
}

/// A state in any kind of number.
struct Values<T, const D: usize> {
    density: T,
    pressure: T,
    velocity: [T; D],
}

impl<const D: usize> Manufactured<D> {
    /// The solution of `entry`, for this gas.
    ///
    /// # Errors
    /// Too few or too many velocities.
    pub(super) fn new(
        entry: &ManufacturedEntry,
        spacing: f64,
        gas: IdealGas,
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
            gas,
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
        let IdealGas { gamma, .. } = self.gas;
        let rubbed = self.rubbed(position, time);
        let variable = |value: f64, k: usize| DualSVec64::<VARIABLES>::from_re(value).derivative(k);
        let position = std::array::from_fn(|k| variable(at(position, k), k));
        let Values {
            density,
            pressure,
            velocity,
        } = self.values(position, variable(time, TIME));
        let energy = pressure / density / (gamma - 1.0);
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
            rubbed,
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

    fn description(&self) -> String {
        "sources keep the gas to a manufactured solution".into()
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
    use aero_solver::gas::{Gas, Transport, Viscosity};

    use super::*;

    fn solution(gas: IdealGas) -> Manufactured<2> {
        let entry: ManufacturedEntry = toml::from_str(
            r#"density = "1 + 0.3 * sin(x + 2 * y - t)"
               pressure = "exp(0.2 * x) * (1 + t * y)"
               velocity = ["x * y + t", "cos(x) - t^2 * y"]"#,
        )
        .unwrap();
        Manufactured::new(&entry, 0.1, gas).unwrap()
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
        let solution = solution(*Gas::ideal(1.4).ideal_gas().unwrap());
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

    /// `div tau`, and `div (tau u + k grad T)` less `u.div tau`, from stress and heat by differences.
    #[test]
    fn viscous_sources_are_the_divergence_of_stress_and_heat() {
        let law = Viscosity::Power {
            viscosity: 0.3,
            temperature: 1.0,
            exponent: 0.8,
        };
        let solution = solution(IdealGas {
            gamma: 1.4,
            constant: 1.0,
            transport: Some(Transport {
                viscosity: law,
                prandtl: 0.6,
            }),
        });
        let at = [0.4, -0.7, 0.3];
        let heat = |[x, y, t]: [f64; 3]| {
            let state = solution.state(&Vector::from([x, y]), t);
            state.pressure / state.density
        };
        let speed =
            |[x, y, t]: [f64; 3], k: usize| solution.state(&Vector::from([x, y]), t).velocity[k];
        // tau_xx, tau_xy, tau_yy and the heat along x and y.
        let parts = |at: [f64; 3]| -> [f64; 5] {
            let slope = |k: usize, axis: usize| difference(|at| speed(at, k), at, axis);
            let viscosity = law.at(heat(at));
            let third = 2.0 / 3.0 * (slope(0, 0) + slope(1, 1));
            let conductivity = viscosity * 1.4 / (0.4 * 0.6);
            [
                viscosity * (2.0 * slope(0, 0) - third),
                viscosity * (slope(0, 1) + slope(1, 0)),
                viscosity * (2.0 * slope(1, 1) - third),
                conductivity * difference(heat, at, 0),
                conductivity * difference(heat, at, 1),
            ]
        };
        let along = |part: usize, axis: usize| difference(|at| parts(at)[part], at, axis);
        let [xx, xy, yy, ..] = parts(at);
        let slope = |k: usize, axis: usize| difference(|at| speed(at, k), at, axis);
        let dissipated = xx * slope(0, 0) + xy * (slope(0, 1) + slope(1, 0)) + yy * slope(1, 1);
        let expected = [
            along(0, 0) + along(1, 1),
            along(1, 0) + along(2, 1),
            dissipated + along(3, 0) + along(4, 1),
        ];
        let (position, time) = (Vector::from([at[0], at[1]]), at[2]);
        let density = solution.state(&position, time).density;
        let rubbed = solution.terms(&position, time).rubbed;
        let force = (rubbed.strained + rubbed.dilated + rubbed.thickened) * density;
        let found = [
            force[0],
            force[1],
            (rubbed.dissipated + rubbed.conducted) * density,
        ];
        for k in 0..3 {
            assert!(
                (found[k] - expected[k]).abs() < 2e-4,
                "{found:?} {expected:?}"
            );
        }
        let inviscid = super::tests::solution(*Gas::ideal(1.4).ideal_gas().unwrap());
        assert_eq!(inviscid.terms(&position, time).rubbed, Rubbed::none());
    }
}
