//! Packs STL files and prints what came of it: `cargo run --release -p aero-packer --example report -- SPACING FILE...`.

use std::error::Error;
use std::path::Path;

use aero_geometry::{Mesh, stl::Unit};
use aero_packer::{PackOptions, pack};
use cpu_time::ProcessTime;

fn main() -> Result<(), Box<dyn Error>> {
    let mut words = std::env::args().skip(1);
    let spacing: f64 = words.next().ok_or("a spacing comes first")?.parse()?;
    for file in words {
        let mesh = Mesh::read(Path::new(&file), Unit::Metre)?;
        let start = ProcessTime::now();
        let report = pack(&mesh, &PackOptions::new(spacing))?.report;
        println!("{file}: {report:#?}");
        println!("{:.2} s of processor time", start.elapsed().as_secs_f64());
    }
    Ok(())
}
