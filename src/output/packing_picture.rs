//! Pictures of a packing: in the plane all particles; in space a slice across the shortest extent and
//! the wall layer as seen along it.

use aero_solver::problem::AXES;
use std::collections::HashMap;
use std::path::{Path, PathBuf};

use aero_packer::{Ghosts, Packing};
use aero_validation::pictures::PictureError;
use aero_validation::pictures::particles::{ParticlePicture, Slab};

use super::error::OutputError;

/// Diameter of the discs in spacings: small enough to see each by itself.
const DISC: f64 = 0.7;

/// Half of a slice, in spacings: rows half a spacing to either side of the middle are in it, whatever round-off says.
const HALF: f64 = 0.501;

/// What is this much higher, in spacings, stands above another.
const ABOVE: f64 = 0.25;

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
            self.diameter.push(DISC * spacing);
            self.value.push(set.distance[n] / spacing);
        }
    }

    /// Lowest and highest coordinate along an axis.
    fn ends(&self, axis: usize) -> [f64; 2] {
        let none = [f64::INFINITY, f64::NEG_INFINITY];
        self.position
            .iter()
            .fold(none, |[low, high], p| [low.min(p[axis]), high.max(p[axis])])
    }
}

impl Set {
    /// Where a slice across an axis shows something: half-way along, or, where a slab of that half
    /// thickness passes between bodies, through the particle in the middle of the order.
    fn middle(&self, axis: usize, half: f64) -> f64 {
        let [low, high] = self.ends(axis);
        let middle = 0.5 * (low + high);
        if self
            .position
            .iter()
            .any(|p| (p[axis] - middle).abs() < half)
        {
            return middle;
        }
        let mut places: Vec<f64> = self.position.iter().map(|p| p[axis]).collect();
        places.sort_by(f64::total_cmp);
        places.get(places.len() / 2).copied().unwrap_or(middle)
    }
}

/// The wall ghosts that an eye far up an axis sees: those that face it, and of the others, such as stand mid-way between the faces
/// of a thin part, those that none which faces it stands above.
fn in_sight<const D: usize>(ghosts: &Ghosts<D>, spacing: f64, across: usize) -> Vec<bool> {
    let faces = |n: usize| ghosts.layer[n] == 0 && ghosts.normal[n][across] > 0.0;
    let cell = |n: usize| -> [i64; 2] {
        let p = ghosts.position[n];
        [1, 2].map(|k| (p[(across + k) % D] / spacing).floor() as i64)
    };
    let mut highest: HashMap<[i64; 2], f64> = HashMap::new();
    for n in (0..ghosts.position.len()).filter(|&n| faces(n)) {
        let height = highest.entry(cell(n)).or_insert(f64::NEG_INFINITY);
        *height = height.max(ghosts.position[n][across]);
    }
    let is_hidden = |n: usize| {
        let [a, b] = cell(n);
        let above = ghosts.position[n][across] + ABOVE * spacing;
        let mut around = (-1..=1).flat_map(|i| (-1..=1).map(move |j| [a + i, b + j]));
        around.any(|place| highest.get(&place).is_some_and(|height| *height > above))
    };
    (0..ghosts.position.len())
        .map(|n| ghosts.layer[n] == 0 && (faces(n) || !is_hidden(n)))
        .collect()
}

/// Draws the packing of `bodies` into `STEM-pack.png`, or `STEM-slice.png` and `STEM-wall.png`;
/// returns the files.
pub(super) fn draw<const D: usize>(
    bodies: &[(String, Packing<D>)],
    stem: &Path,
) -> Result<Vec<PathBuf>, OutputError> {
    let name = stem.file_name().unwrap_or_default().to_string_lossy();
    let mut files = Vec::new();
    let mut save = |picture: &ParticlePicture<'_>, ending: &str| {
        let path = stem.with_file_name(format!("{name}-{ending}.png"));
        match picture.save(&path) {
            Ok(()) => files.push(path),
            // No wall ghost may look towards the eye.
            Err(PictureError::Empty(_)) => {}
            Err(error) => return Err(OutputError::new(&path, std::io::Error::other(error))),
        }
        Ok(())
    };
    let mut all = Set::default();
    for (_, packing) in bodies {
        all.add(&packing.ghosts, packing.report.spacing, |_| true);
        all.add(&packing.fluid, packing.report.spacing, |_| true);
    }
    let label = "signed distance / Δx";
    if D == 2 {
        let picture = ParticlePicture::new(&name, &all.position, &all.diameter, &all.value, label);
        save(&picture, "pack")?;
        return Ok(files);
    }
    let extent = |k: usize| all.ends(k)[1] - all.ends(k)[0];
    // Of equal extents the last is looked along.
    let across = (0..3)
        .rev()
        .min_by(|&a, &b| extent(a).total_cmp(&extent(b)));
    let across = across.unwrap_or(2);
    let axes = [[1, 2], [0, 2], [0, 1]][across];
    let axis_labels = axes.map(|k| AXES[k]);

    let title = format!("{name}: slice");
    let widest = all.diameter.iter().fold(0.0, |a: f64, &b| a.max(b));
    let half = HALF / DISC * widest;
    let slice = ParticlePicture {
        axes,
        axis_labels,
        slab: Some(Slab {
            axis: across,
            centre: all.middle(across, half),
            half,
        }),
        ..ParticlePicture::new(&title, &all.position, &all.diameter, &all.value, label)
    };
    save(&slice, "slice")?;

    let mut wall = Set::default();
    for (_, packing) in bodies {
        let ghosts = &packing.ghosts;
        let shown = in_sight(ghosts, packing.report.spacing, across);
        wall.add(ghosts, packing.report.spacing, |n| shown[n]);
    }
    // What is nearer to the eye is drawn later.
    let mut order: Vec<usize> = (0..wall.position.len()).collect();
    order.sort_by(|&a, &b| wall.position[a][across].total_cmp(&wall.position[b][across]));
    wall.position = order.iter().map(|&n| wall.position[n]).collect();
    wall.diameter = order.iter().map(|&n| wall.diameter[n]).collect();
    let height: Vec<f64> = wall.position.iter().map(|p| p[across]).collect();
    let title = format!("{name}: wall layer");
    let seen = ParticlePicture {
        axes,
        axis_labels,
        ..ParticlePicture::new(
            &title,
            &wall.position,
            &wall.diameter,
            &height,
            AXES[across],
        )
    };
    save(&seen, "wall")?;
    Ok(files)
}

#[cfg(test)]
mod tests {
    use aero_geometry::bodies;
    use aero_packer::{PackOptions, pack};

    use super::*;

    #[test]
    fn the_wall_layer_of_a_thin_plate_is_seen_whole_and_of_a_thick_one_the_upper_face() {
        for thickness in [1.0, 1.4, 8.0] {
            let plate = bodies::cuboid([12.0, 10.0, thickness]).unwrap();
            let ghosts = pack(&plate, &PackOptions::new(1.0)).unwrap().ghosts;
            let shown = in_sight(&ghosts, 1.0, 2);
            let seen = shown.iter().filter(|&&s| s).count();
            // A ghost per square spacing, whichever face it belongs to.
            assert!((110..=135).contains(&seen), "{thickness}: {seen}");
        }
    }
}
