//! Bodies as CAD programs and scanners export them, through `aero pack`: assemblies, holes, sheets, and
//! files of other formats.

use std::fmt::Write as _;
use std::io::Write as _;

use crate::support::{Workplace, read_vtp};

type Facets = Vec<[[f64; 3]; 3]>;

/// Corners of a block's faces; bit `a` of a corner's number is set at the upper end of axis `a`.
const QUADS: [[usize; 4]; 6] = [
    [0, 4, 6, 2],
    [1, 3, 7, 5],
    [0, 1, 5, 4],
    [2, 6, 7, 3],
    [0, 2, 3, 1],
    [4, 5, 7, 6],
];

fn block(low: [f64; 3], high: [f64; 3]) -> Facets {
    let corner = |k: usize| std::array::from_fn(|a| if k >> a & 1 == 1 { high[a] } else { low[a] });
    QUADS
        .iter()
        .flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]])
        .map(|facet| facet.map(corner))
        .collect()
}

/// A block that is open at its upper or lower end.
fn open_block(low: [f64; 3], high: [f64; 3], y: f64) -> Facets {
    let mut facets = block(low, high);
    facets.retain(|facet| !facet.iter().all(|corner| corner[1] == y));
    facets
}

fn stl(facets: &Facets) -> String {
    let mut text = String::from("solid made by hand\n");
    for facet in facets {
        text += "facet normal 0 0 0\nouter loop\n";
        for [x, y, z] in facet {
            // Writing to a string cannot fail.
            let _ = writeln!(text, "vertex {x} {y} {z}");
        }
        text += "endloop\nendfacet\n";
    }
    text + "endsolid\n"
}

const CUBE: [[f64; 3]; 2] = [[-0.5; 3], [0.5; 3]];

#[track_caller]
fn packs(
    name: &str,
    content: impl AsRef<[u8]>,
    flags: &[&str],
    words: &[&str],
) -> (Workplace, f64) {
    let place = Workplace::new();
    place.write(name, content);
    let arguments = [
        "pack",
        name,
        "--spacing",
        "0.05",
        "--layers",
        "2",
        "--out",
        "here",
    ];
    let answer = place.aero(&[&arguments[..], flags].concat());
    answer.succeeds();
    for word in words {
        assert!(answer.out.contains(word), "{word}: {}", answer.out);
    }
    let stem = name.split('.').next().unwrap();
    read_vtp(&place.path(&format!("here/{stem}-ghosts.vtp")));
    let report = place.json(&format!("here/{stem}-pack.json"));
    (place, report["ghosts"].as_f64().unwrap())
}

#[track_caller]
fn refused(name: &str, content: impl AsRef<[u8]>, words: &[&str]) {
    let place = Workplace::new();
    place.write(name, content);
    place.aero(&["pack", name]).refuses(words);
}

#[test]
fn a_fin_that_is_open_in_the_body_and_faces_inwards_is_united_with_it() {
    let [low, high] = CUBE;
    let mut fin = open_block([-0.3, 0.3, -0.1], [0.3, 0.9, 0.1], 0.3);
    for facet in &mut fin {
        facet.swap(1, 2);
    }
    let facets = [block(low, high), fin].concat();
    packs(
        "plane.stl",
        stl(&facets),
        &[],
        &["ignored openings inside of other parts, 1 hole: ", "united"],
    );
}

#[test]
fn touching_blocks_are_packed_as_one() {
    let [low, high] = CUBE;
    let seam = [block(low, high), block([0.5, -0.5, -0.5], [1.0, 0.5, 0.5])].concat();
    let (_, ghosts) = packs("two.stl", stl(&seam), &[], &[]);
    let whole = block(low, [1.0, 0.5, 0.5]);
    let (_, exact) = packs("one.stl", stl(&whole), &[], &[]);
    assert_eq!(ghosts, exact);
}

#[test]
fn a_hole_is_refused_with_the_flag_that_closes_it() {
    let [low, high] = CUBE;
    let cup = stl(&open_block(low, high, 0.5));
    let hole = "is open at 1 hole: 1.414e0 wide near (0.000000, 0.500000, 0.000000)";
    refused("cup.stl", &cup, &[hole, "--fill", "fill = true"]);
    packs(
        "cup.stl",
        &cup,
        &["--fill"],
        &["repaired: filled 1 hole: 1.414e0 wide"],
    );
    packs(
        "cup.stl",
        &cup,
        &["--wrap"],
        &["repaired: wrapped 10 triangles"],
    );
}

