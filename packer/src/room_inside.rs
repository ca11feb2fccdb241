//! How much room the layers have inside of a body: whether a ball as thick as them fits in nearby.

use aero_geometry::{Shape, Vector};

use crate::room::{Probe, Room};

/// A layer fits where a ball of this part of its depth does.
const FITS: f64 = 0.95;

/// A ball that is this much smaller fits too.
const NEARLY: f64 = 0.98;

/// It may be this many times as far away as it is deeper: 1.7 in the corner of a block, 2 in an edge of 60 degrees.
const FARTHEST: f64 = 2.0;

/// What is added to that, in spacings.
const SLACK: f64 = 0.1;

/// Cosine between the normals of opposite faces that are parallel, to 18 degrees; from faces of a wedge pushes lead up it.
const PARALLEL: f64 = -0.95;

/// Pushes away from the nearest surface.
const PUSHES: usize = 10;

/// A distance that differs by this much, in spacings, from the one expected tells of a ridge.
const RIDGE: f64 = 0.01;

/// How far behind the last layer, in spacings, a ridge still counts.
const BEYOND: f64 = 0.2;

/// True where layer `layer` has room at `point`, in the body or on its surface, where the signed distance is `distance` and its gradient
/// `normal`.
pub(crate) fn has_room<const D: usize>(
    shape: &dyn Shape<D>,
    (point, distance, normal): (&Vector<D>, f64, &Vector<D>),
    layer: usize,
    spacing: f64,
) -> bool {
    let wanted = FITS * (layer as f64 + 1.0) * spacing;
    let mut missing = wanted + distance;
    let mut last = *normal;
    let farthest = FARTHEST * missing + SLACK * spacing;
    let mut here = *point;
    let mut strength = 1.0;
    for _ in 1..PUSHES {
        if missing <= (1.0 - NEARLY) * wanted {
            return true;
        }
        here -= strength * missing * last;
        if (here - point).norm() > farthest {
            return false;
        }
        let seen = shape.closest(&here);
        missing = wanted + seen.distance;
        // Between two parallel faces, pushed from one to the other, it comes to the middle.
        if seen.normal.dot(&last) < PARALLEL {
            strength *= 0.5;
        }
        last = seen.normal;
    }
    missing <= (1.0 - NEARLY) * wanted
}

/// How much room the layer of ghosts at the centre of a cell has, and how many layers have room there.
pub(crate) fn room_inside<const D: usize>(
    shape: &dyn Shape<D>,
    cell: &Probe<D>,
    spacing: f64,
) -> (Room, usize) {
    let reach = cell.reach();
    let depth = -cell.distance;
    let end = ((depth + reach) / spacing).ceil();
    if end <= 0.0 {
        return (Room::Clear, usize::MAX);
    }
    let far = (end + BEYOND) * spacing;
    let there = cell.centre - (far - depth) * cell.normal;
    if (shape.signed_distance(&there) + far).abs() < RIDGE * spacing {
        return (Room::Clear, usize::MAX);
    }
    let first = ((depth - reach) / spacing).floor().max(0.0) as usize;
    let layer = (depth.max(0.0) / spacing).floor() as usize;
    let inside = cell.centre + depth.min(0.0) * cell.normal;
    let inside = (&inside, -depth.max(0.0), &cell.normal);
    let full = (first..end as usize)
        .find(|&layer| !has_room(shape, inside, layer, spacing))
        .unwrap_or(usize::MAX);
    let room = if full <= layer {
        Room::Thin
    } else {
        Room::Ridge
    };
    (room, full)
}

/// Number of layers, `most` at most, that have room below a place of the surface.
pub(crate) fn layers_with_room<const D: usize>(
    shape: &dyn Shape<D>,
    (point, normal): (&Vector<D>, &Vector<D>),
    most: usize,
    spacing: f64,
) -> usize {
    let end = most as f64 * spacing;
    if (shape.signed_distance(&(point - end * normal)) + end).abs() < RIDGE * spacing {
        return most;
    }
    (0..most)
        .find(|&layer| !has_room(shape, (point, 0.0, normal), layer, spacing))
        .unwrap_or(most)
}

#[cfg(test)]
mod tests {
    use aero_geometry::bodies;

    use super::*;

    #[test]
    fn a_block_has_room_in_its_corners_and_a_plate_none_at_its_rim() {
        let block = bodies::cuboid([9.0, 9.0, 9.0]).expect("a block");
        let corner = Vector::<3>::repeat(4.5);
        let out = Vector::<3>::repeat(3.0_f64.sqrt().recip());
        let corner = (&corner, 0.0, &out);
        assert!(has_room(&block, corner, 0, 1.0) && has_room(&block, corner, 3, 1.0));
        let plate = bodies::cuboid([9.0, 9.0, 1.2]).expect("a plate");
        let rim = Vector::<3>::new(4.5, 0.3, 0.1);
        assert!(!has_room(&plate, (&rim, 0.0, &Vector::<3>::x()), 0, 1.0));
        let thick = bodies::cuboid([9.0, 9.0, 2.4]).expect("a plate");
        let up = Vector::<3>::z();
        let face = Vector::<3>::new(0.0, 0.3, 1.2);
        assert_eq!(layers_with_room(&thick, (&face, &up), 5, 1.0), 1);
    }
}
