//! What one wall presses beyond what the surface that belongs to it shows, and the next one as much less.
//!
//! Where planes half way between points cut a wall otherwise than nearness to its foot does the surface, a wall has more of it than it is large, and
//! its neighbour less. Under one pressure nothing is missing between them: shown each about its own foot, what is too much and what
//! is too little would stand side by side, at any spacing.

use aero_geometry::{Pencils, Vector};

use super::unshown::Left;

/// Cosine between the normals of walls that face alike.
const ALIKE: f64 = 0.99;

/// Takes from what is `left` of each wall what walls that face alike, no farther than `reach` from it, have too much of it, the nearest first. The
/// sum of all of an owner stays as it is.
pub fn cancel<const D: usize>(left: &mut [Left<'_, D>], reach: f64) {
    let feet: Vec<Vector<D>> = left.iter().map(|left| left.wall.foot).collect();
    let by_foot = Pencils::new(&feet, reach);
    let mut near = Vec::new();
    for own in 0..left.len() {
        let wall = left[own].wall;
        let normal = Vector::<D>::from(wall.image.normal);
        near.clear();
        by_foot.for_each_run_near(&wall.foot, &wall.foot, reach, |run| {
            near.extend(by_foot.order()[run].iter().filter_map(|&n| {
                let other = left[n as usize].wall;
                let away = (other.foot - wall.foot).norm();
                let is_alike = normal.dot(&Vector::from(other.image.normal)) > ALIKE;
                let counts = n as usize != own && other.owner == wall.owner;
                (counts && is_alike && away < reach).then_some((away, n as usize))
            }));
        });
        near.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        for &(_, other) in &near {
            let (force, against) = (left[own].force, left[other].force);
            let size = force.norm();
            if size > 0.0 && force.dot(&against) < 0.0 {
                let moved = force * (against.norm() / size).min(1.0);
                left[own].force -= moved;
                left[other].force += moved;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use aero_geometry::{Placed, Placement, Shape, bodies};

    use super::*;
    use crate::fixed::FixedSimulation;
    use crate::fixed::tests::flows::stream;
    use crate::problem::{Field, Initial, Side, State};

    const SPACING: f64 = 1.0 / 16.0;

    #[test]
    fn what_neighbours_have_too_much_of_is_taken_from_them_and_nothing_is_lost() {
        let plate: Arc<dyn Shape<2>> = Arc::new(bodies::rectangle(0.7, 0.02, 0.0).unwrap());
        let problem = stream(1.2, [[-1.0, -1.0], [1.0, 1.0]], SPACING, vec![plate]);
        let flow = FixedSimulation::new(problem).unwrap();
        let walls: Vec<_> = flow.walls().map(|(wall, _)| wall).collect();
        // Side by side below gas, and one right beneath them.
        let find = |side: f64, x: f64| {
            let on_side = |n: &usize| walls[*n].image.normal[1] * side > 0.9;
            let away = |n: &usize| (walls[*n].foot[0] - x).abs();
            let numbers = (0..walls.len()).filter(on_side);
            let nearest = numbers.min_by(|a, b| away(a).total_cmp(&away(b)));
            nearest.unwrap()
        };
        let (own, next) = (find(-1.0, 0.0), find(-1.0, SPACING));
        let beneath = find(1.0, 0.0);
        let after = |amounts: [(usize, f64); 2]| {
            let mut left: Vec<Left<'_, 2>> = walls
                .iter()
                .map(|&wall| Left {
                    wall,
                    force: Vector::zeros(),
                })
                .collect();
            for (n, amount) in amounts {
                left[n].force = Vector::from(walls[n].image.normal) * amount;
            }
            cancel(&mut left, 2.0 * SPACING);
            amounts.map(|(n, _)| left[n].force.dot(&Vector::from(walls[n].image.normal)))
        };
        assert_eq!(after([(own, 3.0), (next, -1.0)]), [2.0, 0.0]);
        assert_eq!(after([(own, -1.0), (next, 3.0)]), [0.0, 2.0]);
        assert_eq!(after([(own, 3.0), (next, 1.0)]), [3.0, 1.0]);
        assert_eq!(after([(own, 3.0), (beneath, -3.0)]), [3.0, -3.0]);
    }

    /// Gas at rest at twice the stream's pressure over a face that meets a mirror askew, as in a groove.
    #[test]
    fn a_face_askew_shows_an_even_pressure_evenly() {
        let block = bodies::cuboid([6.0, 6.0, 2.0]).unwrap();
        let place = Placement::default()
            .rotated_about(&Vector::x(), 0.56)
            .unwrap()
            .rotated_about(&Vector::y(), 0.3)
            .unwrap();
        let place = place.moved([0.0, 0.0, -1.2].into());
        let block: Arc<dyn Shape<3>> = Arc::new(Placed::new(block, place));
        let bounds = [[-1.0, 0.0, -1.0], [1.0, 1.0, 1.0]];
        let mut problem = stream(0.1, bounds, 1.0 / 8.0, vec![block]);
        problem.domain.sides[1][0] = Side::Symmetry;
        let pressure = 2.0 * problem.free_stream.pressure;
        problem.initial = Initial::Field(Field(Arc::new(move |_| State {
            density: 1.0,
            velocity: Vector::zeros(),
            pressure,
        })));
        let flow = FixedSimulation::new(problem).unwrap();
        let panels = flow.panels();
        let mut seen = 0;
        for (corners, shown) in panels.points.chunks(3).zip(&panels.pressure) {
            let [x, y, z] = [0, 1, 2].map(|k| corners.iter().map(|at| at[k]).sum::<f64>() / 3.0);
            // Cells are cut where the domain ends.
            if x.abs().max(y).max(z.abs()) < 1.0 - 2.0 / 8.0 && y > 0.0 {
                let off = shown / pressure - 1.0;
                assert!(off.abs() < 0.015, "{off:.3} at {x:.3} {y:.3} {z:.3}");
                seen += 1;
            }
        }
        assert!(seen > 50, "{seen}");
    }
}
