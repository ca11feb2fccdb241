//! Quasi-one-dimensional flow through the Back nozzle: choked, and with an internal normal shock.
//!
//! The area mean of a real nozzle follows this closely; its centre line does not (the sonic line is
//! curved). Sources: Back, Massier & Gier, "Comparison of measured and predicted flows through
//! conical supersonic nozzles", AIAA J. 3 (1965) 1606 (doi:10.2514/3.3216), for the shape, in the simplified form of the
//! Eilmer example set (Gibbons et al., Comput. Phys. Commun. 282 (2023) 108551,
//! doi:10.1016/j.cpc.2022.108551); Anderson, "Modern Compressible Flow", chapter 5, for the flow.

use super::isentropic::{self, Branch, mach_from_area};
use super::root::bracketed_root;
use super::{ExactError, normal, require};

/// How the height of a nozzle makes its area.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Section {
    /// Between two plates: the area grows with the height.
    Planar,
    /// Round: the area grows with the height squared.
    Axisymmetric,
}

/// Wall of the Back nozzle: a straight tube, an arc of the tube's radius about the axis, an arc
/// about the throat, and a straight divergent part. Lengths in one unit, `x = 0` at the throat.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BackNozzle {
    /// Half-height (radius) of the tube, and radius of the first contraction arc.
    pub tube: f64,
    /// Half-height of the throat.
    pub throat: f64,
    /// Radius of the wall at the throat.
    pub curve: f64,
    /// Half-angle of the divergent part, radians.
    pub divergence: f64,
}

impl BackNozzle {
    /// The example set's dimensions, in inches, 15 degrees of divergence.
    pub fn in_inches() -> Self {
        Self {
            tube: 1.5955,
            throat: 0.775,
            curve: 1.55,
            divergence: 15_f64.to_radians(),
        }
    }

    /// Abscissas where the tube, the first arc, the throat arc and the cone begin (without 0).
    pub fn joints(&self) -> [f64; 3] {
        let reach = self.tube + self.curve;
        let height = self.throat + self.curve;
        let start = (reach * reach - height * height).sqrt();
        [
            -start,
            -start * self.curve / reach,
            self.curve * self.divergence.sin(),
        ]
    }

    /// Half-height of the channel at `x`.
    pub fn half_height(&self, x: f64) -> f64 {
        let [tube_end, first_end, cone] = self.joints();
        let arc =
            |x: f64| self.throat + self.curve - (self.curve * self.curve - x * x).max(0.0).sqrt();
        if x <= tube_end {
            self.tube
        } else if x <= first_end {
            let from = x - tube_end;
            (self.tube * self.tube - from * from).max(0.0).sqrt()
        } else if x <= cone {
            arc(x)
        } else {
            arc(cone) + (x - cone) * self.divergence.tan()
        }
    }

    /// Area at `x` over that of the throat.
    pub fn area_ratio(&self, x: f64, section: Section) -> f64 {
        let ratio = self.half_height(x) / self.throat;
        match section {
            Section::Planar => ratio,
            Section::Axisymmetric => ratio * ratio,
        }
    }

    /// Mach number at `x` of the choked flow without a shock.
    pub fn mach(&self, x: f64, section: Section, gamma: f64) -> Result<f64, ExactError> {
        let branch = if x < 0.0 {
            Branch::Subsonic
        } else {
            Branch::Supersonic
        };
        mach_from_area(self.area_ratio(x, section).max(1.0), branch, gamma)
    }
}

/// A normal shock standing in the divergent part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InternalShock {
    /// Area at the shock over the throat's.
    pub area_ratio: f64,
    /// Mach number ahead.
    pub mach_ahead: f64,
    /// Mach number behind.
    pub mach_behind: f64,
    /// Total pressure behind over that ahead.
    pub total_pressure_ratio: f64,
    /// Mach number at the exit.
    pub exit_mach: f64,
    /// Pressure at the exit over the total pressure at the inlet.
    pub exit_pressure_ratio: f64,
}

/// The flow with a shock where the area is `shock_area` throats, the exit's area being `exit_area`
/// throats.
pub fn internal_shock(
    shock_area: f64,
    exit_area: f64,
    gamma: f64,
) -> Result<InternalShock, ExactError> {
    require(
        shock_area >= 1.0 && shock_area <= exit_area,
        "the ratio of the shock's area to the throat's",
        shock_area,
        "values from 1 to the exit's",
    )?;
    let mach_ahead = mach_from_area(shock_area, Branch::Supersonic, gamma)?;
    let shock = normal::jump(mach_ahead, gamma);
    // Behind the shock the stream is isentropic again, with a larger sonic area A*2 = A*1 p01/p02.
    let exit = (exit_area * shock.total_pressure_ratio).max(1.0);
    let exit_mach = mach_from_area(exit, Branch::Subsonic, gamma)?;
    Ok(InternalShock {
        area_ratio: shock_area,
        mach_ahead,
        mach_behind: shock.mach,
        total_pressure_ratio: shock.total_pressure_ratio,
        exit_mach,
        exit_pressure_ratio: shock.total_pressure_ratio
            / isentropic::pressure_ratio(exit_mach, gamma),
    })
}

