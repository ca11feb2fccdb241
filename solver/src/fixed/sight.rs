//! What gas around a sharp bend of a wall in the plane the bend can be seen from: no fan acts through a body.

use aero_geometry::Vector;

use super::bend::{Bend, cross, turned};
use super::walls::Wall;

/// Walls nearer to the bend than this, in spacings, are those that meet in it.
const OWN: f64 = 1.0;

/// How far over its wall, in spacings, a place on it is looked for.
const LIFT: f64 = 0.05;

/// What may hide gas from a bend.
pub struct Sight<'a, const D: usize> {
    bend: &'a Bend<D>,
    /// Ends of the walls near it, as seen from there.
    walls: Vec<[Vector<D>; 2]>,
}

impl<'a, const D: usize> Sight<'a, D> {
    /// From `bend`, up to so many spacings from there, among all `walls`.
    pub fn new<'w>(
        bend: &'a Bend<D>,
        walls: impl Iterator<Item = &'w Wall<D>>,
        farthest: f64,
    ) -> Self {
        let at = Vector::from(bend.at);
        let ends = walls.map(|wall| {
            let half = turned(&Vector::from(wall.image.normal)) * (0.5 * wall.image.share);
            [wall.foot - half - at, wall.foot + half - at]
        });
        let reach = farthest * bend.unit;
        Self {
            bend,
            walls: ends
                .filter(|ends| ends.iter().any(|end| end.norm() < reach))
                .collect(),
        }
    }

    /// True where nothing stands between the bend and a place as seen from there.
    pub fn reaches(&self, place: &Vector<D>) -> bool {
        let from = OWN * self.bend.unit / place.norm();
        self.bend.opens_to(place) && !self.walls.iter().any(|wall| is_between(wall, place, from))
    }

    /// The same of the middle of a wall.
    pub fn reaches_wall(&self, wall: &Wall<D>) -> bool {
        let lift = Vector::from(wall.image.normal) * (LIFT * self.bend.unit);
        self.reaches(&(wall.foot - lift - Vector::from(self.bend.at)))
    }
}

/// True of a wall that crosses the way to a place after this part of it.
fn is_between<const D: usize>([start, end]: &[Vector<D>; 2], place: &Vector<D>, from: f64) -> bool {
    let wall = end - start;
    let scale = cross(place, &wall);
    if scale == 0.0 {
        return false;
    }
    let [along, across] = [cross(start, &wall), cross(start, place)].map(|part| part / scale);
    (from..1.0 - 1e-6).contains(&along) && (0.0..=1.0).contains(&across)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_wall_hides_what_is_behind_it() {
        let wall = [[1.0, -0.5], [1.0, 0.5]].map(Vector::<2>::from);
        let is_hidden = |place: [f64; 2], from: f64| is_between(&wall, &Vector::from(place), from);
        assert!(is_hidden([2.0, 0.0], 0.1) && is_hidden([2.0, 0.9], 0.1));
        assert!(!is_hidden([0.9, 0.0], 0.1) && !is_hidden([-2.0, 0.0], 0.1));
        assert!(!is_hidden([2.0, 1.1], 0.1) && !is_hidden([2.0, -1.1], 0.1));
        assert!(!is_hidden([2.0, 0.0], 0.6), "too near to the bend");
    }
}
