//! Forces are the integral of what `surface-*.vtp` shows, for particles and for points that stay.

use crate::support::{Workplace, read_surface};

/// A body in a stream at Mach 2, on its own.
fn scene(dimension: usize, spacing: f64, shape: &str, more: &str) -> String {
    let list = |x: f64, others: f64| {
        let all = [x, others, others];
        format!("{:?}", &all[..dimension])
    };
    let open = |axis: &&str| format!("{axis}_min = \"free-stream\"\n{axis}_max = \"free-stream\"");
    let mut sides = vec!["x_min = \"inlet\"\nx_max = \"outlet\"".to_owned()];
    sides.extend(["y", "z"][..dimension - 1].iter().map(open));
    let sides = sides.join("\n");
    format!(
        r#"
dimension = {dimension}
spacing = {spacing}
end_time = 0.2

[free_stream]
mach = 2.0
density = 1.4
pressure = 1.0
{more}

[domain]
min = {}
max = {}

[domain.sides]
{sides}

[[body]]
name = "body"
shape = {{ {shape} }}

[output]
frames = 1
"#,
        list(-1.2, -1.0),
        list(1.4, 1.0)
    )
}

/// How far the integral over the last surface is from the force in the summary, per cent of the force.
fn difference(scene: &str, motion: &str) -> f64 {
    let (shown, force) = shown_and_force(scene, motion);
    let size = force.iter().map(|f| f * f).sum::<f64>().sqrt();
    let error = (0..3)
        .map(|k| (shown[k] - force[k]).powi(2))
        .sum::<f64>()
        .sqrt();
    100.0 * error / size
}

/// The same of the part along x, which no symmetry cancels.
fn along(scene: &str, motion: &str) -> f64 {
    let (shown, force) = shown_and_force(scene, motion);
    100.0 * (shown[0] - force[0]).abs() / force[0].abs()
}

/// Of gauge pressure: the integral over the last surface of the first body, and the force in the summary.
fn shown_and_force(scene: &str, motion: &str) -> ([f64; 3], [f64; 3]) {
    let place = Workplace::new();
    let settings = ["--set", motion];
    place.run(scene, &settings).succeeds();
    let surface = read_surface(&place.path("results/surface-000001.vtp"));
    let array = |name: &str| &surface.arrays[name];
    let (pressure, normal, friction) = (array("pressure"), array("normal"), array("friction"));
    let mut shown = [0.0; 3];
    let of_first = |n: &usize| surface.arrays["body"][*n] == 0.0;
    for (n, corners) in surface
        .cells
        .iter()
        .enumerate()
        .filter(|(n, _)| of_first(n))
    {
        let area = match corners[..] {
            [a, b] => (0..3).map(|k| (a[k] - b[k]).powi(2)).sum::<f64>().sqrt(),
            [a, b, c] => {
                let [u, v]: [[f64; 3]; 2] = [b, c].map(|p| std::array::from_fn(|k| p[k] - a[k]));
                let cross = |i: usize, j: usize| u[i] * v[j] - u[j] * v[i];
                0.5 * (cross(1, 2).powi(2) + cross(2, 0).powi(2) + cross(0, 1).powi(2)).sqrt()
            }
            _ => panic!("neither a segment nor a triangle"),
        };
        let own = surface.arrays["area"][n];
        assert!(scene.contains("axis") || (area - own).abs() < 1e-9 * area.max(1e-9));
        // Of a ring about the axis it is that all around.
        let area = own;
        for k in 0..3 {
            // The stream's pressure is one.
            let over = pressure[n] - 1.0;
            shown[k] += (friction[3 * n + k] - over * normal[3 * n + k]) * area;
        }
    }
    let force = &place.json("results/summary.json")["bodies"]["body"]["force_gauge"];
    (shown, std::array::from_fn(|k| force[k].as_f64().unwrap()))
}

const MOVING: &str = "scheme.motion=with-the-gas";
const FIXED: &str = "scheme.motion=fixed";

