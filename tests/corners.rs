//! Gas at rest shows its own pressure in corners between walls, whatever the angle and however it is laid there.

use crate::support::{PRESSURE_RATIO, Workplace, read_surface};

/// Largest error of the pressure on the panels whose middles `is_judged`, with how many there are.
fn error(scene: &str, is_judged: impl Fn([f64; 3]) -> bool) -> (f64, usize) {
    let place = Workplace::new();
    place.run(scene, &[]).succeeds();
    let surface = read_surface(&place.path("results/surface-000000.vtp"));
    let (mut largest, mut count) = (0.0_f64, 0);
    for (corners, pressure) in surface.cells.iter().zip(&surface.arrays["pressure"]) {
        let number = corners.len() as f64;
        let middle = std::array::from_fn(|k| corners.iter().map(|c| c[k]).sum::<f64>() / number);
        // Nothing presses what another solid covers.
        if is_judged(middle) && *pressure != 0.0 {
            count += 1;
            largest = largest.max((pressure - 1.0).abs());
        }
    }
    (largest, count)
}

/// Gas at rest around one body, in a box of walls of ten spacings to the metre.
fn at_rest<const D: usize>([min, max]: [[f64; D]; 2], body: &str) -> String {
    let sides = |axis: &&str| format!("{axis}_min = \"wall\"\n{axis}_max = \"wall\"\n");
    let sides: String = ["x", "y", "z"][..D].iter().map(sides).collect();
    let still = [0.0; D];
    format!(
        r#"
dimension = {D}
spacing = 0.1
end_time = 0.001

[free_stream]
density = 1.4
pressure = 1.0
velocity = {still:?}

[domain]
min = {min:?}
max = {max:?}

[domain.sides]
{sides}
[[body]]
name = "body"
{body}

[output]
frames = 1
"#
    )
}

/// A solid whose face rises from a floor at (1.5, 0), with gas between both.
fn overhang(angle: f64) -> String {
    let top = 1.5 - 1.0 / angle.to_radians().tan();
    let end = 3.0_f64.max(top + 1.4);
    let points = [[1.5, 0.0], [end, 0.0], [end, 1.0], [top, 1.0]];
    at_rest(
        [[-1.0, 0.0], [4.5, 2.0]],
        &format!("shape = {{ polygon = {{ points = {points:?} }} }}"),
    )
}

#[test]
fn gas_at_rest_shows_its_pressure_in_corners_of_any_angle() {
    for angle in [30.0, 45.0, 60.0, 90.0, 120.0, 135.0] {
        let near = |at: [f64; 3]| (at[0] - 1.5).hypot(at[1]) < 0.12;
        let (error, count) = error(&overhang(angle), near);
        println!("{angle}: {error} on {count}");
        assert!(count >= 2, "{angle} degrees: {count} panels");
        assert!(error < 0.005, "{angle} degrees: {error}");
    }
}

#[test]
fn gas_at_rest_shows_its_pressure_at_the_foot_of_a_box_in_space() {
    let scene = at_rest(
        [[0.0; 3], [2.0, 2.0, 1.4]],
        "shape = { cuboid = { edges = [0.8, 0.8, 0.6] } }\nplace = { translate = [1.0, 1.0, 0.3] }",
    );
    // Distance from the box's sides.
    let out = |at: [f64; 3]| (at[0] - 1.0).abs().max((at[1] - 1.0).abs()) - 0.4;
    let (largest, count) = error(&scene, |at| {
        at[2] < 0.12 && out(at) > -1e-9 && out(at) < 0.12
    });
    println!("{largest} on {count}");
    assert!(count > 100, "{count} panels");
    assert!(largest < 0.005, "{largest}");
}

/// A plate one spacing thick, its middle on sites of the gas's lattice: gas on one side of it does not see the other side, gas beyond its
/// rim sees both.
#[test]
fn gas_at_rest_shows_its_pressure_up_to_the_rim_of_a_thin_plate_in_space() {
    let scene = at_rest(
        [[0.0; 3], [2.4, 2.5, 2.4]],
        "shape = { cuboid = { edges = [0.8, 0.1, 0.8] } }\nplace = { translate = [1.2, 1.25, 1.2] }",
    );
    let (largest, count) = error(&scene, |at| (at[1] - 1.25).abs() < 0.06);
    println!("{largest} on {count}");
    assert!(count > 100, "{count} panels");
    assert!(largest < 0.05, "{largest}");
}

/// Where a shock stands in a corner, the mean of the gas before it is of both sides of the shock: the first panels behind the corner showed half of
/// what gas presses with there, and the surface 2 % less than the load.
#[test]
fn a_corner_with_a_shock_in_it_shows_what_gas_presses_with() {
    const SPACING: f64 = 0.125;
    let scene = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("cases/wedge.toml");
    let scene = std::fs::read_to_string(scene).expect("the scene");
    let place = Workplace::new();
    let settings = [
        &format!("spacing={SPACING}"),
        "end_time=6.0",
        "output.frames=1",
        "output.compress=false",
    ];
    let settings = settings.map(|setting| ["--set", setting]).concat();
    place.run(&scene, &settings).succeeds();
    let surface = read_surface(&place.path("results/surface-000001.vtp"));
    let (pressure, area) = (&surface.arrays["pressure"], &surface.arrays["area"]);
    let (normal, friction) = (&surface.arrays["normal"], &surface.arrays["friction"]);
    let (mut shown, mut first) = ([0.0; 2], Vec::new());
    let stream = 1.0 / 1.4;
    for (n, corners) in surface.cells.iter().enumerate() {
        let push = (pressure[n] - stream) * area[n];
        for (k, sum) in shown.iter_mut().enumerate() {
            *sum += friction[3 * n + k] * area[n] - push * normal[3 * n + k];
        }
        let along = 0.5 * (corners[0][0] + corners[1][0]) / SPACING;
        if (0.0..3.0).contains(&along) {
            first.push(pressure[n] / (stream * PRESSURE_RATIO) - 1.0);
        }
    }
    assert!(first.len() > 2);
    assert!(first.iter().all(|off| off.abs() < 0.12), "{first:?}");
    let summary = place.json("results/summary.json");
    let load = &summary["bodies"]["ramp"]["force_gauge"];
    for (k, shown) in shown.iter().enumerate() {
        let off = shown / load[k].as_f64().expect("a force") - 1.0;
        assert!(off.abs() < 0.015, "{k}: {off}");
    }
}
