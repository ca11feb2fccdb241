//! A liquid: its pressure is a function of its density alone.

use super::transport::Transport;

/// `p = p_0 + (rho_0 c_0^2 / n) ((rho / rho_0)^n - 1)` [Cole 1948, Underwater Explosions, section 2.5, after Tait; Monaghan 1994, J. Comput.
/// Phys. 110, eq. 3.1]; linear, `p_0 + c_0^2 (rho - rho_0)`, where `n = 1`.
///
/// Its internal energy counts the work of its pressure and no heat: `de = p d rho / rho^2`, from `c_0^2` in the reference state,
/// so that none is negative where the flow is slower than sound.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Liquid {
    /// Speed of sound `c_0` in the reference state.
    pub sound_speed: f64,
    /// Density `rho_0` of the reference state.
    pub density: f64,
    /// Pressure `p_0` of the reference state.
    pub pressure: f64,
    /// Exponent `n`, one or more.
    pub exponent: f64,
    /// Viscosity; heat plays no part.
    pub transport: Option<Transport>,
}

impl Liquid {
    /// `rho_0 c_0^2 / n`.
    fn stiffness(&self) -> f64 {
        self.density * self.sound_speed * self.sound_speed / self.exponent
    }

    /// True where the pressure is linear in the density.
    pub fn is_linear(&self) -> bool {
        self.exponent == 1.0
    }

    /// `x^power`, where powers of one and of nothing cost nothing.
    #[inline]
    fn power(x: f64, power: f64) -> f64 {
        if power == 0.0 {
            1.0
        } else if power == 1.0 {
            x
        } else {
            x.powf(power)
        }
    }

    /// Pressure `p(rho)`.
    #[inline]
    pub fn pressure(&self, density: f64) -> f64 {
        if self.is_linear() {
            // Without the loss of digits of a ratio close to one.
            return self.pressure + self.sound_speed * self.sound_speed * (density - self.density);
        }
        let ratio = density / self.density;
        self.pressure + self.stiffness() * (Self::power(ratio, self.exponent) - 1.0)
    }

    /// Density `rho(p)`.
    #[inline]
    pub fn density(&self, pressure: f64) -> f64 {
        let rise = (pressure - self.pressure) / self.stiffness();
        self.density * Self::power(1.0 + rise, 1.0 / self.exponent)
    }

    /// The pressure of no density, below which there is none.
    pub fn least_pressure(&self) -> f64 {
        self.pressure - self.stiffness()
    }

    /// `c^2 / c_0^2` at a density.
    #[inline]
    pub fn relative_sound_square(&self, density: f64) -> f64 {
        Self::power(density / self.density, self.exponent - 1.0)
    }

    /// Speed of sound at a density.
    #[inline]
    pub fn sound_speed(&self, density: f64) -> f64 {
        self.sound_speed * self.relative_sound_square(density).sqrt()
    }

    /// Specific internal energy at a density: `c_0^2` and what the pressure's work made of it.
    pub fn energy(&self, density: f64) -> f64 {
        let (n, stiffness) = (self.exponent, self.stiffness());
        let ratio = density / self.density;
        // The integral of B (r^n - 1) / (rho_0 r^2) from one to r, and of p_0 / (rho_0 r^2).
        let springy = if self.is_linear() {
            ratio.ln()
        } else {
            (Self::power(ratio, n - 1.0) - 1.0) / (n - 1.0)
        };
        let squeezed = 1.0 - 1.0 / ratio;
        let work = stiffness * springy + (self.pressure - stiffness) * squeezed;
        self.sound_speed * self.sound_speed + work / self.density
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Sea water of Cole 1948: 1026 kg/m^3, 3045 atmospheres times n over the density are `c^2`.
    const WATER: Liquid = Liquid {
        sound_speed: 1484.0,
        density: 998.0,
        pressure: 101_325.0,
        exponent: 7.15,
        transport: None,
    };

    fn both() -> [Liquid; 2] {
        [
            WATER,
            Liquid {
                exponent: 1.0,
                ..WATER
            },
        ]
    }

    #[test]
    fn density_and_pressure_undo_each_other() {
        for liquid in both() {
            for density in [900.0, 998.0, 1100.0] {
                let back = liquid.density(liquid.pressure(density));
                assert!((back / density - 1.0).abs() < 1e-12, "{liquid:?} {back}");
            }
            assert!((liquid.pressure(998.0) - 101_325.0).abs() < 1e-6);
        }
    }

    #[test]
    fn sound_is_the_root_of_the_slope_and_energy_is_work() {
        for liquid in both() {
            let (density, step) = (1030.0, 1e-3);
            let slope =
                |of: &dyn Fn(f64) -> f64| (of(density + step) - of(density - step)) / (2.0 * step);
            let sound = slope(&|density| liquid.pressure(density)).sqrt();
            assert!((liquid.sound_speed(density) / sound - 1.0).abs() < 1e-8);
            let work = liquid.pressure(density) / (density * density);
            let found = slope(&|density| liquid.energy(density));
            assert!((found / work - 1.0).abs() < 1e-5, "{found} of {work}");
        }
        assert!((WATER.sound_speed(WATER.density) - 1484.0).abs() < 1e-9);
    }

    /// Water is compressed by about 4 per cent at a thousand atmospheres [Cole 1948; Bridgman].
    #[test]
    fn a_thousand_atmospheres_compress_water_by_four_per_cent() {
        let rise = WATER.density(1.013e8) / WATER.density - 1.0;
        assert!((rise - 0.040).abs() < 0.002, "{rise}");
    }
}
