//! A supersonic intake of one turn: the shock of its ramp meets the lip of the cowl, the one that the cowl sends back turns the stream along the
//! duct and ends at the shoulder of the ramp, so that what goes in is even; in the duct stands a normal shock where the pressure at its end
//! puts it.
//!
//! Sources: Seddon & Goldsmith, "Intake Aerodynamics" (2nd ed., 1999), chapters 2 and 5; NACA Report 1135 (1953), eqs. 80, 99, 128-142;
//! Kantrowitz & Donaldson, NACA ACR L5D20 (1945), for what lets it start.

use super::isentropic::{self, area_ratio};
use super::normal::normal_shock;
use super::nozzle::{internal_shock, shock_for_back_pressure};
use super::oblique::{ObliqueShock, Strength, oblique_shock};
use super::{ExactError, require};

/// An intake in its stream; the unit of length is the height of the cowl's lip above the foot of the ramp, at the origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Intake {
    /// Mach number of the stream.
    pub mach: f64,
    /// Ratio of specific heats.
    pub gamma: f64,
    /// Shock of the ramp.
    pub ramp: ObliqueShock,
    /// Shock that the cowl sends back.
    pub cowl: ObliqueShock,
    /// How far the lip is behind the foot.
    pub lip: f64,
    /// Where the ramp ends.
    pub shoulder: [f64; 2],
    /// Area of the duct's end over that of the throat, which is above the shoulder.
    pub widening: f64,
}

/// The flow with a normal shock in the duct.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Held {
    /// Area where the shock stands over that of the throat.
    pub area_ratio: f64,
    /// Mach number ahead of it.
    pub mach_ahead: f64,
    /// Total pressure behind all shocks over the stream's.
    pub recovery: f64,
    /// Mach number at the end of the duct.
    pub end_mach: f64,
}

/// The flow with a normal shock ahead of the cowl.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unstarted {
    /// Total pressure in the duct over the stream's.
    pub recovery: f64,
    /// Mass that goes in over that which meets the cowl.
    pub captured: f64,
    /// Mach number at the end of the duct.
    pub end_mach: f64,
}

impl Intake {
    /// The one whose ramp turns a stream by `turn`, radians.
    pub fn new(mach: f64, turn: f64, widening: f64, gamma: f64) -> Result<Self, ExactError> {
        let ramp = oblique_shock(mach, turn, gamma, Strength::Weak)?;
        let cowl = oblique_shock(ramp.mach, turn, gamma, Strength::Weak)?;
        let lip = 1.0 / ramp.angle.tan();
        let (rise, fall) = (turn.tan(), (cowl.angle - turn).tan());
        let x = (1.0 + fall * lip) / (rise + fall);
        Ok(Self {
            mach,
            gamma,
            ramp,
            cowl,
            lip,
            shoulder: [x, x * rise],
            widening,
        })
    }

    /// Height of the throat.
    pub fn throat(&self) -> f64 {
        1.0 - self.shoulder[1]
    }

    /// Total pressure in the throat over the stream's.
    pub fn recovery(&self) -> f64 {
        self.ramp.total_pressure_ratio * self.cowl.total_pressure_ratio
    }

    /// Area of the duct between lip and ramp, across the stream there, over that of the throat.
    pub fn contraction(&self) -> f64 {
        let turn = self.ramp.deflection;
        (1.0 - self.lip * turn.tan()) * turn.cos() / self.throat()
    }

    /// The flow that is unstarted, with a normal shock on the ramp ahead of the cowl and a `pressure` at the end of the duct, over the stream's: its
    /// Mach number ahead and total pressure follow, how much goes in too, if all of that has passed the ramp's shock.
    pub fn unstarted(&self, pressure: f64) -> Result<Unstarted, ExactError> {
        let ahead = normal_shock(self.ramp.mach, self.gamma)?;
        let recovery = self.ramp.total_pressure_ratio * ahead.total_pressure_ratio;
        let total = recovery * isentropic::pressure_ratio(self.mach, self.gamma);
        require(
            pressure > 0.0 && pressure < total,
            "the pressure at the end of the duct over the stream's",
            pressure,
            "values below the total pressure behind a normal shock on the ramp",
        )?;
        let end_mach = isentropic::mach_from_pressure(total / pressure, self.gamma);
        Ok(Unstarted {
            recovery,
            captured: pressure * self.flux(end_mach) * self.widening * self.throat()
                / self.flux(self.mach),
            end_mach,
        })
    }

    /// `rho u` over `p / sqrt(R T0 / gamma)`.
    fn flux(&self, mach: f64) -> f64 {
        mach * isentropic::temperature_ratio(mach, self.gamma).sqrt()
    }

