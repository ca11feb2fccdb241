//! Points come and go while the flow goes on.

use std::sync::OnceLock;

use super::FixedSimulation;
use super::build::{Built, built};
use super::carry;
use super::cells::Cells;
use super::cloud::{Cloud, Place};
use super::columns::Columns;
use super::ground::{Ground, plot};
use super::origins::origins;
use super::outside::Outside;
use super::quiet::Quiet;
use super::rebuild::rebuilt;
use super::state::Conserved;
use crate::Failure;

/// Steps of an unsteady flow after which it is asked what it wants.
const EVERY: u64 = 3;

/// So often it is asked, too, what it wants no longer.
const SELDOM: u64 = 30;

/// Part of the cells that are split above which it pays to have fewer.
const IDLE: f64 = 0.1;

/// There must be one where fewer are left than this: no wave crosses more than one of the smallest cells in a step.
const LEAST_AROUND: i32 = EVERY as i32;

/// How the gas comes onto new cells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Carry {
    /// As the problem starts.
    Afresh,
    /// From the nearest old cells.
    Roughly,
    /// So that nothing is lost.
    Wholly,
}

impl<const D: usize> FixedSimulation<D> {
    /// Adds points where the start asks for them.
    pub(super) fn adapt_start(&mut self) -> Result<(), String> {
        let most = self.ground.as_ref().map_or(0, |ground| ground.most());
        for _ in 0..most {
            if self.adapt(Carry::Afresh)? == 0 {
                break;
            }
        }
        Ok(())
    }

    /// Adds and takes away points of a flow that settles; says how many are new.
    pub(super) fn adapt_settling(&mut self) -> Result<usize, Failure> {
        self.adapt(Carry::Roughly)
            .map_err(|reason| self.no_cells(reason))
    }

    /// Adds and takes away points of an unsteady flow when it is time to.
    pub(super) fn adapt_marching(&mut self) -> Result<(), Failure> {
        let is_due = self.tally.steps > 0 && self.tally.steps.is_multiple_of(EVERY);
        if is_due && self.ground.is_some() {
            self.adapt(Carry::Wholly)
                .map_err(|reason| self.no_cells(reason))?;
        }
        Ok(())
    }

    /// True where an unsteady flow can do without an adaption for now.
    fn can_wait(&self, ground: &Ground<D>, changes: &[f64]) -> bool {
        if !ground.is_served(changes, LEAST_AROUND) {
            return false;
        }
        if !self.tally.steps.is_multiple_of(SELDOM) {
            return true;
        }
        let fewer = ground.heard(changes).len();
        fewer as f64 > (1.0 - IDLE) * ground.levels.len() as f64
    }

    /// Hears what the flow wants and goes on with other cells if it wants any; says how many points are new.
    fn adapt(&mut self, carry: Carry) -> Result<usize, String> {
        let Some(mut ground) = self.ground.take() else {
            return Ok(0);
        };
        let new = self.adapt_on(&mut ground, carry);
        self.ground = Some(ground);
        new
    }

    fn adapt_on(&mut self, ground: &mut Ground<D>, carry: Carry) -> Result<usize, String> {
        let changes = self.changes();
        if carry == Carry::Wholly && self.can_wait(ground, &changes) {
            return Ok(0);
        }
        let levels = ground.asked(&changes)?;
        if levels == ground.levels {
            return Ok(0);
        }
        let plot = plot(&self.problem, &ground.solids, ground.cloud.corner);
        let disorder = self.problem.disorder;
        let cloud = Cloud::lattice_after(&plot, &levels, disorder, Some(&ground.cloud));
        let Built {
            cells, cut, same, ..
        } = if ground.keeps_cells() {
            let before = std::mem::take(&mut ground.cut);
            rebuilt(&plot, &cloud, &ground.cloud, before)
        } else {
            built(&plot, &cloud)
        };
        let held = match carry {
            Carry::Afresh => {
                let states = Self::initial_states(&self.problem, &cells)?;
                let held = states.iter().map(|state| state.conserved(&self.fluid.gas));
                held.collect()
            }
            Carry::Roughly => {
                let volumes: Vec<f64> = self.volumes();
                let origins = origins(&plot, [&ground.cloud, &cloud]);
                mixed(&self.columns.held, &volumes, &origins)
            }
            Carry::Wholly => {
                let shares = carry::shares(&plot, &ground.cloud, &cloud, &same);
                carry::carried(
                    &self.columns.held,
                    [&self.volumes(), &cells.volumes],
                    &shares,
                )
            }
        };
        let is_new = |place: &&Place<D>| {
            // Points of a pair have one site.
            place
                .site
                .is_some_and(|site| ground.cloud.at(&site).is_none())
        };
        let new = cloud.places.iter().filter(is_new).count();
        self.replace_cells(cells, held)?;
        if ground.keeps_cells() {
            ground.cut = cut;
        }
        ground.cloud = cloud;
        ground.take(levels);
        Ok(new)
    }

    /// Goes on with other cells, which hold this much per volume.
    fn replace_cells(&mut self, cells: Cells<D>, held: Vec<Conserved<D>>) -> Result<(), String> {
        let net = Self::net(&cells, &self.problem)?;
        let waves = self.placed_waves();
        self.quiet = Quiet::of(&net, &self.problem);
        self.outside = Outside::of(&self.problem, &cells, &net);
        let states = held
            .iter()
            .map(|held| held.primitive(&self.fluid.gas))
            .collect();
        let pressure = self.problem.free_stream.pressure;
        self.columns = Columns::new(held, states, &net, pressure, self.fluid.viscous.is_some());
        self.points = cells.into_points();
        self.net = net;
        self.take_over_waves(&waves);
        self.settling.sweeps = None;
        self.shown.outlines = OnceLock::new();
        self.start();
        Ok(())
    }

    fn no_cells(&self, reason: String) -> Failure {
        Failure {
            reason,
            particle: None,
            position: [0.0; 3],
            step: self.tally.steps,
            time: self.tally.time,
        }
    }

    /// How many points there are whose cells were split so often, from those that were not; one number where none may be.
    pub fn points_per_level(&self) -> Vec<usize> {
        let Some(ground) = &self.ground else {
            return vec![self.points.len()];
        };
        let mut counts = vec![0; usize::from(ground.deepest()) + 1];
        for point in 0..self.points.len() {
            counts[usize::from(ground.level(point))] += 1;
        }
        counts
    }

    /// True where points have been added because the flow asked for them.
    pub fn has_refined(&self) -> bool {
        let ground = self.ground.as_ref();
        ground.is_some_and(|ground| ground.has_refined())
    }

    /// Spacing of the points around one of them.
    pub(super) fn spacing_at(&self, point: usize) -> f64 {
        let level = self.ground.as_ref().map_or(0, |ground| ground.level(point));
        self.problem.resolution.lattice() / f64::from(1_u32 << level)
    }
}

/// What new cells hold per volume: the mean of what the old ones do that they come from.
fn mixed<const D: usize>(
    held: &[Conserved<D>],
    volumes: &[f64],
    shares: &[Vec<carry::Share>],
) -> Vec<Conserved<D>> {
    let mix = |shares: &Vec<carry::Share>| {
        if let [(only, _)] = shares[..] {
            return held[only as usize];
        }
        let mut total = 0.0;
        let mut sum = Conserved::ZERO;
        for &(old, _) in shares {
            let weight = volumes[old as usize];
            total += weight;
            sum = sum.plus(weight, &held[old as usize]);
        }
        Conserved::ZERO.plus(1.0 / total, &sum)
    };
    shares.iter().map(mix).collect()
}
