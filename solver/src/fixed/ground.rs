//! What cells are made from, where points come and go: bodies, lattice, what is split of it, and how far that may go.

use aero_geometry::Vector;

use super::build::built;
use super::cells::Cells;
use super::cloud::Cloud;
use super::cut_cell::CutCell;
use super::levels::Levels;
use super::plot::{Plot, corner};
use super::refine::{Adaption, BodyNeeds, Wish};
use super::refusal;
use super::site::Site;
use super::solids::Solids;
use super::wishes::wishes;
use crate::method::{FixedPoints, Time};
use crate::problem::{Earlier, Initial, Problem};

/// Points across the thickness of a part of a body.
const ACROSS: f64 = 4.0;

/// Points along the radius of a bend.
const RADIUS: f64 = 5.0;

/// Distance from the wall, in spacings, up to which bodies ask.
const REACH: f64 = 2.0;

/// Cells of their own size that are kept around the marked ones while a flow settles.
const AROUND_SETTLING: i32 = 2;

/// The same of an unsteady flow, whenever there is an adaption: so far waves run before there must be another.
const AROUND_MARCHING: i32 = 8;

/// Part of a given number of points that bodies may ask for before the first step.
const FOR_BODIES: f64 = 0.5;

/// By so much more, for one, must the gas change to get points where there are not enough for all.
const DEARER: [f64; 3] = [1.0, 2.0, 4.0];

/// What cells are made from, where points come and go.
#[derive(Clone, Debug)]
pub struct Ground<const D: usize> {
    /// The bodies.
    pub solids: Solids<D>,
    /// What is split.
    pub levels: Levels<D>,
    /// The points.
    pub cloud: Cloud<D>,
    /// Cells that were cut out one by one, where they are wanted again.
    pub cut: Vec<CutCell<D>>,
    /// What bodies ask for, which stays.
    kept: Levels<D>,
    /// True where more has been split than that.
    has_refined: bool,
    adaption: Adaption,
    /// How often cells may be split, be it for the flow or for bodies.
    deepest: u8,
    /// Points at most.
    limit: Option<u64>,
    /// Points that there is memory for.
    room: Option<u64>,
    settles: bool,
    /// True where the points are those of an earlier flow, which has settled on them.
    starts_settled: bool,
}

impl<const D: usize> Ground<D> {
    /// That of `problem` before the flow has asked for anything, and its cells.
    ///
    /// # Errors
    /// Fewer points asked for than the spacing makes.
    pub fn new(problem: &Problem<D>) -> Result<(Self, Cells<D>), String> {
        let solids = Solids::new(
            problem.bodies.iter().map(|body| body.shape.clone()),
            problem.resolution.lattice(),
        );
        let points = problem.method.fixed().copied().unwrap_or_default();
        let limit = points.refine.points();
        let settles = points.time == Time::Settle;
        let around = if settles {
            AROUND_SETTLING
        } else {
            AROUND_MARCHING
        };
        let most = points.refine.levels();
        let plot = plot(problem, &solids, corner(problem));
        let (kept, cloud) = around_bodies(&plot, &points, problem.disorder)?;
        let earlier = match &problem.initial {
            Initial::Earlier(earlier) if settles => as_earlier(earlier, &kept, &plot, most),
            _ => None,
        };
        let earlier = earlier
            .map(|levels| (Cloud::lattice(&plot, &levels, problem.disorder), levels))
            .filter(|(cloud, _)| limit.is_none_or(|limit| cloud.places.len() as u64 <= limit));
        let starts_settled = earlier.is_some();
        let (cloud, levels) = earlier.unwrap_or_else(|| (cloud, kept.clone()));
        let built = built(&plot, &cloud);
        let ground = Self {
            has_refined: levels != kept,
            kept,
            starts_settled,
            cut: if keeps_cells::<D>(settles) && most > 0 {
                built.cut
            } else {
                Vec::new()
            },
            levels,
            cloud,
            adaption: Adaption {
                most: points.refine.of_flow(),
                around,
            },
            deepest: most,
            limit,
            room: points.room,
            settles,
            solids,
        };
        Ok((ground, built.cells))
    }

