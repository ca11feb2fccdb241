//! Ghosts of bodies and wall sides: where they are, and what the pair loops read of them.

use aero_geometry::parallel::prelude::*;
use aero_geometry::{Pencils, Vector};

mod contact;
pub mod curvature;
mod cut;
mod free;
mod ghost;
mod gliding;
mod joints;
pub mod loads;
mod mirror;
pub mod plane;
mod rebound;
mod ridges;
pub mod rigid;
mod setup;
mod shares;
pub mod solids;
mod sticking;
mod turning;

pub use contact::{Contact, Met};
pub use free::FreeBody;
pub use ghost::{Ghost, Origin, Shown, WallAbove};
pub use plane::wall_sides;
pub use rebound::rebound;
pub use ridges::part as part_ridges;
pub use sticking::beyond;

use nalgebra::Vector3;
use rigid::{Pose, pad};

use super::faces::Faces;
use super::neighbourhood::levels::Grid;
use super::neighbours::{Candidates, Kind, Lists, Seeker};
use super::pairs::extrapolation::Interpolated;
use super::pairs::renormalisation::even_renormalisation;
use super::records::{GHOSTS, Near, Records, State, Symmetric};
use super::vectors::Arch;
use crate::frame::Load;
use crate::gas::Gases;
use crate::problem::{Body, Motion, Problem, WallKind};
use crate::scheme::{Extrapolation, WallTreatment};

/// All ghosts, and what their bodies do.
#[derive(Clone, Debug)]
pub struct Walls<const D: usize> {
    /// Ghosts in the order of `pencils`, then their views in the order of `view_pencils`.
    pub ghosts: Vec<Ghost<D>>,
    /// Order of the ghosts in space.
    pub pencils: Pencils<D>,
    /// Order of the views in space.
    pub view_pencils: Pencils<D>,
    /// Ghosts whose mirror was short of neighbours at the last evaluation.
    pub mirror_fallbacks: usize,
    /// Bodies in scene order, then wall sides.
    bodies: Vec<Mover<D>>,
    treatment: WallTreatment,
    gases: Gases,
    grid: Grid<D>,
    faces: Option<Faces<D>>,
    found: Vec<Option<Interpolated<D>>>,
    mirrored: Vec<Option<Interpolated<D>>>,
}

/// A body or a wall side: how it moves, and what gas and heat do at its surface.
#[derive(Clone, Debug)]
struct Mover<const D: usize> {
    motion: Motion<D>,
    kind: WallKind,
    /// Where it is, if the gas moves it.
    free: Option<FreeBody>,
}

/// Neighbours of the ghosts.
#[derive(Clone, Debug, Default)]
pub struct WallLists {
    /// Around each ghost; the gas only.
    pub near: Lists,
    /// Around each mirror point; the gas only.
    pub mirror: Lists,
}

impl<const D: usize> Walls<D> {
    /// The ghosts of all bodies and wall sides of `problem`, sorted on `grid`.
    pub fn new(problem: &Problem<D>, grid: &Grid<D>) -> Self {
        let mut bodies: Vec<_> = problem
            .bodies
            .iter()
            .map(|body| Mover::new(&body.motion, body.wall))
            .collect();
        let sides = plane::plane_walls(&problem.domain, problem.resolution.lattice());
        bodies.extend((sides.iter()).map(|side| Mover::new(&side.motion, side.kind)));
        let (ghosts, faces) = setup::ghosts(problem, &sides);
        let mut walls = Self {
            ghosts,
            pencils: Pencils::default(),
            view_pencils: Pencils::default(),
            mirror_fallbacks: 0,
            bodies,
            treatment: problem.scheme.wall,
            gases: problem.gases(),
            grid: *grid,
            faces,
            found: Vec::new(),
            mirrored: Vec::new(),
        };
        walls.move_to(0.0);
        walls.sort();
        walls
    }

    /// True where any body moves.
    pub fn are_moving(&self) -> bool {
        self.bodies.iter().any(|body| body.motion.is_moving())
    }

    /// Number of bodies and wall sides.
    pub fn body_count(&self) -> usize {
        self.bodies.len()
    }

