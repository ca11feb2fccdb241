//! Packs ghosts of the tessellated capsule, 50 thousand facets, at finer and finer spacings and prints time and memory against
//! their number: `cargo run --release -p aero-packer -F figures --example growth [-- L1/DX...]`.

#[path = "../tests/packing/bodies.rs"]
mod bodies;

use std::error::Error;
use std::time::Instant;

use aero_geometry::bodies::Capsule;
use aero_packer::{PackOptions, pack};
use cpu_time::ProcessTime;

fn main() -> Result<(), Box<dyn Error>> {
    let start = Instant::now();
    let (_, mesh) = bodies::capsule()?;
    println!(
        "{} facets made a mesh in {:.2} s\n\n\
         | l1 / dx | ghosts | wall s | CPU s | CPU µs per ghost | gap | hole | density std, % |\n\
         |---|---|---|---|---|---|---|---|",
        mesh.facet_count(),
        start.elapsed().as_secs_f64()
    );
    let mut fineness: Vec<f64> = Vec::new();
    for word in std::env::args().skip(1) {
        fineness.push(word.parse()?);
    }
    if fineness.is_empty() {
        fineness = vec![20.0, 54.0, 172.0];
    }
    for across in fineness {
        let (cpu, wall) = (ProcessTime::now(), Instant::now());
        let options = PackOptions::new(Capsule::apollo().radius / across);
        let report = pack(&mesh, &options)?.report;
        let (cpu, wall) = (cpu.elapsed().as_secs_f64(), wall.elapsed().as_secs_f64());
        println!(
            "| {across} | {} | {wall:.1} | {cpu:.1} | {:.0} | {:.2} | {:.2} | {:.2} |",
            report.ghosts,
            1e6 * cpu / report.ghosts as f64,
            report.min_gap,
            report.layer_hole_max,
            report.density_std_percent
        );
    }
    Ok(())
}
