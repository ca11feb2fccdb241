//! Air whose molecules stay what they are, and vibrate as it gets hot: `p = rho R T` with heat capacities of the temperature alone.

use std::sync::LazyLock;

use super::Ratio;
use super::mixture::{self, FRACTIONS};
use super::species::{Molar, Species};

/// Temperatures, K, that it is meant for: molecules come apart above.
pub const RANGE: [f64; 2] = [200.0, 6000.0];

/// Steps of Newton's method for the temperature, which is all but straight in the energy.
const STEPS: usize = 30;

/// Enough digits of a temperature.
const EXACT: f64 = 1e-14;

/// What is known of it once and for all.
#[derive(Debug)]
pub struct ThermallyPerfect {
    /// Specific gas constant, J/(kg K).
    pub constant: f64,
    /// Where its heat capacities begin to depend on the temperature, and where they end to: `T`, `e / R` and `c_v / R` there.
    ends: [[f64; 3]; 2],
    /// What its energy is short of being counted from the gas at rest at no temperature, over `R`, in K.
    shift: f64,
}

/// The gas; made when it is first asked for.
pub static GAS: LazyLock<ThermallyPerfect> = LazyLock::new(ThermallyPerfect::new);

impl ThermallyPerfect {
    fn new() -> Self {
        let [cold, hot] = RANGE.map(|t| (t, mixed(t)));
        let energy = |(t, molar): (f64, Molar)| t * (molar.enthalpy - 1.0);
        // Below the range `e = c_v T`.
        let shift = cold.0 * (cold.1.capacity - 1.0) - energy(cold);
        let end = |at: (f64, Molar)| [at.0, energy(at) + shift, at.1.capacity - 1.0];
        Self {
            constant: mixture::gas_constant(),
            ends: [end(cold), end(hot)],
            shift,
        }
    }

    /// `e / R` and `c_v / R` at a temperature, K.
    fn energy(&self, temperature: f64) -> [f64; 2] {
        let [cold, hot] = self.ends;
        if temperature < cold[0] {
            return [cold[2] * temperature, cold[2]];
        }
        if temperature > hot[0] {
            return [hot[1] + hot[2] * (temperature - hot[0]), hot[2]];
        }
        let molar = mixed(temperature);
        [
            temperature * (molar.enthalpy - 1.0) + self.shift,
            molar.capacity - 1.0,
        ]
    }

    /// `e rho / p` at `p / rho = R T`: `e / (R T)`, and what it changes by, `c_v / R - e / (R T)` to a relative change of `T`.
    pub fn ratio(&self, heat: f64) -> Ratio {
        let temperature = heat / self.constant;
        let [energy, capacity] = self.energy(temperature);
        let value = energy / temperature;
        Ratio {
            value,
            by_density: 0.0,
            by_heat: capacity - value,
        }
    }

    /// Specific entropy, J/(kg K), but for a constant.
    pub fn entropy(&self, density: f64, heat: f64) -> f64 {
        let temperature = heat / self.constant;
        let [cold, hot] = self.ends;
        let inside = temperature.clamp(cold[0], hot[0]);
        let end = if temperature < inside { cold } else { hot };
        let further = (end[2] + 1.0) * (temperature / inside).ln();
        self.constant * (mixed(inside).entropy + further - (density * heat).ln())
    }

    /// `p / rho` of a specific internal energy. Heat capacities grow with the temperature, so that Newton's method comes to it from above.
    pub fn heat(&self, energy: f64) -> f64 {
        let wanted = energy / self.constant;
        let [_, _, capacity] = self.ends[0];
        let mut temperature = wanted / capacity;
        for _ in 0..STEPS {
            let [energy, capacity] = self.energy(temperature);
            let step = (wanted - energy) / capacity;
            temperature += step;
            if step.abs() <= EXACT * temperature {
                break;
            }
        }
        temperature * self.constant
    }
}

/// What a mole of cold air would hold at a temperature, K.
fn mixed(temperature: f64) -> Molar {
    let all = [Species::NITROGEN, Species::OXYGEN, Species::ARGON];
    let mut sum = Molar {
        capacity: 0.0,
        enthalpy: 0.0,
        entropy: 0.0,
    };
    for (part, species) in FRACTIONS.iter().zip(all) {
        let molar = species.at(temperature);
        sum.capacity += part * molar.capacity;
        sum.enthalpy += part * molar.enthalpy;
        sum.entropy += part * molar.entropy;
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::super::Air;
    use approx::assert_relative_eq;

    /// Specific heats of air, `c_p` in kJ/(kg K) and gamma [Hilsenrath et al. 1955, NBS Circular 564, tables 2-3 and 2-4, low pressure].
    #[test]
    fn heat_capacities_are_those_of_the_tables() {
        let air = Air::ThermallyPerfect;
        for (temperature, capacity, gamma) in [
            (300.0, 1.0045, 1.400),
            (600.0, 1.0511, 1.376),
            (1000.0, 1.1410, 1.336),
            (1500.0, 1.2095, 1.311),
        ] {
            let density = 1e5 / (287.06 * temperature);
            let energy = air.energy_at(density, temperature);
            let found = air.heat_capacity(density, energy) / 1e3;
            assert_relative_eq!(found, capacity, max_relative = 4e-3);
            let pressure = air.pressure(density, energy);
            let ratio = air.sound_square(density, pressure) * density / pressure;
            assert_relative_eq!(ratio, gamma, max_relative = 2e-3);
        }
    }
}
