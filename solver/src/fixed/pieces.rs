//! Panels in pieces, each of which belongs to one wall.

use std::rc::Rc;

use aero_geometry::kernel::{SMOOTHING_RATIO, SUPPORT};
use aero_geometry::{Pencils, Vector};

use super::bend::turned;
use super::walls::Wall;
use crate::panels::Panel;
use crate::panels::cut::longest_edge;

/// Part of the kernel's reach that a panel looks about, at first.
const LOOK: f64 = 0.25;

/// So often it looks twice as far.
const FARTHER: usize = 8;

/// Cosine between the directions of a panel and of a wall that it may belong to, which may go round an edge.
const ROUND: f64 = 0.2;

/// Pieces of a panel are no longer than this part of the wall that they belong to.
const FINE: f64 = 0.5;

/// The same of pieces that walls meet in: on lines, where halving goes straight to where they meet, and on surfaces, where what is too much
/// here is too little there.
const FINEST: [f64; 2] = [1e-9, 1.0 / 16.0];

/// No piece is a smaller part of its panel: on lines, and on surfaces.
const LEAST: [f64; 2] = [1e-10, 1.0 / 1024.0];

/// Walls that are smaller than this part of a square as wide as is looked about own nothing: slivers, which an edge that runs along the
/// edges of cells leaves in them, would ask for pieces as small.
const SLIVER: f64 = 1e-7;

/// So few walls are not looked through for those that may own a part of a panel.
const FEW: usize = 12;

/// What distances are off by at most.
const ROUNDED: f64 = 1.0 + 1e-9;

/// Walls in the plane are equally near where they are by this part of their length.
const MEETING: f64 = 1e-6;

/// Cosines that differ by less are of walls that face alike.
const ALIKE: f64 = 1e-9;

/// A piece of a panel.
#[derive(Clone, Copy, Debug)]
pub struct Piece<const D: usize> {
    /// Its middle.
    pub place: Vector<D>,
    /// What it is of the panel.
    pub part: f64,
    /// Number of the wall that it belongs to.
    pub wall: usize,
}

/// The walls of all cells with the pressure on them, to look for those near a place.
pub struct Nearby<'a, const D: usize> {
    walls: &'a [(&'a Wall<D>, f64)],
    points: &'a [Vector<D>],
    by_foot: Pencils<D>,
    look: f64,
    /// Length of the longest wall: what belongs to it may be half of that away from its foot.
    longest: f64,
}

