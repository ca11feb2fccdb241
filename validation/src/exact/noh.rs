//! Noh's implosion: cold gas running onto a wall, an axis or a centre at unit speed.
//!
//! Source: Noh, J. Comput. Phys. 72 (1987) 78 (doi:10.1016/0021-9991(87)90074-X).

use super::{ExactError, State, require, require_gamma};

/// Cold gas of density `density` running inwards at `speed` in 1, 2 or 3 dimensions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Noh {
    dimension: usize,
    density: f64,
    speed: f64,
    gamma: f64,
}

impl Noh {
    /// Implosion of unit density and unit speed in `dimension` 1 (wall), 2 (axis) or 3 (centre).
    pub fn new(dimension: usize, gamma: f64) -> Result<Self, ExactError> {
        require_gamma(gamma)?;
        require(
            (1..=3).contains(&dimension),
            "the dimension",
            dimension as f64,
            "1, 2 and 3",
        )?;
        Ok(Self {
            dimension,
            density: 1.0,
            speed: 1.0,
            gamma,
        })
    }

    /// Speed of the shock that runs outwards, `(gamma - 1)/2` times that of the gas.
    pub fn shock_speed(&self) -> f64 {
        0.5 * (self.gamma - 1.0) * self.speed
    }

    /// Gas at rest behind the shock: density `((gamma+1)/(gamma-1))^D`.
    pub fn plateau(&self) -> State {
        let power = self.dimension as i32;
        let density = self.density * ((self.gamma + 1.0) / (self.gamma - 1.0)).powi(power);
        let energy = 0.5 * self.speed * self.speed;
        State::new(density, 0.0, (self.gamma - 1.0) * density * energy)
    }

    /// Gas at distance `r >= 0` from the centre at time `t >= 0`; the velocity is radial, negative
    /// inwards. Ahead of the shock the density is `(1 + t/r)^(D-1)`.
    pub fn at(&self, r: f64, t: f64) -> State {
        if r < self.shock_speed() * t {
            return self.plateau();
        }
        let squeeze = if self.dimension == 1 {
            1.0
        } else {
            (1.0 + self.speed * t / r).powi(self.dimension as i32 - 1)
        };
        State::new(self.density * squeeze, -self.speed, 0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reference;
    use approx::assert_relative_eq;

    #[test]
    fn the_reference_table_is_reproduced() {
        let table = reference::noh();
        for row in 0..table.len() {
            let get = |name: &str| table.column(name).unwrap()[row];
            let noh = Noh::new(get("dim") as usize, get("gamma")).unwrap();
            let radius = noh.shock_speed() * get("t");
            assert_relative_eq!(radius, get("r_shock"), max_relative = 1e-6);
            assert_relative_eq!(
                noh.plateau().density,
                get("rho_plateau"),
                max_relative = 1e-6
            );
            assert_relative_eq!(
                noh.plateau().pressure,
                get("p_plateau"),
                max_relative = 1e-6
            );
        }
    }

    #[test]
    fn mass_flows_through_the_shock_unchanged() {
        for dimension in 1..=3 {
            let noh = Noh::new(dimension, 5.0 / 3.0).unwrap();
            let front = noh.shock_speed() * 0.6;
            let ahead = noh.at(front * (1.0 + 1e-12), 0.6);
            let behind = noh.at(front * (1.0 - 1e-12), 0.6);
            let flux = |s: State| s.density * (noh.shock_speed() - s.velocity);
            assert_relative_eq!(flux(ahead), flux(behind), max_relative = 1e-9);
        }
    }

    #[test]
    fn a_fourth_dimension_is_refused() {
        assert!(Noh::new(4, 1.4).is_err());
    }
}
