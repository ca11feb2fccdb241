use aero_geometry::{Placed, Placement, bodies};

use super::*;

fn boxed() -> Domain<3> {
    domain([-1.0; 3], [1.0; 3])
}

fn turned(edges: [f64; 3]) -> Arc<dyn Shape<3>> {
    let place = Placement::default()
        .rotated_xyz([0.1, 0.2, 0.3])
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
            let scene = Scene::new(boxed(), vec![shape], dx).disordered(disorder);
            let start = std::time::Instant::now();
            let made = scene.made();
            let [area, along] = made.wall_area(&scene.solids);
            println!(
                "{name} {disorder}: points {}, {:?}, open {:.1e}, volume {:.2e} dx3, area {area:.5} {along:.5}, least {:.3}, {:.0} ms",
                made.cells.points.len(),
                made.findings,
                made.open(false),
                (made.volume() - exact) / dx / dx / dx,
                made.cells
                    .volumes
                    .iter()
                    .fold(1.0_f64, |a, v| a.min(v / dx / dx / dx)),
                start.elapsed().as_secs_f64() * 1e3,
            );
            let [exact_area] = [0.0];
            let _ = exact_area;
        }
    }
}
