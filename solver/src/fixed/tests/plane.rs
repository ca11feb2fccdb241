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
                "{name} {disorder}: points {}, {:?}, open {:.1e}, volume {:.2e} dx2, area {area:.4} {along:.4}, least {:.3}",
                made.cells.points.len(),
                made.findings,
                made.open(false),
                (made.volume() - exact) / dx / dx,
                made.cells
                    .volumes
                    .iter()
                    .fold(1.0_f64, |a, v| a.min(v / dx / dx)),
            );
            assert!(
                made.findings.open < 1e-12 && made.open(false) < 1e-12,
                "{name}"
            );
            assert_eq!(made.findings.lost, 0, "{name}");
            assert!((made.volume() - exact).abs() < 0.25 * dx * dx, "{name}");
        }
    }
}
