//! Where a body that the gas moves comes so near to something that no gas fits between: contact is not modelled.

use aero_geometry::Vector;

use super::Walls;
use super::rigid::Pose;
use crate::problem::{Domain, Problem, Side};

/// A body that has come too near to something.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact<const D: usize> {
    /// Number of the body, which is free.
    pub body: usize,
    /// What it met.
    pub met: Met,
    /// Where.
    pub position: Vector<D>,
}

/// What a free body met.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Met {
    /// Another body, by its number.
    Body(usize),
    /// A side of the domain, by its axis and end.
    Side(usize, usize),
}

impl<const D: usize> Walls<D> {
    /// The first contact of a free body at `time`, if there is any: with a body or a wall nearer than a spacing, or with an open
    /// side.
    pub fn contact(&self, problem: &Problem<D>, time: f64) -> Option<Contact<D>> {
        if !self.are_free() {
            return None;
        }
        let bodies = &problem.bodies;
        let is_free = |number: usize| self.bodies[number].free.is_some();
        let poses: Vec<Pose<D>> = (0..bodies.len()).map(|n| self.pose(n, time)).collect();
        let near = |foot: &Vector<D>, other: usize| {
            let (shape, origin) = (&bodies[other].shape, poses[other].origin(foot));
            shape
                .bounds()
                .grown(problem.resolution.at(foot))
                .contains(&origin)
                && shape.signed_distance(&origin) < problem.resolution.at(foot)
        };
        let outermost = self.own().iter().filter(|ghost| {
            (ghost.body as usize) < bodies.len()
                && ghost.depth <= problem.resolution.at(&ghost.position)
        });
        outermost
            .flat_map(|ghost| {
                let (number, foot) = (ghost.body as usize, ghost.foot());
                let others = (0..bodies.len())
                    .filter(move |&other| other != number && (is_free(number) || is_free(other)));
                let met = others
                    .filter(move |&other| near(&foot, other))
                    .map(Met::Body);
                let side = is_free(number)
                    .then(|| side(problem, number, &foot))
                    .flatten();
                met.chain(side).map(move |met| (number, met, foot))
            })
            .map(|(number, met, position)| match met {
                Met::Body(other) if !is_free(number) => Contact {
                    body: other,
                    met: Met::Body(number),
                    position,
                },
                met => Contact {
                    body: number,
                    met,
                    position,
                },
            })
            .next()
    }
}

/// The side of the domain that a body meets by the foot of one of its ghosts; none that cut it from the start.
fn side<const D: usize>(problem: &Problem<D>, body: usize, foot: &Vector<D>) -> Option<Met> {
    let Domain { bounds, .. } = &problem.domain;
    let extent = problem.bodies[body].shape.bounds();
    let mut sides = problem
        .domain
        .each_side()
        .filter_map(|(axis, end, side, face)| {
            let room = |place: f64| [place - face, face - place][end];
            let starts_inside = room([extent.min[axis], extent.max[axis]][end]) > 0.0;
            let least = match side {
                Side::Wall { .. } => problem.resolution.at(foot),
                _ => 0.0,
            };
            (starts_inside && bounds.size()[axis] > 0.0 && room(foot[axis]) < least)
                .then_some(Met::Side(axis, end))
        });
    sides.next()
}
