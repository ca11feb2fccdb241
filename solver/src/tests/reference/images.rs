//! What lies beyond symmetry planes and periodic sides: every combination of one map per axis.

use aero_geometry::Vector;

use super::{Matrix, Point};

/// `x' = sign x + shift` on one axis.
pub type Map = (f64, f64);

/// All images of `points` by the maps of each axis.
pub fn images<const D: usize>(maps: &[Vec<Map>; D], points: &[Point<D>]) -> Vec<Point<D>> {
    let mut combinations: Vec<[Map; D]> = vec![[(1.0, 0.0); D]];
    for axis in 0..D {
        let without = combinations.clone();
        for &map in &maps[axis] {
            combinations.extend(without.iter().map(|combination| {
                let mut combination = *combination;
                combination[axis] = map;
                combination
            }));
        }
    }
    combinations[1..]
        .iter()
        .flat_map(|maps| points.iter().map(|point| image(point, maps)))
        .collect()
}

fn image<const D: usize>(point: &Point<D>, maps: &[Map; D]) -> Point<D> {
    let sign = Vector::<D>::from_fn(|k, _| maps[k].0);
    let shift = Vector::<D>::from_fn(|k, _| maps[k].1);
    let turned = |vector: &Vector<D>| vector.component_mul(&sign);
    let tensor = |matrix: &Matrix<D>| Matrix::from_fn(|a, b| sign[a] * sign[b] * matrix[(a, b)]);
    Point {
        position: turned(&point.position) + shift,
        velocity: turned(&point.velocity),
        strain: tensor(&point.strain),
        energy_slope: turned(&point.energy_slope),
        renormalisation: tensor(&point.renormalisation),
        density_gradient: turned(&point.density_gradient),
        shift: turned(&point.shift),
        ..*point
    }
}
