//! How far from its bend or tip a shock stands straight, between the gas that the bend tells of: up to where gas beside it is another.
//!
//! A wave that comes from elsewhere bends a shock, and what a shock that is taken for straight there does to the gas it does not do. Cells that the shock
//! runs through, or that are next to it, cannot tell: as long as it is held they are as it wants them. Those some spacings ahead of it do, and
//! those some spacings behind it, which a captured shock leaves as they are too.

use aero_geometry::parallel::prelude::*;

use super::attached::{AttachedShock, across, farthest};
use super::bend::Bend;
use super::cloven::{Cleaving, MOST};
use super::equation_of_state::EquationOfState;
use super::fan::rise;
use super::root::Plan;
use super::state::{Primitive, dot};

/// From here to there from a shock, in spacings, cells ahead of it are looked at; none farther off than [`FELT`](super::attached::FELT).
const AHEAD: [f64; 2] = [2.5, 6.5];

/// From here to there from a shock, in spacings, cells behind it are looked at.
const BEHIND: [f64; 2] = [3.0, 6.5];

/// Part of what a shock changes by which gas ahead of it may be another than at its bend.
const OFF_AHEAD: f64 = 0.02;

/// The same behind it, where a captured shock leaves some noise.
const OFF_BEHIND: f64 = 0.1;

/// Near the bend gas may be as far off as gas that has yet to find its shock: so far from there, in spacings, by all of what the shock changes, and from there on
/// by the inverse square of the distance.
const BEGINNING: [f64; 2] = [6.0, 12.0];

/// Bounds how far the shocks of all blocks stand by the gas beside them.
pub fn bound<G: EquationOfState, const D: usize>(
    gas: &G,
    blocks: &mut [Vec<Cleaving<'_, D>>],
    states: &[Primitive<D>],
) {
    let numbers = blocks.iter().flatten().map(|cleaving| cleaving.root.number);
    let Some(last) = numbers.max() else {
        return;
    };
    let each: Vec<Vec<[f64; MOST]>> = blocks
        .par_iter()
        .map(|block| block.iter().map(|one| one.reaches(gas, states)).collect())
        .collect();
    let mut reaches = vec![[farthest::<D>(); MOST]; last as usize + 1];
    for (cleaving, found) in blocks.iter().flatten().zip(each.iter().flatten()) {
        let reaches = &mut reaches[cleaving.root.number as usize];
        for (reach, found) in reaches.iter_mut().zip(found) {
            *reach = reach.min(*found);
        }
    }
    for cleaving in blocks.iter_mut().flatten() {
        let reaches = &reaches[cleaving.root.number as usize];
        for (behind, reach) in cleaving.shocks.iter_mut().zip(reaches) {
            behind.reach = *reach;
        }
    }
}

impl<const D: usize> Cleaving<'_, D> {
    /// How far each shock stands by the cells around it, in spacings.
    fn reaches<G: EquationOfState>(&self, gas: &G, states: &[Primitive<D>]) -> [f64; MOST] {
        let bend = &self.root.bends[0];
        let mut reaches = [farthest::<D>(); MOST];
        for (number, behind) in self.shocks.iter().enumerate() {
            if let (Some(straight), Some(field)) = (self.root.apex, &behind.shock.field) {
                reaches[number] = reaches[number].min(field.felt(straight));
            }
            let course = Course::new(gas, &behind.shock, &self.front, bend);
            for (cell, parts) in self.root.cells.iter().zip(&self.parts) {
                let all = parts.iter().sum::<f64>();
                if all > 0.0 && parts[number] < 1.0 {
                    continue;
                }
                let Some(seen) = course.sees(cell, all > 0.0) else {
                    continue;
                };
                let known = if all > 0.0 {
                    behind.shock.rear_at(&cell.point)
                } else {
                    self.front
                };
                let own = &states[cell.cell as usize];
                reaches[number] = reaches[number].min(course.reach(&seen, own, &known));
            }
        }
        reaches
    }
}

/// A cell that may say how far a shock stands.
struct Witness {
    /// So far along the shock, in spacings.
    away: f64,
    /// Parts of what the shock changes that it may be off by.
    least: f64,
    is_behind: bool,
}

/// A shock, and which way it goes from its bend.
struct Course<'a, const D: usize> {
    shock: &'a AttachedShock<D>,
    along: [f64; D],
    unit: f64,
    /// Logarithm of the density behind over that in front.
    thickening: f64,
    /// By how much it slows the gas.
    slowing: f64,
    /// How much farther along the shock than across it a sound from behind comes to it.
    lag: f64,
}

