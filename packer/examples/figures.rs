//! Packs the bodies of the tests and prints what came of it as a table:
//! `cargo run --release -p aero-packer -F figures --example figures [-- WORD...]`, where only the bodies whose names
//! hold one of the words are packed. Seconds are those of the processor, all threads together, for ghosts and three fluid layers.

#[path = "../tests/packing/bodies.rs"]
mod bodies;

use std::error::Error;

use aero_geometry::Shape;
use aero_packer::{PackOptions, PackReport, pack};
use cpu_time::ProcessTime;

fn main() -> Result<(), Box<dyn Error>> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let wanted = |name: &str| words.is_empty() || words.iter().any(|word| name.contains(word));
    println!(
        "| body | ghosts | fluid | density std, % | max, % | volume, % | offset, dx | gap, dx | hole, dx | mirror | CPU s |\n\
         |---|---|---|---|---|---|---|---|---|---|---|"
    );
    for body in bodies::planes()? {
        let turned = bodies::off_lattice(&body.shape);
        for (name, shape) in [
            (body.name.to_owned(), body.shape),
            (format!("{}, turned", body.name), turned),
        ] {
            if wanted(&name) {
                row(&name, &shape, 1.0)?;
            }
        }
    }
    for body in bodies::solids()? {
        if wanted(body.name) {
            row(body.name, &body.shape, body.spacing)?;
        }
    }
    Ok(())
}

fn row<const D: usize>(
    name: &str,
    shape: &dyn Shape<D>,
    spacing: f64,
) -> Result<(), Box<dyn Error>> {
    let start = ProcessTime::now();
    let options = PackOptions {
        fluid_layers: 3,
        ..PackOptions::new(spacing)
    };
    let PackReport {
        ghosts,
        fluid,
        density_std_percent: std,
        density_max_percent: max,
        shell_volume_error_percent: volume,
        wall_offset_max: offset,
        min_gap,
        layer_hole_max,
        mirror_error_max,
        ..
    } = pack(shape, &options)?.report;
    let seconds = start.elapsed().as_secs_f64();
    let mirror = mirror_error_max.map_or("-".to_owned(), |error| format!("{error:.0e}"));
    println!(
        "| {name} | {ghosts} | {fluid} | {std:.2} | {max:.2} | {volume:.3} | {offset:.0e} | {min_gap:.2} | {layer_hole_max:.2} | {mirror} | {seconds:.2} |"
    );
    Ok(())
}