#[test]
fn the_force_on_an_aerofoil_is_the_integral_of_its_surface() {
    let wing = scene(
        2,
        0.025,
        "biconvex = { chord = 1.0, thickness_ratio = 0.1 }",
        "incidence = 4.0",
    );
    for (motion, slack) in [(MOVING, 1.0), (FIXED, 1e-6)] {
        let found = difference(&wing, motion);
        assert!(found < slack, "{motion}: {found} %");
    }
}

#[test]
fn the_force_on_a_block_is_the_integral_of_its_surface() {
    let block = scene(2, 0.05, "rectangle = { width = 0.6, height = 0.5 }", "");
    for (motion, slack) in [(MOVING, 1.0), (FIXED, 1e-6)] {
        let found = difference(&block, motion);
        assert!(found < slack, "{motion}: {found} %");
    }
}

/// The floor before a step lies on the side that the step closes, and rounding may put the feet of its ghosts beyond.
#[test]
fn the_force_on_a_floor_along_a_side_is_the_integral_of_its_surface() {
    let step = scene(2, 0.03, "forward_step = { foot = 0.2, height = 0.3 }", "");
    let step = step
        .replace("min = [-1.2, -1.0]", "min = [-1.2, 0.0]")
        .replace("y_min = \"free-stream\"", "y_min = \"body\"");
    // Beside the step's foot particles show the mean pressure of the gas there.
    for (motion, allowed) in [(MOVING, 4.0), (FIXED, 1e-6)] {
        let found = difference(&step, motion);
        assert!(found < allowed, "{motion}: {found} %");
    }
}

/// Their kernels reach over a round wall's horizon, and press it with up to a tenth more than the pressure here.
#[test]
fn gas_at_rest_shows_its_own_pressure_on_round_bodies() {
    let bodies = [
        (2, 0.05, "circle = { radius = 0.3 }"),
        (3, 1.0 / 15.0, "sphere = { radius = 0.4 }"),
    ];
    for (dimension, spacing, shape) in bodies {
        let place = Workplace::new();
        let still = format!("velocity = {:?}", &[0.0; 3][..dimension]);
        let scene = scene(dimension, spacing, shape, "")
            .replace("mach = 2.0", &still)
            .replace("end_time = 0.2", "end_time = 1e-4")
            .replace("\n[output]", "packed_fluid = true\n\n[output]");
        let closed = ["inlet", "outlet", "free-stream"].map(|side| format!("\"{side}\""));
        let scene = closed
            .iter()
            .fold(scene, |scene, side| scene.replace(side, "\"wall\""));
        place.run(&scene, &["--set", MOVING]).succeeds();
        let surface = read_surface(&place.path("results/surface-000000.vtp"));
        let body = surface.arrays["body"]
            .iter()
            .zip(&surface.arrays["pressure"]);
        let pressures: Vec<f64> = body.filter(|(b, _)| **b == 0.0).map(|(_, p)| *p).collect();
        assert!(pressures.len() > 20);
        for pressure in pressures {
            assert!((pressure - 1.0).abs() < 0.02, "{shape}: {pressure}");
        }
    }
}

#[test]
fn symmetric_bodies_in_a_stream_along_them_have_no_lift() {
    let shapes = [
        (
            2,
            0.025,
            "biconvex = { chord = 1.0, thickness_ratio = 0.1 }",
        ),
        (
            2,
            0.025,
            "polygon = { points = [[0.0, 0.0], [0.5, -0.05], [1.0, 0.0], [0.5, 0.05]] }",
        ),
        (3, 0.1, "sphere = { radius = 0.35 }"),
    ];
    // Particles lie beside the plane of a body wherever that is; points stay on their lattice.
    let between = [0.0; 3];
    let flows = [
        (MOVING, between),
        (MOVING, [0.0, 0.36, 0.79]),
        (FIXED, between),
    ];
    for (dimension, spacing, shape) in shapes {
        for (motion, steps) in flows {
            let place = Workplace::new();
            let off = &steps.map(|step| step * spacing)[..dimension];
            let scene = scene(dimension, spacing, shape, "").replace(
                "\n[output]",
                &format!("place = {{ translate = {off:?} }}\n\n[output]"),
            );
            place.run(&scene, &["--set", motion]).succeeds();
            let force = &place.json("results/summary.json")["bodies"]["body"]["force_gauge"];
            let force: [f64; 3] = std::array::from_fn(|k| force[k].as_f64().unwrap());
            let lift = force[1].hypot(force[2]) / force[0];
            assert!(
                lift < 1e-3,
                "{shape}, {motion}, off by {off:?}: {lift} of the drag"
            );
        }
    }
}

