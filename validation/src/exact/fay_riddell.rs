//! Heat into the nose of a blunt body of revolution in a hypersonic stream of air whose specific heats are constant, or that is in equilibrium.
//!
//! Source: Fay & Riddell, J. Aeronaut. Sci. 25 (1958) 73-85, eq. 63, without dissociation or with a Lewis number of one:
//! `q = 0.763 Pr^-0.6 (rho_e mu_e)^0.4 (rho_w mu_w)^0.1 sqrt(du_e/dx) (h_0e - h_w)`, edge `e` at rest behind a normal shock, wall `w` at the
//! same pressure, viscosities by Sutherland's law; `du_e/dx = sqrt(2 (p_e - p) / rho_e) / R`, Newton's pressure on a sphere.
//!
//! How it falls off the nose of a sphere: Lees, Jet Propulsion 26 (1956) 259-269, with the same pressure.

use super::ExactError;
use super::couette::air_viscosity;
use super::hot_air::{Hot, HotAir};
use super::isentropic::temperature_ratio;
use super::normal::pitot_pressure_ratio;

/// A sphere in a stream of air.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nose {
    /// Radius, m.
    pub radius: f64,
    /// Mach number.
    pub mach: f64,
    /// Temperature of the stream, K.
    pub temperature: f64,
    /// Pressure of the stream, Pa.
    pub pressure: f64,
    /// Temperature of the wall, K.
    pub wall: f64,
    /// J/(kg K).
    pub gas_constant: f64,
    /// Ratio of specific heats.
    pub gamma: f64,
    /// Prandtl number.
    pub prandtl: f64,
}

impl Nose {
    /// Heat into the stagnation point, W/m^2, by Newton's pressure.
    pub fn heat_flux(&self) -> f64 {
        let pitot = pitot_pressure_ratio(self.mach, self.gamma);
        self.heat_flux_where(1.0 - 1.0 / pitot)
    }

    /// The same where the pressure of gas without viscosity falls off the nose by this part of itself over the square of the angle from there, in radians:
    /// the gas goes away from the nose as `du_e/dx = sqrt(2 bend p_e / rho_e) / R`.
    pub fn heat_flux_where(&self, bend: f64) -> f64 {
        let pressure = self.pressure * pitot_pressure_ratio(self.mach, self.gamma);
        let edge = self.temperature * temperature_ratio(self.mach, self.gamma);
        let heat_capacity = self.gamma / (self.gamma - 1.0) * self.gas_constant;
        let at = |temperature: f64| Hot {
            pressure,
            density: pressure / (self.gas_constant * temperature),
            temperature,
            enthalpy: heat_capacity * temperature,
        };
        flux(&at(edge), &at(self.wall), self.prandtl, bend, self.radius)
    }

    /// Heat at this angle from the nose, in radians, over that at the nose.
    pub fn part_at(&self, angle: f64) -> f64 {
        let least = 1.0 / (self.gamma * self.mach * self.mach);
        let (sin, cos) = angle.sin_cos();
        let shape = |k: f64| angle * angle - angle * (k * angle).sin() * 2.0 / k;
        let near = shape(4.0) + (1.0 - (4.0 * angle).cos()) / 8.0;
        let far = shape(2.0) + (1.0 - (2.0 * angle).cos()) / 2.0;
        let grown = (1.0 - least) * near + 4.0 * least * far;
        2.0 * angle * sin * ((1.0 - least) * cos * cos + least) / grown.sqrt()
    }
}

/// Heat into the nose behind gas at rest at its `edge`, and with gas like that at its `wall`.
fn flux(edge: &Hot, wall: &Hot, prandtl: f64, bend: f64, radius: f64) -> f64 {
    let gradient = (2.0 * bend * edge.pressure / edge.density).sqrt() / radius;
    let product = |gas: &Hot| gas.density * air_viscosity(gas.temperature);
    0.763
        * prandtl.powf(-0.6)
        * product(edge).powf(0.4)
        * product(wall).powf(0.1)
        * gradient.sqrt()
        * (edge.enthalpy - wall.enthalpy)
}

/// A sphere in a stream of air that gets hot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HotNose {
    /// What happens to it.
    pub air: HotAir,
    /// Radius, m.
    pub radius: f64,
    /// The stream.
    pub ahead: Hot,
    /// Its speed, m/s.
    pub speed: f64,
    /// Temperature of the wall, K.
    pub wall: f64,
    /// Prandtl number of what no species carry.
    pub prandtl: f64,
}