    /// True where cells that were cut out one by one are kept for the next adaption.
    pub fn keeps_cells(&self) -> bool {
        keeps_cells::<D>(self.settles)
    }

    /// This where points are of more than one spacing, or may come to be.
    pub fn if_wanted(self) -> Option<Box<Self>> {
        (self.deepest > 0).then(|| Box::new(self))
    }

    /// True where the points are those of an earlier flow.
    pub fn starts_settled(&self) -> bool {
        self.starts_settled
    }

    /// How often the flow may have cells split.
    pub fn most(&self) -> u8 {
        self.adaption.most
    }

    /// How often they may be split, be it for bodies.
    pub fn deepest(&self) -> u8 {
        self.deepest
    }

    /// The same with cells split as [`Levels::numbers`] of an earlier one said.
    #[must_use]
    pub fn with_numbers(mut self, problem: &Problem<D>, numbers: &[i32]) -> (Self, Cells<D>) {
        let plot = plot(problem, &self.solids, self.cloud.corner);
        let levels = Levels::on(&plot).with_numbers(numbers);
        let cloud = Cloud::lattice(&plot, &levels, problem.disorder);
        let built = built(&plot, &cloud);
        self.take(levels);
        self.cloud = cloud;
        if self.keeps_cells() {
            self.cut = built.cut;
        }
        (self, built.cells)
    }

    /// Splits what `levels` have split from here on.
    pub fn take(&mut self, levels: Levels<D>) {
        self.has_refined |= levels != self.kept;
        self.levels = levels;
    }

    /// True where the flow has had more split than bodies ask for.
    pub fn has_refined(&self) -> bool {
        self.has_refined
    }

    /// How often the cell of each point was split.
    pub fn level(&self, point: usize) -> u8 {
        let place = &self.cloud.places[point];
        // A point of a pair may have no site of its own.
        let halvings = || (self.cloud.spacing / place.spacing).log2().round() as u8;
        place.site.map_or_else(halvings, |site| site.level)
    }

    /// True where all cells are there that must be within `around` of where the gas changes by `changes`.
    pub fn is_served(&self, changes: &[f64], around: i32) -> bool {
        let Some(adaption) = self.affordable(changes) else {
            return true;
        };
        let wishes = self.wishes(changes, 1.0, adaption.most);
        adaption.is_served(&self.cloud, &self.levels, &wishes, around)
    }

    /// What is to be split where the gas changes by `changes`.
    ///
    /// # Errors
    /// More points than there is memory for.
    pub fn asked(&self, changes: &[f64]) -> Result<Levels<D>, String> {
        let levels = self.heard(changes);
        let count = self.points_of(&levels);
        match self.room {
            Some(room) if count > room => Err(refusal::no_room("the flow asks", count, room)),
            _ => Ok(levels),
        }
    }

    /// The same whether there is room for it or not.
    pub fn heard(&self, changes: &[f64]) -> Levels<D> {
        let Some(limit) = self.limit else {
            return self.heard_by(self.adaption, changes, 1.0);
        };
        for most in (0..=self.adaption.most).rev() {
            let adaption = Adaption {
                most,
                ..self.adaption
            };
            for dearer in DEARER {
                let levels = self.heard_by(adaption, changes, dearer);
                if self.points_of(&levels) <= limit {
                    return levels;
                }
            }
        }
        self.levels.clone()
    }

    /// The most halvings for which there are points enough.
    fn affordable(&self, changes: &[f64]) -> Option<Adaption> {
        let Some(limit) = self.limit else {
            return Some(self.adaption);
        };
        let all = (0..=self.adaption.most).rev();
        let mut all = all.map(|most| Adaption {
            most,
            ..self.adaption
        });
        all.find(|adaption| self.points_of(&self.heard_by(*adaption, changes, 1.0)) <= limit)
    }

