//! The bodies on which packings are measured, with what is asked of each. Lengths in spacings.
#![allow(dead_code, reason = "each user takes some of them")]

use std::error::Error;

use aero_geometry::bodies::{Capsule, biconvex, circle, polygon, rectangle, sphere};
use aero_geometry::{Mesh, Outline, Placement, Revolution, Shape, Vector};

/// Facets around the axis of the tessellated capsule: 50 thousand facets in all.
pub const AROUND: usize = 200;

/// What is asked of a packing, in the units of its report.
#[derive(Clone, Copy, Debug)]
pub struct Aim {
    /// Largest standard deviation of the density summed over both sides, per cent.
    pub std: f64,
    /// Largest deviation of the same, per cent.
    pub max: f64,
    /// Smallest gap, in spacings.
    pub gap: f64,
}

const fn aim(std: f64) -> Aim {
    Aim {
        std,
        max: f64::INFINITY,
        gap: 0.7,
    }
}

/// A body in the plane.
pub struct Plane {
    pub name: &'static str,
    pub shape: Outline,
    pub aim: Aim,
}

/// A body in space.
pub struct Solid {
    pub name: &'static str,
    pub shape: Box<dyn Shape<3>>,
    pub spacing: f64,
    pub aim: Aim,
}

pub fn planes() -> Result<Vec<Plane>, Box<dyn Error>> {
    let plane = |name, shape, aim| Plane { name, shape, aim };
    let points =
        |list: &[[f64; 2]]| -> Vec<Vector<2>> { list.iter().map(|&p| Vector::from(p)).collect() };
    let re_entrant = [
        [0.0, 0.0],
        [40.0, 0.0],
        [40.0, 20.0],
        [20.0, 20.0],
        [20.0, 40.0],
        [0.0, 40.0],
    ];
    let tips = Aim {
        max: 1.0,
        gap: 0.5,
        ..aim(0.3)
    };
    Ok(vec![
        plane("circle, R = 10", circle(10.0)?, aim(0.15)),
        plane("circle, R = 20", circle(20.0)?, aim(0.12)),
        plane("biconvex, c = 80", biconvex(80.0, 0.1)?, tips),
        plane("square, 20", rectangle(20.0, 20.0, 0.0)?, aim(0.09)),
        plane("square, 20.37", rectangle(20.37, 20.37, 0.0)?, aim(0.25)),
        plane("re-entrant L, 40", polygon(&points(&re_entrant))?, aim(0.2)),
        plane("plate, 40 by 2", rectangle(40.0, 2.0, 0.0)?, aim(0.18)),
    ])
}

/// The Apollo capsule and its tessellation.
pub fn capsule() -> Result<(Revolution, Mesh), Box<dyn Error>> {
    let exact = Capsule::apollo().body()?;
    let mesh = Mesh::from_facets(exact.tessellate(AROUND))?;
    Ok((exact, mesh))
}

/// Spacing at which the capsule's radius is 20.
pub fn capsule_spacing() -> f64 {
    Capsule::apollo().radius / 20.0
}

pub fn solids() -> Result<Vec<Solid>, Box<dyn Error>> {
    let (exact, mesh) = capsule()?;
    let solid = |name, shape, spacing, aim| Solid {
        name,
        shape,
        spacing,
        aim,
    };
    Ok(vec![
        solid(
            "sphere, R = 20",
            Box::new(sphere(20.0)?) as Box<dyn Shape<3>>,
            1.0,
            aim(0.05),
        ),
        solid(
            "capsule, l1 = 20",
            Box::new(exact),
            capsule_spacing(),
            aim(0.3),
        ),
        solid("capsule, STL", Box::new(mesh), capsule_spacing(), aim(0.22)),
    ])
}

/// The same outline turned and moved, so that nothing of it lies along the lattice.
pub fn off_lattice(shape: &Outline) -> Outline {
    let placement = Placement::default()
        .rotated(17_f64.to_radians())
        .moved([0.31, 0.17].into());
    shape.placed(&placement)
}