impl HotNose {
    /// Heat into the stagnation point, W/m^2, where pressure falls off the nose as [`Nose::heat_flux_where`] has it.
    ///
    /// # Errors
    /// Air that is too hot or too cold.
    pub fn heat_flux_where(&self, bend: f64) -> Result<f64, ExactError> {
        let edge = self.edge()?;
        let wall = self.air.at(edge.pressure, self.wall)?;
        Ok(flux(&edge, &wall, self.prandtl, bend, self.radius))
    }

    /// Gas at rest behind the shock: what is left of its speed there, hardly more than a quarter of that of sound, is stopped as by a liquid.
    ///
    /// # Errors
    /// Air that is too hot or too cold.
    pub fn edge(&self) -> Result<Hot, ExactError> {
        let behind = self.air.normal_shock(&self.ahead, self.speed)?;
        let slow = self.ahead.density * self.speed / behind.density;
        let rest = 0.5 * slow * slow;
        let compressed = rest * behind.density / behind.pressure;
        // To second order with a ratio of specific heats of 1.2: it changes little.
        let pressure = behind.pressure * (1.0 + compressed + compressed * compressed / 2.4);
        self.air.of_enthalpy(pressure, behind.enthalpy + rest)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const NOSE: Nose = Nose {
        radius: 0.1,
        mach: 6.0,
        temperature: 220.0,
        pressure: 50.969,
        wall: 300.0,
        gas_constant: 287.05,
        gamma: 1.4,
        prandtl: 0.72,
    };

    /// Worked out step by step: 2386.12 Pa and 1804 K at the edge, 10 067.5 1/s.
    #[test]
    fn the_heat_is_that_worked_out_beforehand() {
        assert!(
            (NOSE.heat_flux() / 77_905.16 - 1.0).abs() < 1e-4,
            "{}",
            NOSE.heat_flux()
        );
    }

    /// Worked out beforehand: 0.976, 0.831, 0.435 at 10.5, 28.5 and 55.5 degrees.
    #[test]
    fn heat_falls_off_the_nose_as_worked_out_beforehand() {
        for (degrees, part) in [(10.5_f64, 0.976), (28.5, 0.831), (55.5, 0.435)] {
            let found = NOSE.part_at(degrees.to_radians());
            assert!((found - part).abs() < 1e-3, "{degrees}: {found}");
        }
        let steeper = NOSE.heat_flux_where(4.0) / NOSE.heat_flux_where(1.0);
        assert!((steeper - 2.0_f64.sqrt()).abs() < 1e-12);
    }

    /// Air that is cold all the way is an ideal gas.
    #[test]
    fn slow_air_takes_no_notice_of_its_molecules() {
        let slow = Nose { mach: 2.0, ..NOSE };
        let ahead = HotAir::Whole.at(NOSE.pressure, NOSE.temperature).unwrap();
        let hot = HotNose {
            air: HotAir::Whole,
            radius: NOSE.radius,
            ahead,
            speed: 2.0 * (1.4 * ahead.pressure / ahead.density).sqrt(),
            wall: NOSE.wall,
            prandtl: NOSE.prandtl,
        };
        let ratio = hot.heat_flux_where(1.0).unwrap() / slow.heat_flux_where(1.0);
        assert!((ratio - 1.0).abs() < 5e-3, "{ratio}");
    }

    /// It falls with the root of the radius and grows with that of the pressure, and there is none where the wall is as hot as gas at rest.
    #[test]
    fn blunter_noses_and_thinner_air_take_less() {
        let blunt = Nose {
            radius: 0.4,
            ..NOSE
        };
        assert!((blunt.heat_flux() / NOSE.heat_flux() - 0.5).abs() < 1e-12);
        let thin = Nose {
            pressure: NOSE.pressure / 4.0,
            ..NOSE
        };
        assert!((thin.heat_flux() / NOSE.heat_flux() - 0.5).abs() < 1e-12);
        let hot = Nose {
            wall: 220.0 * 8.2,
            ..NOSE
        };
        assert!(hot.heat_flux().abs() < 1e-9 * NOSE.heat_flux());
    }
}