impl<'a, const D: usize> Course<'a, D> {
    fn new<G: EquationOfState>(
        gas: &G,
        shock: &'a AttachedShock<D>,
        front: &Primitive<D>,
        bend: &Bend<D>,
    ) -> Self {
        let mut along = across(&front.velocity, &bend.edge);
        let across = dot(&front.velocity, &shock.normal);
        let mut slowing = 0.0;
        for k in 0..D {
            along[k] -= across * shock.normal[k];
            slowing += (shock.rear.velocity[k] - front.velocity[k]).powi(2);
        }
        let size = dot(&along, &along).sqrt();
        Self {
            shock,
            along: along.map(|part| part / size),
            unit: bend.unit,
            thickening: (shock.rear.density / front.density).ln(),
            slowing: slowing.sqrt(),
            lag: lag(gas, shock, &bend.edge),
        }
    }

    /// What a cell on that side may say of the shock; nothing of one that is next to it or far from it.
    fn sees(&self, cell: &Plan<D>, is_behind: bool) -> Option<Witness> {
        let ahead = dot(&cell.point, &self.shock.normal) / self.unit;
        let height = if is_behind { -ahead } else { ahead };
        let beside = dot(&cell.point, &self.along) / self.unit;
        let ([from, to], least, beginning, away) = if is_behind {
            let felt = beside + self.lag * height;
            (BEHIND, OFF_BEHIND, BEGINNING[1], felt)
        } else {
            (AHEAD, OFF_AHEAD, BEGINNING[0], beside)
        };
        (beside > 0.0 && (from..to).contains(&height)).then(|| Witness {
            away,
            least: least.max((beginning / away).powi(2)),
            is_behind,
        })
    }

    /// How far the shock stands, in spacings, by a cell in the state `own` where it would be `known`.
    fn reach(&self, seen: &Witness, own: &Primitive<D>, known: &Primitive<D>) -> f64 {
        let Witness { away, least, .. } = *seen;
        let agrees = 1.0 - rise(self.off(own, known, seen.is_behind), least, 2.0 * least);
        away + agrees * (farthest::<D>() - away).max(0.0)
    }

    /// How far a state is off, in parts of what the shock changes. Behind it density may be another along a wall.
    fn off(&self, own: &Primitive<D>, known: &Primitive<D>, is_behind: bool) -> f64 {
        let mut speed = 0.0;
        for k in 0..D {
            speed += (own.velocity[k] - known.velocity[k]).powi(2);
        }
        let pressure = (own.pressure / known.pressure).ln().abs() / self.shock.strength;
        let off = pressure.max(speed.sqrt() / self.slowing);
        if is_behind {
            return off;
        }
        off.max((own.density / known.density).ln().abs() / self.thickening)
    }
}

