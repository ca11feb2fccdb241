//! Goes to the steady state, and tells when it is there.
//!
//! Forces, the mass of the gas and its centre are watched: the flow has settled once none of them has changed by more than a tolerance
//! over a number of iterations. The residual is told, and not asked: a limiter may keep it cycling long after nothing changes.

use serde::{Deserialize, Serialize};

use super::FixedSimulation;
use crate::Failure;

/// The Courant number grows by this much with each iteration.
const RAMP: f64 = 0.4;

/// Up to this much.
const FASTEST: f64 = 20.0;

/// Iterations over which nothing may change.
const WINDOW: usize = 20;

/// Largest change over a window, of a force relative to the largest one, of the mass, and of its centre relative to the domain.
pub const TOLERANCE: f64 = 1e-4;

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
    /// How often they did.
    pub(super) adaptions: u32,
    /// True once the flow wants no more of them.
    pub(super) has_points: bool,
    /// The first residual.
    first: f64,
    /// What was watched in the last iterations.
    pub(super) watched: Vec<Vec<f64>>,
}

impl<const D: usize> FixedSimulation<D> {
    /// One iteration towards the steady state.
    ///
    /// # Errors
    /// A [`Failure`] where a cell's state makes no sense any more.
    pub fn settle_step(&mut self) -> Result<Settled, Failure> {
        let courant = (1.0 + RAMP * self.settling.since as f64).min(FASTEST);
        let residual = self.sweep(courant)?;
        self.steps += 1;
        self.updates += self.awake_cells();
        let watched = self.watched();
        let settling = &mut self.settling;
        settling.iterations += 1;
        settling.since += 1;
        if settling.first == 0.0 {
            settling.first = residual;
        }
        if settling.watched.len() > WINDOW {
            settling.watched.remove(0);
        }
        settling.watched.push(watched);
        let change = settling.change();
        let settled = Settled {
            iterations: settling.iterations,
            residual: if settling.first > 0.0 {
                residual / settling.first
            } else {
                0.0
            },
            change,
            is_settled: change < TOLERANCE && (settling.has_points || self.ground.is_none()),
        };
        self.ask_for_points(change)?;
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

    /// What must not change, in parts of what it is measured by.
    fn watched(&self) -> Vec<f64> {
        let (mass, centre) = self.mass_and_centre();
        let size = self.problem.domain.bounds.size().norm();
        let mut watched = vec![mass.ln()];
        watched.extend(centre.iter().map(|x| x / size));
        let loads = self.loads();
        let norms = loads
            .iter()
            .map(|load| load.force.iter().map(|f| f * f).sum::<f64>().sqrt());
        let largest = norms.fold(f64::MIN_POSITIVE, f64::max);
        watched.extend(
            loads
                .iter()
                .flat_map(|load| load.force.map(|f| f / largest)),
        );
        watched
    }
}

impl Settling {
    /// Largest range of what was watched over a full window; infinite before.
    fn change(&self) -> f64 {
        if self.watched.len() <= WINDOW {
            return f64::INFINITY;
        }
        let range = |k: usize| {
            let each = self.watched.iter().map(|watched| watched[k]);
            let (least, most) = each.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| {
                (a.min(x), b.max(x))
            });
            most - least
        };
        (0..self.watched[0].len()).map(range).fold(0.0, f64::max)
    }
}
