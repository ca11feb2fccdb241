//! Fields on a lattice and pictures beside the frames of a run.

use std::path::Path;
use std::process::Command;

use crate::support::{BOX, Workplace, appended, box_with, read_surface, read_vtp};

/// A wedge in a box of gas whose state is linear in place.
const LINEAR: &str = r#"
dimension = 2
spacing = 0.05
end_time = 1e-6

[free_stream]
velocity = [1.0, 0.0]
density = 1.0
pressure = 1.0

[domain]
min = [0.0, 0.0]
max = [1.0, 0.8]

[domain.sides]
x_min = "inlet"
x_max = "outlet"
y_min = "wall"
y_max = "wall"

[initial.field]
density = "1 + 0.5 * x - 0.25 * y"
pressure = "2 + y"
velocity = ["1 + 0.1 * y", "0.2 * x"]

[[body]]
name = "plate"
shape = { polygon = { points = [[0.3, 0.3], [0.7, 0.3], [0.7, 0.5], [0.3, 0.5]] } }

[output]
frames = 1
compress = false
field = { spacing = 0.033 }
"#;

#[test]
fn a_linear_flow_is_met_to_round_off_by_particles_and_by_points() {
    for motion in ["with-the-gas", "fixed"] {
        let place = Workplace::new();
        let motion = format!("scheme.motion=\"{motion}\"");
        let gradients = "output.density_gradient=true";
        place
            .run(LINEAR, &["--set", &motion, "--set", gradients])
            .succeeds();
        let frame = place.path("results/frame-000000.vtp");
        let gradients = appended(&frame, "density_gradient").expect("gradients");
        assert!(gradients.len() > 3 * 200);
        for gradient in gradients.chunks(3) {
            let off = (gradient[0] - 0.5).hypot(gradient[1] + 0.25);
            assert!(off < 1e-9 && gradient[2] == 0.0, "{gradient:?}");
        }
        let path = place.path("results/field-000000.vti");
        let array = |name: &str| appended(&path, name).expect("an array");
        let (density, pressure) = (array("density"), array("pressure"));
        let (velocity, mask) = (array("velocity"), array("vtkValidPointMask"));
        let (gradient, mach) = (array("density_gradient"), array("mach"));
        let (columns, rows) = (31, 25);
        assert_eq!(density.len(), columns * rows);
        let mut solid = 0;
        for n in 0..density.len() {
            let x = (n % columns) as f64 / (columns - 1) as f64;
            let y = 0.8 * (n / columns) as f64 / (rows - 1) as f64;
            if mask[n] == 0.0 {
                assert!((0.3..=0.7).contains(&x) && (0.3..=0.5).contains(&y));
                solid += 1;
                continue;
            }
            let wanted = [1.0 + 0.5 * x - 0.25 * y, 2.0 + y, 1.0 + 0.1 * y, 0.2 * x];
            let found = [
                density[n],
                pressure[n],
                velocity[3 * n],
                velocity[3 * n + 1],
            ];
            for (found, wanted) in found.into_iter().zip(wanted) {
                assert!(
                    (found - wanted).abs() < 1e-11,
                    "{found} for {wanted} at {x}, {y}"
                );
            }
            assert!(
                (gradient[3 * n] - 0.5).abs() < 1e-9 && (gradient[3 * n + 1] + 0.25).abs() < 1e-9
            );
            let sound = (1.4 * wanted[1] / wanted[0]).sqrt();
            assert!((mach[n] - wanted[2].hypot(wanted[3]) / sound).abs() < 1e-11);
        }
        // 13 by 7 points, less those on its faces.
        assert!((50..=91).contains(&solid), "{solid}");
        let hidden = array("vtkGhostType");
        let hidden = hidden.iter().filter(|ghost| **ghost == 32.0).count();
        assert!((40..=72).contains(&hidden), "{hidden}");
        let pvd = std::fs::read_to_string(place.path("results/field.pvd")).expect("a collection");
        assert!(pvd.contains("field-000001.vti"), "{pvd}");
    }
}

