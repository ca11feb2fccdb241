//! Distances, signs, normals and symmetry of the two-dimensional bodies.

mod bodies;
mod properties;
mod symmetry;

use std::f64::consts::{PI, TAU};

use aero_geometry::Vector;
use aero_geometry::bodies::{
    Nozzle, biconvex, blunt_wedge, circle, compression_corner, expansion_corner, forward_step,
    polygon, rectangle, wall,
};
use aero_geometry::outline::Outline;

/// Number of the last smooth face.
fn last_face(outline: &Outline) -> u32 {
    let faces = (0..outline.pieces().len()).map(|piece| outline.face(piece));
    faces.max().expect("an outline has pieces")
}

fn at(x: f64, y: f64) -> Vector<2> {
    Vector::<2>::new(x, y)
}

/// One of each body, about two units in size, near the origin.
fn bodies() -> Vec<Outline> {
    let star = (0..10)
        .map(|k| {
            (1.0 - 0.6 * f64::from(k % 2))
                * at(
                    (f64::from(k) * PI / 5.0).cos(),
                    (f64::from(k) * PI / 5.0).sin(),
                )
        })
        .collect::<Vec<_>>();
    let wavy = (0..300)
        .map(|k| {
            let angle = TAU * f64::from(k) / 300.0;
            (1.0 + 0.3 * (5.0 * angle).cos()) * at(angle.cos(), angle.sin())
        })
        .collect::<Vec<_>>();
    vec![
        wall(0.2).unwrap(),
        compression_corner(0.0, 20.0).unwrap(),
        expansion_corner(-0.3, 35.0).unwrap(),
        forward_step(0.1, 0.7).unwrap(),
        biconvex(2.0, 0.1).unwrap(),
        Nozzle::back().walls().unwrap(),
        Nozzle::back().upper_wall().unwrap(),
        circle(0.8).unwrap(),
        blunt_wedge(0.5, 14.04, 2.0).unwrap(),
        blunt_wedge(0.5, 14.04, f64::INFINITY).unwrap(),
        rectangle(2.0, 1.0, 0.0).unwrap(),
        rectangle(1.0, 2.0, 0.1).unwrap(),
        polygon(&star).unwrap(),
        polygon(&wavy).unwrap(),
    ]
}
