//! The equation of state of the gas: all that the flow about points asks of it.

use super::real::Real;
use crate::gas::{Air, Gas, IdealGas};

/// Between density, pressure and internal energy per volume, `rho e`, on single numbers and on vectors of them.
pub trait EquationOfState: Copy + Send + Sync {
    /// Internal energy per volume.
    fn internal_energy<R: Real>(&self, density: R, pressure: R) -> R;

    /// Pressure of this much internal energy per volume.
    fn pressure<R: Real>(&self, density: R, internal_energy: R) -> R;

    /// Square of the speed of sound.
    fn sound_square<R: Real>(&self, density: R, pressure: R) -> R;

    /// Change of the pressure, of gas of this density and pressure, with those of density and internal energy per volume, to first order.
    fn pressure_change(&self, density: f64, pressure: f64, change: [f64; 2]) -> f64;

    /// `p / rho` at a temperature and a pressure.
    fn heat_at(&self, temperature: f64, pressure: f64) -> f64;

    /// Pressure on a wall at rest that gas of this density and pressure moves into at `speed`, or away from where it is
    /// negative: the Riemann problem between the gas and its mirror image.
    fn wall_pressure(&self, density: f64, pressure: f64, speed: f64) -> f64;
}

/// The gas of a problem.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum AnyGas {
    /// An ideal one.
    Ideal(IdealGas),
    /// Air as it gets hot.
    Air(Air),
}

impl AnyGas {
    /// That of a problem.
    ///
    /// # Errors
    /// A liquid.
    pub fn of(gas: &Gas) -> Result<Self, String> {
        match gas {
            Gas::Ideal(gas) => Ok(Self::Ideal(*gas)),
            Gas::Air { air, .. } => Ok(Self::Air(*air)),
            Gas::Liquid(_) => {
                Err("a liquid goes with particles; use `scheme.motion = \"with-the-gas\"`".into())
            }
        }
    }

    /// What tells the least energy per mass of many: that of gas with this `p / rho`, times [`Self::unit_energy`].
    #[inline(always)]
    pub fn energy_measure(&self, heat: f64, energy: impl Fn() -> f64) -> f64 {
        match self {
            Self::Ideal(_) => heat,
            Self::Air(_) => energy(),
        }
    }

    /// The measure of a specific internal energy of one.
    pub fn unit_energy(&self) -> f64 {
        match self {
            Self::Ideal(gas) => gas.heat(),
            Self::Air(_) => 1.0,
        }
    }
}

/// What of a gas each of the two answers.
macro_rules! either {
    ($self:ident, $gas:ident => $answer:expr) => {
        match $self {
            AnyGas::Ideal($gas) => $answer,
            AnyGas::Air($gas) => $answer,
        }
    };
}

impl EquationOfState for AnyGas {
    #[inline(always)]
    fn internal_energy<R: Real>(&self, density: R, pressure: R) -> R {
        either!(self, gas => EquationOfState::internal_energy(gas, density, pressure))
    }

    #[inline(always)]
    fn pressure<R: Real>(&self, density: R, internal_energy: R) -> R {
        either!(self, gas => EquationOfState::pressure(gas, density, internal_energy))
    }

    #[inline(always)]
    fn sound_square<R: Real>(&self, density: R, pressure: R) -> R {
        either!(self, gas => EquationOfState::sound_square(gas, density, pressure))
    }

    #[inline(always)]
    fn pressure_change(&self, density: f64, pressure: f64, change: [f64; 2]) -> f64 {
        either!(self, gas => EquationOfState::pressure_change(gas, density, pressure, change))
    }

    #[inline(always)]
    fn heat_at(&self, temperature: f64, pressure: f64) -> f64 {
        either!(self, gas => EquationOfState::heat_at(gas, temperature, pressure))
    }

    #[inline(always)]
    fn wall_pressure(&self, density: f64, pressure: f64, speed: f64) -> f64 {
        either!(self, gas => EquationOfState::wall_pressure(gas, density, pressure, speed))
    }
}

/// Lane by lane: what air is made of is no formula.
impl EquationOfState for Air {
    #[inline(always)]
    fn internal_energy<R: Real>(&self, density: R, pressure: R) -> R {
        density.each(pressure, |density, pressure| {
            density * self.energy(density, pressure)
        })
    }

    #[inline(always)]
    fn pressure<R: Real>(&self, density: R, internal_energy: R) -> R {
        density.each(internal_energy, |density, energy| {
            Self::pressure(*self, density, energy / density)
        })
    }