#[test]
fn the_two_sides_of_a_thin_plate_do_not_see_each_other() {
    // A third of a spacing thick, between gas twice as dense above it as below.
    let scene = LINEAR
        .replace(
            "1 + 0.5 * x - 0.25 * y",
            "1.5 + 0.5 * tanh(1e4 * (y - 0.4))",
        )
        .replace(
            "[[0.3, 0.3], [0.7, 0.3], [0.7, 0.5], [0.3, 0.5]]",
            "[[0.1, 0.392], [0.9, 0.392], [0.9, 0.408], [0.1, 0.408]]",
        )
        .replace("spacing = 0.033", "spacing = 0.02");
    for motion in ["with-the-gas", "fixed"] {
        let place = Workplace::new();
        let motion = format!("scheme.motion=\"{motion}\"");
        place.run(&scene, &["--set", &motion]).succeeds();
        let density =
            appended(&place.path("results/field-000000.vti"), "density").expect("densities");
        let columns = 51;
        for (n, density) in density.iter().enumerate() {
            let (x, y) = ((n % columns) as f64 * 0.02, (n / columns) as f64 * 0.02);
            if (0.25..0.75).contains(&x) && (y - 0.4).abs() > 0.01 {
                let wanted = if y > 0.4 { 2.0 } else { 1.0 };
                assert!(
                    (density - wanted).abs() < 1e-9,
                    "{density} at {x}, {y}, {motion}"
                );
            }
        }
    }
}

#[test]
fn the_field_has_the_same_bits_for_any_number_of_threads_and_after_a_stop() {
    let place = Workplace::new();
    let field = || std::fs::read(place.path("results/field-000001.vti")).expect("a field");
    place.run(LINEAR, &["--threads", "1"]).succeeds();
    let one = field();
    place.run(LINEAR, &["--threads", "3"]).succeeds();
    assert!(one == field());
}

#[test]
fn the_field_may_be_of_a_part() {
    let place = Workplace::new();
    let region =
        "output.field={ spacing = 0.05, region = { min = [0.25, 0.1], max = [0.5, 0.5] } }";
    place.run(BOX, &["--set", region]).succeeds();
    let density = appended(&place.path("results/field-000002.vti"), "density");
    assert_eq!(density.map(|values| values.len()), Some(6 * 9));
}

#[test]
fn a_scene_that_asks_for_nothing_gets_nothing() {
    let place = Workplace::new();
    place.run(BOX, &[]).succeeds();
    for name in ["field.pvd", "field-000000.vti", "picture-000000.png"] {
        assert!(!place.path("results").join(name).exists(), "{name}");
    }
}

#[test]
fn pictures_are_drawn_on_lines_in_planes_and_in_space() {
    let line = "dimension = 1\nspacing = 0.05\nend_time = 0.01\n[domain]\nmin = [0.0]\nmax = [1.0]\n\
                [domain.sides]\nx_min = \"wall\"\nx_max = \"wall\"\n[initial.riemann]\nposition = 0.5\n\
                left = { density = 1.0, pressure = 1.0 }\nright = { density = 0.125, pressure = 0.1 }\n\
                [output]\nframes = 1\npicture = { quantity = \"density\" }\n";
    let plane = box_with(
        "frames = 2",
        "frames = 1\npicture = { quantity = \"schlieren\" }",
    );
    let space = line
        .replace("\"density\"", "\"density\", normal = [0.0, 1.0, 0.0], offset = 0.1")
        .replace("dimension = 1", "dimension = 3")
        .replace("[0.0]", "[0.0, 0.0, 0.0]")
        .replace("[1.0]", "[1.0, 0.5, 0.5]")
        .replace(
            "x_max = \"wall\"",
            "x_max = \"wall\"\ny_min = \"symmetry\"\ny_max = \"wall\"\nz_min = \"wall\"\nz_max = \"wall\"",
        );
    for scene in [line.to_owned(), plane, space] {
        let place = Workplace::new();
        place
            .run(&scene, &["--set", "scheme.motion=fixed"])
            .succeeds();
        let png = std::fs::read(place.path("results/picture-000001.png")).expect("a picture");
        assert!(
            png.starts_with(b"\x89PNG") && png.len() > 5_000,
            "{}",
            png.len()
        );
    }
}

