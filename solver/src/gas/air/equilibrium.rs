//! What air is made of in chemical equilibrium: `N2`, `O2`, `NO`, `N`, `O`, `NO+`, `N+`, `O+`, electrons and argon.
//!
//! Of species `j` there are `c_j = (p0 / (R T)) exp(-G_j / (R T)) a^n_j b^o_j q^z_j` moles to a volume, with `n_j` atoms of nitrogen, `o_j` of
//! oxygen and `z_j` charges; `a`, `b` and `q` follow from how much nitrogen, oxygen and charge there is [e.g. Vincenti & Kruger
//! 1965, Introduction to Physical Gas Dynamics, chapter III; Gordon & `McBride` 1994, NASA RP-1311, section 2.3].

use super::mixture::{FRACTIONS, moles};
use super::species::{STANDARD_PRESSURE, Species, UNIVERSAL};

/// The neutral ones, with their atoms of nitrogen and oxygen.
const NEUTRAL: [(Species, [f64; 2]); 5] = [
    (Species::NITROGEN, [2.0, 0.0]),
    (Species::OXYGEN, [0.0, 2.0]),
    (Species::NITRIC_OXIDE, [1.0, 1.0]),
    (Species::NITROGEN_ATOM, [1.0, 0.0]),
    (Species::OXYGEN_ATOM, [0.0, 1.0]),
];

/// Those of one positive charge.
const IONS: [(Species, [f64; 2]); 3] = [
    (Species::NITRIC_OXIDE_ION, [1.0, 1.0]),
    (Species::NITROGEN_ION, [1.0, 0.0]),
    (Species::OXYGEN_ION, [0.0, 1.0]),
];

/// Number of species, argon and electrons last.
const ALL: usize = NEUTRAL.len() + IONS.len() + 2;

/// Steps of Newton's method; some five do.
const STEPS: usize = 200;

/// How far a step of it may go, in logarithms.
const FARTHEST: f64 = 3.0;

/// Off by so little, part of each element, amounts are right.
const EXACT: f64 = 1e-13;

/// What all species hold at a temperature.
#[derive(Clone, Copy, Debug)]
pub struct Level {
    temperature: f64,
    /// `-G / (R T) + ln(p0 / (R T))` of each species.
    potentials: [f64; ALL],
    /// `H / (R T)` of each.
    enthalpies: [f64; ALL],
    /// `S / R + ln(p0 / (R T))` of each: that of a mole to a cubic metre.
    entropies: [f64; ALL],
}

impl Level {
    /// At a temperature, K.
    pub fn at(temperature: f64) -> Self {
        let neutral = NEUTRAL.iter().map(|(species, _)| species);
        let ions = IONS.iter().map(|(species, _)| species);
        let others = [Species::ARGON, Species::ELECTRON];
        let standard = (STANDARD_PRESSURE / (UNIVERSAL * temperature)).ln();
        let [mut potentials, mut enthalpies, mut entropies] = [[0.0; ALL]; 3];
        for (k, species) in neutral.chain(ions).chain(&others).enumerate() {
            let molar = species.at(temperature);
            potentials[k] = standard - molar.gibbs();
            enthalpies[k] = molar.enthalpy;
            entropies[k] = standard + molar.entropy;
        }
        Self {
            temperature,
            potentials,
            enthalpies,
            entropies,
        }
    }
}

/// Air in equilibrium.
#[derive(Clone, Copy, Debug)]
pub struct Mixture {
    /// `ln a` and `ln b`.
    potentials: [f64; 2],
    /// Pressure over density, J/kg.
    pub heat: f64,
    /// Specific internal energy, J/kg, from the elements at 298.15 K.
    pub energy: f64,
    /// Specific entropy, J/(kg K).
    pub entropy: f64,
    /// Moles of each species in a kilogram: `N2`, `O2`, `NO`, `N`, `O`, `NO+`, `N+`, `O+`, `Ar`, electrons.
    #[cfg(test)]
    pub moles: [f64; ALL],
}