/// A pyramid of `sides` sides around a cone of 15 degrees, 1.3 long, each side in `rings` pieces from tip to base.
fn pyramid(sides: usize, rings: usize) -> String {
    let radius = 1.3 * 15_f64.to_radians().tan();
    let place = |ring: usize, side: usize| {
        let part = ring as f64 / rings as f64;
        let (sin, cos) = (std::f64::consts::TAU * (side % sides) as f64 / sides as f64).sin_cos();
        [1.3 * part, radius * part * cos, radius * part * sin]
    };
    let mut facets = Vec::new();
    for side in 0..sides {
        facets.push([[0.0; 3], place(1, side + 1), place(1, side)]);
        for ring in 1..rings {
            let [a, b] = [place(ring, side), place(ring, side + 1)];
            let [c, d] = [place(ring + 1, side + 1), place(ring + 1, side)];
            facets.extend([[a, b, c], [a, c, d]]);
        }
        facets.push([[1.3, 0.0, 0.0], place(rings, side), place(rings, side + 1)]);
    }
    let corner = |[x, y, z]: [f64; 3]| format!("vertex {x} {y} {z}\n");
    let text = facets.iter().map(|facet| {
        let corners: String = facet.iter().map(|&place| corner(place)).collect();
        format!("facet normal 0 0 0\nouter loop\n{corners}endloop\nendfacet\n")
    });
    format!("solid cone\n{}endsolid cone\n", text.collect::<String>())
}

/// Pressure coefficient of a cone of 14.877 degrees at Mach 3, the angle of the sides of a pyramid of 24 in one of 15 degrees
/// [Taylor & Maccoll 1933, Proc. R. Soc. A 139, 278; integrated], by its section where the domain ends.
const FOREBODY: f64 = 0.170_697 * 0.222_988;

#[test]
fn facets_from_tip_to_base_have_the_drag_of_the_cone_that_they_stand_for() {
    let scene = scene(3, 0.1, "stl = { file = \"cone.stl\" }", "")
        .replace("mach = 2.0", "mach = 3.0")
        .replace("end_time = 0.2", "stop = \"steady\"")
        .replace("min = [-1.2, -1.0, -1.0]", "min = [-0.15, 0.0, 0.0]")
        .replace("max = [1.4, 1.0, 1.0]", "max = [1.0, 0.6, 0.6]")
        .replace("y_min = \"free-stream\"", "y_min = \"symmetry\"")
        .replace("z_min = \"free-stream\"", "z_min = \"symmetry\"");
    for rings in [1, 40] {
        let place = Workplace::new();
        place.write("cone.stl", pyramid(24, rings));
        let settings = ["--set", FIXED, "--set", "scheme.refine=2"];
        let answer = place.run(&scene, &settings);
        answer.succeeds();
        let body = &place.json("results/summary.json")["bodies"]["body"];
        let force = body["force_gauge"][0].as_f64().unwrap();
        // The domain cuts the body: what the stream's pressure does to the cut is no load, and is not shown as one.
        assert!(
            answer.out.contains(&format!("`body`: force {force:.4e} ")),
            "{}",
            answer.out
        );
        let drag = force / (0.5 * 1.4 * 9.0);
        let off = drag / FOREBODY - 1.0;
        assert!(off.abs() < 0.03, "{rings} rings: {off} off");
    }
}

/// Pressure coefficient of a wedge of 20 degrees at Mach 3 [NACA Report 1135 (1953), eqs 128 and 150], by its section of two slopes
/// where the domain ends.
const WEDGE: f64 = 0.439_90 * 2.0 * 0.363_970;

