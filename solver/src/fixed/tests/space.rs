use aero_geometry::outline::Piece;
use aero_geometry::{Mesh, Placed, Placement, Revolution, bodies};

use super::*;
use crate::fixed::rim::{closed, polygon};

fn boxed() -> Domain<3> {
    domain([-1.0; 3], [1.0; 3])
}

fn turned(edges: [f64; 3]) -> Arc<dyn Shape<3>> {
    let place = Placement::default()
        .rotated_about(&Vector::x(), 0.1)
        .unwrap()
        .rotated_about(&Vector::y(), 0.2)
        .unwrap()
        .rotated_about(&Vector::z(), 0.3)
        .unwrap()
        .moved(Vector::<3>::new(0.011, -0.007, 0.017));
    Arc::new(Placed::new(bodies::cuboid(edges).unwrap(), place))
}

fn shapes(dx: f64) -> Vec<(&'static str, Arc<dyn Shape<3>>)> {
    vec![
        ("sphere", Arc::new(bodies::sphere(0.43).unwrap()) as _),
        ("block", Arc::new(bodies::cuboid([0.7, 0.4, 0.5]).unwrap())),
        ("turned block", turned([0.7, 0.4, 0.5])),
        ("cone", Arc::new(bodies::cone(20.0, 0.8).unwrap())),
        ("plate 0.3", turned([0.8, 0.3 * dx, 0.7])),
        ("plate 0.5", turned([0.8, 0.5 * dx, 0.7])),
        ("plate 1", turned([0.8, dx, 0.7])),
        (
            "plate 3",
            Arc::new(bodies::cuboid([0.8, 3.0 * dx, 0.7]).unwrap()),
        ),
    ]
}

#[test]
fn cells_around_bodies_in_space_close_and_fill_the_gas() {
    let dx = 1.0 / 12.0;
    for disorder in [0.0, 0.25] {
        for (name, shape) in shapes(dx) {
            let exact = 8.0 - shape.measure().unwrap();
            let made = Scene::new(boxed(), vec![shape], dx)
                .disordered(disorder)
                .made();
            // Where a facet of a cell lies in a wall the skin shows, and the wall takes it.
            assert!(made.cells.open < 1e-8, "{name}: {}", made.cells.open);
            assert!(made.open(false) < 1e-12, "{name}");
            assert_eq!(made.cells.lost, 0, "{name}");
            // The round ones are polyhedra here.
            let miss = (made.volume() - exact) / dx.powi(3);
            assert!(miss.abs() < 4.0, "{name}: {miss}");
            let least = made.cells.volumes.iter().fold(f64::MAX, |a, v| a.min(*v));
            assert!(least > 0.3 * dx.powi(3), "{name}: {least}");
        }
    }
}

/// A spindle of eight facets around, four of whose edges lie in the faces of cells: both cells that one parts hold the same gas.
#[test]
fn cells_on_both_sides_of_an_edge_in_their_face_are_mirror_images() {
    let dx = 1.0 / 12.0;
    let at = Vector::<2>::new;
    let spindle = Revolution::new(vec![
        Piece::segment(at(0.61, 0.0), at(0.0, 0.22)),
        Piece::segment(at(0.0, 0.22), at(-0.61, 0.0)),
    ]);
    let facets = spindle.unwrap().tessellate(8);
    let made = Scene::new(
        boxed(),
        vec![Arc::new(Mesh::from_facets(facets).unwrap())],
        dx,
    )
    .made();
    let cells = made.cells.points.iter().zip(&made.cells.volumes);
    let cut: Vec<_> = cells
        .filter(|(_, v)| (*v / dx.powi(3) - 1.0).abs() > 1e-9)
        .collect();
    assert!(cut.len() > 200, "{}", cut.len());
    for axis in 1..3 {
        for (point, volume) in &cut {
            let mut image = **point;
            image[axis] = -image[axis];
            let away = |place: &Vector<3>| (place - image).norm();
            let nearest = cut.iter().min_by(|a, b| away(a.0).total_cmp(&away(b.0)));
            let (place, there) = nearest.unwrap();
            let off = [away(place) / dx, (*there - *volume).abs() / dx.powi(3)];
            assert!(off[0] < 1e-4 && off[1] < 1e-4, "{point} {volume}: {off:?}");
        }
    }
}

/// Per cent by which wall area, `A . n` and volume of the gas are off.
fn misses(scene: &Scene<3>, area: f64, volume: f64) -> [f64; 3] {
    let made = scene.made();
    let [sum, along] = made.wall_area(&scene.solids);
    let miss = |found: f64, exact: f64| found / exact - 1.0;
    [
        miss(sum, area),
        miss(along, area),
        miss(made.volume(), volume),
    ]
    .map(|miss| 100.0 * miss)
}