impl Mixture {
    /// At a temperature's `level` and a density; the search begins with what is found at one nearby, if there is one.
    pub fn new(level: &Level, density: f64, nearby: Option<&Self>) -> Self {
        let cold = moles();
        let [nitrogen, oxygen, argon] = FRACTIONS.map(|part| part * cold);
        let wanted = [2.0 * nitrogen * density, 2.0 * oxygen * density];
        let mut potentials = nearby.map_or_else(
            || {
                let whole = |k: usize| 0.5 * ((0.5 * wanted[k]).ln() - level.potentials[k]);
                [whole(0), whole(1)]
            },
            |nearby| nearby.potentials,
        );
        let mut amounts = [0.0; ALL];
        for _ in 0..STEPS {
            let (sums, slopes) = sums(level, potentials, &mut amounts);
            let off = [0, 1].map(|k| (sums[k] / wanted[k]).ln());
            let relative = |k: usize, l: usize| slopes[k][l] / sums[k];
            let [[a, b], [c, d]] = [0, 1].map(|k| [relative(k, 0), relative(k, 1)]);
            let determinant = a * d - b * c;
            let steps = [
                (b * off[1] - d * off[0]) / determinant,
                (c * off[0] - a * off[1]) / determinant,
            ];
            for (potential, step) in potentials.iter_mut().zip(steps) {
                *potential += step.clamp(-FARTHEST, FARTHEST);
            }
            if off[0].abs().max(off[1].abs()) < EXACT {
                break;
            }
        }
        amounts[ALL - 2] = argon * density;
        let heat_of_mole = UNIVERSAL * level.temperature;
        let moles = amounts.map(|amount| amount / density);
        let all = || moles.iter().zip(level.enthalpies);
        let mixed = |(amount, entropy): (&f64, &f64)| {
            if *amount > 0.0 {
                amount * (entropy - amount.ln())
            } else {
                0.0
            }
        };
        let entropy: f64 = amounts.iter().zip(&level.entropies).map(mixed).sum();
        Self {
            potentials,
            heat: heat_of_mole * moles.iter().sum::<f64>(),
            energy: heat_of_mole * all().map(|(moles, h)| moles * (h - 1.0)).sum::<f64>(),
            entropy: UNIVERSAL * entropy / density,
            #[cfg(test)]
            moles,
        }
    }
}

/// Moles to a volume of all species where `ln a` and `ln b` are these, how many of them are nitrogen's and oxygen's, and how these change.
fn sums(
    level: &Level,
    potentials: [f64; 2],
    amounts: &mut [f64; ALL],
) -> ([f64; 2], [[f64; 2]; 2]) {
    let (mut sums, mut slopes) = ([0.0; 2], [[0.0; 2]; 2]);
    let raised = |k: usize, atoms: &[f64; 2]| {
        (level.potentials[k] + atoms[0] * potentials[0] + atoms[1] * potentials[1]).exp()
    };
    for (k, (_, atoms)) in NEUTRAL.iter().enumerate() {
        amounts[k] = raised(k, atoms);
        add(amounts[k], atoms, atoms, &mut sums, &mut slopes);
    }
    let first = NEUTRAL.len();
    let mut ions = [0.0; IONS.len()];
    for (k, (_, atoms)) in IONS.iter().enumerate() {
        ions[k] = raised(first + k, atoms);
    }
    let all: f64 = ions.iter().sum();
    // As many electrons as ions: `c_e^2 = c_e q^-1 sum c_ion q`.
    let electrons = (all * level.potentials[ALL - 1].exp()).sqrt();
    amounts[ALL - 1] = electrons;
    for (k, (_, atoms)) in IONS.iter().enumerate() {
        let amount = if all > 0.0 {
            electrons * (ions[k] / all)
        } else {
            0.0
        };
        amounts[first + k] = amount;
        let mean = |l: usize| {
            let each = IONS.iter().zip(&ions);
            let sum: f64 = each.map(|((_, atoms), ion)| atoms[l] * ion).sum();
            if all > 0.0 { sum / all } else { 0.0 }
        };
        let growth = [atoms[0] - 0.5 * mean(0), atoms[1] - 0.5 * mean(1)];
        add(amount, atoms, &growth, &mut sums, &mut slopes);
    }
    (sums, slopes)
}

/// Adds an amount with so many atoms, that grows so much with each logarithm.
fn add(
    amount: f64,
    atoms: &[f64; 2],
    growth: &[f64; 2],
    sums: &mut [f64; 2],
    slopes: &mut [[f64; 2]; 2],
) {
    for k in 0..2 {
        sums[k] += atoms[k] * amount;
        for l in 0..2 {
            slopes[k][l] += atoms[k] * amount * growth[l];
        }
    }
}
