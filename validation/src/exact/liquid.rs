//! Waves in a liquid whose pressure is a function of its density alone.
//!
//! Sources: R. H. Cole, "Underwater Explosions" (1948), sections 2.3 and 2.5; the Riemann problem of barotropic flow as in E. F. Toro,
//! "Riemann Solvers and Numerical Methods for Fluid Dynamics" (3rd ed. 2009), chapter 4, with the jumps of mass and momentum alone.

use super::root::bracketed_root;

/// `p = p_0 + (rho_0 c_0^2 / n) ((rho / rho_0)^n - 1)`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Liquid {
    /// Density of the reference state.
    pub density: f64,
    /// Its speed of sound.
    pub sound_speed: f64,
    /// Its pressure.
    pub pressure: f64,
    /// Exponent, one or more.
    pub exponent: f64,
}

/// Density and velocity along the axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moving {
    /// Density.
    pub density: f64,
    /// Velocity.
    pub velocity: f64,
}

impl Liquid {
    /// Pressure at a density.
    pub fn pressure(&self, density: f64) -> f64 {
        let stiffness = self.density * self.sound_speed * self.sound_speed / self.exponent;
        self.pressure + stiffness * ((density / self.density).powf(self.exponent) - 1.0)
    }

    /// Speed of sound at a density.
    pub fn sound_speed(&self, density: f64) -> f64 {
        self.sound_speed * (density / self.density).powf(0.5 * (self.exponent - 1.0))
    }

    /// `integral of c / rho` from one density to another: what a simple wave changes the velocity by.
    fn wave(&self, from: f64, to: f64) -> f64 {
        let half = 0.5 * (self.exponent - 1.0);
        if half == 0.0 {
            return self.sound_speed * (to / from).ln();
        }
        (self.sound_speed(to) - self.sound_speed(from)) / half
    }

    /// What a wave into `ahead`, at whose back the density is `behind`, changes the velocity by: a shock or a rarefaction.
    fn change(&self, ahead: f64, behind: f64) -> f64 {
        if behind <= ahead {
            return self.wave(ahead, behind);
        }
        let rise = self.pressure(behind) - self.pressure(ahead);
        (rise * (1.0 / ahead - 1.0 / behind)).sqrt()
    }

    /// The state between the waves that two states beside each other send out.
    pub fn between(&self, left: Moving, right: Moving) -> Moving {
        let excess = |density| {
            let from_left = left.velocity - self.change(left.density, density);
            from_left - right.velocity - self.change(right.density, density)
        };
        let (low, high) = (1e-3 * self.density, 10.0 * left.density.max(right.density));
        let density = bracketed_root(excess, low, high);
        Moving {
            density,
            velocity: left.velocity - self.change(left.density, density),
        }
    }

    /// Density behind the shock that a wall sends into liquid which comes to it at `speed`, and the speed of the shock.
    pub fn stopped(&self, density: f64, speed: f64) -> (f64, f64) {
        let coming = Moving {
            density,
            velocity: speed,
        };
        let mirrored = Moving {
            density,
            velocity: -speed,
        };
        let behind = self.between(coming, mirrored).density;
        (behind, speed * density / (behind - density))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const WATER: Liquid = Liquid {
        density: 998.0,
        sound_speed: 1484.0,
        pressure: 101_325.0,
        exponent: 7.0,
    };

    /// Joukowsky 1898: `rho c u` where the liquid comes slowly.
    #[test]
    fn slow_water_that_is_stopped_has_joukowskys_pressure() {
        let (behind, front) = WATER.stopped(998.0, 1.0);
        let rise = WATER.pressure(behind) - WATER.pressure;
        assert!((rise / (998.0 * 1484.0) - 1.0).abs() < 2e-3, "{rise}");
        assert!((front / 1484.0 - 1.0).abs() < 2e-3, "{front}");
    }

    #[test]
    fn jumps_keep_mass_and_momentum() {
        let left = Moving {
            density: 1200.0,
            velocity: 0.0,
        };
        let right = Moving {
            density: 998.0,
            velocity: 0.0,
        };
        let middle = WATER.between(left, right);
        // Into the liquid at rest on the right.
        let front = middle.density * middle.velocity / (middle.density - 998.0);
        let rise = WATER.pressure(middle.density) - WATER.pressure(998.0);
        assert!((rise / (998.0 * front * middle.velocity) - 1.0).abs() < 1e-9);
        // Along the wave to the left, by the invariant `u + 2 c / (n - 1)`.
        let invariant = |of: Moving| of.velocity + WATER.sound_speed(of.density) / 3.0;
        assert!((invariant(left) / invariant(middle) - 1.0).abs() < 1e-9);
    }

    #[test]
    fn a_linear_liquid_is_the_limit_of_an_exponent_of_one() {
        let [linear, nearly] = [1.0, 1.0 + 1e-7].map(|exponent| Liquid { exponent, ..WATER });
        let [a, b] = [linear, nearly].map(|liquid| liquid.stopped(998.0, 100.0).0);
        assert!((a / b - 1.0).abs() < 1e-7, "{a} {b}");
    }
}