#[test]
fn area_and_volume_around_a_sphere_converge_by_the_second_order() {
    let radius: f64 = 0.7;
    let area = 4.0 * std::f64::consts::PI * radius * radius;
    let volume = 8.0 - area * radius / 3.0;
    let at = |n: f64| {
        let sphere: Arc<dyn Shape<3>> = Arc::new(bodies::sphere(radius).unwrap());
        misses(&Scene::new(boxed(), vec![sphere], radius / n), area, volume)
    };
    let (coarse, fine) = (at(8.0), at(16.0));
    for (a, b) in coarse.iter().zip(fine) {
        assert!(
            a.abs() < 0.3 && b.abs() < a.abs() / 3.4,
            "{coarse:?} {fine:?}"
        );
    }
}

#[test]
fn walls_around_a_sphere_bend_as_it_does_and_those_of_a_block_do_not() {
    let radius = 0.7;
    let sphere: Arc<dyn Shape<3>> = Arc::new(bodies::sphere(radius).unwrap());
    let made = Scene::new(boxed(), vec![sphere], radius / 8.0).made();
    for wall in &made.cells.walls {
        let normal = wall.area.normalize();
        let across = wall.curvature * normal;
        let mean = 0.5 * wall.curvature.trace();
        assert!((mean * radius - 1.0).abs() < 0.02, "{mean}");
        assert!(across.norm() * radius < 0.05, "{across}");
    }
    let dx = 1.0 / 12.0;
    let made = Scene::new(boxed(), vec![turned([0.7, 0.4, 0.5])], dx).made();
    // Slivers of cells that an edge cuts may go round it.
    let walls = made.cells.walls.iter();
    let whole: Vec<_> = walls.filter(|w| w.area.norm() > 0.01 * dx * dx).collect();
    assert!(whole.len() > 300, "{}", whole.len());
    for wall in whole {
        assert!(wall.curvature.norm() < 1e-12, "{}", wall.curvature);
    }
}

/// Area within half a spacing times the length of the edges, volume within the square of that, at two spacings, and falling.
fn check_edges(
    name: &str,
    scene: impl Fn(f64) -> Scene<3>,
    exact: impl Fn(f64) -> [f64; 2],
    edges: f64,
) {
    let mut before = [f64::INFINITY; 2];
    for dx in [1.0 / 12.0, 1.0 / 24.0] {
        let (scene, [area, volume]) = (scene(dx), exact(dx));
        let [_, along, gas] = misses(&scene, area, volume);
        let miss = [along * area * 0.01, gas * volume * 0.01].map(f64::abs);
        assert!(miss[0] < 0.5 * dx * edges, "{name}: {miss:?}");
        assert!(miss[1] < 0.25 * dx * dx * edges, "{name}: {miss:?}");
        // What holds a roof's point moves it by a thousandth of its arm: below that volumes are right, cell by cell, and do not fall.
        let held = 1e-4 * dx * dx * edges;
        assert!(
            miss[0] < before[0] && miss[1] < before[1].max(held),
            "{name}: {miss:?} {before:?}"
        );
        before = miss;
    }
}

fn block(edges: [f64; 3]) -> Arc<dyn Shape<3>> {
    Arc::new(bodies::cuboid(edges).unwrap())
}

#[test]
fn edges_of_plates_boxes_and_fins_leave_no_false_walls() {
    let one = |shape: Arc<dyn Shape<3>>, dx: f64| Scene::new(boxed(), vec![shape], dx);
    check_edges(
        "plate of half a spacing",
        |dx| one(turned([0.8, 0.5 * dx, 0.7]), dx),
        |dx| [2.0 * (0.56 + 0.75 * dx), 8.0 - 0.28 * dx],
        6.0,
    );
    let placed = |shape: Arc<dyn Shape<3>>, turn: f64, z: f64| -> Arc<dyn Shape<3>> {
        let place = Placement::default()
            .rotated_about(&Vector::z(), turn)
            .unwrap();
        Arc::new(Placed::new(
            shape,
            place.moved(Vector::<3>::new(0.0, 0.0, z)),
        ))
    };
    check_edges(
        "box on a floor",
        |dx| {
            let floor = placed(block([9.0, 9.0, 1.0]), 0.0, -1.0);
            let stands = placed(block([0.8, 0.6, 0.61]), 0.3, -0.305);
            Scene::new(boxed(), vec![floor, stands], dx)
        },
        |_| [4.0 + 1.4, 6.0 - 0.24],
        2.0 * 2.8 + 4.0 * 0.5,
    );
    let fin: f64 = 0.05;
    check_edges(
        "body with four fins",
        |dx| {
            let fins = [block([0.4, 1.2, fin]), block([0.4, fin, 1.2])];
            let [first, second] = fins;
            Scene::new(boxed(), vec![block([0.8, 0.3, 0.3]), first, second], dx)
        },
        |_| {
            let sides = 0.18 + 0.96 + 4.0 * (0.45 * (0.8 + 2.0 * fin) + 0.4 * fin);
            [sides - 1.6 * fin, 8.0 - 0.072 - 0.72 * fin]
        },
        4.4 + 4.0 * (2.0 * 0.9 + 2.0 * 0.45 + 0.9),
    );
}

