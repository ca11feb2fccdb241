//! Air as it gets hot, from the spectra of its molecules and atoms, and the shocks in it.
//!
//! Partition functions of rigid rotors and harmonic oscillators with the lowest electronic levels, and the law of mass action [Vincenti &
//! Kruger 1965, Introduction to Physical Gas Dynamics, chapters IV and V]. Spectroscopic constants: Huber & Herzberg 1979, Constants of
//! Diatomic Molecules; Moore 1970, NSRDS-NBS 34. Ions, a thousandth of the gas up to 7000 K, are left out. Nothing here is shared with the
//! polynomials that the solver takes. SI units.

use super::root::bracketed_root;
use super::{ExactError, require};

/// Boltzmann's and Planck's constants, and the mass of an atomic mass unit [CODATA 2018].
const BOLTZMANN: f64 = 1.380_649e-23;
const PLANCK: f64 = 6.626_070_15e-34;
const MASS_UNIT: f64 = 1.660_539_066_6e-27;

/// Hotter and colder than this the sums do not hold, K.
const RANGE: [f64; 2] = [200.0, 15_000.0];

/// Mole fractions of N2, O2 and argon in cold air, and their masses in atomic mass units [U.S. Standard Atmosphere 1976].
const FRACTIONS: [f64; 3] = [0.780_84, 0.209_476, 0.009_684];
const MASSES: [f64; 3] = [28.0134, 31.9988, 39.948];

/// Weights and temperatures, K, of the lowest electronic levels.
const OXYGEN_LEVELS: [[f64; 2]; 3] = [[3.0, 0.0], [2.0, 11_392.0], [1.0, 18_985.0]];
const NITRIC_OXIDE_LEVELS: [[f64; 2]; 2] = [[2.0, 0.0], [2.0, 174.2]];
const NITROGEN_ATOM_LEVELS: [[f64; 2]; 3] = [[4.0, 0.0], [10.0, 27_665.0], [6.0, 41_493.0]];
const OXYGEN_ATOM_LEVELS: [[f64; 2]; 5] = [
    [5.0, 0.0],
    [3.0, 227.7],
    [1.0, 326.6],
    [5.0, 22_831.0],
    [1.0, 48_620.0],
];

/// A molecule of two atoms: temperatures, K, of rotation, vibration and of what takes it apart, its symmetry, mass and electronic levels.
#[derive(Clone, Copy)]
struct Molecule {
    rotation: f64,
    vibration: f64,
    bond: f64,
    symmetry: f64,
    mass: f64,
    levels: &'static [[f64; 2]],
}

const NITROGEN: Molecule = Molecule {
    rotation: 2.875,
    vibration: 3393.0,
    bond: 113_253.0,
    symmetry: 2.0,
    mass: 28.0134,
    levels: &[[1.0, 0.0]],
};
const OXYGEN: Molecule = Molecule {
    rotation: 2.080,
    vibration: 2273.0,
    bond: 59_364.0,
    symmetry: 2.0,
    mass: 31.9988,
    levels: &OXYGEN_LEVELS,
};
const NITRIC_OXIDE: Molecule = Molecule {
    rotation: 2.453,
    vibration: 2739.0,
    bond: 75_392.0,
    symmetry: 1.0,
    mass: 30.0061,
    levels: &NITRIC_OXIDE_LEVELS,
};

impl Molecule {
    /// Enthalpy of one over Boltzmann's constant, K, above that of its atoms apart at no temperature.
    fn enthalpy(&self, t: f64) -> f64 {
        let swing = self.vibration / ((self.vibration / t).exp() - 1.0);
        3.5 * t + swing + mean(self.levels, t) - self.bond
    }

    /// Logarithm of its partition function in a cubic metre, from the same zero.
    fn partition(&self, t: f64) -> f64 {
        let turns = t / (self.symmetry * self.rotation);
        let swings = 1.0 - (-self.vibration / t).exp();
        moving(self.mass, t) + (turns / swings * sum(self.levels, t)).ln() + self.bond / t
    }
}