    /// What gas and heat do at the surface of body `number`.
    pub fn kind(&self, number: u32) -> WallKind {
        self.bodies[number as usize].kind
    }

    /// True where heat goes through a surface.
    pub fn are_conducting(&self) -> bool {
        self.bodies.iter().any(|body| body.kind.conducts())
    }

    /// True where a surface moves along itself.
    pub fn are_sliding(&self) -> bool {
        self.bodies.iter().any(|body| body.kind.slides())
    }

    /// Pose of body `number` at `time`.
    pub fn pose(&self, number: usize, time: f64) -> Pose<D> {
        self.bodies[number].pose(time)
    }

    /// True where the gas moves any body.
    pub fn are_free(&self) -> bool {
        self.bodies.iter().any(|body| body.free.is_some())
    }

    /// The bodies that the gas moves, where they are; none of the others.
    pub fn free(&self) -> Vec<Option<FreeBody>> {
        self.bodies.iter().map(|body| body.free).collect()
    }

    /// Puts the bodies that the gas moves where [`Self::free`] had them.
    pub fn restore_free(&mut self, free: &[Option<FreeBody>]) {
        for (body, free) in self.bodies.iter_mut().zip(free) {
            body.free = *free;
        }
    }

    /// Moves what is free by a step, from the loads of its middle, about the moment centres of the `bodies`.
    pub fn push(&mut self, bodies: &[Body<D>], loads: &[Load], (middle, step): (f64, f64)) {
        for ((mover, body), load) in self.bodies.iter_mut().zip(bodies).zip(loads) {
            let pose = mover.pose(middle);
            let arm = pad(&(pose.position(&body.moment_centre) - pose.pivot()));
            let force = Vector3::from(load.force);
            let moment = Vector3::from(load.moment) + arm.cross(&force);
            if let (Some(free), Some(freedom)) = (&mut mover.free, &mover.motion.free) {
                let other = pad(&mover.motion.acceleration);
                free.kick(freedom, [force, moment], &other, step);
            }
        }
    }

    /// Gives the body `number`, if it is free, an impulse at a `position`.
    pub fn strike(&mut self, number: usize, impulse: &Vector<D>, position: &Vector<D>, time: f64) {
        let mover = &mut self.bodies[number];
        let arm = position - mover.pose(time).pivot();
        let moment = pad(&arm).cross(&pad(impulse));
        if let (Some(free), Some(freedom)) = (&mut mover.free, &mover.motion.free) {
            free.strike(freedom, [pad(impulse), moment]);
        }
    }

    /// Moves all ghosts to where they are at `time`.
    pub fn move_to(&mut self, time: f64) {
        let poses: Vec<_> = self.bodies.iter().map(|body| body.pose(time)).collect();
        for ghost in &mut self.ghosts {
            let number = ghost.body as usize;
            let pose = &poses[number];
            ghost.position = pose.position(&ghost.origin.position);
            ghost.normal = pose.direction(&ghost.origin.normal);
            // The wall moves as its surface does, not as the ghost below it.
            let foot = ghost.foot();
            ghost.wall.velocity = pose.velocity(&foot);
            ghost.wall.slide = match self.bodies[number].kind {
                WallKind::Slip => Vector::zeros(),
                WallKind::NoSlip(wall) => {
                    let foot = ghost.origin.position + ghost.origin.normal * ghost.depth;
                    pose.direction(&wall.slide.at(&foot))
                }
            };
            ghost.wall.acceleration = pose.acceleration(&foot);
            ghost.wall.curvature = pose.tensor(&ghost.origin.curvature);
            ghost.wall.coriolis = pose.coriolis(&ghost.normal);
        }
    }

    /// Sorts the ghosts in space; needed after they have moved.
    pub fn sort(&mut self) {
        let (ghosts, views) = self.ghosts.split_at(self.own_count());
        let mut all = sorted(ghosts, &mut self.pencils, &self.grid);
        all.extend(sorted(views, &mut self.view_pencils, &self.grid));
        self.ghosts = all;
    }

    /// Number of ghosts without their views.
    pub fn own_count(&self) -> usize {
        self.ghosts.partition_point(|ghost| !ghost.sight.is_view())
    }

