//! Goes to the steady state, and tells when it is there.
//!
//! Forces, the mass of the gas and its centre are watched: the flow has settled once none of them has changed by more than a tolerance
//! over a number of iterations, nor creeps on by more than that. The residual is told, and not asked: a limiter may keep it cycling long after nothing changes.

use serde::{Deserialize, Serialize};

use super::FixedSimulation;
use super::equation_of_state::EquationOfState;
use super::pace::{Pace, RAMP_LENGTH};
use super::poles::Poles;
use super::state::dot;
use super::stillness::{LONGEST, Look, WINDOW, change, range};
use super::sweeps::Sweeps;
use crate::Failure;
use crate::frame::Load;

/// A force counts as at least this part of what presses the walls, and as at most so many times that.
const LEAST_FORCE: f64 = 0.01;
const MOST_FORCE: f64 = 10.0;

/// Departures from the stream's pressure below this part of it, and speeds below this part of that of sound, are rounded: gas at rest has no others.
const ROUNDED: f64 = 1e-9;

/// Friction below this part of the largest force is not waited for, nor is the heat of as much at the speed of sound.
const LEAST_FRICTION: f64 = 1e-6;

/// Largest change over a window below which the flow may ask for points.
const NEAR: f64 = 3e-3;

/// Largest change over a window of the mass, of its centre relative to the domain, and of what friction and heat are watched by.
const TOLERANCE: f64 = 1e-4;

/// The same of a force: limiters may keep it cycling by a few parts in ten thousand.
const TOLERANCE_OF_FORCES: f64 = 1e-3;

/// Where a flow is on its way to the steady state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settled {
    /// Iterations so far.
    pub iterations: u64,
    /// Rate at which the cells' masses change, relative to the first one.
    pub residual: f64,
    /// Largest change of what is watched over the last iterations.
    pub change: f64,
    /// True once that is as small as asked.
    pub is_settled: bool,
}

/// What was seen on the way.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct Settling {
    pub(super) counts: Counts,
    /// True of a flow that began where an earlier one had settled, and has not gone far from there.
    #[serde(default, rename = "has_begun_near")]
    pub(super) is_near: bool,
    /// True once the flow wants no more points.
    pub(super) has_points: bool,
    /// The first residual; the largest of the first ones of viscous gas.
    first: f64,
    #[serde(default)]
    pub(super) pace: Pace,
    /// Mass of closed-in gas.
    #[serde(default)]
    pub(super) mass: Option<f64>,
    /// What the bodies are to the stream far away; none before the first iteration.
    #[serde(default)]
    pub(super) poles: Option<Poles>,
    /// What was watched in the last iterations.
    pub(super) watched: Vec<Vec<f64>>,
    /// What changes of each of that are measured by.
    #[serde(default)]
    measures: Vec<Measure>,
    /// Links of the cells in the order of the flow, once it has begun to settle on them.
    #[serde(skip)]
    pub(super) sweeps: Option<Sweeps>,
}

impl Settling {
    /// True after the first iteration.
    pub(super) fn has_begun(&self) -> bool {
        self.counts.iterations > 0
    }
}

/// How far it is.
#[derive(Clone, Copy, Debug, Default, Serialize, Deserialize)]
pub struct Counts {
    /// Iterations.
    iterations: u64,
    /// Iterations since points came or went.
    pub(super) since: u64,
    /// Iterations since so many came or went that the gas is far from rest again.
    pub(super) calm: u64,
    /// How often points came or went.
    pub(super) adaptions: u32,
}

/// What changes of a value are measured by.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
struct Measure {
    /// How large the value counts as.
    size: f64,
    /// Largest part of that by which it may change where the flow has settled.
    tolerance: f64,
}

