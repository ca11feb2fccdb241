//! What is too thin for the spacing is told or refused, with what keeps it.

use aero_geometry::{Mesh, Placed, Placement, Vector, bodies};
use aero_packer::{About, PackOptions, PackReport, pack};

use super::fins::Finned;

#[test]
fn a_fin_too_thin_for_the_spacing_is_told_and_an_edge_where_two_faces_meet_is_not() {
    let told = |report: &PackReport| -> Vec<String> {
        let thin = report.warnings.iter().filter(|w| w.about == About::Thin);
        thin.map(|w| w.text.clone()).collect()
    };
    let outline = |tip: f64| {
        let points = [
            [0.0, 0.0],
            [20.0, 0.0],
            [20.0, 9.0],
            [10.1, 9.0],
            [10.0 + tip, 20.0],
            [10.0 - tip, 20.0],
            [9.9, 9.0],
            [0.0, 9.0],
        ];
        let points: Vec<_> = points.iter().map(|&p| Vector::<2>::from(p)).collect();
        bodies::polygon(&points).unwrap()
    };
    for (tip, thickness) in [(0.1, "0.20"), (0.05, "0.10")] {
        let report = pack(&outline(tip), &PackOptions::new(1.0)).unwrap().report;
        let told = told(&report);
        assert!(told.len() == 1 && told[0].contains(thickness), "{told:?}");
    }
    let wedge = bodies::polygon(&[[0.0, 0.0], [40.0, -1.4], [40.0, 1.4]].map(Vector::<2>::from));
    let report = pack(&wedge.unwrap(), &PackOptions::new(1.0))
        .unwrap()
        .report;
    assert!(told(&report).is_empty(), "{report:?}");
    let cone = bodies::cone(3.0, 20.0).unwrap();
    let report = pack(&cone, &PackOptions::new(1.0)).unwrap().report;
    assert!(told(&report).is_empty(), "{report:?}");
    let block = bodies::cuboid([14.0, 10.0, 8.0]).unwrap();
    let fin = bodies::cuboid([7.3, 0.2, 9.0]).unwrap();
    let place = Placement::default().moved(Vector::<3>::new(1.2, 0.4, 6.1));
    let fin = Placed::new(fin, place);
    let report = pack(&Finned { block, fin }, &PackOptions::new(1.0))
        .unwrap()
        .report;
    assert!(told(&report)[0].contains("0.20"), "{report:?}");
}

/// A slab of a section with sharp edges, 60 long.
fn slab(thickness: f64) -> Mesh {
    let half = 0.5 * thickness;
    let section = [
        [0.0, 0.0],
        [7.2, -half],
        [52.8, -half],
        [60.0, 0.0],
        [52.8, half],
        [7.2, half],
    ];
    let at = |n: usize, z: f64| {
        let [x, y] = section[n % 6];
        Vector::<3>::new(x, y, z)
    };
    let mut facets = Vec::new();
    for n in 0..6 {
        let [a, b, c, d] = [at(n, 0.0), at(n + 1, 0.0), at(n + 1, 10.0), at(n, 10.0)];
        facets.extend([[a, b, c], [a, c, d]]);
    }
    for n in 1..5 {
        facets.push([at(0, 10.0), at(n, 10.0), at(n + 1, 10.0)]);
        facets.push([at(0, 0.0), at(n + 1, 0.0), at(n, 0.0)]);
    }
    Mesh::from_facets(facets).unwrap()
}

#[test]
fn sharp_edges_of_a_thin_slab_are_not_told_as_thin_parts_and_what_keeps_it_is_its_plate() {
    let report = pack(&slab(0.3), &PackOptions::new(1.0)).unwrap().report;
    assert!(report.warnings.is_empty(), "{report:?}");
    let error = pack(&slab(0.25), &PackOptions::new(1.0)).unwrap_err();
    assert!(error.to_string().contains("only 0.250 "), "{error}");
}

#[test]
fn a_body_too_thin_everywhere_is_refused_and_told_what_keeps_it() {
    let foil = bodies::cuboid([12.0, 12.0, 0.2]).unwrap();
    let error = pack(&foil, &PackOptions::new(1.0)).unwrap_err().to_string();
    assert!(error.contains("0.20"), "{error}");
    assert!(pack(&foil, &PackOptions::new(0.6)).is_ok());
}