/// A wedge of 20 degrees at Mach 3, `length` long, whole and by halves.
fn wedges(spacing: f64, length: f64) -> [String; 2] {
    let height = 0.363_970 * length;
    let points = format!(
        "[[0.0, 0.0], [{length}, {}], [{length}, {height}]]",
        -height
    );
    let whole = scene(
        2,
        spacing,
        &format!("polygon = {{ points = {points} }}"),
        "",
    )
    .replace("mach = 2.0", "mach = 3.0")
    .replace("end_time = 0.2", "end_time = 1.2")
    .replace("min = [-1.2, -1.0]", "min = [-0.4, -1.0]")
    .replace("max = [1.4, 1.0]", "max = [1.0, 1.0]");
    let half = whole
        .replace("min = [-0.4, -1.0]", "min = [-0.4, 0.0]")
        .replace("y_min = \"free-stream\"", "y_min = \"symmetry\"");
    [whole, half]
}

/// Drag of the body over the dynamic pressure, the mean over the last of the run.
fn mean_drag(scene: &str) -> f64 {
    let place = Workplace::new();
    place.run(scene, &["--set", MOVING]).succeeds();
    let body = &place.json("results/summary.json")["bodies"]["body"];
    let [coefficient, area] = ["cd_mean", "reference_area"].map(|key| body[key].as_f64());
    coefficient.unwrap() * area.unwrap()
}

#[test]
fn a_wedge_that_an_outlet_cuts_has_the_drag_of_its_pressure_whole_or_by_halves() {
    for scene in wedges(0.05, 1.5) {
        let off = mean_drag(&scene) / WEDGE - 1.0;
        assert!(off.abs() < 0.025, "{off} off");
    }
}

#[test]
fn a_body_has_twice_the_drag_of_its_half() {
    // Some of its ghosts stand on the plane of symmetry and face beyond it.
    let [whole, half] = wedges(0.054, 0.8).map(|scene| mean_drag(&scene));
    let off = half / whole - 1.0;
    assert!(off.abs() < 0.01, "{off} off");
}

/// Ten spacings wide, its shoulder half a spacing round.
const CAPSULE: &str = "capsule = { radius = 0.489, length = 0.858, shield_radius = 1.173, apex_radius = 0.058, shoulder_radius = 0.049 }";

/// Gas that thins out around the shoulder lends the ghosts there a longer reach than the particles ahead have.
#[test]
fn what_ghosts_press_from_afar_is_shown() {
    let fast = scene(3, 0.1, CAPSULE, "").replace("mach = 2.0", "mach = 4.0");
    let found = difference(&fast.replace("end_time = 0.2", "end_time = 0.1"), MOVING);
    assert!(found < 0.01, "{found} %");
}

#[test]
fn the_force_on_bodies_in_space_is_the_integral_of_their_surfaces() {
    let shapes = [
        "cuboid = { edges = [0.6, 0.5, 0.5] }",
        "cone = { half_angle = 20.0, length = 0.8 }",
        "tessellated = { body = { sphere = { radius = 0.35 } }, around = 32 }",
        CAPSULE,
    ];
    for shape in shapes {
        for (motion, slack) in [(MOVING, 1.0), (FIXED, 1e-6)] {
            let found = difference(&scene(3, 0.1, shape, ""), motion);
            assert!(found < slack, "{shape}, {motion}: {found} %");
        }
    }
}

