//! Air beyond the ideal gas: molecules that vibrate, come apart and lose electrons as it gets hot.
//!
//! All of it is said by the ratio `b = e rho / p` as a function of `ln rho` and `ln(p / rho)`, which a gas of constant specific heats has
//! at `1 / (gamma - 1)`. Where entropy is constant, `de = p / rho d ln rho`, so that `p / rho` grows as `rho^g` with
//! `g = (1 - db/d ln rho) / (b + db/d ln(p / rho))`, and `c^2 = (1 + g) p / rho`.

mod coefficients;
mod equilibrium;
mod mixture;
mod species;
mod spline;
mod table;
#[cfg(test)]
mod tests;
mod thermally_perfect;
mod waves;

use std::fmt;

/// Air that is not a gas of constant specific heats.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Air {
    /// Molecules vibrate, and stay what they are.
    ThermallyPerfect,
    /// Chemical equilibrium at each moment.
    Equilibrium,
}

/// A ratio of what the gas has to `p / rho`, and what it changes by with relative changes of the density and of `p / rho`.
#[derive(Clone, Copy, Debug)]
struct Ratio {
    value: f64,
    by_density: f64,
    by_heat: f64,
}

impl Ratio {
    /// How fast energy grows with `p / rho` at constant density.
    fn capacity(&self) -> f64 {
        self.value + self.by_heat
    }

    /// `d ln(p / rho) / d ln rho` at constant entropy.
    fn growth(&self) -> f64 {
        (1.0 - self.by_density) / self.capacity()
    }
}

/// Steps of Newton's method.
const STEPS: usize = 100;

/// Enough digits.
const EXACT: f64 = 1e-13;

impl fmt::Display for Air {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(match self {
            Self::ThermallyPerfect => "thermally perfect air",
            Self::Equilibrium => "air in chemical equilibrium",
        })
    }
}

impl Air {
    /// Temperatures, K, that it is meant for.
    pub const fn range(self) -> [f64; 2] {
        match self {
            Self::ThermallyPerfect => thermally_perfect::RANGE,
            Self::Equilibrium => species::RANGE,
        }
    }

    /// Densities, kg/m^3, that it is meant for.
    pub const fn densities(self) -> [f64; 2] {
        match self {
            Self::ThermallyPerfect => [0.0, f64::INFINITY],
            Self::Equilibrium => table::DENSITIES,
        }
    }

    /// Specific gas constant of the air when it is cold, J/(kg K).
    pub fn gas_constant(self) -> f64 {
        mixture::gas_constant()
    }

    /// `e rho / p` at a density and a `p / rho`.
    fn ratio(self, density: f64, heat: f64) -> Ratio {
        match self {
            Self::ThermallyPerfect => thermally_perfect::GAS.ratio(heat),
            Self::Equilibrium => table::TABLE.ratio(density, heat),
        }
    }

    /// Temperature over `p / rho`, and its relative changes.
    fn warmth(self, density: f64, heat: f64) -> Ratio {
        match self {
            Self::ThermallyPerfect => Ratio {
                value: 1.0 / thermally_perfect::GAS.constant,
                by_density: 0.0,
                by_heat: 0.0,
            },
            Self::Equilibrium => table::TABLE.temperature(density, heat),
        }
    }

    /// `p / rho` at a density and a specific internal energy. Of an energy that no gas has it is none either.
    pub fn pressure_over_density(self, density: f64, energy: f64) -> f64 {
        if !(energy > 0.0 && density > 0.0) {
            // Of the energy's sign, as an ideal gas: who asks looks at it.
            return 0.4 * energy;
        }
        match self {
            Self::ThermallyPerfect => thermally_perfect::GAS.heat(energy),
            Self::Equilibrium => table::TABLE.heat(density, energy),
        }
    }

    /// Pressure at a density and a specific internal energy.
    pub fn pressure(self, density: f64, energy: f64) -> f64 {
        density * self.pressure_over_density(density, energy)
    }

    /// Specific internal energy at a density and a pressure.
    pub fn energy(self, density: f64, pressure: f64) -> f64 {
        let heat = pressure / density;
        heat * self.ratio(density, heat).value
    }

    /// Square of the speed of sound.
    pub fn sound_square(self, density: f64, pressure: f64) -> f64 {
        let heat = pressure / density;
        heat * (1.0 + self.ratio(density, heat).growth())
    }

    /// Temperature at a density and a pressure, K.
    pub fn temperature(self, density: f64, pressure: f64) -> f64 {
        let heat = pressure / density;
        heat * self.warmth(density, heat).value
    }

    /// Specific entropy at a density and a pressure, J/(kg K), but for a constant.
    pub fn entropy(self, density: f64, pressure: f64) -> f64 {
        let heat = pressure / density;
        match self {
            Self::ThermallyPerfect => thermally_perfect::GAS.entropy(density, heat),
            Self::Equilibrium => table::TABLE.entropy(density, heat),
        }
    }