#[test]
fn what_cannot_be_shown_is_refused_with_the_mend() {
    let place = Workplace::new();
    let with = |line: &str| box_with("frames = 2", &format!("frames = 2\n{line}"));
    for (line, words) in [
        ("field = { spacing = 1e-5 }", ["output.field", "spacing of"]),
        (
            "field = { region = { min = [0.0, 0.0], max = [2.0, 0.5] } }",
            ["output.field.region", "along x keep it between 0 and 1"],
        ),
        (
            "picture = { quantity = \"temperature\" }",
            ["output.picture.quantity", "free_stream.temperature"],
        ),
        (
            "picture = { quantity = \"pressure-coefficient\" }",
            ["output.picture.quantity", "at rest"],
        ),
        (
            "picture = { normal = [0.0, 0.0, 1.0] }",
            ["output.picture", "leave `normal`"],
        ),
        (
            "picture = { range = [2.0, 1.0] }",
            ["output.picture.range", "lower end first"],
        ),
        (
            "picture = { quantity = \"mac\" }",
            ["mac", "expected one of"],
        ),
    ] {
        place.run(&with(line), &[]).refuses(&words);
    }
}

/// `LINEAR` with a mirror below, and the body on it.
fn halved() -> String {
    LINEAR
        .replace("y_min = \"wall\"", "y_min = \"symmetry\"")
        .replace(
            "[[0.3, 0.3], [0.7, 0.3], [0.7, 0.5], [0.3, 0.5]]",
            "[[0.31, -0.21], [0.69, -0.21], [0.69, 0.21], [0.31, 0.21]]",
        )
        .replace("end_time = 1e-6", "end_time = 1e-3")
}

#[test]
fn the_other_half_is_shown_and_forces_stay_what_they_are() {
    let place = Workplace::new();
    let file = |name: &str| place.path("results").join(name);
    let motion = "scheme.motion=fixed";
    let run = |more: &[&str]| {
        let settings = [&["--set", motion, "--set", "output.cells=true"], more].concat();
        place.run(&halved(), &settings).succeeds();
        let history = std::fs::read_to_string(file("history.csv")).expect("a history");
        let (count, _) = read_vtp(&file("frame-000001.vtp"));
        let surface = read_surface(&file("surface-000001.vtp"));
        let cells = appended(&file("cells-000001.vtu"), "id")
            .expect("ids")
            .len();
        let field = appended(&file("field-000001.vti"), "velocity").expect("velocities");
        (history, count, surface, cells, field)
    };
    let (history, half, half_surface, half_cells, half_field) = run(&[]);
    let gradients = ["--set", "output.density_gradient=true"];
    let (again, whole, surface, cells, field) =
        run(&[&gradients[..], &["--set", "output.mirror=true"]].concat());
    let gradients = appended(&file("frame-000001.vtp"), "density_gradient").expect("gradients");
    let (own, images) = gradients.split_at(gradients.len() / 2);
    for (own, image) in own.chunks(3).zip(images.chunks(3)) {
        let off = (own[0] - image[0]).hypot(own[1] + image[1]);
        assert!(off < 1e-9, "{own:?} {image:?}");
    }
    assert!(history == again);
    assert_eq!((whole, cells), (2 * half, 2 * half_cells));
    assert_eq!(surface.cells.len(), 2 * half_surface.cells.len());
    // The forces across the mirror cancel, those along it are twice what they were.
    let force = |surface: &crate::support::Surface, k: usize| -> f64 {
        let panels = surface.arrays["pressure"]
            .iter()
            .zip(&surface.arrays["area"]);
        let normals = surface.arrays["normal"].iter().skip(k).step_by(3);
        panels.zip(normals).map(|((p, a), n)| p * a * n).sum()
    };
    assert!(force(&surface, 1).abs() < 1e-12);
    let [one, two] = [&half_surface, &surface].map(|surface| force(surface, 0));
    assert!((two - 2.0 * one).abs() < 1e-12);
    // Segments still go round with the gas on the same side of each.
    for (cell, normal) in surface.cells.iter().zip(surface.arrays["normal"].chunks(3)) {
        let [a, b] = [cell[0], cell[1]];
        let across = [b[1] - a[1], a[0] - b[0]];
        let first = half_surface.cells[0].clone();
        let way = half_surface.arrays["normal"][0] * (first[1][1] - first[0][1])
            + half_surface.arrays["normal"][1] * (first[0][0] - first[1][0]);
        let here = across[0] * normal[0] + across[1] * normal[1];
        assert!(here * way > 0.0, "{cell:?}");
    }
    // Row by row from below: the image's velocity along the second axis points the other way.
    let row = 3 * 31;
    let rows = field.len() / row;
    assert_eq!((field.len() - row) / 2, half_field.len() - row);
    for n in 0..rows {
        let (below, above) = (
            &field[n * row..][..row],
            &field[(rows - 1 - n) * row..][..row],
        );
        for (k, (a, b)) in below.iter().zip(above).enumerate() {
            let wanted = if k % 3 == 1 { -b } else { *b };
            assert!((a - wanted).abs() < 1e-12, "row {n}: {a} {b}");
        }
    }
    let whole = LINEAR.replace("field =", "mirror = true\nfield =");
    place
        .run(&whole, &[])
        .refuses(&["output.mirror", "no symmetry side", "leave it out"]);
}

