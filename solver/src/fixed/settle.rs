//! Goes to the steady state, and tells when it is there.
//!
//! Forces, the mass of the gas and its centre are watched: the flow has settled once none of them has changed by more than a tolerance
//! over a number of iterations, nor creeps on by more than that. The residual is told, and not asked: a limiter may keep it cycling long after nothing changes.

use serde::{Deserialize, Serialize};

use super::FixedSimulation;
use super::gas::Gas;
use super::pace::Pace;
use super::state::dot;
use crate::Failure;
use crate::frame::Load;

/// Iterations over which nothing may change.
const WINDOW: usize = 20;

/// Part of its range that a value that creeps goes on by in a window.
const STRAIGHT: f64 = 0.9;

/// Largest part of a window's way that the next is taken to go, so that what only seems to creep is not waited for for ever.
const SLOWEST: f64 = 0.98;

/// The same of viscous flows: heat spreads slowly.
const SLOWEST_VISCOUS: f64 = 0.9995;

/// A force counts as at least this part of what presses the walls, and as at most so many times that.
const LEAST_FORCE: f64 = 0.01;
const MOST_FORCE: f64 = 10.0;

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
    iterations: u64,
    /// Iterations since points came or went.
    pub(super) since: u64,
    /// Iterations since so many came or went that the gas is far from rest again.
    #[serde(default)]
    pub(super) calm: u64,
    /// True of a flow that began where an earlier one had settled.
    #[serde(default)]
    pub(super) has_begun_near: bool,
    /// How often they did.
    pub(super) adaptions: u32,
    /// True once the flow wants no more of them.
    pub(super) has_points: bool,
    /// The first residual; the largest of the first ones of viscous gas.
    first: f64,
    #[serde(default)]
    pace: Pace,
    /// What was watched in the last iterations.
    pub(super) watched: Vec<Vec<f64>>,
    /// What changes of each of that are measured by.
    #[serde(default)]
    measures: Vec<Measure>,
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
        let courant = self.settling.pace.courant(self.settling.calm);
        let residual = self.sweep(courant)?;
        self.tally.steps += 1;
        self.tally.updates += self.awake_cells();
        let (watched, measures) = self.watched().into_iter().unzip();
        let settling = &mut self.settling;
        settling.measures = measures;
        settling.iterations += 1;
        settling.since += 1;
        settling.calm += 1;
        settling.pace.go_by(residual, settling.since);
        if settling.first == 0.0 {
            settling.first = residual;
        }
        if settling.watched.len() > 2 * WINDOW {
            settling.watched.remove(0);
        }
        settling.watched.push(watched);
        let is_viscous = self.viscous.is_some();
        if is_viscous && settling.iterations <= WINDOW as u64 {
            // Walls stop the gas before anything else changes.
            settling.first = settling.first.max(residual);
        }
        let slowest = if is_viscous { SLOWEST_VISCOUS } else { SLOWEST };
        let (change, is_still) = settling.change(slowest);
        let settled = Settled {
            iterations: settling.iterations,
            residual: if settling.first > 0.0 {
                residual / settling.first
            } else {
                0.0
            },
            change,
            is_settled: is_still
                && settling.since >= WINDOW as u64
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
        if self.viscous.is_some() {
            let rubbed = self.rubbed(&loads, force.size);
            watched.extend(rubbed.into_iter().map(|value| (value, within(1.0))));
        }
        watched
    }

    /// What changes of forces are measured by: the largest one, bounded by what all departures from the stream's pressure press the walls with:
    /// from above, for what that pressure does to a body that the domain cuts does not change, and from below, for opposite sides may leave
    /// nothing of it.
    fn size_of_forces(&self, loads: &[Load]) -> f64 {
        let norms = loads
            .iter()
            .map(|load| load.force.iter().map(|f| f * f).sum::<f64>().sqrt());
        let largest = norms.fold(f64::MIN_POSITIVE, f64::max);
        if self.viscous.is_some() {
            // Friction is watched by itself, and where it is all there is, pressure need not be as still.
            return largest;
        }
        let calm = self.problem.free_stream.pressure;
        let departures = self
            .walls()
            .map(|(wall, pressure)| (pressure - calm).abs() * wall.image.size);
        let pressed = departures.sum::<f64>() * self.around();
        let size = largest.min(MOST_FORCE * pressed).max(LEAST_FORCE * pressed);
        size.max(f64::MIN_POSITIVE)
    }

    /// What settles last in viscous gas, and hardly counts beside pressure: friction, heat, the temperature of walls and the energy of all gas.
    /// Those of all walls in parts of themselves, so that they are seen to grow, be they ever so small beside the largest `force`.
    fn rubbed(&self, loads: &[Load], force: f64) -> Vec<f64> {
        let [mut friction, mut heat, mut area, mut level] = [0.0; 4];
        for ((wall, _), share) in self.walls().zip(self.wall_shares()) {
            let size = wall.image.size;
            friction += dot(&share.stress, &share.stress).sqrt() * size;
            heat += share.heat.abs() * size;
            area += size;
            level += share.level * size;
        }
        let held = self.columns.held.iter().enumerate();
        let energy: f64 = held
            .map(|(i, held)| held.energy * self.net.cell(i).volume)
            .sum();
        let sound = self.gas.sound_square(
            self.problem.free_stream.density,
            self.problem.free_stream.pressure,
        );
        let friction = friction + LEAST_FRICTION * force;
        let heat = heat + LEAST_FRICTION * force * sound.sqrt();
        let mut watched = vec![energy.ln(), friction.ln(), heat.ln()];
        if area > 0.0 {
            watched.push((level / area).ln());
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
            has_begun_near: true,
            adaptions: most,
            ..Self::default()
        }
    }

    /// Largest change of what was watched, see [`change`], and whether all of it is within its tolerance; infinite before two windows are full.
    fn change(&self, slowest: f64) -> (f64, bool) {
        if self.watched.len() <= 2 * WINDOW {
            return (f64::INFINITY, false);
        }
        let changes = self.changes(&self.watched, |values| change(values, slowest));
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

fn range(values: &[f64]) -> f64 {
    let most = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let least = values.iter().copied().fold(f64::INFINITY, f64::min);
    most - least
}

/// Range of the second half of `values`; more of one that creeps, all through both halves and one way: what is left of its way if
/// each window goes on to take the same part of the one before, at most `slowest`.
fn change(values: &[f64], slowest: f64) -> f64 {
    let (first, second) = (&values[..=WINDOW], &values[WINDOW..]);
    let way = |values: &[f64]| values[values.len() - 1] - values[0];
    let creeps = |values: &[f64]| way(values).abs() > STRAIGHT * range(values);
    let (before, now) = (way(first), way(second));
    if creeps(first) && creeps(second) && before * now > 0.0 {
        let part = (now / before).min(slowest);
        range(second).max(now.abs() / (1.0 - part))
    } else {
        range(second)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn watched(value: impl Fn(f64) -> f64) -> Vec<f64> {
        (0..=2 * WINDOW).map(|k| value(k as f64)).collect()
    }

    #[test]
    fn what_creeps_is_far_from_where_it_goes() {
        // Half a per cent of the way in each iteration: the rest of the way is what it is at the start of the second window.
        let change = change(&watched(|k| (-0.005 * k).exp()), SLOWEST);
        let rest = (-0.005 * WINDOW as f64).exp();
        assert!((change / rest - 1.0).abs() < 1e-9, "{change} {rest}");
    }

    #[test]
    fn what_swings_changes_by_its_range() {
        let change = change(&watched(|k| (1.3 * k).sin()), SLOWEST);
        assert!((1.9..=2.0).contains(&change), "{change}");
    }
}
