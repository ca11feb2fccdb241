//! The gas: its equation of state and its transport coefficients. Nothing else in the solver knows either.
//!
//! A state is a density `rho` and a specific internal energy `e`; pressure, temperature and speed of sound follow from both, those of a
//! liquid from the density alone.

mod air;
mod liquid;
mod pair;
mod transport;

pub use air::Air;
pub use liquid::Liquid;
pub use pair::Gases;
pub use transport::{Transport, TransportCoefficients, Viscosity};

/// A gas.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Gas {
    /// An ideal gas of constant specific heats.
    Ideal(IdealGas),
    /// Air as it gets hot.
    Air {
        /// What happens to it.
        air: Air,
        /// Viscosity and heat conduction; none makes the equations Euler's.
        transport: Option<Transport>,
    },
    /// A liquid, without heat.
    Liquid(Liquid),
}

/// `p = (gamma - 1) rho e = rho R T`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct IdealGas {
    /// Ratio of specific heats `gamma`, more than one.
    pub gamma: f64,
    /// Specific gas constant `R`, J / (kg K); at one, a temperature is a pressure over a density.
    pub constant: f64,
    /// Viscosity and heat conduction; none makes the equations Euler's.
    pub transport: Option<Transport>,
}

impl Gas {
    /// An ideal gas whose specific heats have the ratio `gamma`, with temperatures in units of energy per mass.
    pub const fn ideal(gamma: f64) -> Self {
        Self::Ideal(IdealGas::new(gamma))
    }

    /// The ideal gas that it is; none of another.
    pub const fn ideal_gas(&self) -> Option<&IdealGas> {
        match self {
            Self::Ideal(gas) => Some(gas),
            Self::Air { .. } | Self::Liquid(_) => None,
        }
    }

    /// The liquid that it is; none of another.
    pub const fn liquid(&self) -> Option<&Liquid> {
        match self {
            Self::Liquid(liquid) => Some(liquid),
            Self::Ideal(_) | Self::Air { .. } => None,
        }
    }

    /// Pressure at no density.
    pub fn least_pressure(&self) -> f64 {
        match self {
            Self::Ideal(_) | Self::Air { .. } => 0.0,
            Self::Liquid(liquid) => liquid.least_pressure(),
        }
    }

    /// Pressure `p(rho, e)`.
    #[inline(always)]
    pub fn pressure(&self, density: f64, energy: f64) -> f64 {
        match self {
            Self::Ideal(gas) => gas.heat() * density * energy,
            Self::Air { air, .. } => air.pressure(density, energy),
            Self::Liquid(liquid) => liquid.pressure(density),
        }
    }

    /// `p / rho` at `rho` and `e`: the heat of compression per rate of relative change of volume.
    #[inline(always)]
    pub fn pressure_over_density(&self, density: f64, energy: f64) -> f64 {
        match self {
            Self::Ideal(gas) => gas.heat() * energy,
            Self::Air { air, .. } => air.pressure_over_density(density, energy),
            Self::Liquid(liquid) => liquid.pressure(density) / density,
        }
    }

    /// Temperature `T(rho, e)`; a liquid has none, and is told zero.
    #[inline(always)]
    pub fn temperature(&self, density: f64, energy: f64) -> f64 {
        match self {
            Self::Ideal(gas) => self.pressure_over_density(density, energy) / gas.constant,
            Self::Air { air, .. } => air.temperature(density, air.pressure(density, energy)),
            Self::Liquid(_) => 0.0,
        }
    }

    /// Temperature at a density and a pressure.
    pub fn temperature_at(&self, density: f64, pressure: f64) -> f64 {
        match self {
            Self::Ideal(gas) => pressure / (density * gas.constant),
            Self::Air { air, .. } => air.temperature(density, pressure),
            Self::Liquid(_) => 0.0,
        }
    }

    /// Speed of sound `c(rho, e)`.
    #[inline(always)]
    pub fn sound_speed(&self, density: f64, energy: f64) -> f64 {
        match self {
            Self::Ideal(gas) => (gas.gamma * gas.heat() * energy).sqrt(),
            Self::Air { air, .. } => air
                .sound_square(density, air.pressure(density, energy))
                .sqrt(),
            Self::Liquid(liquid) => liquid.sound_speed(density),
        }
    }

