//! Forces are the integral of what `surface-*.vtp` shows, for particles and for points that stay.

use crate::support::forces::{FIXED, MOVING, difference, scene};
use crate::support::{Workplace, read_surface};

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
            let short = scene(3, 0.1, shape, "").replace("end_time = 0.2", "end_time = 0.1");
            let found = difference(&short, motion);
            assert!(found < slack, "{shape}, {motion}: {found} %");
        }
    }
}
