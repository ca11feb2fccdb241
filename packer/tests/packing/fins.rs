//! Fins, needles and tips are whole to their ends, whatever their thickness and angle.

use aero_geometry::{Bounds, Closest, Mesh, Placed, Placement, Shape, Vector, bodies};
use aero_packer::{PackOptions, Packing, pack};

use super::thin_parts::{is_whole, turned};

#[test]
fn fins_on_a_body_in_the_plane_are_whole() {
    for tenths in 3..=30 {
        let half = 0.05 * f64::from(tenths);
        let outline = [
            [0.0, 0.0],
            [40.0, 0.0],
            [40.0, 10.0],
            [20.0 + half, 10.0],
            [20.0 + half, 22.2],
            [20.0 - half, 22.2],
            [20.0 - half, 10.0],
            [0.0, 10.0],
        ];
        let points: Vec<_> = outline.iter().map(|&p| Vector::<2>::from(p)).collect();
        let finned = bodies::polygon(&points).unwrap();
        for angle in [0.0, 17.0_f64] {
            let place = Placement::default().rotated(angle.to_radians());
            let packing = pack(&Placed::new(finned.clone(), place), &PackOptions::new(1.0));
            let Packing { ghosts, report, .. } = packing.unwrap();
            let name = format!("fin of {} at {angle}", 2.0 * half);
            is_whole(&name, &report);
            // Above the block there is the fin alone.
            let up = Vector::<2>::new(-angle.to_radians().sin(), angle.to_radians().cos());
            let on_fin = (0..ghosts.volume.len()).filter(|&n| ghosts.position[n].dot(&up) > 12.0);
            let volume: f64 = on_fin.map(|n| ghosts.volume[n]).sum();
            assert!(
                (volume - 20.4 * half).abs() < 2.0 * half,
                "{name}: {volume}"
            );
        }
    }
}

#[derive(Debug)]
pub struct Finned<F: Shape<3>> {
    pub block: bodies::Cuboid,
    pub fin: F,
}

impl<F: Shape<3>> Shape<3> for Finned<F> {
    fn bounds(&self) -> Bounds<3> {
        let (a, b) = (self.block.bounds(), self.fin.bounds());
        Bounds::new(a.min.inf(&b.min), a.max.sup(&b.max))
    }

    fn closest(&self, point: &Vector<3>) -> Closest<3> {
        // Of the union: exact outside, and inside as far as one of the two goes.
        let (a, b) = (self.block.closest(point), self.fin.closest(point));
        if a.distance <= b.distance { a } else { b }
    }

    fn facets(&self, size: f64, region: &Bounds<3>) -> Vec<[Vector<3>; 3]> {
        let mut facets = self.block.facets(size, region);
        facets.extend(self.fin.facets(size, region));
        facets
    }
}

#[test]
fn fins_on_a_body_are_whole() {
    for tenths in 3..=30 {
        let thickness = f64::from(tenths) / 10.0;
        let block = bodies::cuboid([14.0, 10.0, 8.0]).unwrap();
        let fin = bodies::cuboid([7.3, thickness, 9.0]).unwrap();
        let place = Placement::default().moved(Vector::<3>::new(1.2, 0.4, 6.1));
        let finned = Finned {
            block,
            fin: Placed::new(fin, place),
        };
        let Packing { ghosts, report, .. } = pack(&finned, &PackOptions::new(1.0)).unwrap();
        is_whole(&format!("fin of {thickness}"), &report);
        // Above the block there is the fin alone; one ghost at the root stands for what is on either side of it.
        let on_fin = (0..ghosts.volume.len()).filter(|&n| ghosts.position[n][2] > 4.0);
        let volume: f64 = on_fin.map(|n| ghosts.volume[n]).sum();
        let exact = 7.3 * thickness * 6.6;
        assert!(
            (volume - exact).abs() < 0.5 * 7.3 * thickness,
            "{thickness}: {volume} for {exact}"
        );
    }
}

/// The wall layer of the block, whose level runs on into the fin, must not creep up it.
#[test]
fn the_density_on_fins_and_at_their_roots_and_ends_is_right() {
    for (thickness, angle) in [
        (0.5, 20.0),
        (1.0, 20.0),
        (1.4, 0.0),
        (1.4, 20.0),
        (1.4, 45.0),
    ] {
        let block = bodies::cuboid([20.0, 12.0, 10.0]).unwrap();
        let fin = bodies::cuboid([10.0, thickness, 9.0]).unwrap();
        let place = Placement::default().moved(Vector::<3>::new(-1.0, 0.13, 8.5));
        let mut facets = Vec::new();
        for solid in [&block as &dyn Shape<3>, &Placed::new(fin, place)] {
            facets.extend(solid.facets(f64::INFINITY, &solid.bounds()));
        }
        let finned = Placed::new(Mesh::from_facets(facets).unwrap(), turned(angle));
        let report = pack(&finned, &PackOptions::new(1.0)).unwrap().report;
        is_whole(&format!("fin of {thickness} at {angle}"), &report);
        assert!(
            report.density_max_percent < 2.0,
            "{thickness} at {angle}: {report:?}"
        );
    }
}

#[test]
fn needles_and_tips_are_covered_to_their_ends_and_rims() {
    for (angle, length) in [(5.0, 20.0), (15.0, 20.0), (30.0, 20.0), (60.0, 8.0)] {
        let cone = bodies::cone(angle, length).unwrap();
        let report = pack(&cone, &PackOptions::new(1.0)).unwrap().report;
        assert!(report.uncovered_area_percent <= 0.0, "{angle}: {report:?}");
        assert!(report.min_gap >= 0.5 - 1e-9, "{angle}: {report:?}");
    }
}
