//! What heat flows down in a viscous gas: its measure of heat.
//!
//! Heat flows as `mu / Pr` times the gradient of the enthalpy, see [`Transport::at`]. Of an ideal gas the measure is `p / rho`, its temperature
//! times the gas constant, and conductivities are `mu gamma / ((gamma - 1) Pr)`; of hot air it is the enthalpy itself.

use super::super::state::Primitive;
use crate::gas::{Air, Gas, IdealGas, Transport};

/// No air has a larger ratio of its specific heats than cold air.
const LARGEST_RATIO: f64 = 1.402;

/// Viscosity and heat conduction of a gas.
#[derive(Clone, Copy, Debug)]
pub struct Viscous {
    transport: Transport,
    gas: Warm,
}

/// A gas that conducts heat.
#[derive(Clone, Copy, Debug)]
enum Warm {
    Ideal { gamma: f64, constant: f64 },
    Air(Air),
}

impl Viscous {
    /// Those of `gas`; none of one without, and of a liquid.
    pub fn of(gas: &Gas) -> Option<Self> {
        let warm = match *gas {
            Gas::Ideal(IdealGas {
                gamma, constant, ..
            }) => Warm::Ideal { gamma, constant },
            Gas::Air { air, .. } => Warm::Air(air),
            Gas::Liquid(_) => return None,
        };
        gas.transport().map(|&transport| Self {
            transport,
            gas: warm,
        })
    }

    /// Measure of heat in a state.
    #[inline]
    pub fn measure<const D: usize>(&self, state: &Primitive<D>) -> f64 {
        match self.gas {
            Warm::Ideal { .. } => state.heat(),
            Warm::Air(air) => air.energy(state.density, state.pressure) + state.heat(),
        }
    }

    /// That at a temperature and a pressure.
    #[inline]
    pub fn measure_at(&self, temperature: f64, pressure: f64) -> f64 {
        match self.gas {
            Warm::Ideal { constant, .. } => temperature * constant,
            Warm::Air(air) => {
                let density = air.density_at(pressure, temperature);
                air.energy(density, pressure) + pressure / density
            }
        }
    }

    /// How much more it is where the state has changed by `rise`, to first order.
    #[inline]
    pub fn warming<const D: usize>(&self, state: &Primitive<D>, rise: &Primitive<D>) -> f64 {
        match self.gas {
            Warm::Ideal { .. } => state.warming(rise),
            Warm::Air(air) => {
                let change = [rise.density, rise.pressure];
                let [whole, more] = air.enthalpy_change(state.density, state.pressure, change);
                (more - whole / state.density * rise.density) / state.density
            }
        }
    }

    /// How much more enthalpy there is per volume where the state has changed by `rise`, to first order.
    #[inline]
    pub fn enthalpy_change<const D: usize>(
        &self,
        state: &Primitive<D>,
        rise: &Primitive<D>,
    ) -> f64 {
        match self.gas {
            Warm::Ideal { gamma, .. } => gamma / (gamma - 1.0) * rise.pressure,
            Warm::Air(air) => {
                let change = [rise.density, rise.pressure];
                air.enthalpy_change(state.density, state.pressure, change)[1]
            }
        }
    }

    /// Temperature of gas of this measure at a pressure.
    #[inline]
    pub fn temperature(&self, measure: f64, pressure: f64) -> f64 {
        match self.gas {
            Warm::Ideal { constant, .. } => measure / constant,
            Warm::Air(air) => {
                let density = pressure / air.heat_of_enthalpy(pressure, measure);
                air.temperature(density, pressure)
            }
        }
    }

    /// Dynamic viscosity in a state.
    #[inline]
    pub fn viscosity<const D: usize>(&self, state: &Primitive<D>) -> f64 {
        let temperature = match self.gas {
            Warm::Ideal { constant, .. } => state.heat() / constant,
            Warm::Air(air) => air.temperature(state.density, state.pressure),
        };
        self.transport.viscosity.at(temperature)
    }

    /// Dynamic viscosity at this measure of heat and a pressure.
    #[inline]
    pub fn viscosity_at(&self, measure: f64, pressure: f64) -> f64 {
        let temperature = self.temperature(measure, pressure);
        self.transport.viscosity.at(temperature)
    }

    /// Heat conducted per gradient of the measure, of gas with this viscosity.
    #[inline]
    pub fn conductivity(&self, viscosity: f64) -> f64 {
        match self.gas {
            Warm::Ideal { gamma, .. } => {
                viscosity * gamma / ((gamma - 1.0) * self.transport.prandtl)
            }
            Warm::Air(_) => viscosity / self.transport.prandtl,
        }
    }

    /// The faster of what spreads momentum and heat, m^2/s.
    #[inline]
    pub fn diffusivity(&self, viscosity: f64, density: f64) -> f64 {
        /// Gas that is drawn out along a line resists as this much of its viscosity.
        const DRAWN: f64 = 4.0 / 3.0;
        let ratio = match self.gas {
            Warm::Ideal { gamma, .. } => gamma,
            Warm::Air(_) => LARGEST_RATIO,
        };
        viscosity / density * DRAWN.max(ratio / self.transport.prandtl)
    }

    /// What the measure of gas rises by that comes to rest beside a wall with this square of its speed, where no heat goes through the wall:
    /// the enthalpy and `Pr u^2 / 2` are then together the same across the layer.
    #[inline]
    pub fn recovered(&self, square: f64) -> f64 {
        let half = 0.5 * self.transport.prandtl;
        match self.gas {
            Warm::Ideal { gamma, .. } => half * (gamma - 1.0) / gamma * square,
            Warm::Air(_) => half * square,
        }
    }

