//! Pictures of a packing: in the plane all particles; in space a slice through the middle and the wall
//! layer as seen along z.

use std::path::{Path, PathBuf};

use aero_packer::{Ghosts, Packing};
use aero_validation::pictures::PictureError;
use aero_validation::pictures::particles::{ParticlePicture, Slab};

use crate::output::OutputError;

/// The particles that a picture shows.
#[derive(Default)]
struct Set {
    position: Vec<[f64; 3]>,
    diameter: Vec<f64>,
    value: Vec<f64>,
}

impl Set {
    /// Adds the particles for which `wanted(number)` holds, coloured by the signed distance in
    /// spacings.
    fn add<const D: usize>(
        &mut self,
        set: &Ghosts<D>,
        spacing: f64,
        wanted: impl Fn(usize) -> bool,
    ) {
        for n in (0..set.position.len()).filter(|&n| wanted(n)) {
            let coordinate = |k: usize| if k < D { set.position[n][k] } else { 0.0 };
            self.position.push(std::array::from_fn(coordinate));
            self.diameter.push(set.volume[n].powf(1.0 / D as f64));
            self.value.push(set.distance[n] / spacing);
        }
    }
}

/// Draws the packing of `bodies` into files `STEM-pack.png` or `STEM-slice.png` and
/// `STEM-wall.png`; returns them.
pub(super) fn draw<const D: usize>(
    bodies: &[(String, Packing<D>)],
    stem: &Path,
) -> Result<Vec<PathBuf>, OutputError> {
    let name = stem.file_name().unwrap_or_default().to_string_lossy();
    let mut files = Vec::new();
    let mut draw = |picture: &ParticlePicture<'_>, ending: &str| {
        let path = stem.with_file_name(format!("{name}-{ending}.png"));
        match picture.save(&path) {
            Ok(()) => files.push(path),
            // A slice may pass through the hole of a ring.
            Err(PictureError::Empty(_)) => {}
            Err(error) => return Err(OutputError::new(&path, std::io::Error::other(error))),
        }
        Ok(())
    };
    let mut all = Set::default();
    let mut wall = Set::default();
    for (_, packing) in bodies {
        let spacing = packing.report.spacing;
        let ghosts = &packing.ghosts;
        all.add(ghosts, spacing, |_| true);
        all.add(&packing.fluid, spacing, |_| true);
        let seen = |n: usize| ghosts.layer[n] == 0 && ghosts.normal[n][D - 1] > 0.0;
        wall.add(ghosts, spacing, |n| D == 3 && seen(n));
    }
    let label = "signed distance / Δx";
    let slice = if D == 2 {
        name.to_string()
    } else {
        format!("{name}: slice")
    };
    let mut picture = ParticlePicture::new(&slice, &all.position, &all.diameter, &all.value, label);
    if D == 2 {
        draw(&picture, "pack")?;
        return Ok(files);
    }
    let ends = (f64::INFINITY, f64::NEG_INFINITY);
    let (low, high) = all
        .position
        .iter()
        .fold(ends, |(low, high), p| (low.min(p[2]), high.max(p[2])));
    picture.slab = Some(Slab {
        axis: 2,
        centre: 0.5 * (low + high),
        half: 0.5 * all.diameter.iter().fold(0.0, |a: f64, &b| a.max(b)),
    });
    draw(&picture, "slice")?;
    let height: Vec<f64> = wall.position.iter().map(|p| p[2]).collect();
    let title = format!("{name}: wall layer");
    draw(
        &ParticlePicture::new(&title, &wall.position, &wall.diameter, &height, "z"),
        "wall",
    )?;
    Ok(files)
}
