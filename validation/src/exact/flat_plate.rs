//! The laminar boundary layer of air along a flat plate: the similar solution with a viscosity by Sutherland's law.
//!
//! Source: White, "Viscous Fluid Flow", 3rd ed., section 7-4, in the variable of Howarth and Dorodnitsyn,
//! `eta = sqrt(u_e / (2 nu_e x)) integral of rho / rho_e dy`: `(C f'')' + f f'' = 0`,
//! `(C T' / Pr)' + f T' + (gamma - 1) M^2 C f''^2 = 0`, `C = rho mu / (rho_e mu_e)`, `T` over that of the stream.

use super::couette::air_viscosity;

/// Thickness that is integrated over, in `eta`.
const END: f64 = 12.0;

/// Steps over it: fourth order leaves an error near 1e-8.
const STEPS: usize = 1200;

/// Newton's steps at most.
const TRIES: usize = 60;

/// The stream over a plate, of air.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FlatPlate {
    /// Mach number.
    pub mach: f64,
    /// Temperature of the stream, K.
    pub temperature: f64,
    /// Ratio of specific heats.
    pub gamma: f64,
    /// Prandtl number.
    pub prandtl: f64,
    /// Temperature of the wall, K; none of one that no heat goes through.
    pub wall: Option<f64>,
}

/// What the layer does to the plate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Layer {
    /// `c_f sqrt(Re_x)`, by the stream.
    pub friction: f64,
    /// Temperature of the wall over that of the stream.
    pub wall: f64,
    /// `(T_w - T) / (T_0 - T)`: of a wall that no heat goes through, the recovery factor.
    pub recovery: f64,
    /// `q_w sqrt(Re_x) / (rho u c_p T)`, by the stream: heat into the wall.
    pub heat: f64,
}

/// `f`, `f'`, `C f''`, `T`, `C T' / Pr`.
type Profile = [f64; 5];

impl FlatPlate {
    /// `C` at a temperature over the stream's.
    fn product(&self, temperature: f64) -> f64 {
        air_viscosity(temperature * self.temperature)
            / air_viscosity(self.temperature)
            / temperature
    }

    fn slopes(&self, [f, speed, shear, temperature, heat]: Profile) -> Profile {
        let product = self.product(temperature);
        let (bend, rise) = (shear / product, self.prandtl * heat / product);
        let heating = (self.gamma - 1.0) * self.mach * self.mach * product * bend * bend;
        [speed, bend, -f * bend, rise, -f * rise - heating]
    }

    /// Speed and temperature far out, from the shear and what is not known of the heat at the wall.
    fn outside(&self, [shear, heat]: [f64; 2]) -> [f64; 2] {
        let mut at = match self.wall {
            Some(wall) => [0.0, 0.0, shear, wall / self.temperature, heat],
            None => [0.0, 0.0, shear, heat, 0.0],
        };
        let step = END / STEPS as f64;
        for _ in 0..STEPS {
            let moved = |by: f64, slopes: &Profile| -> Profile {
                std::array::from_fn(|k| at[k] + by * slopes[k])
            };
            let a = self.slopes(at);
            let b = self.slopes(moved(0.5 * step, &a));
            let c = self.slopes(moved(0.5 * step, &b));
            let d = self.slopes(moved(step, &c));
            at = std::array::from_fn(|k| {
                at[k] + step / 6.0 * (a[k] + 2.0 * b[k] + 2.0 * c[k] + d[k])
            });
        }
        [at[1], at[3]]
    }

    /// The layer.
    pub fn layer(&self) -> Layer {
        const NUDGE: f64 = 1e-6;
        let kinetic = 0.5 * (self.gamma - 1.0) * self.mach * self.mach;
        let root = self.prandtl.sqrt();
        let mut guess = match self.wall {
            Some(wall) => {
                let recovered = 1.0 + root * kinetic;
                [0.4696, 0.4696 * (recovered - wall / self.temperature)]
            }
            None => [0.4696, 1.0 + root * kinetic],
        };
        for _ in 0..TRIES {
            let found = self.outside(guess);
            let off = [found[0] - 1.0, found[1] - 1.0];
            let along = |k: usize| {
                let mut beside = guess;
                beside[k] += NUDGE;
                let other = self.outside(beside);
                [0, 1].map(|n| (other[n] - found[n]) / NUDGE)
            };
            let (a, b) = (along(0), along(1));
            let scale = a[0] * b[1] - a[1] * b[0];
            let change = [
                (off[0] * b[1] - off[1] * b[0]) / scale,
                (off[1] * a[0] - off[0] * a[1]) / scale,
            ];
            guess = [guess[0] - change[0], guess[1] - change[1]];
            if change.iter().all(|change| change.abs() < 1e-11) {
                break;
            }
        }
        let wall = self.wall.map_or(guess[1], |wall| wall / self.temperature);
        Layer {
            friction: f64::sqrt(2.0) * guess[0],
            wall,
            recovery: (wall - 1.0) / kinetic,
            heat: self.wall.map_or(0.0, |_| guess[1] / f64::sqrt(2.0)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn air(mach: f64, wall: Option<f64>) -> Layer {
        FlatPlate {
            mach,
            temperature: 220.0,
            gamma: 1.4,
            prandtl: 0.72,
            wall,
        }
        .layer()
    }

    /// Blasius: 0.664115.
    #[test]
    fn friction_is_that_computed_beforehand() {
        for (mach, friction) in [(0.1, 0.6641), (0.5, 0.6625), (2.0, 0.6378), (3.0, 0.6093)] {
            let found = air(mach, None).friction;
            assert!((found - friction).abs() < 1e-4, "{mach}: {found}");
        }
        for (mach, friction) in [(2.0, 0.6572), (3.0, 0.6485)] {
            let found = air(mach, Some(220.0)).friction;
            assert!((found - friction).abs() < 1e-4, "{mach}: {found}");
        }
        // By Reynolds' analogy within two per cent: c_f / 2 Pr^(-2/3) (T_r - T_w) / T, with the recovery of a wall that no heat goes through.
        let cold = air(3.0, Some(220.0));
        let rise = 0.4 * 0.5 * 9.0 * air(3.0, None).recovery;
        let alike = 0.5 * cold.friction * 0.72_f64.powf(-2.0 / 3.0) * rise;
        assert!(
            (cold.heat / alike - 1.0).abs() < 0.02,
            "{} {alike}",
            cold.heat
        );
        assert_eq!(air(3.0, None).heat, 0.0);
        let recoveries = [0.1, 3.0].map(|mach| air(mach, None).recovery);
        assert!((recoveries[0] - 0.8477).abs() < 1e-4, "{recoveries:?}");
        assert!((recoveries[1] - 0.8435).abs() < 1e-4, "{recoveries:?}");
    }
}
