//! The exact Riemann problem for a perfect gas, or one on either side, vacuum included.
//!
//! Source: Toro, "Riemann Solvers and Numerical Methods for Fluid Dynamics", 3rd ed. (2009),
//! chapter 4 (doi:10.1007/b79761).

use super::{ExactError, State, require, require_gamma};

/// Gas between the two outer waves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Star {
    /// Pressure, the same on both sides of the contact.
    pub pressure: f64,
    /// Velocity, that of the contact.
    pub velocity: f64,
    /// Density left of the contact.
    pub density_left: f64,
    /// Density right of the contact.
    pub density_right: f64,
}

/// An outer wave of the solution and its speeds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Wave {
    /// A shock of the given speed.
    Shock(f64),
    /// A centred rarefaction.
    Fan {
        /// Speed of the edge towards the undisturbed gas.
        head: f64,
        /// Speed of the edge towards the contact or the vacuum.
        tail: f64,
    },
}

/// The solution of one Riemann problem, a function of `x / t`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Riemann {
    left: State,
    right: State,
    /// Ratios of specific heats left and right of the contact.
    gammas: [f64; 2],
    star: Option<Star>,
}

impl Riemann {
    /// Solves the problem of `left` and `right` brought together. Densities and pressures may be
    /// zero together (a vacuum on one side), not negative.
    pub fn new(left: State, right: State, gamma: f64) -> Result<Self, ExactError> {
        Self::of_two_gases(left, right, [gamma; 2])
    }

    /// The same of a gas on either side, whose ratios of specific heats are `gammas`.
    pub fn of_two_gases(left: State, right: State, gammas: [f64; 2]) -> Result<Self, ExactError> {
        for gamma in gammas {
            require_gamma(gamma)?;
        }
        for state in [left, right] {
            let gas = state.density > 0.0 && state.pressure > 0.0;
            let vacuum = state.density == 0.0 && state.pressure == 0.0;
            require(
                gas || vacuum,
                "the product of density and pressure",
                state.density * state.pressure,
                "gas (both positive) or vacuum (both zero)",
            )?;
            require(
                state.velocity.is_finite(),
                "the velocity",
                state.velocity,
                "finite values",
            )?;
        }
        let star = solve_star(&left, &right, gammas);
        Ok(Self {
            left,
            right,
            gammas,
            star,
        })
    }

    /// The gas between the outer waves; none where a vacuum lies there.
    pub fn star(&self) -> Option<Star> {
        self.star
    }

    /// The wave running into the left state.
    pub fn left_wave(&self) -> Wave {
        mirror_wave(wave(
            &mirror(&self.left),
            self.star.map(mirror_star),
            self.gammas[0],
        ))
    }

    /// The wave running into the right state.
    pub fn right_wave(&self) -> Wave {
        wave(&self.right, self.star, self.gammas[1])
    }

    /// The gas at `x / t = speed`, measured from where the states met.
    pub fn sample(&self, speed: f64) -> State {
        match self.star {
            Some(star) if speed > star.velocity => {
                sample_right(&self.right, Some(star), speed, self.gammas[1])
            }
            Some(star) => {
                let mirrored = Some(mirror_star(star));
                mirror(&sample_right(
                    &mirror(&self.left),
                    mirrored,
                    -speed,
                    self.gammas[0],
                ))
            }
            None => self.sample_vacuum(speed),
        }
    }

    /// Two fans, or one, that end in a vacuum [Toro, section 4.6].
    fn sample_vacuum(&self, speed: f64) -> State {
        let [left, right] = self.gammas;
        let escape = |s: &State, gamma| 2.0 * s.sound_speed(gamma) / (gamma - 1.0);
        if self.left.density > 0.0 && speed < self.left.velocity + escape(&self.left, left) {
            mirror(&sample_right(&mirror(&self.left), None, -speed, left))
        } else if self.right.density > 0.0
            && speed > self.right.velocity - escape(&self.right, right)
        {
            sample_right(&self.right, None, speed, right)
        } else {
            State::new(0.0, speed, 0.0)
        }
    }
}

/// The same gas seen in a mirror: the left half of the problem is the right half of the mirrored.
fn mirror(state: &State) -> State {
    State::new(state.density, -state.velocity, state.pressure)
}

fn mirror_star(star: Star) -> Star {
    Star {
        pressure: star.pressure,
        velocity: -star.velocity,
        density_left: star.density_right,
        density_right: star.density_left,
    }
}

fn mirror_wave(wave: Wave) -> Wave {
    match wave {
        Wave::Shock(speed) => Wave::Shock(-speed),
        Wave::Fan { head, tail } => Wave::Fan {
            head: -head,
            tail: -tail,
        },
    }
}

/// Velocity change across the wave that takes `state` to pressure `p`, and its derivative
/// [Toro, eqs. 4.6, 4.7 and 4.37].
fn velocity_change(p: f64, state: &State, gamma: f64) -> (f64, f64) {
    let c = state.sound_speed(gamma);
    if p > state.pressure {
        let a = 2.0 / ((gamma + 1.0) * state.density);
        let b = (gamma - 1.0) / (gamma + 1.0) * state.pressure;
        let root = (a / (p + b)).sqrt();
        let change = (p - state.pressure) * root;
        (change, root * (1.0 - 0.5 * (p - state.pressure) / (p + b)))
    } else {
        let ratio = p / state.pressure;
        let change = 2.0 * c / (gamma - 1.0) * (ratio.powf(0.5 * (gamma - 1.0) / gamma) - 1.0);
        let slope = ratio.powf(-0.5 * (gamma + 1.0) / gamma) / (state.density * c);
        (change, slope)
    }
}

