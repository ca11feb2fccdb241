//! Packs plates and what else is asked for and prints volume and cover: `cargo run --release -p aero-packer -F figures --example plates`
//! packs plates of 0.3 to 3 spacings, alone at several angles; with a spacing and STL files, these.

use std::error::Error;
use std::path::Path;

use aero_geometry::{Mesh, Placed, Placement, Shape, Vector, bodies, stl::Unit};
use aero_packer::{PackOptions, pack};
use cpu_time::ProcessTime;

fn main() -> Result<(), Box<dyn Error>> {
    println!(
        "| body | ghosts | thin | volume, % | uncovered, % | hole | layer hole | gap | std | max | s |\n|---|---|---|---|---|---|---|---|---|---|---|"
    );
    let mut words = std::env::args().skip(1);
    if let Some(spacing) = words.next() {
        let spacing: f64 = spacing.parse()?;
        for file in words {
            let mesh = Mesh::read(Path::new(&file), Unit::Metre)?;
            row(&file, &mesh, spacing);
        }
        return Ok(());
    }
    for tenths in 3..=30 {
        let thickness = f64::from(tenths) / 10.0;
        let plate = bodies::cuboid([16.3, 11.7, thickness])?;
        for angle in [0.0, 17.0, 45.0] {
            let axis = Vector::<3>::new(0.3, 0.9, 0.2);
            let place = Placement::default()
                .rotated_about(&axis, f64::to_radians(angle))?
                .moved(Vector::<3>::new(0.13, 0.27, 0.41) * (angle / 17.0));
            row(
                &format!("{thickness:.1}, {angle}"),
                &Placed::new(plate, place),
                1.0,
            );
        }
    }
    Ok(())
}

fn row(name: &str, shape: &dyn Shape<3>, spacing: f64) {
    let start = ProcessTime::now();
    let packing = match pack(shape, &PackOptions::new(spacing)) {
        Ok(packing) => packing,
        Err(error) => {
            println!("| {name} | {error}");
            return;
        }
    };
    let report = packing.report;
    println!(
        "| {name} | {} | {} | {:+.2} | {:.3} | {:.2} at {:.3?} | {:.2} | {:.2} | {:.2} | {:.2} | {:.2} | {:?}",
        report.ghosts,
        report.thin,
        report.volume_error_percent,
        report.uncovered_area_percent,
        report.hole_max,
        report.hole_at,
        report.layer_hole_max,
        report.min_gap,
        report.density_std_percent,
        report.density_max_percent,
        start.elapsed().as_secs_f64(),
        report.warnings,
    );
}
