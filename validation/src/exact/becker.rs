//! The inside of a steady shock of gas with a Prandtl number of 3/4, where total enthalpy is the same all through.
//!
//! Sources: Becker, Z. Phys. 8 (1922) 321 (doi:10.1007/BF01329605); Morduchow & Libby, J. Aeronaut. Sci. 16 (1949) 674.

use super::{ExactError, require_gamma, require_supersonic};

/// Where the density has risen by the `part` of its way, in `mu / m`, `m` the flow of mass per area, from where the flow is sonic or
/// thereabouts. With `v` the velocity over that ahead, `8 gamma / (3 (gamma + 1)) v v' = (v - 1) (v - v_1)`.
fn place(ahead: f64, behind: f64, factor: f64, part: f64) -> f64 {
    let v = 1.0 / (1.0 / ahead + part * (1.0 / behind - 1.0 / ahead));
    factor / (ahead - behind) * ((ahead - v).ln() - behind * (v - behind).ln())
}

/// Distance, in `mu / m`, over which the density rises from a tenth of its way to nine tenths, in a shock of this Mach number.
pub fn width(mach: f64, gamma: f64) -> Result<f64, ExactError> {
    require_gamma(gamma)?;
    require_supersonic(mach)?;
    let square = mach * mach;
    let behind = ((gamma - 1.0) * square + 2.0) / ((gamma + 1.0) * square);
    let factor = 8.0 * gamma / (3.0 * (gamma + 1.0));
    let at = |part| place(1.0, behind, factor, part);
    Ok((at(0.9) - at(0.1)).abs())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn widths_are_those_computed_beforehand() {
        for (mach, expected) in [(2.0, 6.334), (3.0, 4.221)] {
            let found = width(mach, 1.4).unwrap();
            assert!((found - expected).abs() < 6e-4, "{mach}: {found}");
        }
    }

    #[test]
    fn nothing_slower_than_sound_has_a_shock() {
        assert!(width(0.9, 1.4).is_err());
    }
}
