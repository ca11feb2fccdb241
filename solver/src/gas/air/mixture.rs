//! What air is made of.

use super::species::UNIVERSAL;

/// Mole fractions of nitrogen, oxygen and argon in cold air [U.S. Standard Atmosphere 1976, table 3]; carbon dioxide and what there is less
/// of count as argon.
pub const FRACTIONS: [f64; 3] = [0.780_84, 0.209_476, 0.009_684];

/// Molar masses of `N2`, `O2` and `Ar`, kg/mol [the same].
const MASSES: [f64; 3] = [28.0134e-3, 31.9988e-3, 39.948e-3];

/// Moles of molecules in a kilogram of cold air, mol/kg.
pub fn moles() -> f64 {
    let masses = FRACTIONS.iter().zip(MASSES);
    1.0 / masses.map(|(part, mass)| part * mass).sum::<f64>()
}

/// Specific gas constant of cold air, J/(kg K).
pub fn gas_constant() -> f64 {
    UNIVERSAL * moles()
}

#[cfg(test)]
mod tests {
    /// 287.053 of the U.S. Standard Atmosphere 1976, with the gas constant of its day and carbon dioxide as such.
    #[test]
    fn cold_air_has_the_gas_constant_of_the_atmosphere() {
        assert!((super::gas_constant() - 287.053).abs() < 0.02);
    }
}
