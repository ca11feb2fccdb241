//! Vectors of any width give the same flow: AVX-512 and AVX2 where the processor has them, and plain numbers.

use std::path::Path;

use crate::support::{Workplace, vtp_array};

/// A short run of a case in vectors of this kind, or the widest; none where the processor has no such vectors.
fn run(case: &str, settings: &[&str], vectors: Option<&str>) -> Option<(Workplace, Vec<f64>)> {
    let place = Workplace::new();
    let scene = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("cases/{case}.toml"));
    let mut command = assert_cmd::Command::cargo_bin("aero").expect("the program");
    command
        .current_dir(place.path(""))
        .arg("run")
        .arg(scene)
        .args(["--out", "results", "--set", "output.frames=2"])
        .args(settings.iter().flat_map(|setting| ["--set", setting]))
        .env_remove("AERO_VECTORS");
    if let Some(vectors) = vectors {
        command.env("AERO_VECTORS", vectors);
    }
    let output = command.output().expect("the program runs");
    let said = String::from_utf8_lossy(&output.stderr);
    if output.status.code() == Some(2) && said.contains("which this processor does not have") {
        return None;
    }
    assert!(output.status.success(), "{said}");
    let frame = place.path("results/frame-000001.vtp");
    let numbers = [vtp_array(&frame, "pressure"), vtp_array(&frame, "density")].concat();
    assert!(numbers.len() > 100, "{case}");
    Some((place, numbers))
}

/// Sums of particles are of products that some processors fuse and others do not.
#[test]
fn vectors_of_any_width_move_particles_alike() {
    let flows: [(&str, &[&str]); 3] = [
        ("sod-1d", &["spacing=0.01", "end_time=0.1"]),
        ("wedge", &["spacing=0.25", "end_time=0.6"]),
        ("sphere", &["spacing=0.3333333333333333", "end_time=0.02"]),
    ];
    for (case, settings) in flows {
        for precision in ["double", "mixed"] {
            let precise = format!("scheme.precision=\"{precision}\"");
            let settings = [settings, &[precise.as_str()]].concat();
            let (_, widest) = run(case, &settings, None).expect("any processor has them");
            let largest = widest.iter().fold(0.0_f64, |most, n| most.max(n.abs()));
            let allowed = largest * if precision == "double" { 1e-8 } else { 1e-4 };
            for vectors in ["avx2", "plain"] {
                let Some((_, narrow)) = run(case, &settings, Some(vectors)) else {
                    continue;
                };
                assert_eq!(narrow.len(), widest.len(), "{case}, {precision}");
                for (a, b) in narrow.iter().zip(&widest) {
                    assert!(
                        (a - b).abs() < allowed,
                        "{case}, {precision}, {vectors}: {a} {b}"
                    );
                }
            }
        }
    }
}

/// Faces are summed up without fused products: to the bit.
#[test]
fn vectors_of_any_width_give_points_the_same_bits() {
    let settings = ["spacing=0.25", "end_time=0.5"];
    let bytes = |place: &Workplace| std::fs::read(place.path("results/frame-000001.vtp"));
    let (widest, _) = run("wedge-fixed", &settings, None).expect("any processor has them");
    let widest = bytes(&widest).expect("a frame");
    for vectors in ["avx2", "plain"] {
        if let Some((place, _)) = run("wedge-fixed", &settings, Some(vectors)) {
            assert!(bytes(&place).expect("a frame") == widest, "{vectors}");
        }
    }
}
