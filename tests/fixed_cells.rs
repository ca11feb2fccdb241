//! Cells and surfaces of points that stay, as files show them.

use std::path::Path;

use crate::support::{
    PRESSURE_RATIO, Workplace, appended, ascii_stl, box_with, fixed_wedge, read_vtp,
};

/// Sides of a hexahedron as VTK counts its corners, seen from without.
const SIDES: [[usize; 4]; 6] = [
    [0, 3, 2, 1],
    [4, 5, 6, 7],
    [0, 1, 5, 4],
    [1, 2, 6, 5],
    [2, 3, 7, 6],
    [3, 0, 4, 7],
];

/// Volume of each cell in a file, from its corners, and the number of its point.
fn cells(path: &Path) -> Vec<(f64, u64)> {
    let array = |name: &str| appended(path, name).unwrap_or_default();
    let whole = |name: &str| -> Vec<usize> { array(name).iter().map(|&x| x as usize).collect() };
    let points = array("Points");
    let corner = |n: usize| -> [f64; 3] { std::array::from_fn(|k| points[3 * n + k]) };
    // Six times the volume of a tetrahedron with the origin.
    let six = |[a, b, c]: [[f64; 3]; 3]| -> f64 {
        let cross = |i: usize| b[(i + 1) % 3] * c[(i + 2) % 3] - b[(i + 2) % 3] * c[(i + 1) % 3];
        (0..3).map(|i| a[i] * cross(i)).sum()
    };
    let ring = |ring: &[usize], lift: f64| -> f64 {
        let at = |n: usize| {
            let [x, y, z] = corner(n);
            [x, y, z + lift]
        };
        let fans = ring[1..].windows(2);
        fans.map(|pair| six([at(ring[0]), at(pair[0]), at(pair[1])]) / 6.0)
            .sum()
    };
    let (connectivity, faces) = (whole("connectivity"), whole("faces"));
    let (mut from, mut face) = (0, 0);
    let offsets = whole("offsets");
    let kinds = array("types");
    let each = offsets.iter().zip(&kinds).map(|(&to, &kind)| {
        let corners = &connectivity[from..to];
        from = to;
        match kind as u8 {
            // At height one the pyramid over a polygon holds a third of its area.
            7 | 9 => 3.0 * ring(corners, 1.0),
            12 => SIDES
                .iter()
                .map(|side| ring(&side.map(|k| corners[k]), 0.0))
                .sum(),
            _ => {
                let count = faces[face];
                face += 1;
                let mut volume = 0.0;
                for _ in 0..count {
                    let end = face + 1 + faces[face];
                    volume += ring(&faces[face + 1..end], 0.0);
                    face = end;
                }
                volume
            }
        }
    });
    let volumes: Vec<f64> = each.collect();
    let ids = array("id").into_iter().map(|id| id as u64);
    volumes.into_iter().zip(ids).collect()
}

#[test]
fn cells_are_those_of_the_points_and_fill_the_domain_less_the_bodies() {
    let place = Workplace::new();
    let settings = ["spacing=0.25", "scheme.refine=1", "output.cells=true"];
    let settings: Vec<&str> = settings.iter().flat_map(|s| ["--set", *s]).collect();
    place.run(&fixed_wedge(), &settings).succeeds();
    let frame = place.path("results/frame-000001.vtp");
    let file = place.path("results/cells-000001.vtu");
    let (count, _) = read_vtp(&frame);
    let ramp = 0.5 * 3.0 * 3.0 * 20.0_f64.to_radians().tan();
    let check = |file: &Path, count: usize, exact: f64, within: f64| {
        let cells = cells(file);
        let ids: std::collections::BTreeSet<u64> = cells.iter().map(|cell| cell.1).collect();
        assert_eq!((cells.len(), ids.len()), (count, count));
        let said = appended(file, "volume").expect("volumes");
        for ((volume, id), said) in cells.iter().zip(&said) {
            assert!((volume / said - 1.0).abs() < 1e-6, "{id}: {volume} {said}");
        }
        let sum: f64 = cells.iter().map(|cell| cell.0).sum();
        assert!((sum / exact - 1.0).abs() < within, "{sum} {exact}");
    };
    check(&file, count, 12.0 - ramp, 1e-9);
    let pressure = appended(&file, "pressure").expect("pressures");
    let highest = pressure.iter().copied().fold(0.0, f64::max) * 1.4;
    assert!((highest / PRESSURE_RATIO - 1.0).abs() < 0.05, "{highest}");
    assert_eq!(appended(&file, "gamma"), Some(vec![1.4]));
    assert_eq!(appended(&file, "temperature"), None);

    let space = BOX_IN_SPACE;
    place.run(space, &[]).succeeds();
    let (count, _) = read_vtp(&place.path("results/frame-000001.vtp"));
    let file = place.path("results/cells-000001.vtu");
    // Corners of the block are met to a thousandth of a cell.
    check(&file, count, 1.0 - 0.3 * 0.4 * 0.2, 1e-5);
    let temperature = appended(&file, "temperature").expect("temperatures");
    assert!(temperature.iter().any(|t| (t - 300.0).abs() < 1.0));

    let particles = box_with("frames = 2", "frames = 2\ncells = true");
    place
        .run(&particles, &[])
        .refuses(&["output.cells", "motion = \"fixed\""]);
}

/// A block in a stream of known temperature.
const BOX_IN_SPACE: &str = r#"
dimension = 3
spacing = 0.1
end_time = 1e-4

[scheme]
motion = "fixed"

[free_stream]
mach = 2.0
pressure = 1e5
temperature = 300.0

[domain]
min = [0.0, 0.0, 0.0]
max = [1.0, 1.0, 1.0]

[domain.sides]
x_min = "inlet"
x_max = "outlet"
y_min = "symmetry"
y_max = "symmetry"
z_min = "symmetry"
z_max = "symmetry"

[[body]]
name = "block"
shape = { cuboid = { edges = [0.3, 0.4, 0.2] } }
place = { translate = [0.5, 0.48, 0.52] }

[output]
frames = 1
cells = true
"#;

/// A wedge whose edge runs along edges of cells: they are left slivers of wall, and its surface is shown at once all the same.
#[test]
fn a_body_whose_edge_runs_along_the_edges_of_cells_is_shown_at_once() {
    let dx = 1.0 / 60.0;
    let [front, back] = [-1.0, 1.0].map(|z| [[0.0, 0.0, z], [0.12, -dx, z], [0.12, dx, z]]);
    let mut facets = vec![[front[0], front[2], front[1]], back];
    for (i, j) in [(0, 1), (1, 2), (2, 0)] {
        facets.push([front[i], front[j], back[j]]);
        facets.push([front[i], back[j], back[i]]);
    }
    let place = Workplace::new();
    place.write("wedge.stl", ascii_stl("wedge", &facets));
    let scene = format!(
        r#"
dimension = 3
spacing = {dx}
end_time = 0.02

[scheme]
motion = "fixed"

[free_stream]
velocity = [2.0, 0.0, 0.0]
density = 1.0
pressure = 0.7142857142857143

[domain]
min = [-0.05, -0.1, -0.05]
max = [0.2, 0.1, 0.05]

[domain.sides]
x_min = "inlet"
x_max = "outlet"
y_min = "free-stream"
y_max = "free-stream"
z_min = "symmetry"
z_max = "symmetry"

[[body]]
name = "wedge"
shape = {{ stl = {{ file = "wedge.stl" }} }}
place = {{ rotate = {{ axis = [0.0, 0.0, 1.0], angle = -5.0 }} }}

[output]
frames = 1
"#
    );
    place.run(&scene, &[]).succeeds();
}
