//! Sheets made thick, and wraps around what is no solid.

use aero_geometry::bodies::sphere;
use aero_geometry::stl::{Facet, Soup};
use aero_geometry::{Mesh, Shape, Sheet, Watch};
use approx::assert_relative_eq;

use super::{at, block, flipped, refusal, shifted, unit_block};

fn soup(facets: Vec<Facet>) -> Soup {
    Soup {
        facets,
        solids: Vec::new(),
    }
}

fn wrapped(facets: Vec<Facet>, spacing: f64) -> Mesh {
    let made = Mesh::wrapped(&soup(facets), spacing, &Watch::default());
    made.unwrap_or_else(|error| panic!("{error}"))
}

fn square() -> Vec<Facet> {
    let [a, b, c, d] = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(|[x, y]| at(x, y, 0.0));
    vec![[a, b, c], [a, c, d]]
}

/// Terrain with a valley and hills.
fn terrain(count: i32) -> Vec<Facet> {
    let height = |x: f64, y: f64| 0.1 * (7.0 * x).sin() * (5.0 * y).cos();
    let point = |i: i32, j: i32| {
        let [x, y] = [i, j].map(|k| f64::from(k) / f64::from(count));
        at(x, y, height(x, y))
    };
    (0..count * count)
        .flat_map(|n| {
            let (i, j) = (n / count, n % count);
            let [a, b] = [point(i, j), point(i + 1, j)];
            let [c, d] = [point(i + 1, j + 1), point(i, j + 1)];
            [[a, b, c], [a, c, d]]
        })
        .collect()
}

#[test]
fn a_sheet_is_as_thick_as_it_is_made_and_knows_its_sides() {
    let back = flipped(square());
    for facets in [square(), [square(), back].concat()] {
        let sheet = Sheet::new(&soup(facets), 0.1, &Watch::default()).unwrap();
        let above = sheet.closest(&at(0.4, 0.3, 0.25));
        assert_relative_eq!(above.distance, 0.2, epsilon = 1e-12);
        assert_relative_eq!(above.point, at(0.4, 0.3, 0.05), epsilon = 1e-12);
        assert_eq!(above.normal, at(0.0, 0.0, 1.0));
        let below = sheet.closest(&at(0.4, 0.3, -0.03));
        assert_relative_eq!(below.distance, -0.02, epsilon = 1e-12);
        assert_eq!(below.normal, at(0.0, 0.0, -1.0));
        assert_ne!(above.face, below.face);
        // In the middle there is a side too.
        assert_relative_eq!(sheet.closest(&at(0.4, 0.3, 0.0)).normal.norm(), 1.0);
        let rim = sheet.closest(&at(1.3, 0.3, 0.0));
        assert_relative_eq!(rim.distance, 0.25, epsilon = 1e-12);
        assert_eq!(sheet.mirror_planes().len(), 3);
    }
    assert!(refusal(terrain(20)).contains("`--thicken T`"));
    assert!(Sheet::new(&soup(square()), 0.0, &Watch::default()).is_err());
}

#[test]
fn a_wrap_of_a_sound_body_is_that_body() {
    let ball = wrapped(sphere(1.0).unwrap().tessellate(60), 0.1);
    let exact = 4.0 / 3.0 * std::f64::consts::PI;
    assert!(
        (ball.volume() / exact - 1.0).abs() < 0.006,
        "{}",
        ball.volume()
    );
    for k in 0..200 {
        let k = f64::from(k);
        let p = 1.5 * at((0.37 * k).sin(), (0.73 * k).cos(), (1.13 * k).sin());
        let gap = ball.signed_distance(&p) - (p.norm() - 1.0);
        assert!(gap.abs() < 0.01, "{p:?}: {gap}");
    }
    // Edges stay sharp.
    let cube = wrapped(unit_block(), 0.1);
    assert_relative_eq!(cube.volume(), 1.0, max_relative = 1e-3);
    assert_relative_eq!(cube.area(), 6.0, max_relative = 2e-3);
    assert!(cube.signed_distance(&at(0.49, 0.49, 0.49)) < 0.0);
}

