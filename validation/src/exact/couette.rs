//! Viscous gas between two plane walls, one of which slides.
//!
//! Sources: the energy equation of plane shear at constant pressure (White, "Viscous Fluid Flow", 3rd ed., section 7-2);
//! Sutherland's law with White's constants for air (table 1-2).

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
        /// Simpson's rule: the integrand is smooth.
        const PANELS: u32 = 200;
        let value = |n: u32| {
            let part = f64::from(n) / f64::from(PANELS);
            air_viscosity(self.between(part)) / air_viscosity(self.temperature)
        };
        let weight = |n: u32| match n {
            0 | PANELS => 1.0,
            n if n % 2 == 1 => 4.0,
            _ => 2.0,
        };
        let sum: f64 = (0..=PANELS).map(|n| weight(n) * value(n)).sum();
        sum / (3.0 * f64::from(PANELS))
    }

    /// `Pr U^2 / (2 c_p T_w)`.
    fn rise(&self) -> f64 {
        0.5 * self.prandtl * (self.gamma - 1.0) * self.mach * self.mach
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
}
