//! Bodies that run on through open sides: which pairs of gas and ghosts press on the part within.
//!
//! The wall's traction is carried by the pairs whose line crosses it [Irving & Kirkwood 1950, J. Chem. Phys. 18, 817, doi
//! 10.1063/1.1747782]: a pair belongs to the piece of surface that its line goes through. Were a ghost counted with all its gas, or
//! with none, by where its own foot lies, then a cut would lose what gas on one side of it gives ghosts on the other, which
//! has a part along the wall: the pressure over a quarter of a spacing of height; and a force would jump by a ghost's share.

use aero_geometry::Vector;
use aero_geometry::kernel::SUPPORT;

use super::Ghost;
use crate::neighbours::Lists;
use crate::problem::{Domain, Side};
use crate::records::Near;

/// Widths of a ghost's kernel from an open side within which pairs are looked at one by one: gas may be wider than a ghost.
const REACH: f64 = 2.0;

/// The lists of `near` with the pairs alone that press on what lies within open sides; none where that is all of them.
pub fn within_open_sides<const D: usize>(
    domain: &Domain<D>,
    ghosts: &[Ghost<D>],
    gas: &[Near<D>],
    near: &Lists,
) -> Option<Lists> {
    let is_at_a_cut = |ghost: &Ghost<D>| {
        let reach = REACH * SUPPORT * ghost.shown.smoothing_length;
        !holds(domain, &ghost.position, -reach)
    };
    if !ghosts.iter().any(is_at_a_cut) {
        return None;
    }
    let mut within = near.clone();
    within.restrict(
        |g| is_at_a_cut(&ghosts[g]).then_some(g),
        |at_a_cut, slot| {
            at_a_cut.is_none_or(|g| holds(domain, &crossing(&ghosts[g], &gas[slot].position), 0.0))
        },
    );
    Some(within)
}

/// Where the line from a ghost to gas in front of it goes through the wall, taken for plane between them.
fn crossing<const D: usize>(ghost: &Ghost<D>, gas: &Vector<D>) -> Vector<D> {
    let height = (gas - ghost.foot()).dot(&ghost.normal).max(0.0);
    let share = ghost.depth / (ghost.depth + height);
    ghost.position + (gas - ghost.position) * share
}

/// True for a place on the inner side of all open sides moved out by `margin`.
fn holds<const D: usize>(domain: &Domain<D>, place: &Vector<D>, margin: f64) -> bool {
    domain.each_side().all(|(axis, end, side, _)| {
        !Side::is_open(side) || domain.depth_within(axis, end, place) >= -margin
    })
}
