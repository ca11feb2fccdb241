//! Shock-expansion theory: the circular-arc (biconvex) aerofoil and the flat plate at incidence.
//!
//! An attached leading-edge shock followed by an isentropic change of direction along the surface;
//! exact for a plate, and for a curved surface up to the waves reflected by the shock, which are
//! weak below Mach 5 or so. Source: Anderson, "Modern Compressible Flow", section 4.15
//! (shock-expansion theory); Ferri, "Elements of Aerodynamics of Supersonic Flows" (1949).

use super::oblique::{ObliqueShock, Strength, oblique_shock};
use super::prandtl_meyer::{expand, mach_from_angle, prandtl_meyer_angle, ratios};
use super::{ExactError, isentropic, require};

/// Gas at a point of a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfacePoint {
    /// Mach number along the surface.
    pub mach: f64,
    /// Pressure over the free stream's.
    pub pressure_ratio: f64,
    /// `(p - p_inf) / (rho_inf u_inf^2 / 2)`.
    pub pressure_coefficient: f64,
}

/// A symmetric aerofoil of two circular arcs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Biconvex {
    thickness: f64,
    mach: f64,
    gamma: f64,
    shock: ObliqueShock,
}

impl Biconvex {
    /// Aerofoil of thickness `thickness` (maximum over chord, up to 1) in a stream of Mach number
    /// `mach`.
    pub fn new(thickness: f64, mach: f64, gamma: f64) -> Result<Self, ExactError> {
        require(
            thickness > 0.0 && thickness <= 1.0,
            "the aerofoil's thickness over chord",
            thickness,
            "values above 0 and up to 1",
        )?;
        let nose = 2.0 * thickness.atan();
        let shock = oblique_shock(mach, nose, gamma, Strength::Weak)?;
        Ok(Self {
            thickness,
            mach,
            gamma,
            shock,
        })
    }

    /// The shock at the leading edge.
    pub fn leading_shock(&self) -> ObliqueShock {
        self.shock
    }

    /// Radius of each arc over the chord: `(1 + t^2) / (4 t)`, `t` the thickness over chord.
    pub fn arc_radius(&self) -> f64 {
        (1.0 + self.thickness * self.thickness) / (4.0 * self.thickness)
    }

    /// Inclination of the upper surface at `x` chords from the leading edge, radians.
    pub fn slope(&self, x: f64) -> f64 {
        ((0.5 - x) / self.arc_radius()).clamp(-1.0, 1.0).asin()
    }

    /// Height of the upper surface at `x` chords from the leading edge, in chords.
    pub fn height(&self, x: f64) -> f64 {
        let radius = self.arc_radius();
        let along = 0.5 - x;
        (radius * radius - along * along).max(0.0).sqrt() - (radius - 0.5 * self.thickness)
    }

    /// Gas on either surface at `x` chords from the leading edge, `0 <= x <= 1`, at no incidence.
    pub fn surface(&self, x: f64) -> Result<SurfacePoint, ExactError> {
        self.behind(&self.shock, x)
    }

    /// Gas at `x` chords on a surface whose leading edge makes this shock.
    fn behind(&self, shock: &ObliqueShock, x: f64) -> Result<SurfacePoint, ExactError> {
        require(
            (0.0..=1.0).contains(&x),
            "the chordwise position",
            x,
            "0 to 1 chords",
        )?;
        let turned = self.slope(0.0) - self.slope(x);
        let start = prandtl_meyer_angle(shock.mach, self.gamma);
        let mach = mach_from_angle(start + turned.max(0.0), self.gamma)?;
        let pressure_ratio = shock.pressure_ratio * ratios(shock.mach, mach, self.gamma)[0];
        Ok(SurfacePoint {
            mach,
            pressure_ratio,
            pressure_coefficient: isentropic::pressure_coefficient(
                pressure_ratio,
                self.mach,
                self.gamma,
            ),
        })
    }

    /// Wave drag of both surfaces at no incidence over `rho_inf u_inf^2 / 2` times the chord.
    pub fn drag_coefficient(&self) -> Result<f64, ExactError> {
        Ok(self.at_incidence(0.0)?.drag)
    }

    /// Lift and wave drag at `incidence` radians, of a size up to the slope of the leading edge: above, the stream turns by as much
    /// less there, below by as much more. The chord line carries `int (Cp_below - Cp_above) dx` across and
    /// `int (Cp_below + Cp_above) tan(slope) dx` along it, by Simpson's rule.
    pub fn at_incidence(&self, incidence: f64) -> Result<Loads, ExactError> {
        const INTERVALS: usize = 400;
        let nose = self.shock.deflection;
        require(
            incidence.abs() <= nose,
            "the incidence in radians",
            incidence,
            "angles up to the slope of the leading edge",
        )?;
        let shock = |turn| oblique_shock(self.mach, turn, self.gamma, Strength::Weak);
        let (above, below) = (shock(nose - incidence)?, shock(nose + incidence)?);
        let (mut across, mut along) = (0.0, 0.0);
        for k in 0..=INTERVALS {
            let x = k as f64 / INTERVALS as f64;
            let weight = match k {
                0 | INTERVALS => 1.0,
                _ if k % 2 == 1 => 4.0,
                _ => 2.0,
            } / (3.0 * INTERVALS as f64);
            let [above, below] = [&above, &below].map(|shock| self.behind(shock, x));
            let (above, below) = (above?.pressure_coefficient, below?.pressure_coefficient);
            across += weight * (below - above);
            along += weight * (below + above) * self.slope(x).tan();
        }
        let (sin, cos) = incidence.sin_cos();
        Ok(Loads {
            lift: across * cos - along * sin,
            drag: across * sin + along * cos,
        })
    }
}