#[test]
fn the_bits_are_the_same_for_any_number_of_threads() {
    let dx = 1.0 / 12.0;
    let scene = Scene::new(boxed(), vec![turned([0.8, 0.3 * dx, 0.7])], dx).disordered(0.25);
    let with = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
        pool.unwrap().install(|| scene.made().cells)
    };
    let (one, three) = (with(1), with(3));
    assert_eq!(one.points, three.points);
    assert_eq!(one.volumes, three.volumes);
    assert_eq!(one.faces, three.faces);
    assert_eq!(one.walls, three.walls);
    assert_eq!(one.sides, three.sides);
}

#[test]
fn a_surface_of_triangles_is_cut_like_the_body_it_stands_for() {
    let dx = 1.0 / 12.0;
    let corner = |n: usize| {
        Vector::<3>::new(
            if n & 1 == 0 { -0.35 } else { 0.35 },
            if n & 2 == 0 { -0.02 } else { 0.02 },
            if n & 4 == 0 { -0.25 } else { 0.25 },
        )
    };
    let quads = [
        [0, 4, 6, 2],
        [1, 3, 7, 5],
        [0, 1, 5, 4],
        [2, 6, 7, 3],
        [0, 2, 3, 1],
        [4, 5, 7, 6],
    ];
    let facets = quads
        .iter()
        .flat_map(|[a, b, c, d]| [[*a, *b, *c], [*a, *c, *d]])
        .map(|corners| corners.map(corner));
    let mesh = Mesh::from_facets(facets.collect()).unwrap();
    let plate = Scene::new(boxed(), vec![Arc::new(mesh)], dx).disordered(0.2);
    let exact = Scene::new(boxed(), vec![block([0.7, 0.04, 0.5])], dx).disordered(0.2);
    let (plate, exact) = (plate.made(), exact.made());
    assert!(plate.cells.open < 1e-12);
    assert_eq!(plate.cells.lost, 0);
    assert!((plate.volume() - exact.volume()).abs() < 0.1 * dx.powi(3));
    let sum = |made: &Made<3>| -> f64 { made.cells.walls.iter().map(|w| w.area.norm()).sum() };
    assert!((sum(&plate) - sum(&exact)).abs() < 0.1 * dx * dx);
}

/// What is kept of cells in which surfaces meet, or that took pieces from behind a thin part, is all that bounds them, as seen from their points.
#[test]
fn cells_with_corners_are_the_polyhedra_that_are_kept_of_them() {
    let dx = 0.05;
    for thick in [0.5, 8.0] {
        let scene = Scene::new(boxed(), vec![turned([0.8, thick * dx, 0.7])], dx);
        let cells = scene.disordered(0.2).made().cells;
        let (mut kept, mut farthest) = (Vec::<(u32, f64)>::new(), 0.0_f64);
        for (cell, rings) in &cells.cornered {
            let cone = |ring: &Vec<Vector<3>>| {
                let face = polygon(0, closed(ring));
                face.area.dot(&face.centre) / 3.0
            };
            let volume = rings.iter().map(cone).sum::<f64>();
            // Those of a piece from next door lie there.
            let away = rings.iter().flatten().map(Vector::norm);
            farthest = away.fold(farthest, f64::max);
            match kept.last_mut() {
                Some((last, sum)) if last == cell => *sum += volume,
                _ => kept.push((*cell, volume)),
            }
        }
        assert!(farthest < 2.2 * dx, "{}", farthest / dx);
        assert!(kept.len() > 100 && kept.len() < cells.points.len() / 4);
        for (cell, volume) in kept {
            let off = volume / cells.volumes[cell as usize] - 1.0;
            assert!(off.abs() < 1e-9, "plate of {thick} spacings: {off}");
        }
    }
}
