//! Fins, needles and tips are whole to their ends, whatever their thickness and angle.

use std::f64::consts::PI;

use aero_geometry::outline::Piece;
use aero_geometry::{Bounds, Closest, Mesh, Placed, Placement, Revolution, Shape, Vector, bodies};
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

/// A rocket 0.1 across with four swept fins of 5 mm, 0.5 m of it: five closed parts that overlap, as CAD exports them.
fn rocket() -> Mesh {
    let profile = [
        [0.0, 0.0],
        [0.08, 0.03],
        [0.2, 0.05],
        [0.5, 0.05],
        [0.5, 0.0],
    ];
    let sides = profile.windows(2).map(|ends| {
        let [a, b] = [ends[0], ends[1]].map(Vector::<2>::from);
        Piece::segment(a, b)
    });
    let mut facets = Revolution::new(sides.collect()).unwrap().tessellate(48);
    let fin = [[0.2, 0.04], [0.5, 0.04], [0.5, 0.15], [0.35, 0.15]];
    for quarter in 0..4 {
        let (sine, cosine) = (0.5 * PI * f64::from(quarter)).sin_cos();
        let corner = |n: usize, across: f64| {
            let [x, r] = fin[n % 4];
            Vector::<3>::new(x, r * cosine - across * sine, r * sine + across * cosine)
        };
        let (low, high) = (-0.0025, 0.0025);
        for n in 0..4 {
            let [a, b] = [corner(n, low), corner(n + 1, low)];
            let [c, d] = [corner(n + 1, high), corner(n, high)];
            facets.extend([[a, b, c], [a, c, d]]);
        }
        for n in 1..3 {
            facets.push([corner(0, high), corner(n, high), corner(n + 1, high)]);
            facets.push([corner(0, low), corner(n + 1, low), corner(n, low)]);
        }
    }
    Mesh::from_facets(facets).unwrap()
}

#[test]
fn the_fins_of_a_rocket_are_whole_and_alike_from_coarse_to_fine() {
    let rocket = rocket();
    for spacing in [0.013, 0.006, 0.004] {
        let Packing { ghosts, report, .. } = pack(&rocket, &PackOptions::new(spacing)).unwrap();
        is_whole(&format!("spacing {spacing}"), &report);
        // Each beyond the tube, which is round to within its sides.
        let mut fins = [0.0; 4];
        for (place, volume) in ghosts.position.iter().zip(&ghosts.volume) {
            let across = [place.y, place.z].map(f64::abs);
            if across[0].max(across[1]) > 0.055 {
                let axis = usize::from(across[1] > across[0]);
                fins[2 * axis + usize::from(place[axis + 1] < 0.0)] += volume;
            }
        }
        // From there on 0.2795 long at its root, 0.15 at its tip; ghosts count as wholes.
        let exact = 0.005 * 0.095 * 0.5 * (0.279_545 + 0.15);
        for fin in fins {
            let off = fin / exact - 1.0;
            assert!(
                off.abs() < 0.5 * spacing / 0.095,
                "spacing {spacing}: {fins:?}, {exact}"
            );
        }
        // Two planes are mirrors of the body; what lies on the lattice is another matter from one of them to the other.
        for [fin, image] in [[fins[0], fins[1]], [fins[2], fins[3]]] {
            assert!((fin / image - 1.0).abs() < 1e-12, "{fins:?}");
        }
        assert!((fins[0] / fins[2] - 1.0).abs() < 0.02, "{fins:?}");
    }
}
