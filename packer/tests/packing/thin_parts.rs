//! Thin plates in the plane and in space are whole, whatever their thickness and angle.

use aero_geometry::{Bounds, Closest, Placed, Placement, Shape, Vector, bodies};
use aero_packer::{PackOptions, PackReport, Packing, pack};

pub fn turned(degrees: f64) -> Placement<3> {
    let axis = Vector::<3>::new(0.3, 0.9, 0.2);
    Placement::default()
        .rotated_about(&axis, degrees.to_radians())
        .unwrap()
        .moved(Vector::<3>::new(0.13, 0.27, 0.41) * (degrees / 17.0))
}

pub fn is_whole(name: &str, report: &PackReport) {
    assert!(
        report.volume_error_percent.abs() < 1.0,
        "{name}: {report:?}"
    );
    assert!(report.uncovered_area_percent <= 0.0, "{name}: {report:?}");
    assert!(report.hole_max < 1.25, "{name}: {report:?}");
    assert!(report.min_gap >= 0.5 - 1e-9, "{name}: {report:?}");
    assert_eq!(report.coincident_ghosts, 0, "{name}: {report:?}");
    assert!(report.warnings.is_empty(), "{name}: {report:?}");
}

#[test]
fn plates_of_any_thickness_are_whole_at_any_angle() {
    for tenths in 3..=30 {
        let thickness = f64::from(tenths) / 10.0;
        let plate = bodies::cuboid([16.3, 11.7, thickness]).unwrap();
        let angle = [0.0, 17.0, 45.0][tenths as usize % 3];
        let packing = pack(&Placed::new(plate, turned(angle)), &PackOptions::new(1.0)).unwrap();
        is_whole(&format!("{thickness} at {angle}"), &packing.report);
    }
}

/// A shape that does not tell what it is symmetric about.
#[derive(Debug)]
struct Untold<S: Shape<3>>(S);

impl<S: Shape<3>> Shape<3> for Untold<S> {
    fn bounds(&self) -> Bounds<3> {
        self.0.bounds()
    }

    fn closest(&self, point: &Vector<3>) -> Closest<3> {
        self.0.closest(point)
    }

    fn facets(&self, size: f64, region: &Bounds<3>) -> Vec<[Vector<3>; 3]> {
        self.0.facets(size, region)
    }

    fn measure(&self) -> Option<f64> {
        self.0.measure()
    }
}

#[test]
fn plates_are_whole_wherever_their_middle_lies_between_sites_of_the_lattice() {
    let tenths = (3..=30).map(|tenths| 0.1 * f64::from(tenths));
    for thickness in tenths.chain([1.87, 3.75, 4.0]) {
        for height in [0.0, 0.25, 0.5] {
            let plate = || bodies::cuboid([8.0, thickness, 8.3]).unwrap();
            let shapes: [&dyn Shape<3>; 2] = [&plate(), &Untold(plate())];
            for (shape, told) in shapes.iter().zip(["told", "untold"]) {
                let mut options = PackOptions::new(1.0);
                options.anchor = Vector::<3>::new(0.0, height, 0.0);
                let packing = pack(*shape, &options).unwrap();
                let name = format!("{thickness}, sites {height} below, symmetry {told}");
                is_whole(&name, &packing.report);
            }
        }
    }
}

/// Cells that a mirror plane halves count for one half.
#[test]
fn bodies_whose_mirror_planes_hold_sites_have_as_many_ghosts_as_others() {
    let count = |shape: &dyn Shape<3>, height: f64| {
        let mut options = PackOptions::new(1.0);
        options.anchor = Vector::<3>::new(0.0, height, 0.0);
        pack(shape, &options).unwrap().report
    };
    let bodies: [&dyn Shape<3>; 3] = [
        &bodies::sphere(6.0).unwrap(),
        &bodies::cuboid([15.0; 3]).unwrap(),
        &bodies::cone(15.0, 20.0).unwrap(),
    ];
    for shape in bodies {
        let (between, on) = (count(shape, 0.0), count(shape, 0.5));
        let more = on.ghosts as f64 / between.ghosts as f64 - 1.0;
        assert!(more.abs() < 0.01, "{between:?} {on:?}");
        assert!(on.volume_error_percent.abs() < 1.0, "{on:?}");
        assert!(on.density_std_percent < 0.5, "{on:?}");
    }
}

#[test]
fn plates_in_the_plane_are_whole_at_any_angle() {
    for tenths in 3..=30 {
        let thickness = f64::from(tenths) / 10.0;
        let plate = bodies::rectangle(16.3, thickness, 0.0).unwrap();
        for angle in [0.0, 17.0, 45.0_f64] {
            let place = Placement::default().rotated(angle.to_radians());
            let place = place.moved(Vector::<2>::new(0.13, 0.27) * (angle / 17.0));
            let packing = pack(&Placed::new(plate.clone(), place), &PackOptions::new(1.0)).unwrap();
            is_whole(&format!("{thickness} at {angle}"), &packing.report);
        }
    }
}