impl<const D: usize> FixedSimulation<D> {
    /// One iteration towards the steady state.
    ///
    /// # Errors
    /// A [`Failure`] where a cell's state makes no sense any more.
    pub fn settle_step(&mut self) -> Result<Settled, Failure> {
        self.turn_far_field();
        self.remember_mass();
        let courant = self.settling.pace.courant(self.settling.counts.calm);
        let residual = self.implicit_step(courant)?;
        self.keep_mass()?;
        self.tally.steps += 1;
        self.tally.updates += self.awake_cells();
        let (watched, measures) = self.watched().into_iter().unzip();
        let is_viscous = self.fluid.viscous.is_some();
        let is_slow_to_rest = is_viscous || self.throws_sound_back();
        let may_swing = self.is_slow() && !is_viscous;
        let is_turned = self.outside.far_field.is_some();
        let settling = &mut self.settling;
        settling.measures = measures;
        let counts = &mut settling.counts;
        counts.iterations += 1;
        counts.since += 1;
        counts.calm += 1;
        settling.pace.go_by(residual, counts.since, may_swing);
        let counts = *counts;
        if settling.first == 0.0 {
            settling.first = residual;
        }
        if settling.watched.len() > 2 * LONGEST {
            settling.watched.remove(0);
        }
        settling.watched.push(watched);
        if is_viscous && counts.iterations <= WINDOW as u64 {
            // Walls stop the gas before anything else changes.
            settling.first = settling.first.max(residual);
        }
        let look = match (is_slow_to_rest, is_turned, settling.is_near) {
            (true, ..) => Look::LONG,
            (_, true, _) => Look::TURNED,
            (.., true) => Look::NEAR,
            _ => Look::USUAL,
        };
        let (change, is_still) = settling.change(look);
        let settled = Settled {
            iterations: counts.iterations,
            residual: if settling.first > 0.0 {
                residual / settling.first
            } else {
                0.0
            },
            change,
            is_settled: is_still
                && counts.since >= WINDOW as u64
                && (settling.has_points || self.ground.is_none()),
        };
        let is_near = self.settling.last_change() < NEAR;
        self.ask_for_points(is_near)?;
        Ok(settled)
    }

    /// Iterates until the flow has settled, `most` times at most.
    ///
    /// # Errors
    /// As of [`Self::settle_step`].
    pub fn settle(&mut self, most: u64) -> Result<Settled, Failure> {
        loop {
            let settled = self.settle_step()?;
            if settled.is_settled || settled.iterations >= most {
                return Ok(settled);
            }
        }
    }

    /// What must not change, and what its changes are measured by.
    fn watched(&self) -> Vec<(f64, Measure)> {
        let within = |size| Measure {
            size,
            tolerance: TOLERANCE,
        };
        let (mass, centre) = self.mass_and_centre();
        let size = self.problem.domain.bounds.size().norm();
        let mut watched = vec![(mass.ln(), within(1.0))];
        watched.extend(centre.iter().map(|x| (*x, within(size))));
        let loads = self.loads();
        let force = Measure {
            size: self.size_of_forces(&loads),
            tolerance: TOLERANCE_OF_FORCES,
        };
        let forces = loads.iter().flat_map(|load| load.force);
        watched.extend(forces.map(|f| (f, force)));
        if self.throws_sound_back() {
            // As much flows in as out long before it is as much as the pressures ask for.
            let (momentum, size) = self.momentum();
            watched.extend(momentum.map(|part| (part, within(size))));
        }
        if self.fluid.viscous.is_some() {
            let rubbed = self.rubbed(&loads, force.size);
            watched.extend(rubbed.into_iter().map(|value| (value, within(1.0))));
        }
        watched
    }

    /// Momentum of all gas, and what it would be if all went one way.
    fn momentum(&self) -> ([f64; D], f64) {
        let (mut sums, mut size) = ([0.0; D], f64::MIN_POSITIVE);
        let slowest = ROUNDED * self.speed_of_sound();
        for (i, held) in self.columns.held.iter().enumerate() {
            let volume = self.net.cell(i).volume;
            for (sum, part) in sums.iter_mut().zip(held.momentum) {
                *sum += part * volume;
            }
            let speed = dot(&held.momentum, &held.momentum).sqrt();
            size += (speed + slowest * held.mass) * volume;
        }
        (sums, size)
    }

    /// Of the stream.
    fn speed_of_sound(&self) -> f64 {
        let stream = &self.problem.free_stream;
        let square = (self.fluid.gas).sound_square(stream.density, stream.pressure);
        square.sqrt()
    }

