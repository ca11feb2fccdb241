use aero_geometry::bodies;

use super::super::carry::shares;
use super::super::cloud::NOBODY;
use super::super::refine::{Adaption, BodyNeeds, Wish};
use super::super::site::Site;
use super::*;

/// Splits the cells around a place, `most` times.
pub(super) fn around<const D: usize>(
    scene: &Scene<D>,
    place: Vector<D>,
    most: u8,
    around: i32,
) -> Levels<D> {
    let mut levels = Levels::on(&scene.plot());
    for _ in 0..most {
        let cloud = Cloud::lattice(&scene.plot(), &levels, 0.0);
        let wishes: Vec<Wish> = cloud
            .places
            .iter()
            .map(|p| {
                if (p.position - place).norm() < 1.5 * p.spacing {
                    Wish::Split
                } else {
                    Wish::Keep
                }
            })
            .collect();
        levels = Adaption { most, around }.heard(&cloud, &levels, &Levels::default(), &wishes);
    }
    levels
}

#[test]
fn split_cells_close_and_fill_the_gas() {
    let square = domain([-1.0, -1.0], [1.0, 1.0]);
    let body: Arc<dyn Shape<2>> = Arc::new(bodies::circle(0.3).unwrap());
    let scene = Scene::new(square, vec![body], 0.125);
    let levels = around(&scene, Vector::<2>::new(-0.4, 0.1), 3, 2);
    let made = scene.made_with(&levels);
    let finest = made
        .cloud
        .places
        .iter()
        .fold(1.0_f64, |a, p| a.min(p.spacing));
    assert_eq!(finest, 0.125 / 8.0);
    assert!(made.cells.open < 1e-12 && made.open(false) < 1e-12);
    let exact = 4.0 - scene.solids.shape(0).measure().unwrap();
    assert!((made.volume() - exact).abs() < 0.25 * 0.125 * 0.125);

    let cube = domain([-1.0; 3], [1.0; 3]);
    let scene = Scene::new(cube, Vec::new(), 0.25);
    let levels = around(&scene, Vector::<3>::new(-0.4, 0.1, 0.2), 2, 1);
    let made = scene.made_with(&levels);
    assert!(made.cells.open < 1e-12 && made.open(false) < 1e-12);
    assert!((made.volume() - 8.0).abs() < 1e-12);
}

#[test]
fn what_is_carried_to_new_cells_is_neither_lost_nor_disturbed() {
    let scene = Scene::new(domain([-1.0, -1.0], [1.0, 1.0]), Vec::new(), 0.125);
    let before = around(&scene, Vector::<2>::new(-0.4, 0.1), 2, 2);
    let after = around(&scene, Vector::<2>::new(0.1, 0.1), 2, 2);
    let [old, new] = [&before, &after].map(|levels| scene.made_with(levels));
    let field = |p: &Vector<2>| 1.0 + (3.0 * p.x).sin() * p.y;
    let states: Vec<f64> = old.cells.points.iter().map(field).collect();
    let parts = shares(
        &scene.plot(),
        &old.cloud,
        &new.cloud,
        &vec![NOBODY; new.cloud.places.len()],
    );
    let total = |cells: &Cells<2>, states: &[f64]| -> f64 {
        cells.volumes.iter().zip(states).map(|(v, q)| v * q).sum()
    };
    let carried: Vec<f64> = parts
        .iter()
        .map(|shares| {
            shares
                .iter()
                .map(|&(from, part)| part * states[from as usize])
                .sum()
        })
        .collect();
    let lost = total(&old.cells, &states) - total(&new.cells, &carried);
    assert!(lost.abs() < 1e-12, "{lost:e}");
    let sums = parts
        .iter()
        .map(|shares| shares.iter().map(|s| s.1).sum::<f64>());
    assert!(sums.into_iter().all(|sum| (sum - 1.0).abs() < 1e-13));
}

#[test]
fn cells_that_nobody_needs_are_joined_again() {
    let scene = Scene::new(domain([-1.0, -1.0], [1.0, 1.0]), Vec::new(), 0.125);
    let mut levels = around(&scene, Vector::<2>::new(-0.4, 0.1), 2, 2);
    let adaption = Adaption { most: 2, around: 2 };
    for _ in 0..4 {
        let cloud = Cloud::lattice(&scene.plot(), &levels, 0.0);
        let wishes = vec![Wish::Join; cloud.places.len()];
        levels = adaption.heard(&cloud, &levels, &Levels::default(), &wishes);
    }
    assert_eq!(levels.len(), 0);
}

#[test]
fn thin_parts_and_noses_ask_for_points() {
    let wedge: Arc<dyn Shape<2>> = Arc::new(bodies::rectangle(0.8, 0.06, 0.0).unwrap());
    let scene = Scene::new(domain([-1.0, -1.0], [1.0, 1.0]), vec![wedge], 0.125);
    let needs = BodyNeeds {
        most: 3,
        most_of_bends: 3,
        across: 4.0,
        radius: 4.0,
        reach: 2.0,
    };
    let levels = needs.levels(&scene.plot(), None).unwrap();
    let made = scene.made_with(&levels);
    let at_wall = made
        .cloud
        .places
        .iter()
        .filter(|p| p.distance < 0.5 * p.spacing);
    assert!(at_wall.into_iter().all(|p| p.spacing < 0.06));
    assert!(made.open(false) < 1e-12);
    let far = Site {
        level: 0,
        index: [0, 0],
    };
    assert!(!levels.is_split(&far));
}
