//! Exact and near-exact solutions of the Euler and Navier-Stokes equations for a calorically perfect gas, for hot air and for liquids.
//!
//! One file per solution. Angles are radians unless a name ends in `_deg`; pressures, densities and
//! speeds carry whatever consistent units the caller uses, ratios none. Nothing here knows about
//! particles, grids or files.

pub mod accelerating_piston;
pub mod becker;
pub mod billig;
pub mod channel;
pub mod cone;
pub mod couette;
pub mod crossing;
pub mod diamond;
pub mod fay_riddell;
pub mod flat_plate;
pub mod hot_air;
pub mod intake;
pub mod isentropic;
pub mod karman_trefftz;
pub mod liquid;
pub mod noh;
pub mod normal;
pub mod nozzle;
pub mod oblique;
pub mod piston;
pub mod prandtl_meyer;
pub mod refraction;
pub mod riemann;
mod root;
pub mod sedov;
pub mod shock_expansion;
pub mod sod_tube;
pub mod spheroid;
pub mod turning;

/// Density, velocity and pressure of a gas moving along one axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct State {
    /// Density.
    pub density: f64,
    /// Velocity along the axis.
    pub velocity: f64,
    /// Pressure.
    pub pressure: f64,
}

impl State {
    /// A state from its three values.
    pub const fn new(density: f64, velocity: f64, pressure: f64) -> Self {
        Self {
            density,
            velocity,
            pressure,
        }
    }

    /// Speed of sound, `sqrt(gamma p / rho)`; zero in a vacuum.
    pub fn sound_speed(&self, gamma: f64) -> f64 {
        if self.density > 0.0 {
            (gamma * self.pressure / self.density).sqrt()
        } else {
            0.0
        }
    }

    /// Specific internal energy, `p / ((gamma - 1) rho)`; zero in a vacuum.
    pub fn energy(&self, gamma: f64) -> f64 {
        if self.density > 0.0 {
            self.pressure / ((gamma - 1.0) * self.density)
        } else {
            0.0
        }
    }
}

/// Why a solution does not exist for the numbers given.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ExactError {
    /// The stream is too slow for a shock.
    #[error("no shock can stand in a stream of Mach number {mach}: give one above 1")]
    Subsonic {
        /// The Mach number given.
        mach: f64,
    },
    /// The body is too blunt for an attached shock.
    #[error(
        "the shock detaches: {given_deg:.3} deg at Mach {mach} exceeds the limit of \
         {limit_deg:.3} deg; give a smaller angle or a higher Mach number"
    )]
    Detached {
        /// The Mach number given.
        mach: f64,
        /// The angle given, degrees.
        given_deg: f64,
        /// The largest angle with an attached shock, degrees.
        limit_deg: f64,
    },
    /// A number lies outside the range where the solution holds.
    #[error("{what} is {value}: the solution holds for {range}")]
    OutOfRange {
        /// The quantity.
        what: &'static str,
        /// Its value.
        value: f64,
        /// Where the solution holds, in words.
        range: &'static str,
    },
}

/// Refuses a value outside the range where a solution holds.
fn require(
    ok: bool,
    what: &'static str,
    value: f64,
    range: &'static str,
) -> Result<(), ExactError> {
    if ok {
        Ok(())
    } else {
        Err(ExactError::OutOfRange { what, value, range })
    }
}

/// Refuses a ratio of specific heats that is not above 1.
fn require_gamma(gamma: f64) -> Result<(), ExactError> {
    require(
        gamma > 1.0 && gamma.is_finite(),
        "the ratio of specific heats",
        gamma,
        "values above 1",
    )
}

/// Refuses a Mach number that is not supersonic.
fn require_supersonic(mach: f64) -> Result<(), ExactError> {
    if mach > 1.0 && mach.is_finite() {
        Ok(())
    } else {
        Err(ExactError::Subsonic { mach })
    }
}