/// `sum g exp(-theta / T)`.
fn sum(levels: &[[f64; 2]], t: f64) -> f64 {
    levels.iter().map(|[g, theta]| g * (-theta / t).exp()).sum()
}

/// Mean energy in the levels, over Boltzmann's constant.
fn mean(levels: &[[f64; 2]], t: f64) -> f64 {
    let each = levels.iter();
    each.map(|[g, theta]| g * theta * (-theta / t).exp())
        .sum::<f64>()
        / sum(levels, t)
}

/// `ln (2 pi m k T / h^2)^(3/2)`.
fn moving(mass: f64, t: f64) -> f64 {
    let square = std::f64::consts::TAU * mass * MASS_UNIT * BOLTZMANN * t / (PLANCK * PLANCK);
    1.5 * square.ln()
}

/// Air.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HotAir {
    /// Molecules swing and stay what they are.
    Whole,
    /// They come apart and meet, in equilibrium.
    Reacting,
}

/// Air at a pressure and a temperature.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hot {
    /// Pressure, Pa.
    pub pressure: f64,
    /// Density, kg/m^3.
    pub density: f64,
    /// Temperature, K.
    pub temperature: f64,
    /// Specific enthalpy, J/kg, above that of atoms at rest.
    pub enthalpy: f64,
}

impl HotAir {
    /// At a pressure, Pa, and a temperature, K.
    ///
    /// # Errors
    /// A temperature outside 200 to 15 000 K.
    pub fn at(self, pressure: f64, temperature: f64) -> Result<Hot, ExactError> {
        let holds = (RANGE[0]..=RANGE[1]).contains(&temperature);
        require(holds, "the temperature", temperature, "200 to 15000 K")?;
        Ok(match self {
            Self::Whole => whole(pressure, temperature),
            // No molecule comes apart.
            Self::Reacting if temperature < 500.0 => whole(pressure, temperature),
            Self::Reacting => reacting(pressure, temperature),
        })
    }

    /// At a pressure, Pa, and an enthalpy, J/kg above that of atoms at rest.
    ///
    /// # Errors
    /// Gas that is too hot or too cold.
    pub fn of_enthalpy(self, pressure: f64, enthalpy: f64) -> Result<Hot, ExactError> {
        let off = |t: f64| {
            self.at(pressure, t)
                .map_or(f64::NAN, |hot| hot.enthalpy - enthalpy)
        };
        self.at(pressure, bracketed_root(off, RANGE[0], RANGE[1]))
    }

    /// Behind a shock that gas runs into at `speed`, m/s: mass, momentum and total enthalpy go through it unchanged [Rankine; Hugoniot].
    ///
    /// # Errors
    /// Gas that is too hot or too cold.
    pub fn normal_shock(self, ahead: &Hot, speed: f64) -> Result<Hot, ExactError> {
        let flow = ahead.density * speed;
        let mut ratio = 0.1;
        let mut behind = *ahead;
        for _ in 0..400 {
            let pressure = ahead.pressure + flow * speed * (1.0 - ratio);
            let enthalpy = ahead.enthalpy + 0.5 * speed * speed * (1.0 - ratio * ratio);
            behind = self.of_enthalpy(pressure, enthalpy)?;
            let next = ahead.density / behind.density;
            let step = next - ratio;
            ratio = next;
            if step.abs() < 1e-13 {
                break;
            }
        }
        Ok(behind)
    }

    /// Behind the shock that a wall sends into gas that runs into it at `speed`, m/s, and how fast that shock leaves the wall.
    ///
    /// # Errors
    /// Gas that is too hot or too cold.
    pub fn stopped(self, ahead: &Hot, speed: f64) -> Result<(Hot, f64), ExactError> {
        let mut front = 0.2 * speed;
        let mut behind = *ahead;
        for _ in 0..400 {
            behind = self.normal_shock(ahead, speed + front)?;
            // As much comes in as the layer behind the shock grows by.
            let next = speed * ahead.density / (behind.density - ahead.density);
            let step = next - front;
            front = next;
            if step.abs() < 1e-12 * speed {
                break;
            }
        }
        Ok((behind, front))
    }

