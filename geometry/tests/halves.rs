//! Halves of bodies that end at a mirror, and the whole that they are half of.

use aero_geometry::bodies::{biconvex, circle, polygon};
use aero_geometry::stl::Facet;
use aero_geometry::{
    Bounds, Mesh, MirrorPlane, Outline, Placement, Shape, Vector, bodies, made_whole,
};
use approx::assert_relative_eq;

fn plane(axis: usize, position: f64, shows_above: bool) -> MirrorPlane {
    MirrorPlane {
        axis,
        position,
        shows_above,
    }
}

fn whole(points: &[[f64; 2]], planes: &[MirrorPlane]) -> Option<Outline> {
    let points: Vec<Vector<2>> = points.iter().map(|&point| point.into()).collect();
    let outline = polygon(&points).expect("a polygon");
    outline.made_whole(planes).expect("a whole")
}

#[test]
fn half_an_outline_is_made_whole_wherever_its_numbers_are_rounded_to() {
    for (sign, shows_above) in [(1.0, true), (-1.0, false)] {
        let floor = plane(1, 0.0, shows_above);
        for off in [0.0, 1e-7, -1e-7] {
            let half = [[0.0, off], [1.0, off], [0.4, 0.1 * sign]];
            let whole = whole(&half, &[floor]).expect("half of one");
            assert_eq!(whole.pieces().len(), 4);
            assert_relative_eq!(whole.measure().unwrap(), 0.1, epsilon = 1e-6);
            assert!(whole.mirror_planes().contains(&(1, 0.0)));
            assert!(whole.signed_distance(&[0.4, 0.0].into()) < -0.05);
        }
    }
}

/// What stands before the plane or goes through it, ends there in a point, or fills a channel from mirror to mirror.
#[test]
fn what_is_no_half_stays_as_it_is() {
    let [floor, roof] = [plane(1, 0.0, true), plane(1, 1.0, false)];
    for points in [
        [[0.0, 1e-3], [1.0, 1e-3], [0.4, 0.1]],
        [[0.0, -1e-3], [1.0, -1e-3], [0.4, 0.1]],
        [[0.0, 0.1], [0.5, 0.0], [1.0, 0.1]],
    ] {
        assert!(whole(&points, &[floor]).is_none(), "{points:?}");
    }
    let post = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    assert!(whole(&post, &[floor, roof]).is_none());
    assert!(whole(&post, &[roof]).is_some());
    let wall = bodies::wall(0.0).unwrap();
    assert!(wall.made_whole(&[floor]).unwrap().is_none());
    let ball = circle(0.5)
        .unwrap()
        .placed(&Placement::default().moved([0.0, 0.5].into()));
    assert!(ball.made_whole(&[floor]).unwrap().is_none());
}

/// Two legs on the plane leave a hole between them and their images; an arc that ends in it goes on as its image.
#[test]
fn legs_leave_a_hole_and_arcs_go_on() {
    let arch = [
        [0.0, 0.0],
        [1.0, 0.0],
        [1.0, 2.0],
        [3.0, 2.0],
        [3.0, 0.0],
        [4.0, 0.0],
        [4.0, 3.0],
        [0.0, 3.0],
    ];
    let floor = plane(1, 0.0, true);
    let ring = whole(&arch, &[floor]).expect("half of one");
    assert_eq!(ring.chains().len(), 2);
    assert_relative_eq!(ring.measure().unwrap(), 2.0 * (12.0 - 4.0), epsilon = 1e-12);
    assert!(ring.signed_distance(&[2.0, 0.0].into()) > 0.0);

    let upper = biconvex(1.0, 0.1).unwrap().pieces()[0];
    let chord = aero_geometry::outline::Piece::segment(upper.end(), upper.start());
    let half = Outline::new(vec![vec![upper, chord]]).unwrap();
    let from = if half.bounds().max.y > 1e-3 {
        plane(1, 0.0, true)
    } else {
        plane(1, 0.0, false)
    };
    let aerofoil = half.made_whole(&[from]).unwrap().expect("half of one");
    let own = biconvex(1.0, 0.1).unwrap();
    assert_relative_eq!(
        aerofoil.measure().unwrap(),
        own.measure().unwrap(),
        epsilon = 1e-12
    );
    assert_eq!(aerofoil.pieces().len(), own.pieces().len());
}

/// A brick in `z` above `low`, with its lower face or without.
fn brick(low: f64, has_floor: bool) -> Vec<Facet> {
    let block = bodies::cuboid([2.0, 1.0, 0.8]).unwrap();
    let everywhere = Bounds::new(Vector::repeat(-9.0), Vector::repeat(9.0));
    let facets = block.facets(9.0, &everywhere);
    let moved = facets
        .into_iter()
        .map(|facet| facet.map(|corner| corner + Vector::<3>::new(0.0, 0.0, 0.4 + low)));
    let is_floor = |facet: &Facet| facet.iter().all(|corner| (corner.z - low).abs() < 1e-9);
    moved
        .filter(|facet| has_floor || !is_floor(facet))
        .collect()
}

#[test]
fn half_a_mesh_is_made_whole_closed_or_open() {
    for has_floor in [true, false] {
        for low in [0.0, 3e-7, -3e-7] {
            let facets = made_whole(&brick(low, has_floor), &[plane(2, 0.0, true)]);
            let mesh = Mesh::from_facets(facets.expect("half of one")).expect("closed");
            assert_relative_eq!(mesh.volume(), 2.0 * 1.6, epsilon = 1e-5);
            assert!(mesh.mirror_planes().contains(&(2, 0.0)));
            assert!(mesh.repairs().is_empty(), "{:?}", mesh.repairs());
            assert!(mesh.signed_distance(&Vector::zeros()) < -0.4);
        }
    }
    // A quarter, at two mirrors.
    let quarter: Vec<Facet> = brick(0.0, true)
        .into_iter()
        .map(|facet| facet.map(|corner| corner + Vector::<3>::new(0.0, 0.5, 0.0)))
        .collect();
    let planes = [plane(1, 0.0, true), plane(2, 0.0, true)];
    let mesh =
        Mesh::from_facets(made_whole(&quarter, &planes).expect("a quarter")).expect("closed");
    assert_relative_eq!(mesh.volume(), 4.0 * 1.6, epsilon = 1e-12);
}

#[test]
fn a_mesh_that_is_no_half_stays_as_it_is() {
    let floor = plane(2, 0.0, true);
    for low in [0.01, -0.01] {
        for has_floor in [true, false] {
            assert!(made_whole(&brick(low, has_floor), &[floor]).is_none());
        }
    }
    // On an edge: both of its facets are there.
    let turned: Vec<Facet> = brick(-0.4, true)
        .into_iter()
        .map(|facet| {
            facet.map(|corner| {
                let (sine, cosine) = 0.5_f64.sin_cos();
                let lowest = 0.5 * sine + 0.4 * cosine;
                Vector::<3>::new(
                    corner.x,
                    cosine * corner.y - sine * corner.z,
                    sine * corner.y + cosine * corner.z + lowest,
                )
            })
        })
        .collect();
    let least = turned
        .iter()
        .flatten()
        .map(|corner| corner.z)
        .fold(f64::INFINITY, f64::min);
    assert!(least.abs() < 1e-12);
    assert!(made_whole(&turned, &[floor]).is_none());
    assert!(made_whole(&[], &[floor]).is_none());
}
