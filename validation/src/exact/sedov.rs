//! Sedov's point explosion in a uniform cold gas: shock radius and profiles.
//!
//! Source: Sedov, "Similarity and Dimensional Methods in Mechanics" (1959), in the form of Kamm &
//! Timmes, "On efficient generation of numerically robust Sedov solutions", LA-UR-07-2849 (2007),
//! the standard case with uniform surroundings.

use super::root::bracketed_root;
use super::{ExactError, State, require};

/// Point (3), line (2) or plane (1) explosion of energy 1 per point, length or area in gas of
/// density 1 and no pressure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sedov {
    dimension: f64,
    gamma: f64,
    alpha: f64,
}

/// Position, density, velocity and pressure over their values at the shock.
struct Similarity {
    radius: f64,
    density: f64,
    velocity: f64,
    pressure: f64,
}

impl Sedov {
    /// Explosion in `dimension` 1, 2 or 3 with `1 < gamma < 2`.
    pub fn new(dimension: usize, gamma: f64) -> Result<Self, ExactError> {
        require(
            (1..=3).contains(&dimension),
            "the dimension",
            dimension as f64,
            "1, 2 and 3",
        )?;
        // At gamma = 2 two of the exponents have a pole and the solution another form.
        require(
            gamma > 1.0 && gamma < 2.0,
            "the ratio of specific heats",
            gamma,
            "values between 1 and 2",
        )?;
        let mut this = Self {
            dimension: dimension as f64,
            gamma,
            alpha: 1.0,
        };
        this.alpha = this.energy_of_unit_blast();
        Ok(this)
    }

    /// The constant of `R = (E t^2 / (alpha rho))^(1/(D+2))`.
    pub fn alpha(&self) -> f64 {
        self.alpha
    }

    /// Radius of the shock at time `t`.
    pub fn shock_radius(&self, t: f64) -> f64 {
        (t * t / self.alpha).powf(1.0 / (self.dimension + 2.0))
    }

    /// Gas just behind the shock at time `t > 0`; velocity outwards.
    pub fn behind_shock(&self, t: f64) -> State {
        let speed = 2.0 * self.shock_radius(t) / ((self.dimension + 2.0) * t);
        let k = 2.0 / (self.gamma + 1.0);
        State::new(
            (self.gamma + 1.0) / (self.gamma - 1.0),
            k * speed,
            k * speed * speed,
        )
    }

    /// Gas at distance `r >= 0` from the centre at time `t > 0`.
    pub fn at(&self, r: f64, t: f64) -> State {
        let radius = self.shock_radius(t);
        if r > radius {
            return State::new(1.0, 0.0, 0.0);
        }
        let shock = self.behind_shock(t);
        let wanted = r / radius;
        let s = bracketed_root(|s| self.similarity(s).radius - wanted, 0.0, 1.0);
        let f = self.similarity(s);
        State::new(
            shock.density * f.density,
            shock.velocity * f.velocity,
            shock.pressure * f.pressure,
        )
    }

    /// The similarity functions [Kamm & Timmes, standard case, uniform surroundings] at parameter
    /// `s`, from 0 in the centre to 1 at the shock.
    ///
    /// Their parameter `V` crowds at the centre, where `r ~ (V - V0)^q`; `V = V0 + (V2 - V0)
    /// s^(1/q)` makes `r` nearly proportional to `s`.
    fn similarity(&self, s: f64) -> Similarity {
        let (j, g) = (self.dimension, self.gamma);
        let a0 = 2.0 / (j + 2.0);
        let a2 = -(g - 1.0) / (2.0 * (g - 1.0) + j);
        let a1 = (j + 2.0) * g / (2.0 + j * (g - 1.0))
            * (2.0 * j * (2.0 - g) / (g * (j + 2.0) * (j + 2.0)) - a2);
        let a3 = j / (2.0 * (g - 1.0) + j);
        let a4 = a1 * (j + 2.0) / (2.0 - g);
        let a5 = -2.0 / (2.0 - g);
        let v0 = 2.0 / ((j + 2.0) * g);
        let v2 = 4.0 / ((j + 2.0) * (g + 1.0));
        let step = (v2 - v0) * s.powf(-1.0 / a2);
        let v = v0 + step;
        let e = 0.5 * (2.0 + j * (g - 1.0));
        let d = (j + 2.0) * (g + 1.0) / ((j + 2.0) * (g + 1.0) - 4.0 * e);
        let b = (g + 1.0) / (g - 1.0);
        let x1 = 0.25 * (j + 2.0) * (g + 1.0) * v;
        // (c V - 1) with c V0 = 1, free of cancellation.
        let x2 = b * 0.5 * (j + 2.0) * g * step;
        let x3 = d * (1.0 - e * v);
        let x4 = b * (1.0 - 0.5 * (j + 2.0) * v);
        let radius = x1.powf(-a0) * x2.powf(-a2) * x3.powf(-a1);
        Similarity {
            radius,
            density: x2.powf(a3) * x3.powf(a4) * x4.powf(a5),
            velocity: x1 * radius,
            pressure: x1.powf(a0 * j) * x3.powf(a4 - 2.0 * a1) * x4.powf(1.0 + a5),
        }
    }