    /// Behind the weak shock at a wedge that turns gas of `speed` by `angle`, and the angle of that shock, both in radians.
    ///
    /// # Errors
    /// Gas that is too hot or too cold, and a wedge that no shock is attached to.
    pub fn oblique_shock(
        self,
        ahead: &Hot,
        speed: f64,
        angle: f64,
    ) -> Result<(Hot, f64), ExactError> {
        let turned = |wave: f64| -> Result<f64, ExactError> {
            let behind = self.normal_shock(ahead, speed * wave.sin())?;
            let ratio = ahead.density / behind.density;
            Ok(wave - (ratio * wave.tan()).atan())
        };
        // Weak shocks lie between the wedge and where the turn is largest, not far above 60 degrees.
        let most = 60_f64.to_radians();
        require(
            turned(most)? > angle,
            "the angle of the wedge",
            angle.to_degrees(),
            "shocks of less than 60 degrees",
        )?;
        let off = |wave: f64| turned(wave).map_or(f64::NAN, |turn| turn - angle);
        let wave = bracketed_root(off, 1.05 * angle, most);
        Ok((self.normal_shock(ahead, speed * wave.sin())?, wave))
    }
}

/// Mass of a molecule of cold air, kg.
fn mean_mass() -> f64 {
    let parts = FRACTIONS.iter().zip(MASSES);
    MASS_UNIT * parts.map(|(part, mass)| part * mass).sum::<f64>()
}

fn whole(pressure: f64, t: f64) -> Hot {
    let [nitrogen, oxygen, argon] = FRACTIONS;
    let enthalpy = nitrogen * NITROGEN.enthalpy(t) + oxygen * OXYGEN.enthalpy(t) + argon * 2.5 * t;
    Hot {
        pressure,
        density: pressure * mean_mass() / (BOLTZMANN * t),
        temperature: t,
        enthalpy: BOLTZMANN * enthalpy / mean_mass(),
    }
}

/// Of the atoms `x` and `y` in a cubic metre follow the molecules by the law of mass action; `y` from how many nuclei of nitrogen there are to
/// one of oxygen, a quadratic equation, and `x` from the pressure.
fn reacting(pressure: f64, t: f64) -> Hot {
    let atoms = [
        moving(14.0067, t) + sum(&NITROGEN_ATOM_LEVELS, t).ln(),
        moving(15.9994, t) + sum(&OXYGEN_ATOM_LEVELS, t).ln(),
    ];
    let met = [
        (NITROGEN.partition(t) - 2.0 * atoms[0]).exp(),
        (OXYGEN.partition(t) - 2.0 * atoms[1]).exp(),
        (NITRIC_OXIDE.partition(t) - atoms[0] - atoms[1]).exp(),
    ];
    let to_one = FRACTIONS[0] / FRACTIONS[1];
    let amounts = |x: f64| {
        let a = 2.0 * to_one * met[1];
        let b = to_one + (to_one - 1.0) * met[2] * x;
        let c = -x - 2.0 * met[0] * x * x;
        let y = -2.0 * c / (b + (b * b - 4.0 * a * c).sqrt());
        let nuclei = y + 2.0 * met[1] * y * y + met[2] * x * y;
        let argon = 0.5 * nuclei * FRACTIONS[2] / FRACTIONS[1];
        [met[0] * x * x, met[1] * y * y, met[2] * x * y, x, y, argon]
    };
    let all = pressure / (BOLTZMANN * t);
    let off = |log: f64| amounts(log.exp()).iter().sum::<f64>() / all - 1.0;
    let amounts = amounts(bracketed_root(off, all.ln() - 300.0, all.ln()).exp());
    let masses = [28.0134, 31.9988, 30.0061, 14.0067, 15.9994, 39.948];
    let enthalpies = [
        NITROGEN.enthalpy(t),
        OXYGEN.enthalpy(t),
        NITRIC_OXIDE.enthalpy(t),
        2.5 * t + mean(&NITROGEN_ATOM_LEVELS, t),
        2.5 * t + mean(&OXYGEN_ATOM_LEVELS, t),
        2.5 * t,
    ];
    let density = MASS_UNIT * dot(&amounts, &masses);
    Hot {
        pressure,
        density,
        temperature: t,
        enthalpy: BOLTZMANN * dot(&amounts, &enthalpies) / density,
    }
}

