//! Bodies that stand on walls, in blasts and in cavities: no gas stays in a wall, and how often walls have to send gas back is small.

use std::fmt::Write as _;

use crate::support::Workplace;

const STREAM: &str = "mach = 2.0\ndensity = 1.4\npressure = 1.0";
const REST: &str = "density = 1.0\npressure = 0.1\nvelocity = [0.0, 0.0]";
const OVER_A_WALL: [&str; 4] = ["inlet", "outlet", "wall", "free-stream"];
const OVER_BODIES: [&str; 4] = ["inlet", "outlet", "body", "free-stream"];

/// A plane scene from -1 to 1, up to 1.
fn plane(
    (spacing, end_time, low): (f64, f64, f64),
    stream: &str,
    sides: [&str; 4],
    blocks: &[[f64; 4]],
) -> String {
    let mut text = format!(
        "dimension = 2\nspacing = {spacing}\nend_time = {end_time}\n[free_stream]\n{stream}\n[domain]\nmin = [-1.0, {low}]\n\
         max = [1.0, 1.0]\n[domain.sides]\n"
    );
    for (side, what) in ["x_min", "x_max", "y_min", "y_max"].iter().zip(sides) {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{side} = \"{what}\"");
    }
    for (number, [x0, x1, y0, y1]) in blocks.iter().enumerate() {
        let _ = writeln!(
            text,
            "[[body]]\nname = \"block-{number}\"\nshape = {{ rectangle = {{ width = {:.6}, height = {:.6} }} }}\n\
             place = {{ translate = [{:.6}, {:.6}] }}",
            x1 - x0,
            y1 - y0,
            0.5 * (x0 + x1),
            0.5 * (y0 + y1)
        );
    }
    text
}

fn box_on_a_wall() -> String {
    let block = [-0.2, 0.2, 0.0, 0.3];
    plane((0.05, 0.8, 0.0), STREAM, OVER_A_WALL, &[block])
}

/// How often walls sent gas back, and whether terminal and summary warn of it.
#[track_caller]
fn sent_back(scene: &str, settings: &[&str]) -> (u64, bool) {
    let place = Workplace::new();
    let answer = place.run(scene, settings);
    answer.succeeds();
    let summary = place.json("results/summary.json");
    assert_eq!(summary["leaked"], 0);
    let times = summary["returned"].as_u64().unwrap();
    let words = format!("walls brought gas back {times} times");
    let warnings = summary["warnings"].as_array().unwrap();
    let told = |w: &serde_json::Value| w.as_str().is_some_and(|w| w.contains(&words));
    let is_told = warnings.iter().any(told);
    assert_eq!(is_told, answer.out.contains(&words), "{}", answer.out);
    (times, is_told)
}

/// How often walls sent gas back, which is too seldom to be worth a word.
#[track_caller]
fn returned(scene: &str) -> u64 {
    let (times, is_told) = sent_back(scene, &[]);
    assert!(!is_told, "{times}");
    times
}

#[test]
fn no_gas_stays_in_a_box_on_a_wall_and_little_is_sent_back() {
    let most = returned(&box_on_a_wall());
    assert!(most <= 20, "{most}");
    // Ghosts that keep their mass instead let far more in.
    let varying = ["--set", "scheme.constant_ghost_volume=false"];
    let (more, is_told) = sent_back(&box_on_a_wall(), &varying);
    assert!(more > 100 && is_told, "{more}");
}

#[test]
fn no_gas_stays_in_a_box_on_a_wall_in_space() {
    let sides = "x_min = \"inlet\"\nx_max = \"outlet\"\ny_min = \"wall\"\ny_max = \"free-stream\"\nz_min = \"free-stream\"\n\
                 z_max = \"free-stream\"";
    let scene = format!(
        "dimension = 3\nspacing = 0.1\nend_time = 0.4\n[free_stream]\n{STREAM}\n[domain]\nmin = [-1.0, 0.0, -0.7]\n\
         max = [1.0, 1.0, 0.7]\n[domain.sides]\n{sides}\n[[body]]\nname = \"box\"\n\
         shape = {{ cuboid = {{ edges = [0.4, 0.4, 0.4] }} }}\nplace = {{ translate = [0.0, 0.2, 0.0] }}\n"
    );
    let most = returned(&scene);
    assert!(most <= 110, "{most}");
}

#[test]
fn no_gas_stays_in_a_building_that_a_blast_meets_or_in_a_cavity_of_blocks() {
    let blast =
        "[initial.field]\ndensity = \"1\"\npressure = \"if((x + 0.5)^2 + y^2 < 0.04, 10, 0.1)\"\n";
    let house = [0.0, 0.4, 0.0, 0.4];
    let building = plane((0.04, 0.4, 0.0), REST, ["wall"; 4], &[house]) + blast;
    let most = returned(&building);
    assert!(most <= 4, "{most}");
    let blocks = [
        [-3.0, -0.3, -0.6, 0.2],
        [-0.3, 0.3, -0.6, -0.05],
        [0.3, 3.0, -0.6, 0.2],
    ];
    let cavity = plane((0.05, 0.4, -0.1), STREAM, OVER_BODIES, &blocks);
    let most = returned(&cavity);
    assert!(most <= 8, "{most}");
}

