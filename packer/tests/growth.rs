//! Reading grows with the number of triangles and not with its square, whatever they are: nine times the
//! triangles may take 27 times the processor time, of which caches and sorting need a part. One
//! test, for it counts the time of the whole process.

use std::f64::consts::TAU;

use aero_geometry::bodies::sphere;
use aero_geometry::stl::Facet;
use aero_geometry::{Mesh, Shape, Vector};
use aero_packer::{PackOptions, pack};
use cpu_time::ProcessTime;

/// 81 would be quadratic.
const MOST: f64 = 27.0;

/// So often it is measured again where it took more.
const TRIES: u32 = 3;

/// A lattice of `count` cubes that do not touch, all inside out.
fn cubes(count: usize) -> Vec<Facet> {
    let across = (count as f64).cbrt().ceil() as usize;
    let faces = [
        [0, 2, 3, 1],
        [4, 5, 7, 6],
        [0, 1, 5, 4],
        [2, 6, 7, 3],
        [0, 4, 6, 2],
        [1, 3, 7, 5],
    ];
    let cube = |number: usize| {
        let place = [
            number % across,
            number / across % across,
            number / across / across,
        ];
        faces.into_iter().flat_map(move |[a, b, c, d]| {
            let corner = |n: usize| {
                Vector::<3>::from_fn(|k, _| place[k] as f64 + 0.6 * f64::from((n >> k & 1) as u8))
            };
            [[a, c, b], [a, d, c]].map(|f| f.map(corner))
        })
    };
    (0..count).flat_map(cube).collect()
}

/// A band of `count` triangles, whose two borders are as long.
fn band(count: usize) -> Vec<Facet> {
    let at = |n: usize| {
        let angle = TAU * (n % count) as f64 / count as f64;
        Vector::<3>::new(angle.cos(), angle.sin(), 0.001 * (n % 2) as f64)
    };
    let facet = |n: usize| {
        if n.is_multiple_of(2) {
            [n, n + 1, n + 2]
        } else {
            [n + 1, n, n + 2]
        }
    };
    (0..count).map(|n| facet(n).map(at)).collect()
}

/// Triangles that have nothing to do with each other.
fn soup(count: usize) -> Vec<Facet> {
    let place = |n: usize| (n as f64 * 0.618_033_988_749_895).fract();
    let corner = |n: usize| Vector::<3>::new(place(n), place(7 * n + 1), place(13 * n + 5));
    (0..count)
        .map(|n| [corner(3 * n), corner(3 * n + 1), corner(3 * n + 2)])
        .collect()
}

/// The triangles of a sphere, each with a needle along an edge.
fn needles(around: usize) -> Vec<Facet> {
    let split = |[a, b, c]: Facet| {
        let tip = a + 0.37 * (b - a);
        [[tip, b, c], [a, tip, c], [a, b, tip]]
    };
    let facets = sphere(1.0).unwrap().tessellate(around).into_iter();
    facets.flat_map(split).collect()
}

#[test]
fn nine_times_the_triangles_take_about_nine_times_the_work() {
    let packed = |facets: Vec<Facet>, closed: bool, across: f64| {
        let start = ProcessTime::now();
        let mesh = Mesh::from_facets(facets);
        assert_eq!(mesh.is_ok(), closed, "{:?}", mesh.err());
        if let Ok(mesh) = mesh {
            // At a fixed spacing packing does not grow with the triangles.
            let size = mesh.bounds().size().max();
            pack(
                &mesh,
                &PackOptions {
                    layers: 2,
                    ..PackOptions::new(size / across)
                },
            )
            .ok();
        }
        start.elapsed().as_secs_f64()
    };
    let seconds = |facets, closed| packed(facets, closed, 12.0);
    // Other work on the processor only ever adds to a time: the least of a few counts.
    let grows = |name: &str, few: &dyn Fn() -> f64, many: &dyn Fn() -> f64| {
        let (mut less, mut more) = (f64::INFINITY, f64::INFINITY);
        for _ in 0..TRIES {
            less = less.min(few());
            more = more.min(many());
            println!("{name}: {less:.3} s, {more:.3} s");
            if more < MOST * less {
                return;
            }
        }
        panic!("{name}: {less} s, but {more} s for nine times the triangles");
    };
    let ball = |around| sphere(1.0).unwrap().tessellate(around);
    assert!(ball(560).len() > 300_000);
    grows("sphere", &|| seconds(ball(187), true), &|| {
        seconds(ball(560), true)
    });
    grows(
        "cubes",
        // Packed finer, the fewer of them take the longer.
        &|| packed(cubes(900), true, 1.0),
        &|| packed(cubes(8_100), true, 1.0),
    );
    grows("needles", &|| seconds(needles(80), true), &|| {
        seconds(needles(240), true)
    });
    grows("band", &|| seconds(band(40_000), false), &|| {
        seconds(band(360_000), false)
    });
    grows("soup", &|| seconds(soup(20_000), false), &|| {
        seconds(soup(180_000), false)
    });
}
