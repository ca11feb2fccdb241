//! Gas beyond sides whose state is given as a function of position and time.

use aero_geometry::Vector;

use super::FixedSimulation;
use super::beyond::Beyond;
use super::cells::{Cells, SideFace};
use super::net::BLOCK;
use crate::problem::{Given, Problem};
use crate::sides::Place;

/// A face that such gas is beyond.
#[derive(Clone, Debug)]
pub struct GivenFace<const D: usize> {
    /// Block of its cell.
    block: usize,
    /// Its number there.
    side: usize,
    centre: Vector<D>,
    given: Given<D>,
}

/// What is beyond each face of the sides of `cells`, in their order.
///
/// # Errors
/// Of a side that has no open faces.
pub fn beyond_faces<const D: usize>(
    problem: &Problem<D>,
    cells: &Cells<D>,
) -> Result<Vec<Beyond<D>>, String> {
    let domain = &problem.domain;
    let mut whole = [[None; 2]; D];
    let mut all = Vec::with_capacity(cells.sides.len());
    for face in &cells.sides {
        let (axis, end) = (usize::from(face.axis), usize::from(face.end));
        let beyond = if let Some(part) = domain.part_at(axis, end, &face.centre) {
            Beyond::of(problem, part.side, Place::of(domain, part))?
        } else if let Some(known) = whole[axis][end] {
            known
        } else {
            let place = Place::whole(domain, axis, end);
            let beyond = Beyond::of(problem, domain.sides[axis][end], place)?;
            *whole[axis][end].insert(beyond)
        };
        all.push(beyond);
    }
    Ok(all)
}

/// The faces of the sides of `cells`, each with the block that it stands in and its number there.
pub fn standing<const D: usize>(
    cells: &Cells<D>,
) -> impl Iterator<Item = (usize, usize, &SideFace<D>)> {
    let mut counts = vec![0; cells.points.len().div_ceil(BLOCK)];
    cells.sides.iter().map(move |face| {
        let block = face.i as usize / BLOCK;
        counts[block] += 1;
        (block, counts[block] - 1, face)
    })
}

/// The faces of `cells` that gas in a given state is beyond.
pub fn given_faces<const D: usize>(problem: &Problem<D>, cells: &Cells<D>) -> Vec<GivenFace<D>> {
    let openings = &problem.domain.openings;
    if openings.iter().all(|opening| opening.given.is_none()) {
        return Vec::new();
    }
    let mut all = Vec::new();
    for (block, side, face) in standing(cells) {
        let place = (usize::from(face.axis), usize::from(face.end));
        let own = openings
            .iter()
            .filter(|opening| (opening.axis, opening.end) == place);
        // A part comes before the side that it is one of.
        let mut own: Vec<_> = own.filter(|opening| opening.faces(&face.centre)).collect();
        own.sort_by_key(|opening| opening.part.is_none());
        if let Some(given) = own.first().and_then(|opening| opening.given.clone()) {
            all.push(GivenFace {
                block,
                side,
                centre: face.centre,
                given,
            });
        }
    }
    all
}

impl<const D: usize> FixedSimulation<D> {
    /// Shows the faces what is beyond them at `time`, and walls what drives the gas into them.
    pub(super) fn give(&mut self, time: f64) {
        self.push_walls(time);
        for face in &self.outside.given {
            let side = &mut self.net.blocks[face.block].sides[face.side];
            side.beyond = side.beyond.at(&face.given.at(&face.centre, time));
        }
    }
}