    /// Energy inside a shock of radius `t^(2/(D+2))`, which is `alpha`: `int (rho u^2/2 +
    /// p/(gamma-1)) dV` at `t = 1`, as a Stieltjes sum over `r^D`.
    fn energy_of_unit_blast(&self) -> f64 {
        const STEPS: usize = 20_000;
        // With alpha = 1 still set, the shock stands at r = 1 at t = 1.
        let shock = self.behind_shock(1.0);
        let density = |s: f64| {
            let f = self.similarity(s);
            let kinetic = 0.5 * shock.density * shock.velocity * shock.velocity;
            let inner = shock.pressure / (self.gamma - 1.0);
            let energy = kinetic * f.density * f.velocity * f.velocity + inner * f.pressure;
            (energy, f.radius.powf(self.dimension))
        };
        let mut sum = 0.0;
        let (mut energy, mut measure) = density(0.0);
        for k in 1..=STEPS {
            let (next_energy, next_measure) = density(k as f64 / STEPS as f64);
            sum += 0.5 * (energy + next_energy) * (next_measure - measure);
            (energy, measure) = (next_energy, next_measure);
        }
        // Volume of the unit ball: 2, pi, 4 pi / 3.
        let ball = match self.dimension as usize {
            1 => 2.0,
            2 => std::f64::consts::PI,
            _ => 4.0 / 3.0 * std::f64::consts::PI,
        };
        ball * sum
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reference;
    use approx::assert_relative_eq;

    #[test]
    fn the_constants_agree_with_the_reference_table() {
        let table = reference::sedov();
        for row in 0..table.len() {
            let get = |name: &str| table.column(name).unwrap()[row];
            let sedov = Sedov::new(get("dim") as usize, get("gamma")).unwrap();
            assert_relative_eq!(sedov.alpha(), get("alpha"), max_relative = 1e-6);
            assert_relative_eq!(
                sedov.shock_radius(1.0),
                get("R_at_E1_t1_rho1"),
                max_relative = 1e-6
            );
            let density = sedov.behind_shock(1.0).density;
            assert_relative_eq!(density, get("rho2_rho1"), max_relative = 1e-6);
        }
    }

    #[test]
    fn the_swept_mass_is_inside_the_shock() {
        let sedov = Sedov::new(3, 1.4).unwrap();
        let radius = sedov.shock_radius(1.0);
        let cells = 4000;
        let mut mass = 0.0;
        for k in 0..cells {
            let r = radius * (f64::from(k) + 0.5) / f64::from(cells);
            mass += 3.0 * sedov.at(r, 1.0).density * r * r * radius / f64::from(cells);
        }
        assert_relative_eq!(mass, radius.powi(3), max_relative = 1e-3);
    }

    #[test]
    fn the_centre_is_empty_and_hot_and_the_surroundings_untouched() {
        let sedov = Sedov::new(2, 1.4).unwrap();
        let centre = sedov.at(1e-3, 1.0);
        assert!(centre.density < 1e-6 && centre.pressure > 0.05);
        assert_eq!(sedov.at(2.0, 1.0), State::new(1.0, 0.0, 0.0));
    }

    #[test]
    fn stiff_gases_are_refused() {
        assert!(Sedov::new(3, 2.0).is_err());
    }
}
