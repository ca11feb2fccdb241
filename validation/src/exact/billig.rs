//! Billig's correlations for the bow shock of a blunt nose in air: stand-off, radius and shape.
//!
//! Fits to experiments and computations, not exact: good to a few per cent near the nose. Source:
//! Billig, "Shock-wave shapes around spherical- and cylindrical-nosed bodies", J. Spacecraft and
//! Rockets 4 (1967) 822 (doi:10.2514/3.28969).

use super::{ExactError, require_supersonic};

/// Shape of the nose.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Nose {
    /// A circular cylinder across the stream (plane flow).
    Cylinder,
    /// A sphere (axisymmetric flow).
    Sphere,
}

/// The bow shock of a nose of unit radius; lengths are in nose radii, `x` points upstream from the
/// nose's centre.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BowShock {
    /// Distance from the nose to the shock on the axis.
    pub stand_off: f64,
    /// Radius of curvature of the shock on the axis.
    pub vertex_radius: f64,
    /// Angle of the shock far downstream, radians.
    pub far_angle: f64,
}

impl BowShock {
    /// Shock of a nose at Mach number `mach`, asymptotic to the Mach angle.
    ///
    /// Cylinder: `delta/R = 0.386 exp(4.67/M^2)`, `Rc/R = 1.386 exp(1.8/(M-1)^0.75)`; sphere:
    /// `0.143 exp(3.24/M^2)`, `1.143 exp(0.54/(M-1)^1.2)`.
    pub fn new(nose: Nose, mach: f64) -> Result<Self, ExactError> {
        require_supersonic(mach)?;
        let (stand_off, vertex_radius) = match nose {
            Nose::Cylinder => (
                0.386 * (4.67 / (mach * mach)).exp(),
                1.386 * (1.8 / (mach - 1.0).powf(0.75)).exp(),
            ),
            Nose::Sphere => (
                0.143 * (3.24 / (mach * mach)).exp(),
                1.143 * (0.54 / (mach - 1.0).powf(1.2)).exp(),
            ),
        };
        Ok(Self {
            stand_off,
            vertex_radius,
            far_angle: (1.0 / mach).asin(),
        })
    }

    /// Position of the shock, upstream of the nose's centre, at distance `y` from the axis
    /// [Billig, the hyperbola]:
    /// `x = R + delta - Rc cot^2(beta) [sqrt(1 + y^2 tan^2(beta)/Rc^2) - 1]`.
    pub fn x(&self, y: f64) -> f64 {
        let lean = self.far_angle.tan();
        let reach = y * lean / self.vertex_radius;
        // sqrt(1 + r^2) - 1 without cancellation.
        let rise = reach * reach / ((1.0 + reach * reach).sqrt() + 1.0);
        1.0 + self.stand_off - self.vertex_radius / (lean * lean) * rise
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reference;
    use approx::{assert_abs_diff_eq, assert_relative_eq};

    #[test]
    fn the_reference_table_is_reproduced() {
        let table = reference::billig();
        for row in 0..table.len() {
            let get = |name: &str| table.column(name).unwrap()[row];
            let nose = if get("sphere") > 0.5 {
                Nose::Sphere
            } else {
                Nose::Cylinder
            };
            let shock = BowShock::new(nose, get("M")).unwrap();
            assert_relative_eq!(shock.stand_off, get("delta_R"), max_relative = 1e-6);
            assert_relative_eq!(shock.vertex_radius, get("Rc_R"), max_relative = 1e-6);
            let angle = shock.far_angle.to_degrees();
            assert_relative_eq!(angle, get("mach_angle_deg"), max_relative = 1e-6);
        }
    }

    #[test]
    fn the_mach_ten_cylinder_shape_is_reproduced() {
        let table = reference::billig_cylinder_shape();
        let shock = BowShock::new(Nose::Cylinder, 10.0).unwrap();
        for row in 0..table.len() {
            let get = |name: &str| table.column(name).unwrap()[row];
            assert_abs_diff_eq!(shock.x(get("y")), get("x_machangle_beta"), epsilon = 1e-6);
        }
    }

    #[test]
    fn the_vertex_has_the_stated_curvature() {
        let shock = BowShock::new(Nose::Sphere, 3.0).unwrap();
        let y = 1e-3;
        let curvature = (2.0 * shock.x(0.0) - shock.x(y) - shock.x(-y)) / (y * y);
        assert_relative_eq!(curvature, 1.0 / shock.vertex_radius, max_relative = 1e-4);
    }
}
