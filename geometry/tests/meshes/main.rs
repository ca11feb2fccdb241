//! Bodies made of triangles: distances against exact bodies, repairs, and refusals.

mod assemblies;
mod distances;
mod mended;
mod parts;
mod properties;
mod refusals;
mod repairs;
mod touching;

use aero_geometry::stl::Facet;
use aero_geometry::{Mesh, Vector};

fn at(x: f64, y: f64, z: f64) -> Vector<3> {
    Vector::<3>::new(x, y, z)
}

/// The twelve triangles of a box.
fn block(low: [f64; 3], high: [f64; 3]) -> Vec<Facet> {
    let corner = |k: usize| {
        let pick = |axis: usize| {
            if k >> axis & 1 == 1 {
                high[axis]
            } else {
                low[axis]
            }
        };
        at(pick(0), pick(1), pick(2))
    };
    let quads = [
        [0, 4, 6, 2],
        [1, 3, 7, 5],
        [0, 1, 5, 4],
        [2, 6, 7, 3],
        [0, 2, 3, 1],
        [4, 5, 7, 6],
    ];
    quads
        .iter()
        .flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]])
        .map(|facet| facet.map(corner))
        .collect()
}

fn unit_block() -> Vec<Facet> {
    block([-0.5; 3], [0.5; 3])
}

fn shifted(facets: Vec<Facet>, offset: Vector<3>) -> Vec<Facet> {
    facets.into_iter().map(|f| f.map(|v| v + offset)).collect()
}

fn flipped(facets: Vec<Facet>) -> Vec<Facet> {
    facets.into_iter().map(|[a, b, c]| [a, c, b]).collect()
}

/// A prism between `z = 0` and `1` over a polygon that is seen whole from its first corner.
fn prism(polygon: &[[f64; 2]]) -> Vec<Facet> {
    let count = polygon.len();
    let point = |k: usize, z: f64| at(polygon[k % count][0], polygon[k % count][1], z);
    let mut facets = Vec::new();
    for k in 0..count {
        let (a, b) = (point(k, 0.0), point(k + 1, 0.0));
        let (c, d) = (point(k + 1, 1.0), point(k, 1.0));
        facets.extend([[a, b, c], [a, c, d]]);
    }
    for k in 1..count - 1 {
        facets.push([point(0, 1.0), point(k, 1.0), point(k + 1, 1.0)]);
        facets.push([point(0, 0.0), point(k + 1, 0.0), point(k, 0.0)]);
    }
    facets
}

fn mesh(facets: Vec<Facet>) -> Mesh {
    Mesh::from_facets(facets).unwrap_or_else(|error| panic!("{error}"))
}

fn refusal(facets: Vec<Facet>) -> String {
    match Mesh::from_facets(facets) {
        Ok(mesh) => panic!("was read: {:?}", mesh.repairs()),
        Err(error) => error.to_string(),
    }
}
