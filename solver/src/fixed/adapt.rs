//! Points come and go while the flow goes on: where the gas asks for them, and around what bodies ask for before the first step.

use super::FixedSimulation;
use super::build::{Built, CutCell, built, rebuilt};
use super::carry;
use super::cells::Cells;
use super::cloud::{Cloud, Plot};
use super::levels::Levels;
use super::quiet::Quiet;
use super::refine::{Adaption, BodyNeeds, Wish};
use super::solids::Solids;
use super::state::Conserved;
use crate::Failure;
use crate::method::Time;
use crate::problem::Problem;

/// Points across the thickness of a part of a body.
const ACROSS: f64 = 4.0;

/// Points along the radius of a bend.
const RADIUS: f64 = 5.0;

/// Distance from the wall, in spacings, up to which bodies ask.
const REACH: f64 = 2.0;

/// Steps of an unsteady flow after which it is asked what it wants.
const EVERY: u64 = 3;

/// So often it is asked, too, what it wants no longer.
const SELDOM: u64 = 30;

/// Part of the cells that are split above which it pays to have fewer.
const IDLE: f64 = 0.1;

/// Cells of their own size that are kept around the marked ones while a flow settles.
const AROUND_SETTLING: i32 = 2;

/// The same of an unsteady flow, whenever there is an adaption: so far waves run before there must be another.
const AROUND_MARCHING: i32 = 8;

/// There must be one where fewer are left than this: no wave crosses more than 0.8 of the smallest cells in a step.
const LEAST_AROUND: i32 = EVERY as i32;

/// What cells are made from, where points come and go.
#[derive(Clone, Debug)]
pub struct Ground<const D: usize> {
    solids: Solids<D>,
    levels: Levels<D>,
    /// What bodies ask for, which stays.
    kept: Levels<D>,
    cloud: Cloud<D>,
    /// Cells that were cut out one by one, where they are wanted again.
    cut: Vec<CutCell<D>>,
    adaption: Adaption,
}

impl<const D: usize> Ground<D> {
    /// That of `problem` before the flow has asked for anything, and its cells.
    pub fn new(problem: &Problem<D>) -> (Self, Cells<D>) {
        let solids = Solids::new(
            problem.bodies.iter().map(|body| body.shape.clone()),
            problem.spacing,
        );
        let points = problem.method.fixed();
        let most = points.map_or(0, |points| points.refine.levels());
        let settles = points.is_some_and(|points| points.time == Time::Settle);
        let plot = plot(problem, &solids);
        let needs = BodyNeeds {
            most,
            across: ACROSS,
            radius: RADIUS,
            reach: REACH,
        };
        let levels = needs.levels(&plot);
        let cloud = Cloud::lattice(&plot, &levels, problem.disorder);
        let built = built(&plot, &cloud);
        let ground = Self {
            kept: levels.clone(),
            cut: if settles || most == 0 {
                Vec::new()
            } else {
                built.cut
            },
            levels,
            cloud,
            adaption: Adaption {
                most,
                around: if settles {
                    AROUND_SETTLING
                } else {
                    AROUND_MARCHING
                },
            },
            solids,
        };
        (ground, built.cells)
    }

    /// True where points may come.
    pub fn may_change(&self) -> bool {
        self.adaption.most > 0
    }

    /// How often cells may be split.
    pub fn most(&self) -> u8 {
        self.adaption.most
    }

    /// The same with cells split as [`Levels::numbers`] of an earlier one said.
    #[must_use]
    pub fn with_numbers(mut self, problem: &Problem<D>, numbers: &[i32]) -> (Self, Cells<D>) {
        let plot = plot(problem, &self.solids);
        self.levels = Levels::on(&plot).with_numbers(numbers);
        self.cloud = Cloud::lattice(&plot, &self.levels, problem.disorder);
        let built = built(&plot, &self.cloud);
        self.cut = built.cut;
        (self, built.cells)
    }

    /// All that is split, as numbers.
    pub fn numbers(&self) -> Vec<i32> {
        self.levels.numbers()
    }

    /// How often the cell of each point was split.
    pub fn level(&self, point: usize) -> u8 {
        self.cloud.places[point].site.map_or(0, |site| site.level)
    }
}

