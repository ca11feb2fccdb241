//! How much room layers have in the plane, and outside of a body: how far it is to the opposite surface.

use aero_geometry::{Shape, Vector};

use crate::room::{Probe, Room};

/// A layer fits where the body is at least this much of twice its depth thick.
const FITS: f64 = 0.95;

/// A distance that differs by this much, in spacings, from the one expected tells of a ridge.
const RIDGE: f64 = 0.01;

/// How far behind the last layer, in spacings, a ridge still counts.
const BEYOND: f64 = 0.2;

/// Steps of the ray that measures thickness; a ray along a wall takes many and has room.
const RAY_STEPS: usize = 60;

/// True where layer `layer` has room at `point`: its far face exists, or the way through the body
/// to the opposite surface is long enough for the layers of both sides.
pub(crate) fn fits<const D: usize>(
    shape: &dyn Shape<D>,
    (point, distance, normal): (&Vector<D>, f64, &Vector<D>),
    layer: usize,
    spacing: f64,
) -> bool {
    let depth = (layer as f64 + 1.0) * spacing;
    let face = depth.copysign(distance);
    let beyond = shape.signed_distance(&(point + (face - distance) * normal));
    (beyond - face).abs() <= 0.1 * spacing
        || thickness(shape, (point, distance, normal), 2.0 * FITS * depth) >= 2.0 * FITS * depth
}

/// Length of the straight way from the closest surface point through `point` to the opposite
/// surface, or `enough` if it is no shorter.
pub(crate) fn thickness<const D: usize>(
    shape: &dyn Shape<D>,
    (point, distance, normal): (&Vector<D>, f64, &Vector<D>),
    enough: f64,
) -> f64 {
    let direction = normal * 1.0_f64.copysign(distance);
    let mut travelled = distance.abs();
    let mut step = travelled;
    for _ in 0..RAY_STEPS {
        if travelled >= enough {
            return enough;
        }
        if step < 1e-3 * enough {
            return travelled;
        }
        travelled += step;
        let here = shape.signed_distance(&(point + (travelled - distance.abs()) * direction));
        step = here * 1.0_f64.copysign(distance);
    }
    enough
}

/// How much room the layer at the centre of a cell has, and how many layers have room there.
pub(crate) fn room_across<const D: usize>(
    shape: &dyn Shape<D>,
    cell: &Probe<D>,
    spacing: f64,
) -> (Room, usize) {
    let last = ((cell.distance.abs() + cell.reach()) / spacing).ceil() * spacing;
    let end = (last + BEYOND * spacing).copysign(cell.distance);
    let there = cell.centre + (end - cell.distance) * cell.normal;
    if (shape.signed_distance(&there) - end).abs() < RIDGE * spacing {
        return (Room::Clear, usize::MAX);
    }
    let layer = (cell.distance.abs() / spacing).floor() as usize;
    let seen = (&cell.centre, cell.distance, &cell.normal);
    if fits(shape, seen, layer, spacing) {
        (Room::Ridge, usize::MAX)
    } else {
        (Room::Thin, 0)
    }
}
