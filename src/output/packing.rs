//! What a packing writes: ghosts, conforming fluid, report, pictures.

use std::path::{Path, PathBuf};

use aero_packer::Ghosts;

use super::atomic::write_json;
use super::error::{OutputError, make_folder};
use super::ghosts::write_ghosts;
use super::packing_picture::draw;
use crate::pack::{AnyPacked, PackFile, Packed};

/// Writes ghosts, conforming fluid if there is any, report and pictures into `folder`; returns the
/// files.
pub fn write_packing(packed: &AnyPacked, folder: &Path) -> Result<Vec<PathBuf>, OutputError> {
    let report = packed.report();
    match packed {
        AnyPacked::Two(packed) => write(packed, &report, folder),
        AnyPacked::Three(packed) => write(packed, &report, folder),
    }
}

fn write<const D: usize>(
    packed: &Packed<D>,
    report: &PackFile,
    folder: &Path,
) -> Result<Vec<PathBuf>, OutputError> {
    make_folder(folder)?;
    let file = |ending: &str| folder.join(format!("{}-{ending}", packed.name));
    let bodies = || packed.bodies.iter().map(|(_, packing)| packing);
    let mut files = vec![file("ghosts.vtp")];
    let ghosts: Vec<&Ghosts<D>> = bodies().map(|packing| &packing.ghosts).collect();
    write_ghosts(&files[0], &ghosts)?;
    let fluid: Vec<&Ghosts<D>> = bodies().map(|packing| &packing.fluid).collect();
    if fluid.iter().any(|fluid| !fluid.position.is_empty()) {
        files.push(file("fluid.vtp"));
        write_ghosts(&files[1], &fluid)?;
    }
    files.push(file("pack.json"));
    write_json(&files[files.len() - 1], report)?;
    files.extend(draw(&packed.bodies, &folder.join(&packed.name))?);
    Ok(files)
}