impl<'a, const D: usize> Nearby<'a, D> {
    /// Of `walls` of the cells about `points`, in gas of this spacing.
    pub fn new(walls: &'a [(&'a Wall<D>, f64)], points: &'a [Vector<D>], spacing: f64) -> Self {
        let feet: Vec<Vector<D>> = walls.iter().map(|(wall, _)| wall.foot).collect();
        let look = LOOK * SMOOTHING_RATIO * SUPPORT * spacing;
        Self {
            walls,
            points,
            by_foot: Pencils::new(&feet, look),
            look,
            longest: walls
                .iter()
                .map(|(wall, _)| length(wall))
                .fold(0.0, f64::max),
        }
    }

    /// How far is near, m.
    pub fn look(&self) -> f64 {
        self.look
    }

    /// Hands out the number of each wall that may have its foot within `reach` of a place, and the wall.
    pub fn for_each(
        &self,
        place: &Vector<D>,
        reach: f64,
        mut take: impl FnMut(usize, &(&Wall<D>, f64)),
    ) {
        self.by_foot.for_each_run_near(place, place, reach, |run| {
            for &n in &self.by_foot.order()[run] {
                take(n as usize, &self.walls[n as usize]);
            }
        });
    }

    /// The pieces of a panel, each with the wall of the cell that it belongs to; none where there is none far and wide.
    pub fn pieces(&self, panel: &Panel<D>) -> Vec<Piece<D>> {
        let mut reach = self.look.max(self.longest);
        for _ in 0..FARTHER {
            if let Some(mut found) = self.pieces_within(panel, reach) {
                // All panels' are kept at once.
                found.shrink_to_fit();
                return found;
            }
            reach *= 2.0;
        }
        Vec::new()
    }

    /// The same of walls that are no farther than `reach`; none where a piece has none.
    fn pieces_within(&self, panel: &Panel<D>, reach: f64) -> Option<Vec<Piece<D>>> {
        let mut found = Vec::new();
        let near = within(
            &Rc::new(self.candidates(panel, reach)),
            &panel.corners,
            reach,
        );
        // Whom a corner belongs to is found out once, not for each of the pieces that meet there.
        let owners = panel.corners.each_ref().map(|at| owner(&near, at, reach));
        let mut left = vec![(panel.corners, owners, 1.0, near)];
        let least = LEAST[usize::from(D == 3)];
        while let Some((corners, owners, part, near)) = left.pop() {
            let place = corners.iter().sum::<Vector<D>>() / D as f64;
            let wall = owner(&near, &place, reach)?;
            let fine = if owners.iter().all(|corner| *corner == Some(wall)) {
                FINE
            } else {
                FINEST[usize::from(D == 3)]
            };
            let longest = fine * length(self.walls[wall].0);
            match longest_edge(&corners) {
                Some((a, b, long)) if long > longest && part > least => {
                    let middle = (corners[a] + corners[b]) * 0.5;
                    let beside = owner(&near, &middle, reach);
                    for end in [a, b] {
                        let (mut half, mut halves) = (corners, owners);
                        (half[end], halves[end]) = (middle, beside);
                        let near = within(&near, &half, reach);
                        left.push((half, halves, 0.5 * part, near));
                    }
                }
                _ => found.push(Piece { place, part, wall }),
            }
        }
        Some(found)
    }

    /// The walls that places on a panel may belong to which are no farther from them than `reach`.
    fn candidates(&self, panel: &Panel<D>, reach: f64) -> Vec<Candidate<D>> {
        let mut found = Vec::new();
        let sliver = SLIVER * self.look.powi(D as i32 - 1);
        let [low, high] = panel
            .corners
            .iter()
            .fold([panel.corners[0]; 2], |[low, high], corner| {
                [low.inf(corner), high.sup(corner)]
            });
        self.by_foot.for_each_run_near(&low, &high, reach, |run| {
            for &n in &self.by_foot.order()[run] {
                let (wall, _) = self.walls[n as usize];
                let facing = facing(wall, panel);
                if facing > ROUND && wall.image.share >= sliver {
                    found.push(Candidate {
                        n: n as usize,
                        cell: wall.i,
                        foot: wall.foot,
                        along: turned(&wall.image.normal.into()),
                        point: self.points[wall.i as usize],
                        facing,
                        area: wall.image.share,
                    });
                }
            }
        });
        found
    }
}

/// Those of the walls `near` a panel that places on a part of it with these `corners` may belong to: one that is farther from all of it than another
/// owns none of its places. Fine cells may be thousands to the spacing that is looked about.
fn within<const D: usize>(
    near: &Rc<Vec<Candidate<D>>>,
    corners: &[Vector<D>; D],
    reach: f64,
) -> Rc<Vec<Candidate<D>>> {
    if near.len() <= FEW {
        return Rc::clone(near);
    }
    let centre = corners.iter().sum::<Vector<D>>() / D as f64;
    let to_corners = corners.iter().map(|corner| (corner - centre).norm());
    let radius = to_corners.fold(0.0, f64::max);
    let in_reach = near
        .iter()
        .filter(|found| (found.foot - centre).norm() + radius < reach);
    let nearest = in_reach.map(|found| found.away(&centre));
    let farthest = ROUNDED * (nearest.fold(f64::INFINITY, f64::min) + 2.0 * radius);
    let may_own = |found: &&Candidate<D>| found.away(&centre) <= farthest + MEETING * found.area;
    Rc::new(near.iter().filter(may_own).copied().collect())
}

/// Number of the wall that a place on a panel belongs to: in the plane the nearest one, in space that of the cell whose point is nearest, as cells
/// are divided but for thin parts of bodies; of a cell's walls the one that faces the panel most, the larger one of several. None where all `near`
/// the panel are farther than `reach`.
fn owner<const D: usize>(near: &[Candidate<D>], place: &Vector<D>, reach: f64) -> Option<usize> {
    let mut best: Option<(&Candidate<D>, f64)> = None;
    for found in near {
        if (found.foot - place).norm_squared() > reach * reach {
            continue;
        }
        let from_point = (found.point - place).norm_squared();
        let is_better = best.is_none_or(|(best, least)| {
            let nearer = found.away(place) - best.away(place);
            if D == 2 && nearer.abs() > MEETING * found.area {
                nearer < 0.0
            } else if found.cell == best.cell || from_point == least {
                found.faces_more_than(best)
            } else {
                from_point < least
            }
        });
        if is_better {
            best = Some((found, from_point));
        }
    }
    best.map(|(found, _)| found.n)
}