#[test]
fn a_nozzle_that_ends_in_the_buffer_is_refused() {
    let walls = [[-3.0, 1.1, -0.6, 0.2], [-3.0, 1.1, 0.8, 1.6]];
    let sides = ["inlet", "outlet", "body", "body"];
    let scene = plane((0.05, 0.4, 0.0), STREAM, sides, &walls);
    let words = ["ends inside the buffer of side `x_max`", "carry it on past"];
    Workplace::new().run(&scene, &[]).refuses(&words);
}

/// A slab of a section with sharp edges in space, of facets as long as it is, `thickness` chords thick.
fn slab(thickness: f64) -> String {
    let half = 0.5 * thickness;
    let section = [
        [0.0, 0.0],
        [0.12, -half],
        [0.88, -half],
        [1.0, 0.0],
        [0.88, half],
        [0.12, half],
    ];
    let at = |n: usize, z: f64| {
        let [x, y] = section[n % 6];
        [x, y, z]
    };
    let mut facets = Vec::new();
    for n in 0..6 {
        let [a, b, c, d] = [at(n, -0.5), at(n + 1, -0.5), at(n + 1, 0.5), at(n, 0.5)];
        facets.extend([[a, b, c], [a, c, d]]);
    }
    for n in 1..5 {
        facets.push([at(0, 0.5), at(n, 0.5), at(n + 1, 0.5)]);
        facets.push([at(0, -0.5), at(n + 1, -0.5), at(n, -0.5)]);
    }
    let mut text = String::from("solid slab\n");
    for facet in facets {
        text += "facet normal 0 0 0\nouter loop\n";
        for [x, y, z] in facet {
            // Writing to a string cannot fail.
            let _ = writeln!(text, "vertex {x} {y} {z}");
        }
        text += "endloop\nendfacet\n";
    }
    text + "endsolid slab\n"
}

/// A mesh's normals lean where its facets are long, those of the smooth surface that it stands for.
#[test]
fn gas_on_both_sides_of_a_slab_of_long_facets_stays_apart() {
    let scene = "dimension = 3\nspacing = 0.04\nend_time = 0.25\n\
                 [free_stream]\nvelocity = [2.0, 0.0, 0.0]\ndensity = 1.4\npressure = 1.0\n\
                 [domain]\nmin = [-0.2, -0.4, 0.0]\nmax = [1.2, 0.32, 0.16]\n\
                 [domain.sides]\nx_min = \"inlet\"\nx_max = \"outlet\"\ny_min = \"free-stream\"\ny_max = \"free-stream\"\n\
                 z_min = \"symmetry\"\nz_max = \"symmetry\"\n\
                 [[body]]\nname = \"slab\"\nshape = { stl = { file = \"slab.stl\" } }\n\
                 place = { rotate = { axis = [0.0, 0.0, 1.0], angle = -5.0 } }\nreference_area = 0.16\n";
    for spacings in [0.3, 1.0] {
        let place = Workplace::new();
        place.write("slab.stl", slab(0.04 * spacings));
        place.run(scene, &[]).succeeds();
        let summary = place.json("results/summary.json");
        let returned = summary["returned"].as_u64().unwrap();
        let lift = summary["bodies"]["slab"]["cl"].as_f64().unwrap();
        println!("{spacings}: {returned}, {lift}");
        assert_eq!(summary["leaked"], 0);
        assert!(returned <= 40, "{spacings}: {returned}");
        assert!(lift > 0.15, "{spacings}: {lift}");
    }
}

/// A pocket of half a spacing between four plates, about points that stay: none of them is in it.
const POCKET: &str = r#"
dimension = 2
spacing = 0.1
end_time = 0.02

[scheme]
motion = "fixed"

[free_stream]
mach = 2.0
density = 1.0
pressure = 0.7142857142857143

[domain]
min = [-1.0, -1.0]
max = [2.0, 1.0]

[domain.sides]
x_min = "inlet"
x_max = "outlet"
y_min = "free-stream"
y_max = "free-stream"
"#;

#[test]
fn gas_in_a_pocket_without_a_point_is_told() {
    let plate = |name: &str, [x, y]: [f64; 2], [width, height]: [f64; 2]| {
        let (right, top) = (x + width, y + height);
        format!(
            "[[body]]\nname = \"{name}\"\nshape = {{ polygon = {{ points = [[{x}, {y}], [{right}, {y}], [{right}, {top}], [{x}, {top}]] }} }}\n"
        )
    };
    // Around a square of this size at this place.
    let pocket = |size: f64| {
        let [x, y] = [0.31, 0.013];
        let (thick, over) = (0.03, 0.001);
        [
            plate("west", [x - thick, y - thick], [thick, size + 2.0 * thick]),
            plate("east", [x + size, y - thick], [thick, size + 2.0 * thick]),
            plate("south", [x - over, y - thick], [size + 2.0 * over, thick]),
            plate("north", [x - over, y + size], [size + 2.0 * over, thick]),
        ]
        .concat()
    };
    let place = Workplace::new();
    for (size, is_told) in [(0.06, true), (0.12, false)] {
        let answer = place.run(&[POCKET, &pocket(size)].concat(), &[]);
        answer.succeeds();
        let summary = place.json("results/summary.json");
        let warnings = summary["warnings"].to_string();
        assert_eq!(summary["leaked"].as_u64() > Some(0), is_told, "{size}");
        assert_eq!(warnings.contains("is left out"), is_told, "{warnings}");
        let said = [answer.out, answer.err].concat();
        assert_eq!(said.contains("is left out"), is_told, "{said}");
    }
}