/// Coefficients of an aerofoil, over `rho_inf u_inf^2 / 2` times the chord.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Loads {
    /// Lift.
    pub lift: f64,
    /// Wave drag.
    pub drag: f64,
}

/// A thin flat plate at incidence.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FlatPlate {
    /// Pressure on the lower, windward side over the free stream's.
    pub windward_pressure_ratio: f64,
    /// Pressure on the upper, leeward side over the free stream's.
    pub leeward_pressure_ratio: f64,
    /// Force normal to the plate over `rho_inf u_inf^2 / 2` times the chord.
    pub normal_force: f64,
    /// Lift coefficient.
    pub lift: f64,
    /// Wave-drag coefficient.
    pub drag: f64,
}

/// Plate at `incidence` radians (not negative) in a stream of Mach number `mach`.
pub fn flat_plate(mach: f64, incidence: f64, gamma: f64) -> Result<FlatPlate, ExactError> {
    let windward = oblique_shock(mach, incidence, gamma, Strength::Weak)?.pressure_ratio;
    let leeward = expand(mach, incidence, gamma)?.pressure_ratio;
    let normal_force = 2.0 * (windward - leeward) / (gamma * mach * mach);
    Ok(FlatPlate {
        windward_pressure_ratio: windward,
        leeward_pressure_ratio: leeward,
        normal_force,
        lift: normal_force * incidence.cos(),
        drag: normal_force * incidence.sin(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reference;
    use approx::{assert_abs_diff_eq, assert_relative_eq};

    #[test]
    fn the_biconvex_reference_table_is_reproduced() {
        let aerofoil = Biconvex::new(0.1, 4.04, 1.4).unwrap();
        let table = reference::biconvex();
        for row in 0..table.len() {
            let get = |name: &str| table.column(name).unwrap()[row];
            let x = get("x_c");
            let point = aerofoil.surface(x).unwrap();
            assert_abs_diff_eq!(aerofoil.height(x), get("y_c"), epsilon = 1e-8);
            let slope = aerofoil.slope(x).to_degrees();
            assert_abs_diff_eq!(slope, get("theta_deg"), epsilon = 1e-6);
            assert_relative_eq!(point.mach, get("M"), max_relative = 1e-6);
            assert_relative_eq!(point.pressure_ratio, get("p_pinf"), max_relative = 1e-6);
            assert_abs_diff_eq!(point.pressure_coefficient, get("Cp"), epsilon = 1e-7);
        }
        assert_abs_diff_eq!(
            aerofoil.leading_shock().angle.to_degrees(),
            23.402,
            epsilon = 1e-3
        );
    }

    #[test]
    fn the_biconvex_drag_is_the_published_figure() {
        let drag = Biconvex::new(0.1, 4.04, 1.4)
            .unwrap()
            .drag_coefficient()
            .unwrap();
        assert_abs_diff_eq!(drag, 0.014_284, epsilon = 1e-6);
    }

    #[test]
    fn a_thin_aerofoil_lifts_as_linear_theory_says_and_its_drag_grows_with_the_lift() {
        let (mach, incidence) = (2.0_f64, 1e-4);
        let thin = Biconvex::new(1e-3, mach, 1.4).unwrap();
        let loads = thin.at_incidence(incidence).unwrap();
        // Ackeret: 4 alpha / b, and a drag of that times alpha above that at no incidence.
        let lift = 4.0 * incidence / (mach * mach - 1.0).sqrt();
        assert_relative_eq!(loads.lift, lift, max_relative = 1e-3);
        let more = loads.drag - thin.drag_coefficient().unwrap();
        assert_relative_eq!(more, lift * incidence, max_relative = 1e-2);
        let turned = thin.at_incidence(-incidence).unwrap();
        assert_abs_diff_eq!(turned.lift, -loads.lift, epsilon = 1e-15);
        assert!(thin.at_incidence(0.1).is_err());
    }

    #[test]
    fn the_plate_at_five_degrees_and_mach_three_is_reproduced() {
        let plate = flat_plate(3.0, 5_f64.to_radians(), 1.4).unwrap();
        assert_abs_diff_eq!(plate.windward_pressure_ratio, 1.453_98, epsilon = 1e-5);
        assert_abs_diff_eq!(plate.leeward_pressure_ratio, 0.667_61, epsilon = 1e-5);
        assert_abs_diff_eq!(plate.normal_force, 0.124_82, epsilon = 1e-5);
        assert_abs_diff_eq!(plate.drag, 0.010_88, epsilon = 1e-5);
    }

    #[test]
    fn small_incidence_tends_to_linear_theory() {
        // Ackeret: lift 4 alpha / sqrt(M^2 - 1).
        let plate = flat_plate(2.0, 1e-4, 1.4).unwrap();
        assert_relative_eq!(plate.lift, 4e-4 / 3_f64.sqrt(), max_relative = 1e-3);
    }

    #[test]
    fn a_thick_aerofoil_detaches_its_shock() {
        assert!(matches!(
            Biconvex::new(0.5, 2.0, 1.4),
            Err(ExactError::Detached { .. })
        ));
    }
}