    fn heard_by(&self, adaption: Adaption, changes: &[f64], dearer: f64) -> Levels<D> {
        let wishes = self.wishes(changes, dearer, adaption.most);
        adaption.heard(&self.cloud, &self.levels, &self.kept, &wishes)
    }

    fn wishes(&self, changes: &[f64], dearer: f64, most: u8) -> Vec<Wish> {
        let mut wishes = wishes(changes, dearer);
        for (wish, place) in wishes.iter_mut().zip(&self.cloud.places) {
            if place.site.is_some_and(|site| site.level > most) {
                *wish = Wish::Join;
            }
        }
        wishes
    }

    /// About so many points other levels would make.
    fn points_of(&self, levels: &Levels<D>) -> u64 {
        (self.cloud.places.len() + levels.added()).saturating_sub(self.levels.added()) as u64
    }
}

/// A flow in space that settles has few adaptions, and its cells are large: they would take more memory than they save time.
fn keeps_cells<const D: usize>(settles: bool) -> bool {
    D < 3 || !settles
}

/// The plot of `problem`, with its bodies as one and the first corner of its lattice.
pub fn plot<'a, const D: usize>(
    problem: &'a Problem<D>,
    solids: &'a Solids<D>,
    corner: Vector<D>,
) -> Plot<'a, D> {
    Plot {
        domain: &problem.domain,
        solids,
        spacing: problem.resolution.lattice(),
        corner,
    }
}

/// What is split if not less than an earlier flow had split, and what is `kept`; none where its lattice was another.
fn as_earlier<const D: usize>(
    earlier: &Earlier<D>,
    kept: &Levels<D>,
    plot: &Plot<'_, D>,
    most: u8,
) -> Option<Levels<D>> {
    const SAME: f64 = 1e-9;
    let is_same = |spacing: f64| (spacing / plot.spacing - 1.0).abs() < SAME;
    earlier.spacing.filter(|spacing| is_same(*spacing))?;
    let mut levels = kept.clone();
    for split in earlier.split.iter() {
        let level = split.level.min(most);
        if level == 0 {
            continue;
        }
        // The cell that is split for it.
        let size = plot.spacing / f64::from(1_u32 << (level - 1));
        let from = split.point - plot.corner;
        levels.split(&Site {
            level: level - 1,
            index: std::array::from_fn(|k| (from[k] / size).floor() as i32),
        });
    }
    Some(levels)
}

/// What bodies ask for, as far as there are points enough.
fn around_bodies<const D: usize>(
    plot: &Plot<'_, D>,
    points: &FixedPoints,
    disorder: f64,
) -> Result<(Levels<D>, Cloud<D>), String> {
    let FixedPoints { refine, room, .. } = *points;
    let limit = refine.points();
    let mut needs = BodyNeeds {
        most: refine.of_bodies(),
        most_of_bends: refine.of_bends(),
        across: ACROSS,
        radius: RADIUS,
        reach: REACH,
    };
    loop {
        let halvings = needs.most.max(needs.most_of_bends);
        let levels = match needs.levels(plot, room) {
            Ok(levels) => levels,
            Err(_) if limit.is_some() && halvings > 0 => {
                needs = needs.less();
                continue;
            }
            Err(count) => {
                let room = room.unwrap_or(count);
                return Err(refusal::no_room("the bodies ask", count, room));
            }
        };
        let cloud = Cloud::lattice(plot, &levels, disorder);
        let count = cloud.places.len() as u64;
        let Some(limit) = limit else {
            return Ok((levels, cloud));
        };
        if count > limit && halvings == 0 {
            return Err(format!(
                "`scheme.refine` has {limit} points in all, but a spacing of {} makes {count} before any is added; \
                 use a larger `spacing` or more points",
                plot.spacing
            ));
        }
        if halvings == 0 || count as f64 <= FOR_BODIES * limit as f64 {
            return Ok((levels, cloud));
        }
        needs = needs.less();
    }
}
