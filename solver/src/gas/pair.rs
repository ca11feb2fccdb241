//! Two gases in one flow, beside each other without mixing.

use super::{Gas, IdealGas};

/// The gas of a flow, and the second one where there are two.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gases {
    /// The gas; the first of two.
    pub first: Gas,
    /// The second.
    pub second: Option<Gas>,
}

impl Gases {
    /// The gas itself, or the second one.
    #[inline(always)]
    pub const fn of(&self, is_second: bool) -> &Gas {
        match &self.second {
            Some(second) if is_second => second,
            _ => &self.first,
        }
    }

    /// True of two.
    pub const fn are_two(&self) -> bool {
        self.second.is_some()
    }

    /// Square of the speed of sound over that of the first gas's [`Gas::unit_sound`].
    #[inline(always)]
    pub fn sound_measure(&self, is_second: bool, density: f64, energy: f64) -> f64 {
        let gas = self.of(is_second);
        let measure = gas.sound_measure(density, energy);
        if is_second && self.are_two() {
            let ratio = gas.unit_sound() / self.first.unit_sound();
            measure * ratio * ratio
        } else {
            measure
        }
    }

    /// What `share` of the volume of the second and the rest of the first make where they are looked at together, at one pressure and one
    /// temperature: heat capacities and molecules add.
    pub fn mixed(&self, share: f64) -> Gas {
        let (Some(Gas::Ideal(second)), Gas::Ideal(first)) = (self.second, self.first) else {
            return self.first;
        };
        if share <= 0.0 {
            return self.first;
        }
        let rest = 1.0 - share;
        Gas::Ideal(IdealGas {
            gamma: 1.0 + 1.0 / (share / second.heat() + rest / first.heat()),
            constant: 1.0 / (share / second.constant + rest / first.constant),
            transport: None,
        })
    }
}

impl From<Gas> for Gases {
    fn from(first: Gas) -> Self {
        Self {
            first,
            second: None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn air_and_helium() -> Gases {
        let ideal = |gamma, constant| {
            Gas::Ideal(IdealGas {
                gamma,
                constant,
                transport: None,
            })
        };
        Gases {
            first: ideal(1.4, 287.05),
            second: Some(ideal(5.0 / 3.0, 2077.1)),
        }
    }

    /// Steps are bounded by the speed of sound of each.
    #[test]
    fn sound_of_either_gas_is_measured_alike() {
        let gases = air_and_helium();
        for is_second in [false, true] {
            let (density, energy) = (0.7, 2.3e5);
            let measured = gases.sound_measure(is_second, density, energy).sqrt();
            let sound = gases.of(is_second).sound_speed(density, energy);
            let error = measured * gases.first.unit_sound() / sound - 1.0;
            assert!(error.abs() < 1e-14, "{error:e}");
        }
    }

    /// Energies of the parts at one pressure add up to that of the mixture, and so do masses at one temperature.
    #[test]
    fn a_mixture_has_the_energy_and_the_mass_of_its_parts() {
        let gases = air_and_helium();
        let (pressure, temperature, share) = (1.0e5, 300.0, 0.3);
        let [first, second] = [false, true].map(|is_second| *gases.of(is_second));
        let density = |gas: &Gas| pressure / (gas.ideal_gas().unwrap().constant * temperature);
        let stored = |gas: &Gas| density(gas) * gas.energy(density(gas), pressure);
        let mixed = gases.mixed(share);
        let sum = |of: &dyn Fn(&Gas) -> f64| share * of(&second) + (1.0 - share) * of(&first);
        assert!((stored(&mixed) / sum(&stored) - 1.0).abs() < 1e-14);
        assert!((density(&mixed) / sum(&density) - 1.0).abs() < 1e-14);
        assert_eq!(gases.mixed(0.0), first);
    }
}