/// Pressure and velocity between the waves, or none where a vacuum forms.
fn solve_star(left: &State, right: &State, [behind, ahead]: [f64; 2]) -> Option<Star> {
    let apart = right.velocity - left.velocity;
    let escape = |state: &State, gamma: f64| 2.0 / (gamma - 1.0) * state.sound_speed(gamma);
    let is_vacuum = left.density == 0.0 || right.density == 0.0;
    if is_vacuum || escape(left, behind) + escape(right, ahead) <= apart {
        return None;
    }
    let excess = |p: f64| {
        let (l, dl) = velocity_change(p, left, behind);
        let (r, dr) = velocity_change(p, right, ahead);
        (l + r + apart, dl + dr)
    };
    let lower = left.pressure.min(right.pressure);
    let mut p = lower;
    if excess(lower).0 >= 0.0 {
        p = between_fans(left, right, [behind, ahead], apart, &excess);
    } else {
        // The excess is increasing and concave, so Newton's method started where it is negative
        // climbs to the root without ever passing it.
        for _ in 0..200 {
            let (value, slope) = excess(p);
            let next = p - value / slope;
            if next <= p {
                break;
            }
            p = next;
        }
    }
    let (l, _) = velocity_change(p, left, behind);
    let (r, _) = velocity_change(p, right, ahead);
    Some(Star {
        pressure: p,
        velocity: 0.5 * (left.velocity + right.velocity) + 0.5 * (r - l),
        density_left: star_density(p, left, behind),
        density_right: star_density(p, right, ahead),
    })
}

/// Pressure between two rarefactions: of one gas the closed form [Toro, eq. 4.46] is exact; of two, halvings of its logarithm.
fn between_fans(
    left: &State,
    right: &State,
    [behind, ahead]: [f64; 2],
    apart: f64,
    excess: &impl Fn(f64) -> (f64, f64),
) -> f64 {
    let mut high = left.pressure.min(right.pressure);
    if behind == ahead {
        let gamma = behind;
        let z = 0.5 * (gamma - 1.0) / gamma;
        let over = left.sound_speed(gamma) + right.sound_speed(gamma) - 0.5 * (gamma - 1.0) * apart;
        let under = left.sound_speed(gamma) / left.pressure.powf(z)
            + right.sound_speed(gamma) / right.pressure.powf(z);
        return (over / under).powf(1.0 / z);
    }
    let mut low = high;
    while excess(low).0 > 0.0 && low > f64::MIN_POSITIVE {
        high = low;
        low *= 0.5;
    }
    for _ in 0..100 {
        let middle = (low * high).sqrt();
        if excess(middle).0 < 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    high
}

/// Density of `state` taken to pressure `p` by a shock or a rarefaction [Toro, eqs. 4.50, 4.53].
fn star_density(p: f64, state: &State, gamma: f64) -> f64 {
    let ratio = p / state.pressure;
    if ratio > 1.0 {
        let k = (gamma - 1.0) / (gamma + 1.0);
        state.density * (ratio + k) / (k * ratio + 1.0)
    } else {
        state.density * ratio.powf(1.0 / gamma)
    }
}

/// The wave running right into `state`.
fn wave(state: &State, star: Option<Star>, gamma: f64) -> Wave {
    let c = state.sound_speed(gamma);
    let head = state.velocity + c;
    match star {
        Some(star) if star.pressure > state.pressure => {
            let ratio = star.pressure / state.pressure;
            let mach2 = 0.5 * ((gamma + 1.0) * ratio + gamma - 1.0) / gamma;
            Wave::Shock(state.velocity + c * mach2.sqrt())
        }
        Some(star) => {
            let inside = State::new(star.density_right, star.velocity, star.pressure);
            Wave::Fan {
                head,
                tail: star.velocity + inside.sound_speed(gamma),
            }
        }
        None => Wave::Fan {
            head,
            tail: state.velocity - 2.0 * c / (gamma - 1.0),
        },
    }
}

/// The gas right of the contact (or vacuum) at `speed` [Toro, section 4.5].
fn sample_right(state: &State, star: Option<Star>, speed: f64, gamma: f64) -> State {
    let inside = star.map(|s| State::new(s.density_right, s.velocity, s.pressure));
    match wave(state, star, gamma) {
        Wave::Shock(shock) if speed >= shock => *state,
        Wave::Shock(_) => inside.unwrap_or(*state),
        Wave::Fan { head, .. } if speed >= head => *state,
        Wave::Fan { tail, .. } if speed > tail => {
            let c = state.sound_speed(gamma);
            let velocity = 2.0 / (gamma + 1.0) * (0.5 * (gamma - 1.0) * state.velocity - c + speed);
            let ratio = (speed - velocity) / c;
            State::new(
                state.density * ratio.powf(2.0 / (gamma - 1.0)),
                velocity,
                state.pressure * ratio.powf(2.0 * gamma / (gamma - 1.0)),
            )
        }
        Wave::Fan { .. } => inside.unwrap_or(State::new(0.0, speed, 0.0)),
    }
}

#[cfg(test)]
#[path = "riemann_tests.rs"]
mod tests;