#[test]
fn files_say_what_they_are_measured_by() {
    let place = Workplace::new();
    place
        .run(LINEAR, &["--set", "body.plate.reference_area=0.7"])
        .succeeds();
    for name in ["frame-000001.vtp", "surface-000001.vtp", "field-000001.vti"] {
        let path = place.path("results").join(name);
        assert_eq!(appended(&path, "gamma"), Some(vec![1.4]), "{name}");
        assert_eq!(appended(&path, "reference_area"), Some(vec![0.7]), "{name}");
        assert_eq!(appended(&path, "TimeValue").map(|t| t.len()), Some(1));
        let bytes = std::fs::read(&path).expect("a file");
        let text = String::from_utf8_lossy(&bytes);
        // `those of the scene`.
        assert!(
            text.contains("Name=\"units\"") && text.contains("116 104 111 115 101 32"),
            "{name}"
        );
    }
}

/// The script of `docs/VIEWING.md` reads what this run has written.
#[test]
fn the_script_for_viewing_is_python_and_opens_files_that_a_run_writes() {
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/VIEWING.md");
    let page = std::fs::read_to_string(page).expect("a page");
    let script = page.split("```python\n").nth(1).expect("a script");
    let script = script.split("```").next().expect("its end");
    let place = Workplace::new();
    place.run(LINEAR, &[]).succeeds();
    let mut names = script.split("{folder}/").skip(1).peekable();
    assert!(names.peek().is_some(), "{script}");
    for name in names {
        let name = name.split('"').next().expect("a name");
        let path = place
            .path("results")
            .join(name.replace("{number}", "000001"));
        assert!(path.exists(), "{}", path.display());
    }
    let path = place.write("show.py", script);
    let compiled = Command::new("python3")
        .args(["-m", "py_compile"])
        .arg(path)
        .output();
    let Ok(compiled) = compiled else {
        return;
    };
    assert!(
        compiled.status.success(),
        "{}",
        String::from_utf8_lossy(&compiled.stderr)
    );
}

#[test]
fn ghosts_and_buffers_have_files_of_their_own_where_they_are_asked_for() {
    let place = Workplace::new();
    place.run(LINEAR, &[]).succeeds();
    assert!(!place.path("results/ghosts-000001.vtp").exists());
    let kinds = |name: &str| appended(&place.path("results").join(name), "kind").expect("kinds");
    assert!(kinds("frame-000001.vtp").iter().all(|kind| *kind == 0.0));
    place
        .run(LINEAR, &["--set", "output.ghosts=true"])
        .succeeds();
    let others = kinds("ghosts-000001.vtp");
    assert!(others.contains(&1.0) && others.contains(&3.0) && !others.contains(&0.0));
    let settings = [
        "--set",
        "output.ghosts=true",
        "--set",
        "scheme.motion=fixed",
    ];
    place
        .run(LINEAR, &settings)
        .refuses(&["output.ghosts", "leave it out"]);
}