/// The heaviest ghost: a row a spacing and a half thick, its ghosts a little farther apart than a spacing.
const HEAVIEST: f64 = 1.65;

#[test]
fn sections_with_sharp_edges_in_the_plane_keep_their_volume_and_no_ghost_stands_for_two() {
    let corners = |points: &[[f64; 2]]| {
        let points: Vec<_> = points.iter().map(|&p| Vector::<2>::from(p)).collect();
        bodies::polygon(&points).unwrap()
    };
    let mut sections = vec![
        ("biconvex".to_owned(), bodies::biconvex(160.0, 0.1).unwrap()),
        (
            "double wedge".to_owned(),
            corners(&[[0.0, 0.0], [50.0, -8.8], [100.0, 0.0], [50.0, 8.8]]),
        ),
    ];
    for thickness in [0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 6.0] {
        let lens = bodies::biconvex(40.0, thickness / 40.0).unwrap();
        sections.push((format!("lens {thickness}"), lens));
    }
    for angle in [4.0, 10.0, 20.0, 30.0, 45.0_f64] {
        let half = 40.0 * (0.5 * angle).to_radians().tan();
        let wedge = corners(&[[0.0, 0.0], [40.0, -half], [40.0, half]]);
        sections.push((format!("wedge {angle}"), wedge));
    }
    for (name, section) in sections {
        for angle in [0.0, 11.0_f64] {
            let place = Placement::default().rotated(angle.to_radians());
            let packing = pack(&Placed::new(section.clone(), place), &PackOptions::new(1.0));
            let Packing { ghosts, report, .. } = packing.unwrap();
            let name = format!("{name} at {angle}");
            is_whole(&name, &report);
            let heaviest = ghosts.volume.iter().fold(0.0, |a: f64, &b| a.max(b));
            assert!(heaviest < HEAVIEST, "{name}: a ghost of {heaviest}");
            assert!(report.density_max_percent < 3.0, "{name}: {report:?}");
        }
    }
}

#[test]
fn a_plate_thinner_than_a_spacing_and_a_half_has_one_row_of_its_thickness() {
    for thickness in [0.4, 1.0, 1.4] {
        let plate = bodies::cuboid([12.0, 12.0, thickness]).unwrap();
        let ghosts = pack(&plate, &PackOptions::new(1.0)).unwrap().ghosts;
        assert!(ghosts.position.iter().all(|p| p[2].abs() < 1e-2));
        let mean = ghosts.volume.iter().sum::<f64>() / ghosts.volume.len() as f64;
        assert!(
            (mean / thickness - 1.0).abs() < 0.1,
            "{mean} for {thickness}"
        );
    }
}

#[test]
fn a_plate_thicker_than_a_spacing_and_a_half_has_two_rows_at_its_quarters() {
    let plate = bodies::cuboid([12.0, 12.0, 1.6]).unwrap();
    let ghosts = pack(&plate, &PackOptions::new(1.0)).unwrap().ghosts;
    assert!(
        ghosts
            .position
            .iter()
            .all(|p| (p[2].abs() - 0.4).abs() < 0.05)
    );
}

#[test]
fn plates_along_the_lattice_that_end_between_its_sites_keep_their_volume() {
    for sides in [[10.3, 8.7], [12.0, 12.0], [30.0, 5.5]] {
        for tenths in 20..=28 {
            let thickness = f64::from(tenths) / 10.0;
            let plate = bodies::cuboid([sides[0], sides[1], thickness]).unwrap();
            let packing = pack(&plate, &PackOptions::new(1.0)).unwrap();
            is_whole(&format!("{sides:?} by {thickness}"), &packing.report);
        }
    }
}

#[test]
fn plates_that_the_region_cuts_off_keep_their_volume_inside_of_it() {
    for thickness in [1.0, 2.0, 2.5, 3.0, 4.0, 12.0] {
        for degrees in [-5.0, -30.0_f64] {
            let axis = Vector::<3>::z();
            let place = Placement::default().rotated_about(&axis, degrees.to_radians());
            let plate = bodies::cuboid([24.0, thickness, 40.0]).unwrap();
            let mut options = PackOptions::new(1.0);
            let (low, high) = (Vector::<3>::new(-20.0, -20.0, 0.0), 20.0);
            let high = Vector::<3>::new(high, high, 4.0);
            options.region = Some(Bounds::new(low, high));
            let Packing { ghosts, report, .. } =
                pack(&Placed::new(plate, place.unwrap()), &options).unwrap();
            let name = format!("{thickness} at {degrees}");
            is_whole(&name, &report);
            if thickness < 5.0 {
                let volume: f64 = ghosts.volume.iter().sum();
                let off = volume / (96.0 * thickness) - 1.0;
                assert!(off.abs() < 0.05, "{name}: {off}");
            }
        }
    }
}