/// The shock that a back pressure of `back_pressure` inlet total pressures puts inside the nozzle.
pub fn shock_for_back_pressure(
    back_pressure: f64,
    exit_area: f64,
    gamma: f64,
) -> Result<InternalShock, ExactError> {
    let at_exit = internal_shock(exit_area, exit_area, gamma)?.exit_pressure_ratio;
    let at_throat = internal_shock(1.0, exit_area, gamma)?.exit_pressure_ratio;
    require(
        (at_exit..=at_throat).contains(&back_pressure),
        "the back pressure over the inlet's total pressure",
        back_pressure,
        "values that hold a shock between throat and exit",
    )?;
    let excess = |area: f64| {
        internal_shock(area, exit_area, gamma).map_or(f64::NAN, |s| s.exit_pressure_ratio)
            - back_pressure
    };
    internal_shock(bracketed_root(excess, 1.0, exit_area), exit_area, gamma)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reference;
    use approx::{assert_abs_diff_eq, assert_relative_eq};

    #[test]
    fn the_joints_lie_where_the_example_puts_them() {
        let nozzle = BackNozzle::in_inches();
        let [x1, x2, x4] = nozzle.joints();
        assert_abs_diff_eq!(x1, -2.118_619, epsilon = 1e-6);
        assert_abs_diff_eq!(x2, -1.043_986, epsilon = 1e-6);
        assert_abs_diff_eq!(x4, 0.401_170, epsilon = 1e-6);
        assert_abs_diff_eq!(nozzle.half_height(x2), 1.179_316, epsilon = 1e-6);
        assert_abs_diff_eq!(nozzle.half_height(x4), 0.827_815, epsilon = 1e-6);
        assert_abs_diff_eq!(nozzle.half_height(3.0), 1.524_169, epsilon = 1e-6);
    }

    #[test]
    fn the_quasi_one_dimensional_tables_are_reproduced() {
        let nozzle = BackNozzle::in_inches();
        for (table, section) in [
            (reference::nozzle_planar(), Section::Planar),
            (reference::nozzle_axisymmetric(), Section::Axisymmetric),
        ] {
            for row in 0..table.len() {
                let get = |name: &str| table.column(name).unwrap()[row];
                let x = get("x_in");
                assert_abs_diff_eq!(nozzle.half_height(x), get("y_in"), epsilon = 1e-6);
                let area = nozzle.area_ratio(x, section);
                assert_relative_eq!(area, get("A_At"), max_relative = 1e-6);
                let mach = nozzle.mach(x, section, 1.4).unwrap();
                // The Mach number rises as the square root of the area at the throat.
                assert_abs_diff_eq!(mach, get("M"), epsilon = 2e-6);
                let pressure = 1.0 / isentropic::pressure_ratio(mach, 1.4);
                assert_abs_diff_eq!(pressure, get("p_p0"), epsilon = 2e-6);
            }
        }
    }

    #[test]
    fn internal_shocks_agree_with_the_reference_table_both_ways() {
        let nozzle = BackNozzle::in_inches();
        let exit = nozzle.area_ratio(3.0, Section::Planar);
        let table = reference::nozzle_internal_shock();
        for row in 0..table.len() {
            let get = |name: &str| table.column(name).unwrap()[row];
            let area = nozzle.area_ratio(get("x_shock_in"), Section::Planar);
            let shock = internal_shock(area, exit, 1.4).unwrap();
            assert_relative_eq!(shock.mach_ahead, get("M1"), max_relative = 1e-6);
            assert_relative_eq!(shock.mach_behind, get("M2"), max_relative = 1e-6);
            assert_relative_eq!(
                shock.total_pressure_ratio,
                get("p02_p01"),
                max_relative = 1e-6
            );
            assert_relative_eq!(shock.exit_mach, get("Me"), max_relative = 1e-6);
            assert_relative_eq!(
                shock.exit_pressure_ratio,
                get("pe_p01"),
                max_relative = 1e-6
            );
            let back = shock_for_back_pressure(shock.exit_pressure_ratio, exit, 1.4).unwrap();
            assert_relative_eq!(back.area_ratio, area, max_relative = 1e-6);
        }
    }

    #[test]
    fn a_back_pressure_that_empties_the_nozzle_of_its_shock_is_refused() {
        assert!(shock_for_back_pressure(0.1, 1.9667, 1.4).is_err());
        assert!(shock_for_back_pressure(0.99, 1.9667, 1.4).is_err());
    }
}