fn dot(a: &[f64; 6], b: &[f64; 6]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// Air at 60 km of the U.S. Standard Atmosphere 1976.
    fn high() -> Hot {
        HotAir::Reacting.at(21.9587, 247.021).unwrap()
    }

    /// Density ratio, pressure, Pa, and temperature, K, behind normal shocks at 60 km by Cantera 3.2, from the NASA Glenn polynomials and
    /// with ions.
    #[test]
    fn shocks_of_a_return_to_earth_are_those_of_another_code() {
        for (speed, ratio, pressure, temperature) in [
            (2000.0, 6.1842, 1060.4, 1927.2),
            (4000.0, 11.161, 4532.9, 3814.8),
            (6000.0, 14.309, 10_391.3, 5747.0),
            (7500.0, 16.792, 16_404.0, 6532.1),
        ] {
            let ahead = high();
            let behind = HotAir::Reacting.normal_shock(&ahead, speed).unwrap();
            assert_relative_eq!(behind.density / ahead.density, ratio, max_relative = 0.015);
            assert_relative_eq!(behind.pressure, pressure, max_relative = 5e-3);
            assert_relative_eq!(behind.temperature, temperature, max_relative = 0.01);
        }
    }

    /// Cold air is an ideal gas: behind its shocks are the states of NACA 1135.
    #[test]
    fn weak_shocks_in_cold_air_are_those_of_an_ideal_gas() {
        let ahead = HotAir::Whole.at(1e5, 300.0).unwrap();
        let sound = (1.4 * ahead.pressure / ahead.density).sqrt();
        let behind = HotAir::Whole.normal_shock(&ahead, 1.5 * sound).unwrap();
        assert_relative_eq!(
            behind.pressure / ahead.pressure,
            2.4583,
            max_relative = 3e-3
        );
        assert_relative_eq!(behind.density / ahead.density, 1.8621, max_relative = 5e-3);
        let (_, wave) = HotAir::Whole
            .oblique_shock(&ahead, 3.0 * sound, 20_f64.to_radians())
            .unwrap();
        assert_relative_eq!(wave.to_degrees(), 37.764, max_relative = 2e-3);
    }

    /// Behind it the gas is at rest: its own shock at that speed, seen from the wall.
    #[test]
    fn gas_that_is_stopped_rests() {
        let ahead = high();
        let (behind, front) = HotAir::Reacting.stopped(&ahead, 7000.0).unwrap();
        let slower = ahead.density * (7000.0 + front) / behind.density;
        assert_relative_eq!(slower, front, max_relative = 1e-9);
    }

    /// Mass, momentum and energy go through.
    #[test]
    fn nothing_is_lost_in_a_shock() {
        let ahead = HotAir::Whole.at(1e4, 900.0).unwrap();
        let speed = 2800.0;
        let behind = HotAir::Whole.normal_shock(&ahead, speed).unwrap();
        let after = ahead.density * speed / behind.density;
        let push = |hot: &Hot, u: f64| hot.pressure + hot.density * u * u;
        assert_relative_eq!(
            push(&behind, after),
            push(&ahead, speed),
            max_relative = 1e-9
        );
        let total = |hot: &Hot, u: f64| hot.enthalpy + 0.5 * u * u;
        let off = total(&behind, after) - total(&ahead, speed);
        assert!(off.abs() < 1e-6 * speed * speed, "{off}");
    }

    #[test]
    fn gas_that_is_too_hot_is_refused() {
        assert!(HotAir::Whole.at(1e5, 2e4).is_err());
    }
}