fn plot<'a, const D: usize>(problem: &'a Problem<D>, solids: &'a Solids<D>) -> Plot<'a, D> {
    Plot {
        domain: &problem.domain,
        solids,
        spacing: problem.spacing,
    }
}

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
        let is_due = self.steps > 0 && self.steps.is_multiple_of(EVERY);
        if is_due && self.ground.is_some() {
            self.adapt(Carry::Wholly)
                .map_err(|reason| self.no_cells(reason))?;
        }
        Ok(())
    }

    /// True where an unsteady flow can do without an adaption for now.
    fn can_wait(&self, ground: &Ground<D>, wishes: &[Wish]) -> bool {
        let Ground {
            adaption,
            cloud,
            levels,
            kept,
            ..
        } = ground;
        if !adaption.is_served(cloud, levels, wishes, LEAST_AROUND) {
            return false;
        }
        if !self.steps.is_multiple_of(SELDOM) {
            return true;
        }
        let fewer = adaption.heard(cloud, levels, kept, wishes).len();
        fewer as f64 > (1.0 - IDLE) * levels.len() as f64
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
        let wishes = self.wishes();
        if carry == Carry::Wholly && self.can_wait(ground, &wishes) {
            return Ok(0);
        }
        let levels = ground
            .adaption
            .heard(&ground.cloud, &ground.levels, &ground.kept, &wishes);
        if levels == ground.levels {
            return Ok(0);
        }
        let plot = plot(&self.problem, &ground.solids);
        let disorder = self.problem.disorder;
        let cloud = Cloud::lattice_after(&plot, &levels, disorder, Some(&ground.cloud));
        let Built {
            cells, cut, same, ..
        } = if carry == Carry::Roughly {
            built(&plot, &cloud)
        } else {
            let before = std::mem::take(&mut ground.cut);
            rebuilt(&plot, &cloud, &ground.cloud, before)
        };
        let held = match carry {
            Carry::Afresh => {
                let states = Self::initial_states(&self.problem, &cells)?;
                let held = states.iter().map(|state| state.conserved(&self.gas));
                held.collect()
            }
            Carry::Roughly => {
                let volumes: Vec<f64> = self.volumes();
                let origins = carry::origins(&plot, [&ground.cloud, &cloud]);
                mixed(&self.held, &volumes, &origins)
            }
            Carry::Wholly => {
                let shares = carry::shares(&plot, &ground.cloud, &cloud, &same);
                carry::carried(&self.held, [&self.volumes(), &cells.volumes], &shares)
            }
        };
        let is_new = |place: &&super::cloud::Place<D>| {
            place
                .site
                .is_none_or(|site| ground.cloud.at(&site).is_none())
        };
        let new = cloud.places.iter().filter(is_new).count();
        self.replace_cells(cells, held)?;
        if carry != Carry::Roughly {
            ground.cut = cut;
        }
        ground.cloud = cloud;
        ground.levels = levels;
        Ok(new)
    }

    /// Goes on with other cells, which hold this much per volume.
    fn replace_cells(&mut self, cells: Cells<D>, held: Vec<Conserved<D>>) -> Result<(), String> {
        let net = Self::net(&cells, &self.problem)?;
        self.quiet = Quiet::of(&net, &self.problem);
        self.states = held.iter().map(|held| held.primitive(&self.gas)).collect();
        self.before.clone_from(&held);
        self.held = held;
        self.slopes = vec![super::Slopes::LEVEL; self.states.len()];
        self.careful.clear();
        self.pressures = super::pressures(&net, self.problem.free_stream.pressure);
        self.points = cells.points;
        self.net = net;
        self.sweeps = None;
        self.start();
        Ok(())
    }

    fn no_cells(&self, reason: String) -> Failure {
        Failure {
            reason,
            particle: 0,
            position: [0.0; 3],
            step: self.steps,
            time: self.time,
        }
    }

    /// How many points there are whose cells were split so often, from those that were not; one number where none may be.
    pub fn points_per_level(&self) -> Vec<usize> {
        let Some(ground) = &self.ground else {
            return vec![self.points.len()];
        };
        let mut counts = vec![0; usize::from(ground.most()) + 1];
        for point in 0..self.points.len() {
            counts[usize::from(ground.level(point))] += 1;
        }
        counts
    }

    /// Spacing of the points around one of them.
    pub(super) fn spacing_at(&self, point: usize) -> f64 {
        let level = self.ground.as_ref().map_or(0, |ground| ground.level(point));
        self.problem.spacing / f64::from(1_u32 << level)
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
