//! Values on particles about an open side: how steeply they rise out of the domain, read off those that gas comes from, and what they are at a place.

use aero_geometry::Vector;
use nalgebra::SMatrix;

use super::model::Place;

/// How far it looks, in spacings: two layers and what disorder makes of them.
const REACH: f64 = 2.5;

/// Condition number of the moments of neighbours that all but lie in a row.
const FLAT: f64 = 1e3;

/// So many values on each of the particles about an open side, by cells as wide as the reach.
#[derive(Debug)]
pub struct Upstream<const D: usize, const N: usize> {
    place: Place,
    reach: f64,
    /// Cell, position and values.
    values: Vec<([i64; D], Vector<D>, [f64; N])>,
}

impl<const D: usize, const N: usize> Upstream<D, N> {
    /// None yet, about `place` on gas of this spacing.
    pub fn new(place: Place, spacing: f64) -> Self {
        Self {
            place,
            reach: REACH * spacing,
            values: Vec::new(),
        }
    }

    /// How far before the side particles matter.
    pub fn reach(&self) -> f64 {
        self.reach
    }

    /// Adds values.
    pub fn add(&mut self, position: Vector<D>, values: [f64; N]) {
        self.values.push((self.cell(&position), position, values));
    }

    /// Brings them into the order of cells, after the last has been added.
    pub fn sort(&mut self) {
        // Stable: what is in a cell stays in the order in which it came, so that sums have one.
        self.values.sort_by_key(|(cell, ..)| *cell);
    }

    fn cell(&self, position: &Vector<D>) -> [i64; D] {
        std::array::from_fn(|k| (position[k] / self.reach).floor() as i64)
    }

    /// Those about `position`: away from it, the square of the distance as a part of the reach, and values.
    fn about(&self, position: &Vector<D>) -> impl Iterator<Item = (Vector<D>, f64, &[f64; N])> {
        let position = *position;
        let home = self.cell(&position);
        (0..3_i64.pow(D as u32)).flat_map(move |offset| {
            let mut rest = offset;
            let cell = home.map(|k| {
                let k = k + rest % 3 - 1;
                rest /= 3;
                k
            });
            let first = self.values.partition_point(|(other, ..)| *other < cell);
            let there = self.values[first..].iter();
            let there = there.take_while(move |(other, ..)| *other == cell);
            there.filter_map(move |(_, place, values)| {
                let apart = place - position;
                let part = apart.norm_squared() / (self.reach * self.reach);
                (part < 1.0).then_some((apart, part, values))
            })
        })
    }

    /// Mean of the values about `position`, the nearer the more; none where none is near.
    pub fn mean(&self, position: &Vector<D>) -> Option<[f64; N]> {
        let (mut sums, mut total) = ([0.0; N], 0.0);
        for (_, part, values) in self.about(position) {
            let weight = (1.0 - part).powi(4);
            total += weight;
            for (sum, value) in sums.iter_mut().zip(values) {
                *sum += weight * value;
            }
        }
        (total > 0.0).then(|| sums.map(|sum| sum / total))
    }

    /// How far the nearest of them is from `position`, as a part of how far it looks; none where none is near.
    pub fn nearest(&self, position: &Vector<D>) -> Option<f64> {
        let parts = self.about(position).map(|(_, part, _)| part.sqrt());
        parts.min_by(f64::total_cmp)
    }

    /// Slopes out of the domain at `position`, where the values are `own`: of the planes that fit them and the values before them
    /// best. None where there are too few of them.
    pub fn slopes(&self, position: &Vector<D>, own: [f64; N]) -> [f64; N] {
        let axis = self.place.axis;
        let mut moment = SMatrix::<f64, D, D>::zeros();
        let mut rises = [Vector::zeros(); N];
        for (apart, part, values) in self.about(position) {
            if self.place.inward() * apart[axis] > 0.0 {
                let weight = (1.0 - part) * (1.0 - part);
                moment += apart * apart.transpose() * weight;
                for n in 0..N {
                    rises[n] += apart * ((values[n] - own[n]) * weight);
                }
            }
        }
        let outward = -self.place.inward();
        let square = moment[(axis, axis)];
        if square <= 0.0 {
            return [0.0; N];
        }
        // A plane where neighbours fix one, a line across the side where they do not.
        let plane = moment
            .try_inverse()
            .filter(|inverse| moment.norm() * inverse.norm() < FLAT);
        rises.map(|rise| {
            outward * plane.map_or(rise[axis] / square, |inverse| (inverse * rise)[axis])
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// The plane across `axis` at the origin, with the gas before its `end`.
    fn side(axis: usize, end: usize) -> Place {
        Place {
            axis,
            end,
            face: 0.0,
            part: None,
        }
    }

    #[test]
    fn the_slope_of_a_plane_is_found_from_one_side_of_it() {
        let place = side(0, 1);
        let value = |x: &Vector<2>| [2.0 - 3.0 * x[0] + 0.7 * x[1], 1.0 + x[0] + 4.0 * x[1]];
        let mut upstream = Upstream::new(place, 0.1);
        let points = (-4..4).flat_map(|i| (-4..4).map(move |j| (i, j)));
        for (i, j) in points {
            let (i, j) = (f64::from(i), f64::from(j));
            let at = Vector::<2>::new(0.1 * i + 0.01 * (j * 1.7).sin(), 0.1 * j);
            // What lies downstream is not asked.
            let beyond = if at[0] > 0.0 { 1e9 } else { 0.0 };
            upstream.add(at, value(&at).map(|value| value + beyond));
        }
        upstream.sort();
        let at = Vector::<2>::new(0.0, 0.03);
        let [first, second] = upstream.slopes(&at, value(&at));
        assert_relative_eq!(first, -3.0, epsilon = 1e-12);
        assert_relative_eq!(second, 1.0, epsilon = 1e-12);
    }

    #[test]
    fn a_row_alone_has_a_slope_along_itself_and_nothing_has_none() {
        let place = side(1, 0);
        let mut upstream = Upstream::<2, 2>::new(place, 0.1);
        let here = Vector::<2>::zeros();
        assert_eq!(upstream.slopes(&here, [1.0; 2]), [0.0; 2]);
        upstream.add(Vector::<2>::new(0.0, 0.1), [2.0, 1.0]);
        upstream.sort();
        let [first, second] = upstream.slopes(&here, [1.0; 2]);
        assert_relative_eq!(first, -10.0, epsilon = 1e-12);
        assert_eq!(second, 0.0);
    }

    #[test]
    fn a_mean_is_that_of_those_near_and_of_equals_their_own() {
        let place = side(0, 1);
        let mut upstream = Upstream::<2, 2>::new(place, 0.1);
        for n in -5..6 {
            let y = 0.1 * f64::from(n);
            upstream.add(Vector::<2>::new(0.05, y), [3.0, y]);
        }
        upstream.sort();
        let mean = upstream.mean(&Vector::<2>::new(0.0, 0.1)).unwrap();
        assert_relative_eq!(mean[0], 3.0, epsilon = 1e-14);
        assert_relative_eq!(mean[1], 0.1, epsilon = 1e-12);
        assert_eq!(upstream.mean(&Vector::<2>::new(1.0, 0.1)), None);
    }
}
