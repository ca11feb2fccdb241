//! Two oblique shocks of opposite ways that cross: each goes on through the gas behind the other one, and what is behind both
//! has one pressure and one direction on both sides of a slip line.
//!
//! Source: Anderson, "Modern Compressible Flow", section 4.8, with eqs. 4.7-4.17 for each of the four shocks.

use super::oblique::{ObliqueShock, Strength, detachment, oblique_shock};
use super::root::bracketed_root;
use super::{ExactError, require};

/// Four shocks that meet in one point. Directions are angles from that of the stream, radians, upwards; the first of each pair is that of the gas
/// below.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing {
    /// The shock of the lower and that of the upper wall.
    pub first: [ObliqueShock; 2],
    /// What goes on through the gas along the lower and along the upper wall.
    pub second: [ObliqueShock; 2],
    /// Direction of the slip line.
    pub direction: f64,
    /// Pressure behind both over the stream's.
    pub pressure_ratio: f64,
    /// Density below and above the slip line over the stream's.
    pub density_ratios: [f64; 2],
}

impl Crossing {
    /// Directions of the shocks behind the crossing, downwards below and upwards above.
    pub fn beyond(&self) -> [f64; 2] {
        let [below, above] = [0, 1].map(|k| self.first[k].deflection - self.second[k].angle);
        [below, -above]
    }
}

/// The crossing of the shocks of a wall below that turns a stream of Mach number `mach` upwards and one above that turns it downwards, by `turns`
/// in radians, both above zero.
///
/// # Errors
/// Turns of which a shock is detached, or whose shocks do not cross but in a stem across the stream.
pub fn crossing(mach: f64, turns: [f64; 2], gamma: f64) -> Result<Crossing, ExactError> {
    let shock = |mach, turn| oblique_shock(mach, turn, gamma, Strength::Weak);
    let first = [shock(mach, turns[0])?, shock(mach, turns[1])?];
    let largest = [0, 1].map(|k| detachment(first[k].mach, gamma).map(|most| most.deflection));
    let [below, above] = largest;
    // Gas below is turned from its wall's direction down to that of the slip line, gas above up to it.
    let lowest = (turns[0] - below?).max(-turns[1]);
    let highest = (above? - turns[1]).min(turns[0]);
    require(
        lowest < highest,
        "the larger turn in radians",
        turns[0].max(turns[1]),
        "turns of which one pressure is left",
    )?;
    let pressure = |k: usize, turn: f64| -> f64 {
        let behind = shock(first[k].mach, turn).map_or(1.0, |shock| shock.pressure_ratio);
        first[k].pressure_ratio * behind
    };
    let apart =
        |direction: f64| pressure(0, turns[0] - direction) - pressure(1, direction + turns[1]);
    require(
        apart(lowest) > 0.0 && apart(highest) < 0.0,
        "the larger turn in radians",
        turns[0].max(turns[1]),
        "turns of which one pressure is left",
    )?;
    let direction = bracketed_root(apart, lowest, highest);
    let second = [
        shock(first[0].mach, turns[0] - direction)?,
        shock(first[1].mach, direction + turns[1])?,
    ];
    let density = |k: usize| first[k].density_ratio * second[k].density_ratio;
    Ok(Crossing {
        first,
        second,
        direction,
        pressure_ratio: first[0].pressure_ratio * second[0].pressure_ratio,
        density_ratios: [density(0), density(1)],
    })
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    /// NACA Report 1135 (1953), charts 2 and 3: a stream of Mach 3 is at 2.505 behind a shock that turns it by 10 degrees, with 2.054 of its pressure;
    /// the second one, at 31.8 degrees, makes 1.866 of that.
    #[test]
    fn shocks_of_equal_wedges_leave_the_stream_its_direction() {
        let turn = f64::to_radians(10.0);
        let crossing = crossing(3.0, [turn; 2], 1.4).unwrap();
        assert!(crossing.direction.abs() < 1e-12);
        assert_relative_eq!(crossing.first[0].pressure_ratio, 2.0545, epsilon = 1e-4);
        assert_relative_eq!(crossing.second[0].pressure_ratio, 1.8656, epsilon = 1e-3);
        let [below, above] = crossing.beyond().map(f64::to_degrees);
        assert_relative_eq!(below, 10.0 - 31.8, epsilon = 0.02);
        assert_relative_eq!(above, 31.8 - 10.0, epsilon = 0.02);
    }

    /// What is behind has one pressure and one direction, by whichever way gas comes there.
    #[test]
    fn gas_on_both_sides_of_the_slip_line_goes_one_way_under_one_pressure() {
        for (mach, turns) in [
            (3.0, [10.0_f64, 16.0]),
            (2.5, [12.0, 3.0]),
            (5.0, [20.0, 5.0]),
        ] {
            let turns = turns.map(f64::to_radians);
            let met = crossing(mach, turns, 1.4).unwrap();
            let [below, above] =
                [0, 1].map(|k| met.first[k].pressure_ratio * met.second[k].pressure_ratio);
            assert_relative_eq!(below, above, max_relative = 1e-9);
            let ways = [
                turns[0] - met.second[0].deflection,
                met.second[1].deflection - turns[1],
            ];
            assert_relative_eq!(ways[0], ways[1], epsilon = 1e-9);
            assert!((met.direction > 0.0) == (turns[0] > turns[1]));
            let swapped = crossing(mach, [turns[1], turns[0]], 1.4).unwrap();
            assert_relative_eq!(met.direction, -swapped.direction, epsilon = 1e-9);
        }
    }

    #[test]
    fn shocks_that_meet_in_a_stem_are_refused() {
        let turns = [20.0_f64, 25.0].map(f64::to_radians);
        assert!(crossing(2.5, turns, 1.4).is_err());
    }
}
