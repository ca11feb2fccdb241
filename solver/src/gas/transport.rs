//! What makes momentum and heat flow through a gas: its viscosity, and the Prandtl number that its conductivity follows from.

/// Viscosity and heat conduction of a gas.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Transport {
    /// Dynamic viscosity.
    pub viscosity: Viscosity,
    /// Prandtl number `mu c_p / k`.
    pub prandtl: f64,
}

/// How the dynamic viscosity, Pa s, depends on the temperature, K.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Viscosity {
    /// It does not.
    Constant(f64),
    /// `mu = mu_0 (T / T_0)^n`.
    Power {
        /// `mu_0`, Pa s.
        viscosity: f64,
        /// `T_0`, K.
        temperature: f64,
        /// `n`.
        exponent: f64,
    },
    /// `mu = mu_0 (T / T_0)^(3/2) (T_0 + S) / (T + S)` [Sutherland 1893, Phil. Mag. 36, 507-531].
    Sutherland {
        /// `mu_0`, Pa s.
        viscosity: f64,
        /// `T_0`, K.
        temperature: f64,
        /// `S`, K.
        constant: f64,
    },
}

/// What makes momentum and heat flow through gas in a state.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct TransportCoefficients {
    /// Dynamic viscosity, Pa s.
    pub viscosity: f64,
    /// Heat that flows per gradient of the specific internal energy at constant pressure, kg / (m s): what flows per gradient of the temperature
    /// over the heat capacity at constant volume, where that energy is one of the temperature alone.
    pub conductivity: f64,
}

impl Viscosity {
    /// Sutherland's law for air [White 2006, Viscous Fluid Flow, table 1-2].
    pub const AIR: Self = Self::Sutherland {
        viscosity: 1.716e-5,
        temperature: 273.15,
        constant: 110.4,
    };

    /// Dynamic viscosity at a temperature.
    #[inline]
    pub fn at(&self, temperature: f64) -> f64 {
        match *self {
            Self::Constant(viscosity) => viscosity,
            Self::Power {
                viscosity,
                temperature: reference,
                exponent,
            } => viscosity * (temperature / reference).powf(exponent),
            Self::Sutherland {
                viscosity,
                temperature: reference,
                constant,
            } => {
                let ratio = temperature / reference;
                viscosity * ratio * ratio.sqrt() * (reference + constant) / (temperature + constant)
            }
        }
    }

    /// How fast it changes with the temperature, `d mu / d T`.
    pub fn slope(&self, temperature: f64) -> f64 {
        let viscosity = self.at(temperature);
        match *self {
            Self::Constant(_) => 0.0,
            Self::Power { exponent, .. } => viscosity * exponent / temperature,
            Self::Sutherland { constant, .. } => {
                viscosity * (1.5 / temperature - 1.0 / (temperature + constant))
            }
        }
    }

    /// True where it has to know the temperature.
    pub fn asks_for_temperature(&self) -> bool {
        !matches!(self, Self::Constant(_))
    }
}

impl Transport {
    /// Viscosity and conductivity at a temperature: heat flows as `mu / Pr` times the gradient of the enthalpy, which rises so much
    /// `by_energy` at constant pressure.
    ///
    /// That is `mu c_p / Pr` times the gradient of the temperature where nothing reacts; of air in equilibrium it has what species carry
    /// that spread as fast as heat does, whose Lewis number is one [Fay & Riddell 1958, J. Aeronaut. Sci. 25, 73-85].
    #[inline]
    pub fn at(&self, temperature: f64, by_energy: f64) -> TransportCoefficients {
        let viscosity = self.viscosity.at(temperature);
        TransportCoefficients {
            viscosity,
            conductivity: viscosity * by_energy / self.prandtl,
        }
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    /// Air at sea level and at 20 km of the U.S. Standard Atmosphere 1976 (table II), which takes other constants.
    #[test]
    fn air_is_as_viscous_as_the_standard_atmosphere_says() {
        assert_relative_eq!(Viscosity::AIR.at(288.15), 1.7894e-5, max_relative = 2e-3);
        assert_relative_eq!(Viscosity::AIR.at(216.65), 1.4216e-5, max_relative = 2e-3);
    }

    #[test]
    fn slopes_are_those_of_differences() {
        let power = Viscosity::Power {
            viscosity: 2.0,
            temperature: 100.0,
            exponent: 0.75,
        };
        for law in [Viscosity::AIR, power, Viscosity::Constant(3.0)] {
            let difference = (law.at(250.1) - law.at(249.9)) / 0.2;
            assert_relative_eq!(law.slope(250.0), difference, max_relative = 1e-6);
        }
    }

    #[test]
    fn a_power_of_the_temperature_is_one_of_ratios() {
        let law = Viscosity::Power {
            viscosity: 2.0,
            temperature: 100.0,
            exponent: 0.75,
        };
        assert_relative_eq!(law.at(1600.0), 16.0, max_relative = 1e-14);
    }
}