/// Cotangent of the angle between a shock and the Mach lines that come to it from behind: zero where gas is slower than sound there.
fn lag<G: EquationOfState, const D: usize>(
    gas: &G,
    shock: &AttachedShock<D>,
    edge: &[f64; D],
) -> f64 {
    let rear = &shock.rear;
    let across = across(&rear.velocity, edge);
    let square = dot(&across, &across);
    let mach = (square / gas.sound_square(rear.density, rear.pressure)).sqrt();
    if mach <= 1.0 {
        return 0.0;
    }
    let elevation = (dot(&across, &shock.normal).abs() / square.sqrt()).asin();
    1.0 / ((1.0 / mach).asin() - elevation).tan()
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use aero_geometry::Vector;
    use approx::assert_relative_eq;

    use super::*;
    use crate::fixed::state::front;
    use crate::gas::IdealGas;

    const AIR: IdealGas = IdealGas::new(1.4);

    fn bend() -> Bend<2> {
        Bend::ramp(15.0, 0.1)
    }

    fn shock() -> AttachedShock<2> {
        AttachedShock::new(&AIR, &front(), &bend()).unwrap()
    }

    /// How far the shock stands by a cell so far along it and ahead of it, in spacings.
    fn reach(along: f64, ahead: f64, own: &Primitive<2>) -> f64 {
        let shock = shock();
        let front = front();
        let course = Course::new(&AIR, &shock, &front, &bend());
        let place = Vector::from(course.along) * along + Vector::from(shock.normal) * ahead;
        let cell = Plan {
            cell: 0,
            point: (place * 0.1).into(),
            radius: 0.07,
            volume: 0.01,
            pieces: Arc::new([]),
        };
        let is_behind = ahead < 0.0;
        let known = if is_behind { &shock.rear } else { &front };
        let seen = course.sees(&cell, is_behind);
        seen.map_or(farthest::<2>(), |seen| course.reach(&seen, own, known))
    }

    /// NACA Report 1135 (1953), charts 2 and 3: at Mach 3 and 15 degrees the shock rises by 32.24, and gas is at Mach 2.255 behind it, where Mach lines rise by
    /// 26.33 degrees over the wall and the shock by 17.24.
    #[test]
    fn a_shock_runs_along_the_gas_and_feels_what_is_behind_it_along_mach_lines() {
        let (shock, front) = (shock(), front());
        let course = Course::new(&AIR, &shock, &front, &bend());
        let rise = course.along[1].atan2(course.along[0]).to_degrees();
        assert_relative_eq!(rise, 32.24, epsilon = 0.01);
        let cotangent = 1.0 / f64::to_radians(26.33 - 17.24).tan();
        assert_relative_eq!(course.lag, cotangent, max_relative = 0.01);
    }

    /// What gas moves along an edge in space changes nothing of it.
    #[test]
    fn a_shock_at_a_swept_edge_runs_across_it() {
        let flat = bend();
        let lifted = |[x, y]: [f64; 2]| [x, y, 0.0];
        let edge = Bend {
            at: [0.0; 3],
            edge: [0.0, 0.0, 1.0],
            donors: Vec::new(),
            along: lifted(flat.along),
            before: lifted(flat.before),
            up: lifted(flat.up),
            unit: flat.unit,
        };
        let swept = Primitive {
            density: 1.4,
            velocity: [3.0, 0.0, 2.0],
            pressure: 1.0,
        };
        let (plane, space) = (shock(), AttachedShock::new(&AIR, &swept, &edge).unwrap());
        assert_relative_eq!(space.rear.pressure, plane.rear.pressure);
        assert_relative_eq!(space.rear.velocity[2], 2.0);
        let course = Course::new(&AIR, &space, &swept, &edge);
        let front = front();
        let straight = Course::new(&AIR, &plane, &front, &flat);
        assert_relative_eq!(course.lag, straight.lag, max_relative = 1e-12);
        assert_relative_eq!(course.along[0], straight.along[0], max_relative = 1e-12);
        assert_eq!(course.along[2], 0.0);
    }

    #[test]
    fn a_shock_stands_as_far_as_the_gas_ahead_of_it_is_that_of_its_bend() {
        let strength = shock().strength;
        let off = |part: f64| Primitive {
            pressure: (part * strength).exp(),
            ..front()
        };
        assert_eq!(reach(60.0, 4.0, &front()), farthest::<2>());
        assert_eq!(reach(60.0, 4.0, &off(0.015)), farthest::<2>());
        assert_relative_eq!(reach(60.0, 4.0, &off(0.05)), 60.0);
        let half = reach(60.0, 4.0, &off(0.03));
        assert_relative_eq!(half, 94.0, epsilon = 1e-6);
        // Near the bend, in the shock and far from it nothing is told by that.
        for (along, ahead) in [(12.0, 4.0), (60.0, 1.0), (60.0, 9.0), (-20.0, 4.0)] {
            assert_eq!(reach(along, ahead, &off(0.05)), farthest::<2>());
        }
        let shears = Primitive {
            velocity: [2.8, 0.0],
            ..front()
        };
        let is_light = Primitive {
            density: 1.2,
            ..front()
        };
        assert_relative_eq!(reach(60.0, 4.0, &shears), 60.0);
        assert_relative_eq!(reach(60.0, 4.0, &is_light), 60.0);
    }

    #[test]
    fn gas_behind_a_shock_counts_where_its_sound_comes_to_it() {
        let shock = shock();
        let lag = Course::new(&AIR, &shock, &front(), &bend()).lag;
        let is_pressed = Primitive {
            pressure: shock.rear.pressure * (0.3 * shock.strength).exp(),
            ..shock.rear
        };
        assert_relative_eq!(
            reach(60.0, -4.0, &is_pressed),
            60.0 + 4.0 * lag,
            epsilon = 1e-9
        );
        // A layer along the wall is of another density for good.
        let is_light = Primitive {
            density: 0.7 * shock.rear.density,
            ..shock.rear
        };
        assert_eq!(reach(60.0, -4.0, &is_light), farthest::<2>());
    }
}
