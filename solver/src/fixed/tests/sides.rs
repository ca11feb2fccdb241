use aero_geometry::bodies;

use super::*;
use crate::problem::WallKind;

#[test]
fn periodic_sides_join_and_fill() {
    for disorder in [0.0, 0.25] {
        let mut square = domain([0.0, 0.0], [1.0, 0.5]);
        square.sides[0] = [Side::Periodic; 2];
        let made = Scene::new(square, Vec::new(), 0.1)
            .disordered(disorder)
            .made();
        assert!(made.open(false) < 1e-12);
        assert!((made.volume() - 0.5).abs() < 1e-13);
        assert!(made.cells.sides.iter().all(|side| side.axis == 1));
        let across = made.cells.faces.iter().filter(|face| {
            let direct = made.cells.points[face.j as usize] - made.cells.points[face.i as usize];
            (direct - face.apart).norm() > 0.5
        });
        assert!(across.count() >= 5);
        assert!(made.cells.faces.iter().all(|face| face.apart.norm() < 0.3));
        let mut cube = domain([0.0; 3], [1.0; 3]);
        cube.sides = [[Side::Periodic; 2]; 3];
        let made = Scene::new(cube, Vec::new(), 0.125)
            .disordered(disorder)
            .made();
        assert!(made.open(false) < 1e-12);
        assert!((made.volume() - 1.0).abs() < 1e-13);
        assert!(made.cells.sides.is_empty());
    }
}

#[test]
fn cells_end_at_sides_that_do_not_fit_the_lattice() {
    let mut sides = domain([0.0, 0.0], [1.04, 0.97]);
    sides.sides[1] = [
        Side::Symmetry,
        Side::Wall {
            kind: WallKind::Slip,
            velocity: 0.0,
            acceleration: 0.0,
        },
    ];
    for disorder in [0.0, 0.25] {
        let scene = Scene::new(sides.clone(), Vec::new(), 0.1).disordered(disorder);
        let made = scene.made();
        assert!(made.open(false) < 1e-12);
        assert!((made.volume() - 1.04 * 0.97).abs() < 1e-13);
        let wall: f64 = made.cells.walls.iter().map(|wall| wall.area.y).sum();
        assert!((wall - 1.04).abs() < 1e-13);
    }
}

#[test]
fn a_line_of_points_is_divided_half_way() {
    for disorder in [0.0, 0.25] {
        let made = Scene::new(domain([0.0], [1.0]), Vec::new(), 0.1)
            .disordered(disorder)
            .made();
        assert_eq!(made.cells.faces.len(), 9);
        assert_eq!(made.cells.sides.len(), 2);
        assert!(made.open(false) < 1e-14);
        assert!((made.volume() - 1.0).abs() < 1e-14);
    }
}

/// Gas at rest about an axis feels `p` times the area of its cell in the plane, and that is what the radial areas add
/// up to.
#[test]
fn about_an_axis_the_radial_areas_add_up_to_the_plane_cell() {
    let (radius, dx) = (0.42, 1.0 / 16.0);
    let mut rings = domain([-1.0, 0.0], [1.0, 1.0]);
    rings.sides[1][0] = Side::Axis;
    let mut flat = rings.clone();
    flat.sides[1][0] = Side::Symmetry;
    let body = || -> Vec<Arc<dyn Shape<2>>> { vec![Arc::new(bodies::circle(radius).unwrap())] };
    for disorder in [0.0, 0.25] {
        let made = Scene::new(rings.clone(), body(), dx)
            .disordered(disorder)
            .made();
        let plane = Scene::new(flat.clone(), body(), dx)
            .disordered(disorder)
            .made();
        assert!(made.open(true) < 1e-13);
        let exact = 2.0 * 0.5 - 2.0 / 3.0 * radius.powi(3);
        assert!((made.volume() - exact).abs() < 0.2 * dx * dx);
        let sums = made.cells.open_areas(false);
        for (sum, area) in sums.iter().zip(&plane.cells.volumes) {
            assert!((sum.y - area).abs() < 1e-13, "{} {area}", sum.y);
        }
        let drag: f64 = made.cells.walls.iter().map(|wall| wall.area.x.abs()).sum();
        assert!((drag - radius * radius).abs() < 0.5 * dx * dx, "{drag}");
        // The first walls' areas cannot be negative: nothing lies beyond the axis.
        assert!(made.cells.volumes.iter().all(|&volume| volume > 0.0));
    }
}
