//! Ghosts on ridges: those that two faces of a body are equally near to. One ghost can mirror the gas at one face alone, and would
//! show the gas before the other a wall that leans; so it is parted into as many as there are faces, at the same place, each with
//! its share of the volume.

use aero_geometry::{Shape, Vector};
use aero_packer::Ghosts;

use crate::faces::{Foot, foot_on};
use crate::problem::Problem;

/// How far, as a part of the depth, a point is moved away from one face to find another as near.
const PROBE: f64 = 1e-3;

/// Feet that lie nearer to each other than this part of the depth are on one face.
const APART: f64 = 0.1;

/// Ways in which faces are looked for, by their parts along the axes, each with all its mirror images. Around an axis no gap between
/// them is wider than 14 degrees, so that a polygon of 25 sides shows all of them, and no two images of one way are nearer to each
/// other than feet on two faces are. Polygons rarely have a corner there.
const WAYS: [[f64; 3]; 4] = [
    [1.0, 0.509, 0.259],
    [1.0, 0.601, 0.268],
    [1.0, 0.781, 0.469],
    [1.0, 0.364, 0.064],
];

/// Parts the ghosts of all bodies of `problem` that lie on ridges.
pub fn part<const D: usize>(problem: &mut Problem<D>) {
    let planes: Vec<(usize, f64)> = problem
        .domain
        .each_side()
        .filter(|(_, _, side, _)| side.is_mirror())
        .map(|(axis, _, _, plane)| (axis, plane))
        .collect();
    for body in &mut problem.bodies {
        let shape = body.shape.as_ref();
        let ghosts = &mut body.ghosts;
        for g in 0..ghosts.position.len() {
            let feet = feet(shape, ghosts, g, problem.resolution.at(&ghosts.position[g]));
            // On a plane that mirrors the flow the ghost's own image shows the other face.
            let is_imaged = planes.iter().any(|&(axis, plane)| {
                (ghosts.position[g][axis] - plane).abs()
                    < 1e-6 * problem.resolution.at(&ghosts.position[g])
            });
            if feet.len() < 2 || is_imaged {
                continue;
            }
            let place = ghosts.position[g];
            ghosts.volume[g] /= feet.len() as f64;
            for (n, (foot, face)) in feet.into_iter().enumerate() {
                let arm = foot - place;
                let (normal, distance) = (arm.normalize(), -arm.norm());
                if n == 0 {
                    (ghosts.normal[g], ghosts.distance[g], ghosts.face[g]) =
                        (normal, distance, face);
                    continue;
                }
                ghosts.position.push(place);
                ghosts.normal.push(normal);
                ghosts.distance.push(distance);
                ghosts.volume.push(ghosts.volume[g]);
                ghosts.layer.push(ghosts.layer[g]);
                ghosts.face.push(face);
            }
        }
    }
}

/// The feet of ghost `g` on all faces that it is as near to as to its own, and their faces; of faces that many, as on the axis of a
/// round body, those that [`ways`] lead to, so that the feet are their own mirror image where the body is.
fn feet<const D: usize>(
    shape: &dyn Shape<D>,
    ghosts: &Ghosts<D>,
    g: usize,
    spacing: f64,
) -> Vec<(Vector<D>, u32)> {
    let (place, depth) = (ghosts.position[g], -ghosts.distance[g]);
    let own = (place + ghosts.normal[g] * depth, ghosts.face[g]);
    if depth <= 0.0 {
        return vec![own];
    }
    let mut feet: Vec<(Vector<D>, u32)> = Vec::new();
    let is_among = |feet: &[(Vector<D>, u32)], point: &Vector<D>| {
        let mut near = feet.iter();
        near.any(|(foot, _)| (point - foot).norm() <= APART * depth)
    };
    let look = |way: Vector<D>| {
        let seen = shape.closest(&(place + way * (PROBE * depth)));
        let is_near = ((seen.point - place).norm() - depth).abs() < PROBE * depth;
        is_near.then_some(seen)
    };
    let away = look((place - own.0) / depth);
    if away.is_none_or(|seen| is_among(&[own], &seen.point)) {
        return vec![own];
    }
    for way in ways() {
        let Some(seen) = look(way) else {
            continue;
        };
        if is_among(&feet, &seen.point) {
            continue;
        }
        // Seen from a little aside, the foot is a little aside too; the face is where it is.
        let outwards = seen.normal;
        let found = foot_on(shape, &place, &Foot::of(&seen), spacing);
        let foot = found.map_or_else(
            || place + outwards * (seen.point - place).dot(&outwards),
            |found| found.point,
        );
        feet.push((foot, seen.face));
    }
    feet
}

/// Unit vectors all around that coordinate planes, and those midway between two of them, mirror onto each other; none lies in one of
/// these planes, where bodies have their edges and two faces are as near.
fn ways<const D: usize>() -> impl Iterator<Item = Vector<D>> {
    let orders = (0..D.pow(D as u32)).filter_map(|order| {
        let order: [usize; D] = std::array::from_fn(|k| order / D.pow(k as u32) % D);
        (0..D).all(|n| order.contains(&n)).then_some(order)
    });
    let images = orders.flat_map(|order| (0..1_usize << D).map(move |signs| (order, signs)));
    WAYS.iter().flat_map(move |parts| {
        images.clone().map(move |(order, signs)| {
            let sign = |k: usize| if signs >> k & 1 == 0 { 1.0 } else { -1.0 };
            Vector::<D>::from_fn(|k, _| sign(k) * parts[order[k]]).normalize()
        })
    })
}