    /// What changes of forces are measured by: the largest one, bounded by what all departures from the stream's pressure press the walls with:
    /// from above, for what that pressure does to a body that the domain cuts does not change, and from below, for opposite sides may leave
    /// nothing of it.
    fn size_of_forces(&self, loads: &[Load]) -> f64 {
        let norms = loads
            .iter()
            .map(|load| load.force.iter().map(|f| f * f).sum::<f64>().sqrt());
        let largest = norms.fold(f64::MIN_POSITIVE, f64::max);
        if self.fluid.viscous.is_some() {
            // Friction is watched by itself, and where it is all there is, pressure need not be as still.
            return largest;
        }
        let calm = self.problem.free_stream.pressure;
        let rounded = ROUNDED * calm.abs();
        let departures = self
            .walls()
            .map(|(wall, pressure)| (rounded + (pressure - calm).abs()) * wall.image.size);
        let pressed = departures.sum::<f64>() * self.around();
        let size = largest.min(MOST_FORCE * pressed).max(LEAST_FORCE * pressed);
        size.max(f64::MIN_POSITIVE)
    }

    /// What settles last in viscous gas, and hardly counts beside pressure: friction, heat, the temperature of walls and the energy of all gas.
    /// Those of all walls in parts of themselves, so that they are seen to grow, be they ever so small beside the largest `force`.
    fn rubbed(&self, loads: &[Load], force: f64) -> Vec<f64> {
        let [mut friction, mut heat, mut area, mut warmth] = [0.0; 4];
        for ((wall, _), share) in self.walls().zip(self.wall_shares()) {
            let size = wall.image.size;
            friction += dot(&share.stress, &share.stress).sqrt() * size;
            heat += share.heat.abs() * size;
            area += size;
            warmth += share.temperature * size;
        }
        let held = self.columns.held.iter().enumerate();
        let energy: f64 = held
            .map(|(i, held)| held.energy * self.net.cell(i).volume)
            .sum();
        let friction = friction + LEAST_FRICTION * force;
        let heat = heat + LEAST_FRICTION * force * self.speed_of_sound();
        let mut watched = vec![energy.ln(), friction.ln(), heat.ln()];
        if area > 0.0 {
            watched.push((warmth / area).ln());
        }
        watched.extend(
            loads
                .iter()
                .flat_map(|load| load.friction.map(|f| f / friction)),
        );
        watched.extend(loads.iter().map(|load| load.heat / heat));
        watched
    }
}

impl Settling {
    /// Of a flow that starts as an earlier one has settled, on its points, whose cells may be split `most` times.
    pub(super) fn from_earlier(most: u32) -> Self {
        Self {
            is_near: true,
            counts: Counts {
                calm: RAMP_LENGTH,
                adaptions: most,
                ..Counts::default()
            },
            ..Self::default()
        }
    }

    /// Largest change of what was watched, see [`change`], and whether all of it is within its tolerance; infinite before two windows are full.
    fn change(&self, look: Look) -> (f64, bool) {
        let Some(first) = self.watched.len().checked_sub(2 * look.window + 1) else {
            return (f64::INFINITY, false);
        };
        let changes = self.changes(&self.watched[first..], |values| change(values, look));
        let mut pairs = changes.iter().zip(&self.measures);
        let is_still = pairs.all(|(change, by)| *change < by.tolerance);
        (changes.into_iter().fold(0.0, f64::max), is_still)
    }

    /// Largest range over the last window, whatever was before it; infinite before one is full.
    fn last_change(&self) -> f64 {
        match self.watched.len().checked_sub(WINDOW + 1) {
            Some(first) => {
                let changes = self.changes(&self.watched[first..], range);
                changes.into_iter().fold(0.0, f64::max)
            }
            None => f64::INFINITY,
        }
    }

    /// What `measure` makes of each value that was watched, in parts of its size.
    fn changes(&self, watched: &[Vec<f64>], measure: impl Fn(&[f64]) -> f64) -> Vec<f64> {
        let each = self.measures.iter().enumerate().map(|(k, by)| {
            let values: Vec<f64> = watched.iter().map(|watched| watched[k]).collect();
            measure(&values) / by.size
        });
        each.collect()
    }
}
