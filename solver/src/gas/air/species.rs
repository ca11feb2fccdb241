//! What a mole of each species of air holds: the NASA Glenn polynomials.
//!
//! [`McBride`, Zehe & Gordon 2002, NASA Glenn Coefficients for Calculating Thermodynamic Properties of Individual Species,
//! `NASA/TP-2002-211556`], at a standard pressure of 1 bar, with enthalpies counted from the elements at 298.15 K.

/// Temperatures, K, that the three polynomials of a species reach up to.
const BREAKS: [f64; 2] = [1000.0, 6000.0];

/// Temperatures, K, that they hold for. Beyond them heat capacities stay what they are at the end.
pub const RANGE: [f64; 2] = [200.0, 20_000.0];

/// Universal gas constant, J/(mol K) [CODATA 2018].
pub const UNIVERSAL: f64 = 8.314_462_618;

/// Pressure, Pa, that the polynomials are for.
pub const STANDARD_PRESSURE: f64 = 1e5;

/// A species: the coefficients `a_1` to `a_7`, `b_1`, `b_2` below 1000 K, below 6000 K and above.
#[derive(Clone, Copy, Debug)]
pub struct Species([[f64; 9]; 3]);

/// What a mole of a species holds at a temperature, over the gas constant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Molar {
    /// Heat capacity at constant pressure, `C_p / R`.
    pub capacity: f64,
    /// Enthalpy, `H / (R T)`.
    pub enthalpy: f64,
    /// Entropy at the standard pressure, `S / R`.
    pub entropy: f64,
}

impl Molar {
    /// Gibbs energy at the standard pressure, `G / (R T)`.
    pub fn gibbs(&self) -> f64 {
        self.enthalpy - self.entropy
    }
}

impl Species {
    /// That of these coefficients.
    pub const fn new(coefficients: [[f64; 9]; 3]) -> Self {
        Self(coefficients)
    }

    /// What it holds at a temperature, K.
    pub fn at(&self, temperature: f64) -> Molar {
        let inside = temperature.clamp(RANGE[0], RANGE[1]);
        let end = self.inside(inside);
        if inside == temperature {
            return end;
        }
        let ratio = inside / temperature;
        Molar {
            capacity: end.capacity,
            enthalpy: ratio * end.enthalpy + (1.0 - ratio) * end.capacity,
            entropy: end.entropy - end.capacity * ratio.ln(),
        }
    }

    /// The same within the range: `C_p / R = a_1 T^-2 + a_2 T^-1 + a_3 + a_4 T + a_5 T^2 + a_6 T^3 + a_7 T^4`, and its integrals
    /// [`McBride` et al. 2002, eqs 1 to 3].
    fn inside(&self, t: f64) -> Molar {
        let part = BREAKS.iter().filter(|&&end| t > end).count();
        let [a1, a2, a3, a4, a5, a6, a7, b1, b2] = self.0[part];
        let (over, log) = (1.0 / t, t.ln());
        Molar {
            capacity: (a1 * over + a2) * over + a3 + t * (a4 + t * (a5 + t * (a6 + t * a7))),
            enthalpy: (b1 + a2 * log - a1 * over) * over
                + a3
                + t * (a4 / 2.0 + t * (a5 / 3.0 + t * (a6 / 4.0 + t * a7 / 5.0))),
            entropy: b2 - (a1 * over / 2.0 + a2) * over
                + a3 * log
                + t * (a4 + t * (a5 / 2.0 + t * (a6 / 3.0 + t * a7 / 4.0))),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// Part of a value by which two polynomials may differ where they meet.
    const MEETS: f64 = 1e-5;

    /// Heat capacities, J/(mol K), and enthalpies over that at 298.15 K, kJ/mol, at 1000 and 3000 K
    /// [Chase 1998, NIST-JANAF Thermochemical Tables].
    #[test]
    fn molecules_hold_what_the_tables_say() {
        let tables = [
            (Species::NITROGEN, [[32.697, 21.463], [37.030, 92.715]]),
            (Species::OXYGEN, [[34.870, 22.703], [39.884, 98.013]]),
        ];
        for (species, rows) in tables {
            for (t, [capacity, rise]) in [1000.0, 3000.0].into_iter().zip(rows) {
                let found = species.at(t);
                assert_relative_eq!(found.capacity * UNIVERSAL, capacity, max_relative = 4e-3);
                let enthalpy = found.enthalpy * UNIVERSAL * t / 1e3;
                assert_relative_eq!(enthalpy, rise, max_relative = 2e-3);
            }
        }
    }

    /// `dH = C_p dT` and `dS = C_p dT / T`, within the polynomials and beyond their ends.
    #[test]
    fn enthalpy_and_entropy_are_integrals_of_the_heat_capacity() {
        for species in [
            Species::OXYGEN,
            Species::NITRIC_OXIDE_ION,
            Species::NITROGEN_ATOM,
        ] {
            for t in [120.0, 400.0, 2500.0, 9000.0, 25_000.0] {
                let step = 1e-4 * t;
                let [low, high] = [t - step, t + step].map(|t| (t, species.at(t)));
                let capacity = species.at(t).capacity;
                let heat = high.0 * high.1.enthalpy - low.0 * low.1.enthalpy;
                assert_relative_eq!(heat / (2.0 * step), capacity, max_relative = 1e-6);
                let entropy = t * (high.1.entropy - low.1.entropy) / (2.0 * step);
                assert_relative_eq!(entropy, capacity, max_relative = 1e-6);
            }
        }
    }

    /// The polynomials of a species meet: a wrong digit in one of them shows.
    #[test]
    fn polynomials_meet_where_one_ends() {
        let all = [
            Species::NITROGEN,
            Species::OXYGEN,
            Species::NITRIC_OXIDE,
            Species::NITROGEN_ATOM,
            Species::OXYGEN_ATOM,
            Species::NITRIC_OXIDE_ION,
            Species::NITROGEN_ION,
            Species::OXYGEN_ION,
            Species::ELECTRON,
        ];
        for (number, species) in all.into_iter().enumerate() {
            for end in BREAKS {
                let [below, above] = [1.0 - 1e-12, 1.0 + 1e-12].map(|part| species.at(part * end));
                for (a, b) in [
                    (below.capacity, above.capacity),
                    (below.enthalpy, above.enthalpy),
                    (below.entropy, above.entropy),
                ] {
                    assert!(
                        (a - b).abs() < MEETS * a.abs(),
                        "{number} at {end}: {a}, {b}"
                    );
                }
            }
        }
    }

    /// Heats of formation at 298.15 K, kJ/mol [Chase 1998]: those of atoms are half of what takes the molecules apart.
    #[test]
    fn species_are_formed_with_the_heat_of_the_tables() {
        for (species, heat) in [
            (Species::NITROGEN_ATOM, 472.68),
            (Species::OXYGEN_ATOM, 249.18),
            (Species::NITRIC_OXIDE, 91.27),
            (Species::NITROGEN, 0.0),
            (Species::OXYGEN, 0.0),
            (Species::ARGON, 0.0),
        ] {
            let found = species.at(298.15).enthalpy * UNIVERSAL * 298.15 / 1e3;
            assert!((found - heat).abs() < 0.02, "{found} for {heat}");
        }
    }
}