    /// Pressures at the end of the duct over the stream's between which a shock stands in the duct: at its end, and in the throat.
    pub fn range(&self) -> Result<[f64; 2], ExactError> {
        let [from, to] = [self.widening, 1.0].map(|area| self.at(area));
        Ok([from?, to?])
    }

    /// Pressure at the end over the stream's with a shock at so many throats.
    fn at(&self, area: f64) -> Result<f64, ExactError> {
        let sonic = area_ratio(self.cowl.mach, self.gamma);
        let shock = internal_shock(area * sonic, self.widening * sonic, self.gamma)?;
        Ok(shock.exit_pressure_ratio * self.total_pressure())
    }

    /// Total pressure in the throat over the stream's pressure.
    fn total_pressure(&self) -> f64 {
        self.recovery() * isentropic::pressure_ratio(self.mach, self.gamma)
    }

    /// The shock that a `pressure` at the end of the duct, over the stream's, holds.
    pub fn held(&self, pressure: f64) -> Result<Held, ExactError> {
        let [low, high] = self.range()?;
        require(
            (low..=high).contains(&pressure),
            "the pressure at the end of the duct over the stream's",
            pressure,
            "values that hold a shock between throat and end",
        )?;
        let sonic = area_ratio(self.cowl.mach, self.gamma);
        let part = pressure / self.total_pressure();
        let shock = shock_for_back_pressure(part, self.widening * sonic, self.gamma)?;
        Ok(Held {
            area_ratio: shock.area_ratio / sonic,
            mach_ahead: shock.mach_ahead,
            recovery: self.recovery() * shock.total_pressure_ratio,
            end_mach: shock.exit_mach,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    fn intake() -> Intake {
        Intake::new(2.5, 7_f64.to_radians(), 1.35, 1.4).unwrap()
    }

    /// Two shocks and a throat of the height that their geometry gives pass all that meets the cowl, which none of their formulas knows.
    #[test]
    fn what_meets_the_cowl_passes_the_throat() {
        for (mach, turn) in [(2.5_f64, 7.0_f64), (2.2, 5.0), (3.0, 10.0)] {
            let intake = Intake::new(mach, turn.to_radians(), 1.35, 1.4).unwrap();
            let (ramp, cowl) = (intake.ramp, intake.cowl);
            let density = ramp.density_ratio * cowl.density_ratio;
            let sound = (ramp.temperature_ratio * cowl.temperature_ratio).sqrt();
            let through = density * sound * cowl.mach / mach * intake.throat();
            assert_relative_eq!(through, 1.0, max_relative = 1e-9);
        }
    }

    #[test]
    fn shocks_meet_lip_and_shoulder() {
        let intake = intake();
        let turn = 7_f64.to_radians();
        let [x, y] = intake.shoulder;
        assert_relative_eq!(y, x * turn.tan(), max_relative = 1e-12);
        let slope = (intake.cowl.angle - turn).tan();
        assert_relative_eq!(y, 1.0 - (x - intake.lip) * slope, max_relative = 1e-12);
        assert_relative_eq!(
            intake.lip * intake.ramp.angle.tan(),
            1.0,
            max_relative = 1e-12
        );
    }

    /// Mass that passes the shock in the duct goes on through its end.
    #[test]
    fn what_passes_the_throat_leaves_by_the_end() {
        let intake = intake();
        let [low, high] = intake.range().unwrap();
        for part in [0.05, 0.4, 0.95] {
            let pressure = low + part * (high - low);
            let held = intake.held(pressure).unwrap();
            let [stream, end] = [2.5, held.end_mach].map(|mach| intake.flux(mach));
            let area = 1.35 * intake.throat();
            assert_relative_eq!(pressure * end * area / stream, 1.0, max_relative = 1e-9);
        }
    }

    /// With the pressure at which it would be full a duct behind a normal shock on the ramp takes in all; with more, less.
    #[test]
    fn an_unstarted_intake_takes_in_less_the_more_is_held() {
        let intake = intake();
        let captured = |pressure| intake.unstarted(pressure).unwrap().captured;
        // M 0.4191 behind 0.61824 of the stream's total pressure, 17.086 p1: 9.361 x 0.4264 x 1.35 x 0.6214 / 3.75.
        assert_relative_eq!(captured(9.361), 0.8929, max_relative = 1e-3);
        assert!(captured(10.0) < captured(9.361) && captured(10.0) > 0.0);
        assert!(intake.unstarted(11.0).is_err());
    }

    #[test]
    fn pressures_that_hold_no_shock_inside_are_refused() {
        let [low, high] = intake().range().unwrap();
        assert!(intake().held(0.99 * low).is_err());
        assert!(intake().held(1.01 * high).is_err());
    }
}
