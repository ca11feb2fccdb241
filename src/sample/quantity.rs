//! What can be shown of the gas at a place.

use super::gas::State;
use aero_solver::gas::{Gas, Gases};

/// What it is measured by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scale {
    /// The gas, or both.
    pub gases: Gases,
    /// Specific gas constant, where it is known.
    pub gas_constant: Option<f64>,
    /// Pressure and density of the free stream.
    pub stream: [f64; 2],
    /// Its dynamic pressure.
    pub dynamic_pressure: f64,
}

/// A number that the state of the gas gives.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// Mach number.
    Mach,
    /// Pressure.
    Pressure,
    /// Pressure over that of the free stream, in its dynamic pressures.
    PressureCoefficient,
    /// Density.
    Density,
    /// Temperature, in K.
    Temperature,
    /// Entropy over that of the free stream, in heat capacities at constant volume.
    Entropy,
    /// Speed.
    Speed,
    /// Size of the density's gradient, as schlieren show it.
    Schlieren,
}

impl Scale {
    /// The gas in a state: where there are two, what both of them make there.
    pub fn gas(&self, state: &State) -> Gas {
        self.gases.mixed(state.second)
    }

    /// Temperature, K, where the gas constant is known: of an ideal gas `p / (rho R)`.
    pub fn temperature(&self, state: &State) -> Option<f64> {
        self.gas_constant?;
        Some(finite(
            self.gas(state)
                .temperature_at(state.density, state.pressure),
        ))
    }

    /// Mach number.
    pub fn mach(&self, state: &State) -> f64 {
        let sound = self
            .gas(state)
            .sound_speed_at(state.density, state.pressure);
        finite(size(&state.velocity) / sound)
    }

    /// Entropy over that of the free stream, in heat capacities at constant volume: of an ideal gas `ln((p / p_inf) (rho_inf / rho)^gamma)`.
    pub fn entropy(&self, state: &State) -> f64 {
        let [pressure, density] = self.stream;
        let here = [state.density, state.pressure];
        finite(self.gas(state).entropy_rise(here, [density, pressure]))
    }

    /// The number that `quantity` is at a place; none of a temperature that is not known.
    pub fn value(&self, quantity: Quantity, state: &State) -> Option<f64> {
        Some(match quantity {
            Quantity::Mach => self.mach(state),
            Quantity::Pressure => state.pressure,
            Quantity::PressureCoefficient => {
                finite((state.pressure - self.stream[0]) / self.dynamic_pressure)
            }
            Quantity::Density => state.density,
            Quantity::Temperature => self.temperature(state)?,
            Quantity::Entropy => self.entropy(state),
            Quantity::Speed => size(&state.velocity),
            Quantity::Schlieren => size(&state.density_gradient),
        })
    }
}

fn size(vector: &[f64; 3]) -> f64 {
    vector.iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// `value`, zero where a vacuum leaves none.
fn finite(value: f64) -> f64 {
    if value.is_finite() { value } else { 0.0 }
}
