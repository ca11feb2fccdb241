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

/// Most faces that meet in a ridge: those of an octahedron.
const MOST: usize = 8;

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
            let share = 1.0 / feet.len() as f64;
            ghosts.volume[g] *= share;
            for (foot, face) in feet.into_iter().skip(1) {
                let arm = foot - ghosts.position[g];
                ghosts.position.push(ghosts.position[g]);
                ghosts.distance.push(-arm.norm());
                ghosts.normal.push(arm.normalize());
                ghosts.volume.push(ghosts.volume[g]);
                ghosts.layer.push(ghosts.layer[g]);
                ghosts.face.push(face);
            }
        }
    }
}

/// The feet of ghost `g` on all faces that it is as near to as to its own, its own first, and their faces.
fn feet<const D: usize>(
    shape: &dyn Shape<D>,
    ghosts: &Ghosts<D>,
    g: usize,
    spacing: f64,
) -> Vec<(Vector<D>, u32)> {
    let (place, depth) = (ghosts.position[g], -ghosts.distance[g]);
    let mut feet = vec![(place + ghosts.normal[g] * depth, ghosts.face[g])];
    if depth <= 0.0 {
        return feet;
    }
    let look = |feet: &mut Vec<(Vector<D>, u32)>, way: Vector<D>| {
        let seen = shape.closest(&(place + way * (PROBE * depth)));
        let is_near = ((seen.point - place).norm() - depth).abs() < PROBE * depth;
        let is_new = feet
            .iter()
            .all(|(foot, _)| (seen.point - foot).norm() > APART * depth);
        if is_near && is_new && feet.len() < MOST {
            // Seen from a little aside, the foot is a little aside too; the face is where it is.
            let outwards = seen.normal;
            let found = foot_on(shape, &place, &Foot::of(&seen), spacing);
            let foot = found.map_or_else(
                || place + outwards * (seen.point - place).dot(&outwards),
                |found| found.point,
            );
            feet.push((foot, seen.face));
        }
    };
    let away = (place - feet[0].0) / depth;
    look(&mut feet, away);
    if feet.len() == 1 {
        return feet;
    }
    // All around: of a body that is its own mirror image the feet are, too.
    for number in 0..3_usize.pow(D as u32) {
        let way = Vector::<D>::from_fn(|k, _| (number / 3_usize.pow(k as u32) % 3) as f64 - 1.0);
        if let Some(way) = way.try_normalize(0.5) {
            look(&mut feet, way);
        }
    }
    feet
}
