//! A shock tube closed by walls: the incident shock, its reflection off the right wall, and its
//! meeting with the contact.
//!
//! Before the shock reaches the wall this is the Riemann problem; the reflected shock brings the
//! gas behind the incident one to rest; where it meets the contact a second Riemann problem starts.
//! The solution ends when the fan reaches the left wall or a wave of the second problem reaches
//! another wave or wall. Sources: Sod, J. Comput. Phys. 27 (1978) 1
//! (doi:10.1016/0021-9991(78)90023-2); Anderson, "Modern Compressible Flow", chapter 7.

use super::piston::Piston;
use super::riemann::{Riemann, Wave};
use super::{ExactError, State, require};

/// A tube from `left_wall` to `right_wall`, its diaphragm at `diaphragm`, broken at `t = 0`; the
/// high pressure lies on the left and all gas is at rest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ClosedTube {
    first: Riemann,
    second: Riemann,
    diaphragm: f64,
    right_wall: f64,
    reflected: State,
    reflected_speed: f64,
    wall_time: f64,
    meeting: [f64; 2],
    end: f64,
}

impl ClosedTube {
    /// Sod's tube on `[0, 1]`: (1, 0, 1) and (0.125, 0, 0.1), diaphragm in the middle, gamma 1.4.
    pub fn sod() -> Result<Self, ExactError> {
        Self::new(
            State::new(1.0, 0.0, 1.0),
            State::new(0.125, 0.0, 0.1),
            1.4,
            [0.0, 0.5, 1.0],
        )
    }

    /// Tube of gas `left` and `right` at rest; `places` are the left wall, the diaphragm and the
    /// right wall, in this order.
    pub fn new(
        left: State,
        right: State,
        gamma: f64,
        places: [f64; 3],
    ) -> Result<Self, ExactError> {
        let [left_wall, diaphragm, right_wall] = places;
        require(
            left_wall < diaphragm && diaphragm < right_wall,
            "the diaphragm's position",
            diaphragm,
            "positions between the walls",
        )?;
        require(
            left.velocity == 0.0 && right.velocity == 0.0,
            "the velocity at the start",
            left.velocity.abs() + right.velocity.abs(),
            "gas at rest",
        )?;
        require(
            left.pressure > right.pressure && right.pressure > 0.0,
            "the ratio of the left to the right pressure",
            left.pressure / right.pressure,
            "high pressure on the left against gas on the right",
        )?;
        let first = Riemann::new(left, right, gamma)?;
        let (Some(star), Wave::Shock(shock), Wave::Fan { head, .. }) =
            (first.star(), first.right_wave(), first.left_wave())
        else {
            return Err(ExactError::OutOfRange {
                what: "the ratio of the left to the right pressure",
                value: left.pressure / right.pressure,
                range: "a shock running right and a fan running left",
            });
        };
        // Seen from the gas behind the incident shock, the wall is a piston coming at its speed.
        let wall = Piston::new(star.velocity, star.density_right, star.pressure, gamma)?;
        let reflected = State::new(wall.face().density, 0.0, wall.face().pressure);
        let reflected_speed = wall.front_speed() - star.velocity;
        let wall_time = (right_wall - diaphragm) / shock;
        let travel = right_wall + reflected_speed * wall_time - diaphragm;
        let time = travel / (star.velocity + reflected_speed);
        let meeting = [diaphragm + star.velocity * time, time];
        let behind = State::new(star.density_left, star.velocity, star.pressure);
        let second = Riemann::new(behind, reflected, gamma)?;
        let leading = |wave| match wave {
            Wave::Shock(speed) => speed,
            Wave::Fan { head, .. } => head,
        };
        let to_wall = (right_wall - meeting[0]) / leading(second.right_wave());
        let fan_at_wall = (diaphragm - left_wall) / -head;
        Ok(Self {
            first,
            second,
            diaphragm,
            right_wall,
            reflected,
            reflected_speed,
            wall_time,
            meeting,
            end: fan_at_wall.min(time + to_wall),
        })
    }

    /// The Riemann problem of the diaphragm.
    pub fn incident(&self) -> &Riemann {
        &self.first
    }

    /// Gas at rest between the right wall and the reflected shock.
    pub fn reflected(&self) -> State {
        self.reflected
    }

    /// When the incident shock reaches the right wall.
    pub fn wall_time(&self) -> f64 {
        self.wall_time
    }

    /// Where and when the reflected shock meets the contact, `[x, t]`.
    pub fn meeting(&self) -> [f64; 2] {
        self.meeting
    }

    /// Last time at which [`at`](Self::at) holds.
    pub fn valid_until(&self) -> f64 {
        self.end
    }

    /// Position of the foremost shock front at time `t`: the incident shock, then the reflected,
    /// until it meets the contact.
    pub fn shock_position(&self, t: f64) -> Option<f64> {
        if t > self.meeting[1] {
            None
        } else if t > self.wall_time {
            Some(self.right_wall - self.reflected_speed * (t - self.wall_time))
        } else if let Wave::Shock(speed) = self.first.right_wave() {
            Some(self.diaphragm + speed * t)
        } else {
            None
        }
    }

