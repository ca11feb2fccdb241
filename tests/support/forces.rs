//! Forces in the summary against what surfaces show, of one body in a stream.

use super::{Workplace, read_surface};

/// A body in a stream at Mach 2, on its own.
pub fn scene(dimension: usize, spacing: f64, shape: &str, more: &str) -> String {
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
pub fn difference(scene: &str, motion: &str) -> f64 {
    let (shown, force) = shown_and_force(scene, motion);
    let size = force.iter().map(|f| f * f).sum::<f64>().sqrt();
    let error = (0..3)
        .map(|k| (shown[k] - force[k]).powi(2))
        .sum::<f64>()
        .sqrt();
    100.0 * error / size
}

/// The same of the part along x, which no symmetry cancels.
pub fn along(scene: &str, motion: &str) -> f64 {
    let (shown, force) = shown_and_force(scene, motion);
    100.0 * (shown[0] - force[0]).abs() / force[0].abs()
}

/// Of gauge pressure: the integral over the last surface of the first body, and the force in the summary.
pub fn shown_and_force(scene: &str, motion: &str) -> ([f64; 3], [f64; 3]) {
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

/// Settings of a command.
pub const MOVING: &str = "scheme.motion=with-the-gas";
/// As [`MOVING`].
pub const FIXED: &str = "scheme.motion=fixed";

/// Drag of the body over the dynamic pressure, the mean over the last of the run.
pub fn mean_drag(scene: &str) -> f64 {
    let place = Workplace::new();
    place.run(scene, &["--set", MOVING]).succeeds();
    let body = &place.json("results/summary.json")["bodies"]["body"];
    let [coefficient, area] = ["cd_mean", "reference_area"].map(|key| body[key].as_f64());
    coefficient.unwrap() * area.unwrap()
}