    /// What two cells with these viscosities add to the wave speeds of the first one, of this density, over a face of this size and so far
    /// apart: twice the diffusivity over the distance, times the area.
    #[inline]
    pub fn reach(&self, viscosities: [f64; 2], density: f64, size: f64, apart: f64) -> f64 {
        let mean = 0.5 * (viscosities[0] + viscosities[1]);
        2.0 * self.diffusivity(mean, density) * size / apart
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::super::super::equation_of_state::EquationOfState;
    use super::*;
    use crate::gas::Viscosity;

    const TRANSPORT: Transport = Transport {
        viscosity: Viscosity::AIR,
        prandtl: 0.71,
    };

    /// Cold air by its three laws, and hot air by two.
    fn gases() -> [(Viscous, f64); 5] {
        let ideal = Gas::Ideal(IdealGas {
            gamma: 1.4,
            constant: 287.06,
            transport: Some(TRANSPORT),
        });
        let hot = |air| Gas::Air {
            air,
            transport: Some(TRANSPORT),
        };
        let [whole, reacting] = [Air::ThermallyPerfect, Air::Equilibrium].map(hot);
        [
            (ideal, 300.0),
            (whole, 300.0),
            (reacting, 300.0),
            (whole, 2500.0),
            (reacting, 4500.0),
        ]
        .map(|(gas, temperature)| (Viscous::of(&gas).unwrap(), temperature))
    }

    /// Gas of this temperature at 1000 Pa.
    fn state(viscous: &Viscous, temperature: f64) -> Primitive<1> {
        let pressure = 1000.0;
        let heat = match viscous.gas {
            Warm::Ideal { constant, .. } => constant * temperature,
            Warm::Air(air) => pressure / air.density_at(pressure, temperature),
        };
        Primitive {
            density: pressure / heat,
            velocity: [0.0],
            pressure,
        }
    }

    #[test]
    fn temperatures_come_back_from_the_measure_of_heat() {
        for (viscous, temperature) in gases() {
            let state = state(&viscous, temperature);
            let heat = viscous.measure(&state);
            let at = viscous.measure_at(temperature, state.pressure);
            assert_relative_eq!(heat, at, max_relative = 1e-10);
            if let Warm::Air(air) = viscous.gas {
                let at = EquationOfState::heat_at(&air, temperature, state.pressure);
                assert_relative_eq!(at, state.heat(), max_relative = 1e-10);
            }
            let back = viscous.temperature(heat, state.pressure);
            assert_relative_eq!(back, temperature, max_relative = 1e-8);
            let viscosity = Viscosity::AIR.at(temperature);
            assert_relative_eq!(viscous.viscosity(&state), viscosity, max_relative = 1e-8);
            let at = viscous.viscosity_at(heat, state.pressure);
            assert_relative_eq!(at, viscosity, max_relative = 1e-8);
        }
    }

    /// By differences, whatever changes.
    #[test]
    fn the_measure_and_the_enthalpy_change_as_told() {
        for (viscous, temperature) in gases() {
            let state = state(&viscous, temperature);
            for [by_density, by_pressure] in [[1.0, 0.0], [0.0, 1.0], [-0.5, 1.0]] {
                let rise = Primitive {
                    density: by_density * state.density,
                    velocity: [0.0],
                    pressure: by_pressure * state.pressure,
                };
                let step = 1e-5;
                let at = |part: f64| state.plus(part, &rise);
                let slope =
                    (viscous.measure(&at(step)) - viscous.measure(&at(-step))) / (2.0 * step);
                let told = viscous.warming(&state, &rise);
                let size = viscous.measure(&state);
                assert!((told - slope).abs() < 1e-5 * size, "{told} {slope}");
                // Measures in enthalpies.
                let unit = viscous.conductivity(TRANSPORT.prandtl);
                let enthalpy = |part: f64| unit * viscous.measure(&at(part)) * at(part).density;
                let slope = (enthalpy(step) - enthalpy(-step)) / (2.0 * step);
                let told = viscous.enthalpy_change(&state, &rise);
                assert!((told - slope).abs() < 1e-5 * unit * size * state.density);
            }
        }
    }

    /// Cold, all three conduct and recover alike; hot, what air takes up flows with its heat.
    #[test]
    fn cold_air_conducts_as_an_ideal_gas_and_hot_air_by_its_heat_capacity() {
        for (viscous, temperature) in gases() {
            let [low, high] = [0.999, 1.001].map(|part| state(&viscous, part * temperature));
            let rise = (viscous.measure(&high) - viscous.measure(&low)) / (0.002 * temperature);
            let flux = viscous.conductivity(1.0) * rise;
            let capacity = match viscous.gas {
                Warm::Ideal { .. } => 3.5 * 287.06,
                Warm::Air(air) => {
                    air.heat_capacity(low.density, air.energy(low.density, low.pressure))
                }
            };
            // Splines between the entries of a table have slopes of fewer digits.
            assert_relative_eq!(flux * TRANSPORT.prandtl, capacity, max_relative = 0.02);
            // `T + Pr u^2 / (2 c_p)`, of a little of it.
            let speed = 1.0;
            let warmed = viscous.measure(&low) + viscous.recovered(speed);
            let warmer = viscous.temperature(warmed, low.pressure)
                - viscous.temperature(viscous.measure(&low), low.pressure);
            let expected = 0.5 * TRANSPORT.prandtl / capacity;
            assert_relative_eq!(warmer, expected, max_relative = 0.02);
            assert!(viscous.diffusivity(1.0, 1.0) >= 1.4 / TRANSPORT.prandtl - 1e-12);
        }
    }
}
