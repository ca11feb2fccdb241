//! `NAME-ghosts.vtp` and `NAME-fluid.vtp`: what the packer made.

use std::path::Path;

use aero_geometry::Vector;
use aero_packer::Ghosts;

use super::error::OutputError;
use super::vtk_xml::Told;
use super::vtp::Cloud;

/// Writes what was packed for several bodies, ghosts or conforming fluid, into one file, with the
/// number of the body on each particle.
pub fn write_ghosts<const D: usize>(path: &Path, bodies: &[&Ghosts<D>]) -> Result<(), OutputError> {
    let joined = |pick: fn(&Ghosts<D>) -> &[f64]| -> Vec<f64> {
        bodies
            .iter()
            .flat_map(|ghosts| pick(ghosts))
            .copied()
            .collect()
    };
    let positions = bodies.iter().flat_map(|ghosts| &ghosts.position);
    let normals: Vec<[f64; 3]> = bodies
        .iter()
        .flat_map(|ghosts| &ghosts.normal)
        .map(in_space)
        .collect();
    let layers: Vec<u32> = bodies
        .iter()
        .flat_map(|ghosts| &ghosts.layer)
        .copied()
        .collect();
    let faces: Vec<u32> = bodies
        .iter()
        .flat_map(|ghosts| &ghosts.face)
        .copied()
        .collect();
    let numbers = numbers(bodies.iter().map(|ghosts| ghosts.position.len()));
    Cloud::new(
        &positions.map(in_space).collect::<Vec<_>>(),
        &Told::default(),
    )
    .vectors("normal", &normals)
    .scalars("distance", &joined(|ghosts| &ghosts.distance)[..])
    .scalars("volume", &joined(|ghosts| &ghosts.volume)[..])
    .scalars("layer", &layers[..])
    .scalars("body", &numbers[..])
    .scalars("face", &faces[..])
    .write(path)
}

/// The number of the body, once per point of it.
fn numbers(counts: impl Iterator<Item = usize>) -> Vec<u32> {
    counts
        .enumerate()
        .flat_map(|(body, count)| std::iter::repeat_n(body as u32, count))
        .collect()
}

/// A point with its missing axes set to zero.
fn in_space<const D: usize>(point: &Vector<D>) -> [f64; 3] {
    std::array::from_fn(|k| if k < D { point[k] } else { 0.0 })
}
