//! Ghosts behind the plane walls that bound the domain, on the gas's own lattice.

use aero_geometry::Vector;

use crate::lattice;
use crate::layers::{BUFFER, GHOSTS};
use crate::problem::{Domain, Motion, Side, WallKind};

/// One wall side with its ghosts.
#[derive(Clone, Debug)]
pub struct SideWall<const D: usize> {
    /// Motion along the axis.
    pub motion: Motion<D>,
    /// Slip or no slip.
    pub kind: WallKind,
    /// Ghosts of this side; corners where walls meet belong to the first of them.
    pub ghosts: Vec<SideGhost<D>>,
}

/// A ghost behind a plane wall.
#[derive(Clone, Copy, Debug)]
pub struct SideGhost<const D: usize> {
    /// Position.
    pub position: Vector<D>,
    /// Unit normal into the domain; oblique in corners.
    pub normal: Vector<D>,
    /// Distance from the domain.
    pub depth: f64,
    /// Layer, 0 at the wall.
    pub layer: u32,
}

/// Axis and number (0 lower, 1 upper) of each wall side of the domain, in the order of
/// `plane_walls`.
pub fn wall_sides<const D: usize>(domain: &Domain<D>) -> Vec<(usize, usize)> {
    let walls = domain.each_side().filter(|(_, _, side, _)| side.is_wall());
    walls.map(|(axis, end, ..)| (axis, end)).collect()
}

/// Ghosts of all wall sides of `domain`, on the lattice of `spacing`.
pub fn plane_walls<const D: usize>(domain: &Domain<D>, spacing: f64) -> Vec<SideWall<D>> {
    let sides = wall_sides(domain);
    sides
        .iter()
        .enumerate()
        .map(|(number, &(axis, end))| {
            let Side::Wall {
                kind,
                velocity,
                acceleration,
            } = domain.sides[axis][end]
            else {
                unreachable!("only wall sides are listed")
            };
            let mut motion = Motion::none();
            motion.velocity[axis] = velocity;
            motion.acceleration[axis] = acceleration;
            let behind_earlier = |position: &Vector<D>| {
                sides[..number]
                    .iter()
                    .any(|&(axis, end)| beyond(domain, position, axis, end))
            };
            let ghosts = slab(domain, spacing, axis, end)
                .into_iter()
                .filter(|position| !behind_earlier(position))
                .filter(|position| domain.part_at(axis, end, position).is_none())
                .map(|position| ghost(domain, spacing, position, axis))
                .collect();
            SideWall {
                motion,
                kind,
                ghosts,
            }
        })
        .collect()
}

fn ghost<const D: usize>(
    domain: &Domain<D>,
    spacing: f64,
    position: Vector<D>,
    axis: usize,
) -> SideGhost<D> {
    // Along open sides the wall runs on; only other walls make corners.
    let mut closest = position;
    for k in 0..D {
        for end in [0, 1] {
            if domain.sides[k][end].is_wall() && beyond(domain, &position, k, end) {
                closest[k] = domain.face(k, end);
            }
        }
    }
    let arm = closest - position;
    SideGhost {
        position,
        normal: arm.normalize(),
        depth: arm.norm(),
        layer: (arm[axis].abs() / spacing).floor() as u32,
    }
}

fn beyond<const D: usize>(
    domain: &Domain<D>,
    position: &Vector<D>,
    axis: usize,
    end: usize,
) -> bool {
    let face = domain.face(axis, end);
    if end == 0 {
        position[axis] < face
    } else {
        position[axis] > face
    }
}

/// Lattice points behind one side, over the domain's width and its buffers or corners.
fn slab<const D: usize>(
    domain: &Domain<D>,
    spacing: f64,
    axis: usize,
    end: usize,
) -> Vec<Vector<D>> {
    let mut first = [0_i64; D];
    let mut last = [0_i64; D];
    for k in 0..D {
        let cells = (domain.bounds.size()[k] / spacing).round() as i64;
        let margin = |e: usize| match domain.sides[k][e] {
            _ if domain.opens(k, e) => BUFFER as i64,
            side if side.is_mirror() || side.is_periodic() => 0,
            _ => GHOSTS as i64,
        };
        (first[k], last[k]) = match (k == axis, end) {
            (true, 0) => (-(GHOSTS as i64), 0),
            (true, _) => (cells, cells + GHOSTS as i64),
            _ => (-margin(0), cells + margin(1)),
        };
    }
    lattice::points(first, last)
        .map(|index| lattice::position(&domain.bounds.min, spacing, &index))
        .collect()
}

#[cfg(test)]
mod tests {
    use aero_geometry::Bounds;

    use super::*;

    const WALL: Side = Side::Wall {
        kind: WallKind::Slip,
        velocity: 0.0,
        acceleration: 0.0,
    };

    #[test]
    fn a_closed_box_is_fenced_without_gaps_or_doubles() {
        let bounds = Bounds::new(Vector::<2>::zeros(), Vector::<2>::repeat(1.0));
        let domain = Domain {
            bounds,
            sides: [[WALL; 2]; 2],
            openings: Vec::new(),
        };
        let walls = plane_walls(&domain, 0.1);
        let count: usize = walls.iter().map(|wall| wall.ghosts.len()).sum();
        assert_eq!(count, 20 * 20 - 10 * 10);
        let corner = walls[0]
            .ghosts
            .iter()
            .find(|g| g.position.max() < 0.0 && g.layer == 0);
        let corner = corner.expect("the corner belongs to the first wall");
        assert!((corner.normal.norm() - 1.0).abs() < 1e-14);
    }
}