    /// Speed of sound at a density and a pressure.
    #[inline(always)]
    pub fn sound_speed_at(&self, density: f64, pressure: f64) -> f64 {
        match self {
            Self::Ideal(gas) => (gas.gamma * pressure / density).sqrt(),
            Self::Air { air, .. } => air.sound_square(density, pressure).sqrt(),
            Self::Liquid(liquid) => liquid.sound_speed(density),
        }
    }

    /// Square of the speed of sound over that of [`Self::unit_sound`]: of an ideal gas, its energy.
    #[inline(always)]
    pub fn sound_measure(&self, density: f64, energy: f64) -> f64 {
        match self {
            Self::Ideal(_) => energy,
            Self::Air { air, .. } => air.sound_square(density, air.pressure(density, energy)),
            Self::Liquid(liquid) => liquid.relative_sound_square(density),
        }
    }

    /// Speed of sound where [`Self::sound_measure`] is one.
    #[inline(always)]
    pub fn unit_sound(&self) -> f64 {
        match self {
            Self::Ideal(_) => self.sound_speed(1.0, 1.0),
            Self::Air { .. } => 1.0,
            Self::Liquid(liquid) => liquid.sound_speed,
        }
    }

    /// `rho c^2 / p` in a state: of an ideal gas, the ratio of its specific heats.
    pub fn ratio_at(&self, density: f64, pressure: f64) -> f64 {
        match self {
            Self::Ideal(gas) => gas.gamma,
            Self::Air { air, .. } => air.sound_square(density, pressure) * density / pressure,
            Self::Liquid(liquid) => liquid.sound_speed(density).powi(2) * density / pressure,
        }
    }

    /// Enthalpy `e + p / rho` at a density and a pressure.
    pub fn enthalpy(&self, density: f64, pressure: f64) -> f64 {
        match self {
            Self::Ideal(gas) => gas.gamma / gas.heat() * pressure / density,
            Self::Air { air, .. } => air.energy(density, pressure) + pressure / density,
            Self::Liquid(liquid) => liquid.energy(density) + pressure / density,
        }
    }

    /// Entropy at a density and a pressure over that at others, in heat capacities at constant volume there.
    pub fn entropy_rise(&self, [density, pressure]: [f64; 2], from: [f64; 2]) -> f64 {
        match self {
            Self::Ideal(gas) => (pressure / from[1]).ln() - gas.gamma * (density / from[0]).ln(),
            Self::Air { air, .. } => {
                let capacity = air.heat_capacity_at_volume(from[0], air.energy(from[0], from[1]));
                (air.entropy(density, pressure) - air.entropy(from[0], from[1])) / capacity
            }
            Self::Liquid(_) => 0.0,
        }
    }

    /// Specific internal energy at a density and a pressure.
    #[inline(always)]
    pub fn energy(&self, density: f64, pressure: f64) -> f64 {
        match self {
            Self::Ideal(gas) => pressure / (gas.heat() * density),
            Self::Air { air, .. } => air.energy(density, pressure),
            Self::Liquid(liquid) => liquid.energy(density),
        }
    }

    /// Density at a pressure and a specific internal energy.
    #[inline(always)]
    pub fn density(&self, pressure: f64, energy: f64) -> f64 {
        match self {
            Self::Ideal(gas) => pressure / (gas.heat() * energy),
            Self::Air { air, .. } => air.density(pressure, energy),
            Self::Liquid(liquid) => liquid.density(pressure),
        }
    }

    /// Specific internal energy at `pressure` of gas that had `energy` at the pressure `before`, at constant entropy.
    pub fn isentropic_energy(&self, energy: f64, before: f64, pressure: f64) -> f64 {
        match self {
            Self::Ideal(gas) => energy * (pressure / before).powf(gas.heat() / gas.gamma),
            Self::Air { air, .. } => {
                let density = air.density(before, energy);
                air.energy(air.isentropic_density(density, before, pressure), pressure)
            }
            Self::Liquid(liquid) => {
                let at = |pressure| liquid.energy(liquid.density(pressure));
                energy + at(pressure) - at(before)
            }
        }
    }

    /// Viscosity and heat conduction; none of a gas that has neither.
    #[inline(always)]
    pub const fn transport(&self) -> Option<&Transport> {
        match self {
            Self::Ideal(gas) => gas.transport.as_ref(),
            Self::Air { transport, .. } => transport.as_ref(),
            Self::Liquid(liquid) => liquid.transport.as_ref(),
        }
    }

    /// True of a gas with viscosity.
    #[inline(always)]
    pub const fn is_viscous(&self) -> bool {
        self.transport().is_some()
    }

