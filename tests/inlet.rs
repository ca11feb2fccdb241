//! A wall that crosses an inlet lies where it likes, not where the lattice of the gas that enters has its rows.

use crate::support::{Surface, Workplace, read_surface};

/// Spacing of the scene.
const SPACING: f64 = 0.0625;

/// Free stream's pressure, `1 / gamma`.
const STREAM: f64 = 1.0 / 1.4;

/// Ratio of pressures across the shock of a corner of 20 degrees at Mach 2.5 [NACA report 1135, eqs. 128 and 150].
const BEHIND: f64 = 3.2109;

/// A compression corner, `off` spacings above the lower end of the inlet.
fn corner(motion: &str, off: f64) -> Surface {
    let stop = if motion == "fixed" {
        "stop = \"steady\""
    } else {
        ""
    };
    let scene = format!(
        r#"
dimension = 2
spacing = {SPACING}
end_time = 2.0
{stop}

[scheme]
motion = "{motion}"

[free_stream]
mach = 2.5
density = 1.0
pressure = {STREAM}

[domain]
min = [-1.0, 0.0]
max = [1.0, 1.5]

[domain.sides]
x_min = "inlet"
x_max = "outlet"
y_min = "body"
y_max = "free-stream"

[[body]]
name = "ramp"
shape = {{ compression_corner = {{ angle = 20.0, corner = [0.0, {}] }} }}

[output]
frames = 1
compress = false
"#,
        off * SPACING
    );
    let place = Workplace::new();
    place.run(&scene, &[]).succeeds();
    let mut names: Vec<_> = std::fs::read_dir(place.path("results"))
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.to_string_lossy().contains("surface-"))
        .collect();
    names.sort();
    read_surface(names.last().expect("a surface"))
}

/// Mean over area, and largest departure from one, of the pressure over `expected` between two places along x.
fn pressure(surface: &Surface, expected: f64, (from, to): (f64, f64)) -> (f64, f64) {
    let (mut sum, mut area, mut worst) = (0.0, 0.0, 0.0_f64);
    for (n, ends) in surface.cells.iter().enumerate() {
        let x = 0.5 * (ends[0][0] + ends[1][0]);
        if from < x && x < to {
            let ratio = surface.arrays["pressure"][n] / expected;
            sum += ratio * surface.arrays["area"][n];
            area += surface.arrays["area"][n];
            worst = worst.max((ratio - 1.0).abs());
        }
    }
    assert!(area > 0.0);
    (sum / area, worst)
}

fn a_wall_off_the_lattice_feels_the_stream(motion: &str) {
    let ahead = (-0.95, -0.25);
    let behind = (0.4, 0.8);
    let plateau = STREAM * BEHIND;
    let aligned = pressure(&corner(motion, 0.0), plateau, behind).0;
    for off in [0.2, 0.5, 0.8] {
        let surface = corner(motion, off);
        let (mean, worst) = pressure(&surface, STREAM, ahead);
        assert!(
            (mean - 1.0).abs() < 0.005 && worst < 0.025,
            "{motion}, {off} off: {mean} ahead of the corner, {worst} at worst"
        );
        let (mean, _) = pressure(&surface, plateau, behind);
        assert!(
            (mean - aligned).abs() < 0.005 && (mean - 1.0).abs() < 0.01,
            "{motion}, {off} off: {mean} behind the corner, {aligned} aligned"
        );
    }
}

#[test]
fn particles_that_enter_beside_a_wall_off_the_lattice_press_it_as_the_stream_does() {
    a_wall_off_the_lattice_feels_the_stream("with-the-gas");
}

#[test]
fn points_beside_a_wall_off_the_lattice_at_an_inlet_press_it_as_the_stream_does() {
    a_wall_off_the_lattice_feels_the_stream("fixed");
}