/// Nothing presses the foot of what stands on another solid, and where they are flush their surface is one.
#[test]
fn the_force_on_what_stands_on_another_solid_is_the_integral_of_its_surface() {
    let [upper, lower] = [0.55, 0.05].map(|height| {
        let block = scene(2, 0.05, "rectangle = { width = 0.63, height = 0.5 }", "");
        let block = block.replace("min = [-1.2, -1.0]", "min = [-1.2, -0.2]");
        let place = format!("}} }}\nplace = {{ translate = [0.0, {height}] }}");
        let block = block.replacen("} }", &place, 1);
        let on_the_floor = block.replace("y_min = \"free-stream\"", "y_min = \"wall\"");
        on_the_floor.replace("mach = 2.0", "mach = 0.5")
    });
    let below = "[[body]]\nname = \"below\"\nshape = { rectangle = { width = 1.4, height = 0.5 } }\n\
                 place = { translate = [0.0, 0.05] }\n[output]";
    let stacked = upper.replace("[output]", below);
    for scene in [&lower, &stacked] {
        for motion in [MOVING, FIXED] {
            let found = difference(scene, motion);
            assert!(found < 0.01, "{motion}: {found} %: {scene}");
        }
    }
    // Fins through a tube end where it does.
    let tube = "profile = { points = [[-0.9, 0.0], [-0.3, 0.25], [0.3, 0.25], [0.3, 0.0]] }";
    let fins =
        "[[body]]\nname = \"fins\"\nshape = { cuboid = { edges = [0.6, 0.07, 1.3] } }\n[output]";
    let tail = scene(3, 0.1, tube, "").replace("[output]", fins);
    let found = difference(&tail, FIXED);
    assert!(found < 1e-6, "{found} %");
    // Less than a fiftieth of it is spread as friction.
    let place = Workplace::new();
    let answer = place.run(&tail, &["--set", FIXED]);
    answer.succeeds();
    let told = answer.out.contains("`body`: its force is");
    assert!(!told, "{}", answer.out);
}

/// The rest of a wedge is beyond the outlet, of a half and of a meridian plane behind the mirror and around the axis.
#[test]
fn the_force_on_what_sides_cut_is_the_integral_of_its_surface() {
    const WORDS: &str = "than the integral of what its surface shows";
    let above = |scene: &str, side: &str| {
        scene
            .replace("min = [-1.2, -1.0]", "min = [-1.2, 0.0]")
            .replace("y_min = \"free-stream\"", &format!("y_min = {side:?}"))
    };
    let [wedge, _] = wedges(0.1, 2.0);
    let cone = scene(3, 0.1, "cone = { half_angle = 20.0, length = 2.8 }", "");
    let block = scene(2, 0.05, "rectangle = { width = 0.6, height = 0.5 }", "");
    let ball = scene(2, 0.1, "circle = { radius = 0.3 }", "");
    let place = Workplace::new();
    for scene in [&wedge, &cone, &above(&block, "axis"), &above(&ball, "axis")] {
        for motion in [MOVING, FIXED] {
            let found = along(scene, motion);
            assert!(found < 1e-6, "{motion}: {found} %: {scene}");
        }
    }
    // What is spread of it is told where it is much, as on a cone of a few cells, and nothing else.
    let run = |scene: &str, motion: &str| {
        let answer = place.run(scene, &["--set", motion]);
        answer.succeeds();
        let summary = place.json("results/summary.json");
        let told = summary["warnings"].as_array().expect("a list").clone();
        let told = told
            .iter()
            .any(|w| w.as_str().is_some_and(|w| w.contains(WORDS)));
        assert_eq!(told, answer.out.contains(WORDS), "{}", answer.out);
        told
    };
    assert!(run(&cone, MOVING));
    for scene in [&block, &above(&block, "symmetry")] {
        for motion in [MOVING, FIXED] {
            assert!(!run(scene, motion), "{motion}: {scene}");
        }
    }
    // Gas at rest presses it with nothing but what is rounded.
    let closed = block.replace("mach = 2.0", "mach = 0.0").replace(
        "x_min = \"inlet\"\nx_max = \"outlet\"",
        "x_min = \"wall\"\nx_max = \"wall\"",
    );
    let standing = closed
        .replace("min = [-1.2, -1.0]", "min = [-1.2, -0.25]")
        .replace("y_min = \"free-stream\"", "y_min = \"wall\"");
    for scene in [&closed, &standing] {
        for motion in [MOVING, FIXED] {
            assert!(!run(scene, motion), "{motion}: {scene}");
        }
    }
}
