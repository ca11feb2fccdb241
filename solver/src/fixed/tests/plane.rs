use aero_geometry::{Placement, bodies};

use super::*;

fn boxed() -> Domain<2> {
    domain([-1.0, -1.0], [1.0, 1.0])
}

fn plate(thickness: f64, degrees: f64) -> Arc<dyn Shape<2>> {
    let place = Placement::default()
        .rotated(degrees.to_radians())
        .moved(Vector::<2>::new(0.013, 0.027));
    let plate = bodies::rectangle(1.0, thickness, 0.0).unwrap();
    Arc::new(plate.placed(&place))
}

fn shapes(dx: f64) -> Vec<(&'static str, Arc<dyn Shape<2>>)> {
    let block = bodies::rectangle(0.7, 0.4, 0.0).unwrap();
    let turned = block.placed(&Placement::default().rotated(0.3));
    vec![
        ("circle", Arc::new(bodies::circle(0.43).unwrap()) as _),
        ("block", Arc::new(block) as _),
        ("turned block", Arc::new(turned) as _),
        (
            "biconvex",
            Arc::new(bodies::biconvex(0.9, 0.1).unwrap()) as _,
        ),
        ("plate 0.3", plate(0.3 * dx, 0.0)),
        ("plate 0.3, turned", plate(0.3 * dx, 5.0)),
        ("plate 0.5, turned", plate(0.5 * dx, 5.0)),
        ("plate 1, turned", plate(dx, 37.0)),
        ("plate 2, turned", plate(2.0 * dx, 5.0)),
        ("plate 8", plate(8.0 * dx, 0.0)),
    ]
}

#[test]
fn cells_around_bodies_in_the_plane_close_and_fill_the_gas() {
    let dx = 1.0 / 16.0;
    for disorder in [0.0, 0.25] {
        for (name, shape) in shapes(dx) {
            let exact = 4.0 - shape.measure().unwrap();
            let scene = Scene::new(boxed(), vec![shape], dx).disordered(disorder);
            let made = scene.made();
            let [area, along] = made.wall_area(&scene.solids);
            println!(
                "{name} {disorder}: points {}, open {:.1e}, volume {:.2e} dx2, area {area:.4} {along:.4}, least {:.3}",
                made.cells.points.len(),
                made.open(false),
                (made.volume() - exact) / dx / dx,
                made.cells
                    .volumes
                    .iter()
                    .fold(1.0_f64, |a, v| a.min(v / dx / dx)),
            );
            assert!(
                made.cells.open < 1e-12 && made.open(false) < 1e-12,
                "{name}"
            );
            assert_eq!(made.cells.lost, 0, "{name}");
            assert!((made.volume() - exact).abs() < 0.25 * dx * dx, "{name}");
        }
    }
}

/// Every cell's point sees all faces of its cell but those at the tips of thin parts, and no cell lies on both sides.
#[test]
fn no_cell_straddles_a_thin_plate() {
    let dx = 1.0 / 16.0;
    for thickness in [0.3, 0.5, 1.0, 2.0] {
        for (degrees, disorder) in [(0.0, 0.0), (5.0, 0.0), (5.0, 0.25), (40.0, 0.25)] {
            let scene = Scene::new(boxed(), vec![plate(thickness * dx, degrees)], dx);
            let scene = scene.disordered(disorder);
            let made = scene.made();
            let turned = Placement::<2>::default().rotated(f64::to_radians(degrees));
            let up = turned.direction(&Vector::<2>::y());
            let side = |p: &Vector<2>| turned.point_back(&(p - Vector::<2>::new(0.013, 0.027)));
            for wall in &made.cells.walls {
                let (foot, point) = (side(&wall.foot), side(&made.cells.points[wall.i as usize]));
                // Away from the tips the point is on the wall's side.
                let is_face = wall.area.normalize().dot(&up).abs() > 0.9;
                if is_face && point.x.abs() < 0.5 - dx {
                    assert!(
                        foot.y * point.y > 0.0,
                        "{thickness} {degrees}: {foot} {point}"
                    );
                }
            }
            for face in made.cells.faces.iter() {
                let [a, b] = [face.i, face.j].map(|i| side(&made.cells.points[i as usize]));
                if a.x.abs().max(b.x.abs()) < 0.5 - dx && a.y.abs().min(b.y.abs()) < 2.0 * dx {
                    assert!(a.y * b.y > 0.0, "{thickness} {degrees}: {a} {b}");
                }
            }
        }
    }
}

#[test]
fn corners_of_endless_walls_leave_the_gas_that_is_above_them() {
    let mut duct = domain([-1.0, 0.0], [2.0, 2.0]);
    duct.sides[1][0] = Side::Body;
    let dx = 1.0 / 16.0;
    let slope = f64::to_radians(20.0).tan();
    let ramp: Arc<dyn Shape<2>> = Arc::new(bodies::compression_corner(0.03, 20.0).unwrap());
    for disorder in [0.0, 0.25] {
        let scene = Scene::new(duct.clone(), vec![ramp.clone()], dx).disordered(disorder);
        let made = scene.made();
        let exact = 6.0 - 0.5 * 1.97 * 1.97 * slope;
        assert!(made.cells.open < 1e-12);
        assert!((made.volume() - exact).abs() < 1e-6 * dx * dx);
        let [area, _] = made.wall_area(&scene.solids);
        assert!((area - 1.03 - 1.97 * (1.0 + slope * slope).sqrt()).abs() < 1e-7);
    }
    let mut lower = domain([-1.0, -1.0], [2.0, 2.0]);
    lower.sides[1][0] = Side::Body;
    let fall: Arc<dyn Shape<2>> = Arc::new(bodies::expansion_corner(0.03, 20.0).unwrap());
    let made = Scene::new(lower, vec![fall], dx).made();
    let exact = 6.0 + 0.5 * 1.97 * 1.97 * slope;
    assert!((made.volume() - exact).abs() < 1e-6 * dx * dx);
    // Both walls of the cell at the corner are there, each with its own normal.
    let corner = made
        .cells
        .walls
        .iter()
        .filter(|wall| (wall.foot.x - 0.03).abs() < dx);
    let flat = corner.filter(|wall| wall.area.x.abs() < 1e-9 && wall.area.y < 0.0);
    assert!(flat.count() >= 1);
}
