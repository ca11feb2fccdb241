//! Pictures of a packing: in the plane all particles; in space a slice through the middle and the wall
//! layer as seen along z.

use std::path::{Path, PathBuf};

use aero_packer::{Ghosts, Packing};
use aero_validation::pictures::PictureError;
use aero_validation::pictures::particles::{ParticlePicture, Slab};

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
) -> Result<Vec<PathBuf>, PictureError> {
    let file = |ending: &str| {
        let name = stem.file_name().unwrap_or_default().to_string_lossy();
        stem.with_file_name(format!("{name}-{ending}.png"))
    };
    let mut all = Set::default();
    let mut wall = Set::default();
    for (_, packing) in bodies {
        let spacing = packing.report.spacing;
        let ghosts = &packing.ghosts;
        all.add(ghosts, spacing, |_| true);
        all.add(&packing.fluid, spacing, |_| true);
        wall.add(ghosts, spacing, |n| {
            ghosts.layer[n] == 0 && D == 3 && ghosts.normal[n][D - 1] > 0.0
        });
    }
    let label = "signed distance / Δx";
    let name = stem.file_name().unwrap_or_default().to_string_lossy();
    if D == 2 {
        let picture =
            ParticlePicture::new(&name, &all.position, &all.diameter, &all.value, label);
        picture.save(&file("pack"))?;
        return Ok(vec![file("pack")]);
    }
    let (low, high) = all
        .position
        .iter()
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), p| {
            (low.min(p[2]), high.max(p[2]))
        });
    let thickest = all.diameter.iter().fold(0.0, |a: f64, &b| a.max(b));
    let title = format!("{name}: slice");
    let mut slice =
        ParticlePicture::new(&title, &all.position, &all.diameter, &all.value, label);
    slice.slab = Some(Slab {
        axis: 2,
        centre: 0.5 * (low + high),
        half: 0.5 * thickest,
    });
    slice.save(&file("slice"))?;
    // What is nearer hides what is farther; the height tells the two apart.
    let mut order: Vec<usize> = (0..wall.position.len()).collect();
    order.sort_by(|&a, &b| wall.position[a][2].total_cmp(&wall.position[b][2]));
    let position: Vec<[f64; 3]> = order.iter().map(|&n| wall.position[n]).collect();
    let diameter: Vec<f64> = order.iter().map(|&n| wall.diameter[n]).collect();
    let height: Vec<f64> = position.iter().map(|p| p[2]).collect();
    let title = format!("{name}: wall layer");
    ParticlePicture::new(&title, &position, &diameter, &height, "z").save(&file("wall"))?;
    Ok(vec![file("slice"), file("wall")])
}