    /// How much its enthalpy rises for each rise of its specific internal energy at constant pressure, in a state: of an ideal gas, the ratio of
    /// its specific heats; none of a liquid, which conducts no heat.
    pub fn enthalpy_by_energy(&self, density: f64, energy: f64) -> f64 {
        match self {
            Self::Ideal(gas) => gas.gamma,
            Self::Air { air, .. } => air.enthalpy_by_energy(density, energy),
            Self::Liquid(_) => 0.0,
        }
    }

    /// Specific internal energy at a pressure and a temperature.
    pub fn energy_at(&self, pressure: f64, temperature: f64) -> f64 {
        match self {
            Self::Ideal(gas) => gas.constant / gas.heat() * temperature,
            Self::Air { air, .. } => air.energy(air.density_at(pressure, temperature), pressure),
            Self::Liquid(liquid) => liquid.energy(liquid.density(pressure)),
        }
    }

    /// Viscosity and conductivity at `rho` and `e`; none where the equations are Euler's.
    pub fn coefficients(&self, density: f64, energy: f64) -> TransportCoefficients {
        self.transport()
            .map_or_else(TransportCoefficients::default, |transport| {
                let by_energy = self.enthalpy_by_energy(density, energy);
                transport.at(self.temperature(density, energy), by_energy)
            })
    }
}

impl IdealGas {
    /// One without viscosity, with temperatures in units of energy per mass.
    pub const fn new(gamma: f64) -> Self {
        Self {
            gamma,
            constant: 1.0,
            transport: None,
        }
    }

    /// `gamma - 1`.
    #[inline(always)]
    pub(crate) const fn heat(self) -> f64 {
        self.gamma - 1.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Air at sea level of the U.S. Standard Atmosphere 1976.
    #[test]
    fn air_at_sea_level_has_its_temperature_and_speed_of_sound() {
        let air = Gas::Ideal(IdealGas {
            gamma: 1.4,
            constant: 287.053,
            transport: None,
        });
        let energy = air.energy(1.225, 101_325.0);
        assert!((air.temperature(1.225, energy) - 288.15).abs() < 0.01);
        assert!((air.sound_speed(1.225, energy) - 340.294).abs() < 0.01);
        assert!((air.sound_speed_at(1.225, 101_325.0) - 340.294).abs() < 0.01);
    }

    #[test]
    fn pressure_energy_and_density_undo_each_other() {
        let gas = Gas::ideal(5.0 / 3.0);
        let energy = gas.energy(0.7, 2.3);
        assert!((gas.pressure(0.7, energy) - 2.3).abs() < 1e-15);
        assert!((gas.density(2.3, energy) - 0.7).abs() < 1e-15);
        assert!((gas.pressure_over_density(0.7, energy) - 2.3 / 0.7).abs() < 1e-15);
    }

    /// Air at 300 K conducts 0.0262 W/(m K) [White 2006, Viscous Fluid Flow, table 1-3].
    #[test]
    fn the_conductivity_follows_from_the_prandtl_number() {
        let air = Gas::Ideal(IdealGas {
            gamma: 1.4,
            constant: 287.05,
            transport: Some(Transport {
                viscosity: Viscosity::AIR,
                prandtl: 0.71,
            }),
        });
        let energy = air.energy(1.2, 1.2 * 287.05 * 300.0);
        let found = air.coefficients(1.2, energy);
        assert!((found.viscosity - 1.846e-5).abs() < 1e-8, "{found:?}");
        let by_temperature = found.conductivity * 287.05 / 0.4;
        assert!((by_temperature - 0.0262).abs() < 2e-4, "{found:?}");
        assert!(!Gas::ideal(1.4).is_viscous());
        assert_eq!(
            Gas::ideal(1.4).coefficients(1.2, energy),
            TransportCoefficients::default()
        );
    }

    /// `de = p / rho^2 d rho` at constant entropy, by differences.
    #[test]
    fn gas_that_is_compressed_slowly_heats_by_the_work_of_its_pressure() {
        let gas = Gas::ideal(1.4);
        let (density, energy, step) = (1.3, 0.9, 1e-6);
        let state = |energy| gas.pressure(density + step, energy);
        let work = gas.pressure_over_density(density, energy) * step / density;
        let heated =
            gas.isentropic_energy(energy, gas.pressure(density, energy), state(energy + work));
        assert!((heated - energy - work).abs() < 1e-11);
    }
}
