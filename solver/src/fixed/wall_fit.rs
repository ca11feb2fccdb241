//! How the pressure on walls rises along a surface.

use aero_geometry::Vector;
use aero_geometry::kernel::{QuinticSpline, SUPPORT};

use super::pieces::Nearby;
use super::state::dot;
use super::walls::Wall;
use crate::panels::fit::Fit;
use crate::problem::{Domain, Side};

/// Cosine below which walls face another way.
const ASKEW: f64 = 0.7;

/// Walls that are smaller than this part of another tell it nothing: beside an edge they belong to cells around it, and how the pressure rises
/// to them is no matter of the surface.
const SLIVER: f64 = 0.1;

/// The walls of all cells, and their mirror images behind planes of symmetry: next to one, where a nose is, pressure has its crest, and what walls
/// on one side of it alone say would carry it on up.
pub struct Around<'a, const D: usize> {
    nearby: &'a Nearby<'a, D>,
    /// Axes and places of the planes of symmetry, or of the axis.
    planes: Vec<(usize, f64)>,
}

/// What a mirror, or some of them, makes of places.
#[derive(Clone)]
struct Mirrored<const D: usize> {
    sign: Vector<D>,
    shift: Vector<D>,
}

impl<const D: usize> Mirrored<D> {
    fn place(&self, place: &Vector<D>) -> Vector<D> {
        self.sign.component_mul(place) + self.shift
    }
}

impl<'a, const D: usize> Around<'a, D> {
    /// In `domain`.
    pub fn new(nearby: &'a Nearby<'a, D>, domain: &Domain<D>) -> Self {
        let ends = (0..D).flat_map(|axis| [0, 1].map(|end| (axis, end)));
        let is_mirror = |&(axis, end): &(usize, usize)| {
            matches!(domain.sides[axis][end], Side::Symmetry | Side::Axis)
        };
        let planes = ends.filter(is_mirror);
        Self {
            nearby,
            planes: planes
                .map(|(axis, end)| (axis, domain.face(axis, end)))
                .collect(),
        }
    }

    /// How the pressure on the walls around a `wall`, on the same smooth part of the surface, rises at its `middle`: it jumps where that bends.
    pub fn fit(&self, wall: &Wall<D>, middle: &Vector<D>) -> Fit<D> {
        let mut fit = Fit::new();
        let look = self.nearby.look();
        for mirrored in self.images(middle, look) {
            let normal = mirrored
                .sign
                .component_mul(&Vector::from(wall.image.normal));
            self.nearby
                .for_each(&mirrored.place(middle), look, |_, (other, pressure)| {
                    let arm = mirrored.place(&other.foot) - middle;
                    let kernel = QuinticSpline::<D>::value(arm.norm(), look / SUPPORT);
                    let facing = dot(&normal.into(), &other.image.normal);
                    let on_one = (other.owner, other.facet) == (wall.owner, wall.facet);
                    let is_sliver = other.image.size < SLIVER * wall.image.size;
                    if kernel > 0.0 && facing > ASKEW && on_one && !is_sliver {
                        fit.add(kernel * other.image.size, &arm, *pressure);
                    }
                });
        }
        fit
    }

    /// The walls as they are, and as those of the mirrors show them that are no farther than `look` from a place.
    fn images(&self, place: &Vector<D>, look: f64) -> Vec<Mirrored<D>> {
        let mut images = vec![Mirrored {
            sign: Vector::repeat(1.0),
            shift: Vector::zeros(),
        }];
        for &(axis, plane) in &self.planes {
            if (place[axis] - plane).abs() < look {
                for number in 0..images.len() {
                    let mut image = images[number].clone();
                    image.sign[axis] = -image.sign[axis];
                    image.shift[axis] = 2.0 * plane - image.shift[axis];
                    images.push(image);
                }
            }
        }
        images
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use aero_geometry::bodies;

    use super::*;
    use crate::fixed::FixedSimulation;
    use crate::fixed::tests::flows::stream;

    /// Pressure that falls along a circle on both sides of a plane through its nose, seen from a wall next to the plane.
    #[test]
    fn a_crest_on_a_plane_of_symmetry_is_seen_from_both_sides() {
        let circle = Arc::new(bodies::circle(0.5).expect("a circle"));
        let mut problem = stream(2.0, [[-1.0, 0.0], [1.0, 1.0]], 1.0 / 16.0, vec![circle]);
        problem.domain.sides[1][0] = Side::Symmetry;
        let flow = FixedSimulation::new(problem).expect("a flow");
        let fallen = |place: &Vector<2>| 1.0 - place[1] * place[1];
        let walls: Vec<_> = (flow.walls())
            .map(|(wall, _)| (wall, fallen(&wall.foot)))
            .collect();
        let nearby = Nearby::new(&walls, &flow.points, 1.0 / 16.0);
        let around = Around::new(&nearby, &flow.problem.domain);
        let noses = walls.iter().filter(|(wall, _)| wall.foot[0] < 0.0);
        let (nose, _) = (noses.min_by(|a, b| a.0.foot[1].total_cmp(&b.0.foot[1]))).expect("a nose");
        let [x, y] = nose.foot.into();
        let along = Vector::from([y, -x]) / x.hypot(y);
        let slope = around.fit(nose, &nose.foot).slope().dot(&along);
        let exact = -2.0 * y * along[1];
        assert!((slope / exact - 1.0).abs() < 0.1, "{slope} {exact}");
        // On the plane itself it does not rise at all.
        let crest = Vector::from([-0.5, 0.0]);
        let slope = around.fit(nose, &crest).slope();
        assert!(slope[1].abs() < 1e-3, "{slope}");
    }

    /// The sides of a block end a twenty-fifth of a cell into the cells around its corners.
    #[test]
    fn slivers_beside_an_edge_tell_nothing_of_how_the_pressure_rises() {
        let block = Arc::new(bodies::rectangle(0.63, 0.4, 0.0).expect("a block"));
        let problem = stream(2.0, [[-1.0, -1.0], [1.0, 1.0]], 1.0 / 16.0, vec![block]);
        let flow = FixedSimulation::new(problem).expect("a flow");
        let is_sliver = |wall: &Wall<2>| wall.image.size < 0.1 / 16.0;
        let walls: Vec<_> = (flow.walls())
            .map(|(wall, _)| (wall, if is_sliver(wall) { 2.0 } else { 1.0 }))
            .collect();
        let nearby = Nearby::new(&walls, &flow.points, 1.0 / 16.0);
        let around = Around::new(&nearby, &flow.problem.domain);
        let beside = |wall: &Wall<2>| {
            let near = |other: &Wall<2>| (other.foot - wall.foot).norm() < 0.75 / 16.0;
            walls
                .iter()
                .any(|(other, _)| is_sliver(other) && near(other))
        };
        let mut seen = 0;
        for (wall, _) in walls
            .iter()
            .filter(|(wall, _)| !is_sliver(wall) && beside(wall))
        {
            let slope = around.fit(wall, &wall.foot).slope();
            assert!(slope.norm() < 1e-9, "{slope} at {}", wall.foot);
            seen += 1;
        }
        assert!(seen > 3, "{seen}");
    }
}
