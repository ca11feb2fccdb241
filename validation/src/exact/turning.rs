//! Viscous gas between a cylinder that turns and a round hole at rest.
//!
//! Source: Taylor, Phil. Trans. R. Soc. A 223 (1923) 289-343, eq. 1: the speed is `A r + B / r` whatever the viscosity.

/// A cylinder in a hole about the same axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TurningCylinder {
    /// Radius of the cylinder.
    pub inner: f64,
    /// Radius of the hole.
    pub outer: f64,
    /// Angular velocity of the cylinder.
    pub rate: f64,
    /// Dynamic viscosity.
    pub viscosity: f64,
}

impl TurningCylinder {
    /// Speed of the gas around the axis at a radius.
    pub fn speed(&self, radius: f64) -> f64 {
        self.swirl() * (1.0 / radius - radius / (self.outer * self.outer))
    }

    /// Moment on the cylinder over its length, against its turn: `4 pi mu B`.
    pub fn moment(&self) -> f64 {
        4.0 * std::f64::consts::PI * self.viscosity * self.swirl()
    }

    /// `B`.
    fn swirl(&self) -> f64 {
        let [inner, outer] = [self.inner, self.outer].map(|r| r * r);
        self.rate * inner * outer / (outer - inner)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const GAP: TurningCylinder = TurningCylinder {
        inner: 0.25,
        outer: 0.5,
        rate: 0.4,
        viscosity: 0.0025,
    };

    #[test]
    fn gas_sticks_to_both_walls() {
        assert!((GAP.speed(0.25) - 0.1).abs() < 1e-15);
        assert!(GAP.speed(0.5).abs() < 1e-15);
    }

    /// `2 pi r^2` times the shear stress `mu (u' - u / r)` is the same at all radii.
    #[test]
    fn the_moment_goes_through_the_gas() {
        for radius in [0.25, 0.3, 0.45] {
            let step = 1e-5;
            let slope = (GAP.speed(radius + step) - GAP.speed(radius - step)) / (2.0 * step);
            let stress = GAP.viscosity * (GAP.speed(radius) / radius - slope);
            let moment = std::f64::consts::TAU * radius * radius * stress;
            assert!((moment / GAP.moment() - 1.0).abs() < 1e-8, "{moment}");
        }
    }
}