#[test]
fn a_sheet_is_refused_with_the_flag_that_makes_it_thick() {
    let sheet = stl(&vec![
        [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.1]],
        [[0.0, 0.0, 0.0], [1.0, 1.0, 0.1], [0.0, 1.0, 0.0]],
    ]);
    refused("sail.stl", &sheet, &["--thicken T", "thicken = T"]);
    let (_, thick) = packs(
        "sail.stl",
        &sheet,
        &["--thicken", "0.2"],
        &["2 triangles a thickness"],
    );
    assert!(thick > 1500.0, "{thick}");
    packs(
        "sail.stl",
        &sheet,
        &["--wrap"],
        &["as thick as the spacing"],
    );
    for bad in ["0", "-1", "thin"] {
        let place = Workplace::new();
        place.write("sail.stl", &sheet);
        let thicken = format!("--thicken={bad}");
        assert_eq!(place.aero(&["pack", "sail.stl", &thicken]).status, 2);
        assert_eq!(
            place.aero(&["pack", "sail.stl", "--fill", "--wrap"]).status,
            2
        );
    }
}

#[test]
fn files_of_other_formats_are_read_packed_or_not_or_refused_with_a_way_to_convert_them() {
    let corner = |k: usize| {
        [0, 1, 2]
            .map(|a| if k >> a & 1 == 1 { "0.5" } else { "-0.5" })
            .join(" ")
    };
    let corners: Vec<String> = (0..8).map(corner).collect();
    let mut obj = String::from("o cube\n");
    let mut ply = String::from(
        "ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float y\n\
         property float z\nelement face 6\nproperty list uchar int vertex_indices\nend_header\n",
    );
    for corner in &corners {
        let _ = writeln!(obj, "v {corner}");
        ply.push_str(corner);
        ply.push('\n');
    }
    for [a, b, c, d] in QUADS {
        let _ = writeln!(obj, "f {} {} {} {}", a + 1, b + 1, c + 1, d + 1);
        let face = format!("4 {a} {b} {c} {d}\n");
        ply.push_str(&face);
    }
    let [low, high] = CUBE;
    let (_, ghosts) = packs("cube.stl", stl(&block(low, high)), &[], &[]);
    let packed = |text: &str| {
        let mut writer = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::fast());
        writer.write_all(text.as_bytes()).unwrap();
        writer.finish().unwrap()
    };
    for (name, content) in [
        ("cube.obj", obj.clone().into_bytes()),
        ("cube.PLY", ply.clone().into_bytes()),
        ("cube.obj.gz", packed(&obj)),
        ("cube.ply.gz", packed(&ply)),
        ("cube.stl.gz", packed(&stl(&block(low, high)))),
    ] {
        assert_eq!(packs(name, content, &[], &[]).1, ghosts, "{name}");
    }
    refused("cube.stl.gz", "not packed at all", &["cube.stl.gz"]);
    refused("cube.step", &obj, &["cube.step", "gmsh"]);
    refused("cube.3MF", &obj, &["cube.3MF", "--export-stl"]);
    refused(
        "cube.txt",
        &obj,
        &["cube.txt", ".obj or .ply", "scene (.toml)"],
    );
    refused(
        "cube.obj",
        obj.replace("f 1", "f 9"),
        &["cube.obj", "obj: "],
    );
    refused(
        "cube.ply",
        ply.replace("4 0", "4 8"),
        &["cube.ply", "ply: "],
    );
}

#[test]
fn a_scene_says_the_same_in_the_body_s_shape() {
    let [low, high] = CUBE;
    let scene = |keys: &str| {
        format!(
            "dimension = 3\nspacing = 0.05\nend_time = 1.0\n\n[domain]\nmin = [-1.0, -1.0, -1.0]\n\
             max = [1.0, 1.0, 1.0]\n\n[domain.sides]\nx_min = \"wall\"\nx_max = \"wall\"\n\
             y_min = \"periodic\"\ny_max = \"periodic\"\nz_min = \"periodic\"\nz_max = \"periodic\"\n\n\
             [initial.riemann]\nposition = 0.5\nleft = {{ density = 1.0, pressure = 1.0 }}\n\
             right = {{ density = 0.125, pressure = 0.1 }}\n\n[[body]]\nname = \"cup\"\nshape = {{ stl = {{ file = \"cup.stl\"{keys} }} }}\n\
             place = {{ scale = 0.5 }}\n"
        )
    };
    let place = Workplace::new();
    place.write("cup.stl", stl(&open_block(low, high, 0.5)));
    for (keys, word) in [
        (", fill = true", "filled 1 hole"),
        (", thicken = 0.2", "a thickness of 2.000e-1"),
        (", wrap = true", "at a spacing of 1.000e-1"),
    ] {
        place.write("scene.toml", scene(keys));
        let answer = place.aero(&["pack", "scene.toml"]);
        answer.succeeds();
        assert!(answer.out.contains(word), "{}", answer.out);
    }
    place.write("scene.toml", scene(""));
    place
        .aero(&["pack", "scene.toml"])
        .refuses(&["body `cup`", "fill = true"]);
    place.write("scene.toml", scene(", fill = true, wrap = true"));
    place
        .aero(&["pack", "scene.toml"])
        .refuses(&["exclude each other"]);
    place.write("scene.toml", scene(", thicken = -1.0"));
    place.aero(&["pack", "scene.toml"]).refuses(&["thicken"]);
    place
        .aero(&["pack", "scene.toml", "--wrap"])
        .refuses(&["--wrap", "shape"]);
}