    /// Gas at `x` at time `t`, `0 < t <= valid_until`.
    pub fn at(&self, x: f64, t: f64) -> Result<State, ExactError> {
        require(
            t > 0.0 && t <= self.end,
            "the time",
            t,
            "times after the start and before the waves of the tube's ends meet others",
        )?;
        let undisturbed = self.first.sample((x - self.diaphragm) / t);
        if t <= self.wall_time {
            return Ok(undisturbed);
        }
        if t <= self.meeting[1] {
            let shock = self.right_wall - self.reflected_speed * (t - self.wall_time);
            return Ok(if x > shock {
                self.reflected
            } else {
                undisturbed
            });
        }
        let ray = (x - self.meeting[0]) / (t - self.meeting[1]);
        let front = match self.second.left_wave() {
            Wave::Shock(speed) => speed,
            Wave::Fan { head, .. } => head,
        };
        Ok(if ray > front {
            self.second.sample(ray)
        } else {
            undisturbed
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reference;
    use approx::{assert_abs_diff_eq, assert_relative_eq};

    #[test]
    fn the_reflection_agrees_with_the_reference_states() {
        let tube = ClosedTube::sod().unwrap();
        assert_relative_eq!(tube.wall_time(), 0.285_362_76, max_relative = 1e-7);
        assert_relative_eq!(tube.reflected().pressure, 0.780_386_08, max_relative = 1e-7);
        assert_relative_eq!(tube.reflected().density, 0.509_395_32, max_relative = 1e-7);
        assert_relative_eq!(tube.reflected().energy(1.4), 3.829_963, max_relative = 1e-6);
        assert_relative_eq!(tube.reflected_speed, 1.010_193_6, max_relative = 1e-7);
        assert_relative_eq!(tube.meeting()[1], 0.406_819_17, max_relative = 1e-7);
        assert_relative_eq!(tube.meeting()[0], 0.877_305_51, max_relative = 1e-7);
        assert_relative_eq!(
            tube.shock_position(0.375).unwrap(),
            0.909_449_03,
            max_relative = 1e-7
        );
        assert_relative_eq!(tube.valid_until(), 0.422_577_13, max_relative = 1e-7);
    }

    #[test]
    fn the_gas_after_the_shock_has_met_the_contact_agrees_with_the_reference() {
        let tube = ClosedTube::sod().unwrap();
        let star = tube.second.star().unwrap();
        assert_relative_eq!(star.pressure, 0.864_090_07, max_relative = 1e-6);
        assert_relative_eq!(star.velocity, 0.107_374_49, max_relative = 1e-6);
        assert_relative_eq!(star.density_left, 0.872_013_77, max_relative = 1e-6);
        assert_relative_eq!(star.density_right, 0.547_833_19, max_relative = 1e-6);
    }

    #[test]
    fn every_point_of_the_reference_profiles_is_reproduced() {
        let tube = ClosedTube::sod().unwrap();
        let table = reference::sod_profiles();
        for row in 0..table.len() {
            let get = |name: &str| table.column(name).unwrap()[row];
            let state = tube.at(get("x"), get("t")).unwrap();
            assert_abs_diff_eq!(state.density, get("rho"), epsilon = 1e-6);
            assert_abs_diff_eq!(state.velocity, get("u"), epsilon = 1e-6);
            assert_abs_diff_eq!(state.pressure, get("p"), epsilon = 1e-6);
            assert_abs_diff_eq!(state.energy(1.4), get("e"), epsilon = 1e-5);
        }
    }

    #[test]
    fn the_closed_tube_keeps_its_mass_and_energy() {
        let tube = ClosedTube::sod().unwrap();
        let cells = 100_000;
        for t in [0.1, 0.3, 0.375, 0.42] {
            let (mut mass, mut energy) = (0.0, 0.0);
            for k in 0..cells {
                let state = tube.at((f64::from(k) + 0.5) / f64::from(cells), t).unwrap();
                mass += state.density / f64::from(cells);
                let kinetic = 0.5 * state.velocity * state.velocity;
                energy += state.density * (state.energy(1.4) + kinetic) / f64::from(cells);
            }
            assert_relative_eq!(mass, 0.5625, max_relative = 1e-4);
            assert_relative_eq!(energy, 1.375, max_relative = 1e-4);
        }
    }

    #[test]
    fn times_out_of_range_and_tubes_the_wrong_way_round_are_refused() {
        assert!(ClosedTube::sod().unwrap().at(0.5, 0.43).is_err());
        let (low, high) = (State::new(0.125, 0.0, 0.1), State::new(1.0, 0.0, 1.0));
        assert!(ClosedTube::new(low, high, 1.4, [0.0, 0.5, 1.0]).is_err());
    }
}