    #[inline(always)]
    fn sound_square<R: Real>(&self, density: R, pressure: R) -> R {
        density.each(pressure, |density, pressure| {
            Self::sound_square(*self, density, pressure)
        })
    }

    fn pressure_change(&self, density: f64, pressure: f64, change: [f64; 2]) -> f64 {
        Self::pressure_change(*self, density, pressure, change)
    }

    fn heat_at(&self, temperature: f64, pressure: f64) -> f64 {
        pressure / self.density_at(pressure, temperature)
    }

    fn wall_pressure(&self, density: f64, pressure: f64, speed: f64) -> f64 {
        Self::wall_pressure(*self, density, pressure, speed)
    }
}

impl EquationOfState for IdealGas {
    #[inline(always)]
    fn internal_energy<R: Real>(&self, _: R, pressure: R) -> R {
        pressure * (1.0 / (self.gamma - 1.0))
    }

    #[inline(always)]
    fn pressure<R: Real>(&self, _: R, internal_energy: R) -> R {
        internal_energy * (self.gamma - 1.0)
    }

    #[inline(always)]
    fn sound_square<R: Real>(&self, density: R, pressure: R) -> R {
        pressure * self.gamma / density
    }

    #[inline(always)]
    fn pressure_change(&self, _: f64, _: f64, [_, internal_energy]: [f64; 2]) -> f64 {
        internal_energy * (self.gamma - 1.0)
    }

    #[inline(always)]
    fn heat_at(&self, temperature: f64, _: f64) -> f64 {
        temperature * self.constant
    }

    /// The shock that stops the gas [Toro 2009, eq. 4.6 with `u* = 0`, solved for `p*`], or the isentropic expansion
    /// `p* = p (1 + (gamma - 1) u / (2 a))^(2 gamma / (gamma - 1))` [eq. 4.7]; zero where it leaves a vacuum behind.
    #[inline]
    fn wall_pressure(&self, density: f64, pressure: f64, speed: f64) -> f64 {
        let gamma = self.gamma;
        if speed > 0.0 {
            let a = 2.0 / ((gamma + 1.0) * density);
            let b = (gamma - 1.0) / (gamma + 1.0) * pressure;
            let root = (speed * speed + 4.0 * a * (pressure + b)).sqrt();
            pressure + speed * (speed + root) / (2.0 * a)
        } else if speed < 0.0 {
            let sound = (gamma * pressure / density).sqrt();
            let share = (1.0 + 0.5 * (gamma - 1.0) * speed / sound).max(0.0);
            pressure * share.powf(2.0 * gamma / (gamma - 1.0))
        } else {
            pressure
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    const AIR: IdealGas = IdealGas::new(1.4);

    #[test]
    fn energy_and_pressure_are_inverse() {
        let energy = AIR.internal_energy(1.3, 2.7);
        assert_relative_eq!(energy, 2.7 / 0.4, epsilon = 1e-14);
        assert_relative_eq!(AIR.pressure(1.3, energy), 2.7, epsilon = 1e-14);
    }

    /// Sod's reflected shock: the gas behind the first one, (0.265574, 0.927453, 0.303130), stops at a wall at
    /// 0.780386 (exact solution of the Riemann problem with its mirror image).
    #[test]
    fn gas_that_meets_a_wall_is_stopped_by_a_shock() {
        let wall = AIR.wall_pressure(0.265_574, 0.303_130, 0.927_453);
        assert_relative_eq!(wall, 0.780_386, epsilon = 2e-5);
    }

    #[test]
    fn gas_that_leaves_a_wall_expands_isentropically() {
        let (density, pressure) = (1.2, 0.9_f64);
        let sound = (1.4 * pressure / density).sqrt();
        let wall = AIR.wall_pressure(density, pressure, -0.5 * sound);
        assert_relative_eq!(wall, pressure * 0.9_f64.powi(7), epsilon = 1e-14);
        // Faster than 2 / (gamma - 1) times sound, and it leaves nothing behind.
        assert_eq!(AIR.wall_pressure(density, pressure, -5.1 * sound), 0.0);
    }

    #[test]
    fn weak_waves_meet_the_wall_alike_from_both_sides() {
        let step = 1e-6;
        let [up, down] = [step, -step].map(|u| AIR.wall_pressure(1.0, 1.0, u) - 1.0);
        assert_relative_eq!(up / step, 1.4_f64.sqrt(), epsilon = 1e-5);
        assert_relative_eq!(down / step, -(1.4_f64.sqrt()), epsilon = 1e-5);
    }
}