    /// Density at a pressure and a specific internal energy.
    pub fn density(self, pressure: f64, energy: f64) -> f64 {
        let wanted = energy.ln();
        // About as much as when it is warm.
        let heat = newton((energy / 3.0).ln(), |heat| {
            let ratio = self.ratio(pressure / heat.exp(), heat.exp());
            let off = heat + ratio.value.ln() - wanted;
            let slope = 1.0 + (ratio.by_heat - ratio.by_density) / ratio.value;
            [off, slope]
        });
        pressure / heat.exp()
    }

    /// Density at a pressure and a temperature, K.
    pub fn density_at(self, pressure: f64, temperature: f64) -> f64 {
        let wanted = temperature.ln();
        let heat = newton((temperature * self.gas_constant()).ln(), |heat| {
            let warmth = self.warmth(pressure / heat.exp(), heat.exp());
            let off = heat + warmth.value.ln() - wanted;
            [off, 1.0 + warmth.by_heat - warmth.by_density]
        });
        pressure / heat.exp()
    }

    /// Enthalpy per volume `rho e + p`, and what it changes by with changes of density and pressure, to first order.
    pub(crate) fn enthalpy_change(self, density: f64, pressure: f64, change: [f64; 2]) -> [f64; 2] {
        let heat = pressure / density;
        let ratio = self.ratio(density, heat);
        let by_density = heat * (ratio.by_density - ratio.by_heat);
        let by_pressure = 1.0 + ratio.capacity();
        let rise = by_density * change[0] + by_pressure * change[1];
        [pressure * (1.0 + ratio.value), rise]
    }

    /// `p / rho` at a pressure and a specific enthalpy.
    pub fn heat_of_enthalpy(self, pressure: f64, enthalpy: f64) -> f64 {
        let wanted = enthalpy.ln();
        // About as much as when it is warm.
        let heat = newton((enthalpy / 4.0).ln(), |heat| {
            let ratio = self.ratio(pressure / heat.exp(), heat.exp());
            let off = heat + (1.0 + ratio.value).ln() - wanted;
            let slope = 1.0 + (ratio.by_heat - ratio.by_density) / (1.0 + ratio.value);
            [off, slope]
        });
        heat.exp()
    }

    /// How much its enthalpy rises for each rise of its specific internal energy at constant pressure.
    pub fn enthalpy_by_energy(self, density: f64, energy: f64) -> f64 {
        let ratio = self.ratio(density, self.pressure_over_density(density, energy));
        1.0 + 1.0 / (ratio.capacity() - ratio.by_density)
    }

    /// Specific internal energy at a density and a temperature, K.
    #[cfg(test)]
    pub(crate) fn energy_at(self, density: f64, temperature: f64) -> f64 {
        let wanted = temperature.ln();
        let heat = newton((temperature * self.gas_constant()).ln(), |heat| {
            let warmth = self.warmth(density, heat.exp());
            [heat + warmth.value.ln() - wanted, 1.0 + warmth.by_heat]
        });
        self.energy(density, density * heat.exp())
    }

    /// Heat capacity at constant volume, J/(kg K).
    pub fn heat_capacity_at_volume(self, density: f64, energy: f64) -> f64 {
        let heat = self.pressure_over_density(density, energy);
        let warmth = self.warmth(density, heat);
        self.ratio(density, heat).capacity() / (warmth.value * (1.0 + warmth.by_heat))
    }

    /// Heat capacity at constant pressure, J/(kg K): that at constant volume, times the square of the speed of sound over that of waves at
    /// constant temperature.
    #[cfg(test)]
    pub(crate) fn heat_capacity(self, density: f64, energy: f64) -> f64 {
        let heat = self.pressure_over_density(density, energy);
        let warmth = self.warmth(density, heat);
        let held = 1.0 - warmth.by_density / (1.0 + warmth.by_heat);
        let sound = 1.0 + self.ratio(density, heat).growth();
        self.heat_capacity_at_volume(density, energy) * sound / held
    }

    /// Change of the pressure with those of density and internal energy per volume.
    pub fn pressure_change(self, density: f64, pressure: f64, change: [f64; 2]) -> f64 {
        let heat = pressure / density;
        let ratio = self.ratio(density, heat);
        (change[1] - heat * (ratio.by_density - ratio.by_heat) * change[0]) / ratio.capacity()
    }
}

/// A logarithm, near this one, of which `[off, slope]` says how far it is off, by Newton's method.
fn newton(mut log: f64, off: impl Fn(f64) -> [f64; 2]) -> f64 {
    for _ in 0..STEPS {
        let [off, slope] = off(log);
        let step = (off / slope).clamp(-0.5, 0.5);
        log -= step;
        if step.abs() < EXACT {
            break;
        }
    }
    log
}
