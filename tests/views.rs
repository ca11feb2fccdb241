//! Fields on a lattice and pictures beside the frames of a run.

mod support;

use support::{BOX, Workplace, appended, box_with};

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
        place.run(LINEAR, &["--set", &motion]).succeeds();
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
fn the_field_has_the_same_bits_for_any_number_of_threads_and_after_a_stop() {
    let place = Workplace::new();
    let field = || std::fs::read(place.path("results/field-000001.vti")).expect("a field");
    place.run(LINEAR, &["--threads", "1"]).succeeds();
    let one = field();
    place.run(LINEAR, &["--threads", "3"]).succeeds();
    assert!(one == field());
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
