//! How many particles a scene asks for, and whether this machine can hold them: asked before
//! anything is allocated.

use aero_geometry::Bounds;

use super::domain::number;
use super::error::SceneError;

/// Bytes per particle while a run is going, by dimension: most of it is neighbour lists and the
/// frame being written. Measured on shock tubes of half a million particles (1D, 2D) and 144 000
/// (3D), rounded up.
const BYTES: [f64; 3] = [1000.0, 1200.0, 2200.0];

/// The same of a point that stays, while points come and go: measured on refined flows of 0.07 (2D) to 0.6 million (3D), rounded up.
const BYTES_OF_POINT: f64 = 1500.0;

/// Numbers of particles are 32-bit in neighbour lists.
const MOST: f64 = 4.0e9;

/// Refuses a scene whose region of flow would hold more particles at `spacing` than memory does.
pub(super) fn check<const D: usize>(
    region: &Bounds<D>,
    spacing: f64,
    place: &str,
) -> Result<(), SceneError> {
    let particles: f64 = region.size().iter().map(|width| width / spacing).product();
    refuse::<D>(particles, spacing, place, available_bytes())
}

/// So many points that stay fit into memory, where the system tells.
pub(super) fn room_for_points() -> Option<u64> {
    available_bytes().map(|free| (free / BYTES_OF_POINT).min(MOST) as u64)
}

/// Refuses to pack a surface of about `area` with `layers` layers at `spacing` if the ghosts would
/// not fit.
pub(super) fn check_ghosts<const D: usize>(
    bounds: &Bounds<D>,
    spacing: f64,
    layers: usize,
    place: &str,
) -> Result<(), SceneError> {
    let cells = bounds.size().map(|width| (width / spacing).max(1.0));
    let face = |k: usize| cells.iter().product::<f64>() / cells[k];
    let shell = (0..D).map(|k| 2.0 * face(k)).sum::<f64>() * layers as f64;
    let shell = shell.min(cells.iter().product());
    refuse::<D>(shell, spacing, place, available_bytes())
}

fn refuse<const D: usize>(
    particles: f64,
    spacing: f64,
    place: &str,
    available: Option<f64>,
) -> Result<(), SceneError> {
    let bytes = particles * BYTES[D - 1];
    let room = available.map_or(MOST, |free| (free / BYTES[D - 1]).min(MOST));
    if particles <= room {
        return Ok(());
    }
    let coarser = spacing * (particles / room).powf(1.0 / D as f64);
    let free = available.map_or(String::new(), |free| format!("; {} are free", size(free)));
    Err(SceneError::value(
        place,
        format!(
            "{} asks for about {particles:.1e} particles, {} of memory{free}; a spacing of {} or more would fit",
            number(spacing),
            size(bytes),
            number(coarser),
        ),
    ))
}

fn size(bytes: f64) -> String {
    const GB: f64 = 1e9;
    if bytes < 0.1 * GB {
        format!("{:.1} MB", bytes / 1e6)
    } else if bytes < 1e4 * GB {
        format!("{:.1} GB", bytes / GB)
    } else {
        format!("{:.1e} GB", bytes / GB)
    }
}

/// Memory that a new process can have, where the system tells (Linux).
fn available_bytes() -> Option<f64> {
    let table = std::fs::read_to_string("/proc/meminfo").ok()?;
    let line = table
        .lines()
        .find(|line| line.starts_with("MemAvailable:"))?;
    let kilobytes: f64 = line.split_whitespace().nth(1)?.parse().ok()?;
    Some(kilobytes * 1024.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_scene_that_fits_passes_and_one_that_does_not_names_a_spacing() {
        assert!(refuse::<3>(1e6, 0.1, "spacing", Some(8e9)).is_ok());
        let room = 1e9 * BYTES[2];
        let error = refuse::<3>(8e9, 0.1, "spacing", Some(room)).unwrap_err();
        // An eighth of the particles fits, so twice the spacing.
        assert!(
            error.to_string().contains("a spacing of 0.2 or more"),
            "{error}"
        );
    }
}
