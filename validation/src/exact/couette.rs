//! Viscous gas between two plane walls, one of which slides.
//!
//! Where heat flows as `mu / Pr` times the gradient of the enthalpy, `h - Pr u (U - u) / 2` is the same from wall to wall, whatever viscosity and heat
//! capacity do.
//!
//! Sources: the energy equation of plane shear at constant pressure (White, "Viscous Fluid Flow", 3rd ed., section 7-2);
//! Sutherland's law with White's constants for air (table 1-2).

use super::ExactError;
use super::hot_air::HotAir;

/// Viscosity of air, Pa s, at a temperature, K: 1.716e-5 at 273.15 K, constant 110.4 K.
pub fn air_viscosity(temperature: f64) -> f64 {
    let ratio = temperature / 273.15;
    1.716e-5 * ratio.powf(1.5) * (273.15 + 110.4) / (temperature + 110.4)
}

/// Walls at the same temperature, or the sliding one without heat through it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Couette {
    /// Temperature of the wall at rest, K.
    pub temperature: f64,
    /// Mach number of the sliding wall by that temperature.
    pub mach: f64,
    /// Ratio of specific heats.
    pub gamma: f64,
    /// Prandtl number.
    pub prandtl: f64,
}

impl Couette {
    /// `T = T_w + Pr (U u - u^2) / (2 c_p)` between walls of the same temperature, at a speed that is `part` of the sliding wall's,
    /// whatever the viscosity does with the temperature.
    pub fn between(&self, part: f64) -> f64 {
        self.temperature * (1.0 + self.rise() * (part - part * part))
    }

    /// Temperature of a sliding wall that no heat goes through: `T_w + Pr U^2 / (2 c_p)`.
    pub fn adiabatic_wall(&self) -> f64 {
        self.temperature * (1.0 + self.rise())
    }

    /// `tau H / (mu_w U)` between walls of the same temperature: the mean over the speed of the viscosity over that at the walls.
    pub fn shear(&self) -> f64 {
        mean(|part| air_viscosity(self.between(part))) / air_viscosity(self.temperature)
    }

    /// `Pr U^2 / (2 c_p T_w)`.
    fn rise(&self) -> f64 {
        0.5 * self.prandtl * (self.gamma - 1.0) * self.mach * self.mach
    }
}

/// Mean over the parts of a whole, by Simpson's rule: what it is taken of is smooth.
fn mean(value: impl Fn(f64) -> f64) -> f64 {
    const PANELS: u32 = 200;
    let weight = |n: u32| match n {
        0 | PANELS => 1.0,
        n if n % 2 == 1 => 4.0,
        _ => 2.0,
    };
    let each = (0..=PANELS).map(|n| weight(n) * value(f64::from(n) / f64::from(PANELS)));
    each.sum::<f64>() / (3.0 * f64::from(PANELS))
}

/// The same of air that gets hot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HotCouette {
    /// What happens to it.
    pub air: HotAir,
    /// Pressure, Pa.
    pub pressure: f64,
    /// Temperature of the wall at rest, K.
    pub temperature: f64,
    /// Speed of the sliding wall, m/s.
    pub speed: f64,
    /// Prandtl number.
    pub prandtl: f64,
}

impl HotCouette {
    /// Temperature between walls of the same one, at a speed that is `part` of the sliding wall's.
    ///
    /// # Errors
    /// Air that is too hot or too cold.
    pub fn between(&self, part: f64) -> Result<f64, ExactError> {
        self.risen(part - part * part)
    }

    /// Temperature of a sliding wall that no heat goes through.
    ///
    /// # Errors
    /// Air that is too hot or too cold.
    pub fn adiabatic_wall(&self) -> Result<f64, ExactError> {
        self.risen(1.0)
    }

    /// `tau H / (mu_w U)` between walls of the same temperature.
    ///
    /// # Errors
    /// Air that is too hot or too cold.
    pub fn shear(&self) -> Result<f64, ExactError> {
        self.between(0.5)?;
        let viscosity = |part| self.between(part).map_or(f64::NAN, air_viscosity);
        Ok(mean(viscosity) / air_viscosity(self.temperature))
    }

    /// Where there is this much of `Pr U^2 / 2` more enthalpy than at the wall at rest.
    fn risen(&self, part: f64) -> Result<f64, ExactError> {
        let wall = self.air.at(self.pressure, self.temperature)?.enthalpy;
        let rise = 0.5 * self.prandtl * self.speed * self.speed * part;
        let hot = self.air.of_enthalpy(self.pressure, wall + rise)?;
        Ok(hot.temperature)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shear_and_wall_temperature_are_those_computed_beforehand() {
        for (mach, shear) in [(0.5, 1.0046), (2.0, 1.0718), (3.0, 1.1567)] {
            let couette = Couette {
                temperature: 300.0,
                mach,
                gamma: 1.4,
                prandtl: 0.72,
            };
            assert!(
                (couette.shear() - shear).abs() < 6e-5,
                "{}",
                couette.shear()
            );
        }
        let couette = Couette {
            temperature: 300.0,
            mach: 2.0,
            gamma: 1.4,
            prandtl: 0.72,
        };
        assert!((couette.adiabatic_wall() - 472.8).abs() < 1e-9);
    }

    /// Air that is cold all the way is an ideal gas; fast enough, what swings and comes apart in it takes up heat.
    #[test]
    fn hot_air_is_colder_than_an_ideal_gas_and_cold_air_is_not() {
        let at = |speed: f64, air| HotCouette {
            air,
            pressure: 1e3,
            temperature: 300.0,
            speed,
            prandtl: 0.72,
        };
        let ideal = |speed: f64| Couette {
            temperature: 300.0,
            mach: speed / (1.4_f64 * 287.06 * 300.0).sqrt(),
            gamma: 1.4,
            prandtl: 0.72,
        };
        let slow = at(200.0, HotAir::Whole);
        let (found, known) = (slow.shear().unwrap(), ideal(200.0).shear());
        assert!((found - known).abs() < 1e-4, "{found} {known}");
        let [whole, reacting] =
            [HotAir::Whole, HotAir::Reacting].map(|air| at(4000.0, air).adiabatic_wall().unwrap());
        let perfect = ideal(4000.0).adiabatic_wall();
        assert!(
            reacting < 0.9 * whole && whole < 0.9 * perfect,
            "{reacting} {whole} {perfect}"
        );
    }
}