/// A wall that places on a panel may belong to.
#[derive(Clone, Copy)]
struct Candidate<const D: usize> {
    /// Its number.
    n: usize,
    /// Its cell.
    cell: u32,
    foot: Vector<D>,
    /// Direction of the wall in the plane.
    along: Vector<D>,
    /// That cell's point.
    point: Vector<D>,
    /// Cosine between the directions of the wall and of the panel.
    facing: f64,
    /// Area of the wall.
    area: f64,
}

impl<const D: usize> Candidate<D> {
    /// How far a place is, in the plane from the wall, which is as long as its cell says, and in space from the cell's point.
    fn away(&self, place: &Vector<D>) -> f64 {
        if D == 3 {
            return (self.point - place).norm();
        }
        let arm = place - self.foot;
        let along = arm.dot(&self.along);
        let beyond = (along.abs() - 0.5 * self.area).max(0.0);
        (arm - self.along * along).norm().hypot(beyond)
    }

    /// Of walls that face alike the larger one: slivers, which facets that meet leave in a cell, would ask for pieces as small.
    fn faces_more_than(&self, other: &Self) -> bool {
        let more = self.facing - other.facing;
        more > ALIKE || (more > -ALIKE && self.area > other.area)
    }
}

/// Cosine between the directions that a wall and a panel look in; below any where they are not of the same body.
fn facing<const D: usize>(wall: &Wall<D>, panel: &Panel<D>) -> f64 {
    if wall.owner == panel.owner {
        -panel.normal.dot(&Vector::from(wall.image.normal))
    } else {
        f64::NEG_INFINITY
    }
}

/// Length of a wall's side, as if it were a square.
fn length<const D: usize>(wall: &Wall<D>) -> f64 {
    if D == 3 {
        wall.image.share.sqrt()
    } else {
        wall.image.share
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use aero_geometry::{Placement, Shape, bodies};

    use super::*;
    use crate::fixed::FixedSimulation;
    use crate::fixed::tests::flows::stream;
    use crate::panels::Panels;

    /// Places that a panel is sampled at.
    const SAMPLES: usize = 2000;

    /// A panel that walls meet in is shared by them as its places are.
    #[test]
    fn walls_have_of_a_panel_what_is_theirs_of_its_places() {
        let block = bodies::rectangle(0.7, 0.4, 0.0).expect("a block");
        let block: Arc<dyn Shape<2>> = Arc::new(block.placed(&Placement::default().rotated(0.3)));
        let problem = stream(2.0, [[-1.0, -1.0], [1.0, 1.0]], 1.0 / 16.0, vec![block]);
        let flow = FixedSimulation::new(problem).expect("a flow");
        let walls: Vec<_> = flow.walls().collect();
        let nearby = Nearby::new(&walls, &flow.points, flow.problem.resolution.lattice());
        let mut shared = 0;
        for panel in Panels::new(&flow.problem).all() {
            let pieces = nearby.pieces(panel);
            let near = nearby.candidates(panel, nearby.look());
            let [from, to] = panel.corners;
            let owners: Vec<usize> = (0..SAMPLES)
                .map(|n| from + (to - from) * ((n as f64 + 0.5) / SAMPLES as f64))
                .filter_map(|place| owner(&near, &place, nearby.look()))
                .collect();
            assert_eq!(owners.len(), SAMPLES);
            let whole: f64 = pieces.iter().map(|piece| piece.part).sum();
            assert!((whole - 1.0).abs() < 1e-12, "{whole}");
            let mut found: Vec<usize> = pieces.iter().map(|piece| piece.wall).collect();
            found.sort_unstable();
            found.dedup();
            shared += usize::from(found.len() > 1);
            for wall in found {
                let own = pieces.iter().filter(|piece| piece.wall == wall);
                let part: f64 = own.map(|piece| piece.part).sum();
                let sampled = owners.iter().filter(|other| **other == wall).count();
                let sampled = sampled as f64 / SAMPLES as f64;
                let fine = FINEST[0] * length(walls[wall].0) / (to - from).norm();
                let off = (part - sampled).abs();
                assert!(off < 2.0 * fine + 2.0 / SAMPLES as f64, "{part} {sampled}");
            }
        }
        assert!(shared > 10, "{shared}");
    }
}