    /// The ghosts without their views.
    pub fn own(&self) -> &[Ghost<D>] {
        &self.ghosts[..self.own_count()]
    }

    /// The faces of thin parts; none where there are no such parts.
    pub fn faces(&self) -> Option<&Faces<D>> {
        self.faces.as_ref()
    }

    /// Lists the gas around each ghost and, with mirrors, around each mirror point.
    pub fn build_lists(
        &self,
        arch: Arch,
        sets: &[Candidates<'_, D>],
        half_step: f64,
        lists: &mut WallLists,
    ) {
        // The sums over the gas around ghosts are few.
        let arch = arch.double();
        let ghosts = &self.ghosts;
        let count = ghosts.len();
        let everyone = |_| Kind::default();
        let gas: Vec<_> = sets.iter().filter(|set| !set.is_wall()).copied().collect();
        lists.near.build(
            arch,
            count,
            |g| seeker(&ghosts[g]),
            &gas,
            half_step,
            everyone,
        );
        if self.treatment.extrapolation == Extrapolation::Wm {
            let seeker = |g: usize| mirror_seeker(&ghosts[g]);
            lists
                .mirror
                .build(arch, count, seeker, &gas, half_step, everyone);
        }
    }

    /// Writes the ghosts' records. Ghosts partition space evenly: their renormalisation is that
    /// of a lattice, which the gas at rest has too.
    pub fn fill(&self, records: &mut Records<D>) {
        let slots = records.segment(GHOSTS);
        let even = even_renormalisation();
        let (near, state) = (
            &mut records.near[slots.clone()],
            &mut records.state[slots.clone()],
        );
        near.par_iter_mut()
            .zip(state)
            .zip(&self.ghosts)
            .for_each(|((near, state), ghost)| {
                *near = Near {
                    position: ghost.position,
                    half_h: 0.5 * ghost.shown.smoothing_length,
                    volume: ghost.volume,
                    mass: ghost.shown.density * ghost.volume,
                    half_density: 0.5 * ghost.shown.density,
                    velocity: ghost.shown.velocity,
                };
                *state = State::new(
                    ghost.shown.pressure,
                    ghost.shown.density,
                    ghost.shown.energy,
                    &self.gases.mixed(ghost.shown.second),
                );
                state.strain = Symmetric::new(&ghost.shown.strain);
                state.renormalise(&even, &ghost.shown.density_gradient, ghost.volume);
            });
        if records.are_two {
            let second = &mut records.second[slots];
            let shares = second.iter_mut().zip(&self.ghosts);
            shares.for_each(|(second, ghost)| *second = ghost.shown.second);
        }
    }
}

impl<const D: usize> Mover<D> {
    fn new(motion: &Motion<D>, kind: WallKind) -> Self {
        let free = (motion.free.as_ref()).map(|freedom| FreeBody::new(motion, freedom));
        let motion = motion.clone();
        Self { motion, kind, free }
    }

    fn pose(&self, time: f64) -> Pose<D> {
        match &self.free {
            Some(free) => free.pose(&self.motion.pivot, time),
            None => Pose::new(&self.motion, time),
        }
    }
}

/// The ghosts in the order of `pencils`, which are made anew.
fn sorted<const D: usize>(
    ghosts: &[Ghost<D>],
    pencils: &mut Pencils<D>,
    grid: &Grid<D>,
) -> Vec<Ghost<D>> {
    let (place, rank) = (|g: usize| ghosts[g].position, |g| g as u64);
    pencils.rebuild_on_grid(&grid.corner, grid.width, ghosts.len(), place, rank);
    let order = pencils.order().iter();
    order.map(|&g| ghosts[g as usize]).collect()
}

fn seeker<const D: usize>(ghost: &Ghost<D>) -> Seeker<D> {
    Seeker {
        position: ghost.position,
        half_h: 0.5 * ghost.shown.smoothing_length,
        velocity: ghost.wall.velocity,
    }
}

fn mirror_seeker<const D: usize>(ghost: &Ghost<D>) -> Seeker<D> {
    Seeker {
        position: ghost.mirror(),
        ..seeker(ghost)
    }
}