#[test]
fn a_wrap_makes_panels_as_thick_as_the_spacing_and_fills_what_they_enclose() {
    let spacing = 0.1;
    // One panel, seen from both sides.
    let panel = wrapped([square(), flipped(square())].concat(), spacing);
    let expected = 1.0 * spacing + std::f64::consts::FRAC_PI_8 * spacing * spacing * 4.0;
    assert!(
        (panel.volume() / expected - 1.0).abs() < 0.03,
        "{}",
        panel.volume()
    );
    assert!((panel.signed_distance(&at(0.5, 0.5, 0.2)) - 0.15).abs() < 1e-3);
    // Six of them around nothing.
    let double = [unit_block(), flipped(unit_block())].concat();
    let loose: Vec<Facet> = double
        .iter()
        .map(|f| f.map(|v| v + 1e-3 * (f[0] + f[1] + f[2])))
        .collect();
    let cube = wrapped(loose, spacing);
    assert!(cube.signed_distance(&at(0.0, 0.0, 0.0)) < -0.5);
    assert!((cube.signed_distance(&at(0.0, 0.0, 1.0)) - 0.45).abs() < 0.01);
    assert!(
        cube.repairs()
            .iter()
            .any(|r| r.contains("voids without a way in"))
    );
    // Terrain keeps its valleys: nothing is filled.
    let ground = wrapped(terrain(40), 0.05);
    for (x, y) in [(0.2, 0.6), (0.7, 0.3), (0.5, 0.5)] {
        let z = 0.1 * (7.0_f64 * x).sin() * (5.0_f64 * y).cos();
        let gap = ground.signed_distance(&at(x, y, z + 0.1));
        assert!((0.04..0.08).contains(&gap), "({x}, {y}): {gap}");
    }
}

#[test]
fn a_wrap_takes_what_nothing_else_can_and_loses_nothing() {
    let spacing = 0.06;
    let mut cup = unit_block();
    cup.truncate(11);
    let fin = block([-0.2, 0.3, -0.005], [0.2, 0.9, 0.005]);
    let mut facets = [cup, flipped(fin), shifted(square(), at(0.4, -0.2, 0.1))].concat();
    assert!(refusal(facets.clone()).contains("is open"));
    // A one-sided strip, which has no inside.
    let strip = |k: i32, side: f64| {
        let angle = f64::from(k) * std::f64::consts::TAU / 30.0;
        let (sin, cos) = (0.5 * angle).sin_cos();
        let r = 2.0 + 0.3 * side * cos;
        at(r * angle.cos(), r * angle.sin(), 0.3 * side * sin)
    };
    facets.extend((0..30).flat_map(|k| {
        let (a, b) = (strip(k, -1.0), strip(k, 1.0));
        let (c, d) = (strip(k + 1, -1.0), strip(k + 1, 1.0));
        [[a, c, b], [b, c, d]]
    }));
    let all = wrapped(facets, spacing);
    let near = |p, distance: f64| {
        let found = all.signed_distance(&p);
        assert!(
            (found - distance).abs() < 0.35 * spacing,
            "{p:?}: {found}, not {distance}"
        );
    };
    // The box, its thin fin, the panel and the strip.
    near(at(0.0, -0.4, 0.4), -0.1);
    near(at(0.0, 0.8, 0.2), 0.2 - 0.5 * spacing);
    near(at(1.0, 0.3, 0.4), 0.3 - 0.5 * spacing);
    near(at(2.0, 0.0, 0.3), 0.3 - 0.5 * spacing);
    let message = Mesh::wrapped(&soup(unit_block()), 1e-5, &Watch::default()).unwrap_err();
    assert!(message.to_string().contains("choose"), "{message}");
}
