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
        // Cells next to each other along the last axis follow each other.
        (0..3_i64.pow(D as u32 - 1)).flat_map(move |offset| {
            let mut rest = offset;
            let mut first = home.map(|k| k - 1);
            for k in &mut first[..D - 1] {
                *k += rest % 3;
                rest /= 3;
            }
            let mut last = first;
            last[D - 1] += 2;
            let start = self.values.partition_point(|(cell, ..)| *cell < first);
            let there = self.values[start..].iter();
            let there = there.take_while(move |(cell, ..)| *cell <= last);
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

    /// True if there is one of `which` nearer to `position` than this.
    pub fn has(&self, position: &Vector<D>, near: f64, which: impl Fn(&[f64; N]) -> bool) -> bool {
        let mut about = self.about(position);
        about.any(|(apart, _, values)| apart.norm_squared() < near * near && which(values))
    }

    /// How far the nearest of them is from `position`, as a part of how far it looks; none where none is near.
    pub fn nearest(&self, position: &Vector<D>) -> Option<f64> {
        let parts = self.about(position).map(|(_, part, _)| part.sqrt());
        parts.min_by(f64::total_cmp)
    }

    /// The values so far before `position`, into the domain, where they are `own`: by the planes that fit them and the values before
    /// them best, and `own` where there are too few of them; what lies beside a place says nothing of a slope across it. Within
    /// the range of what is before it and its own, so that nothing grows on its way out: particles nearer to each other than a wave goes in a
    /// step, or all but in a row, would make a burst of a ripple.
    pub fn before(&self, position: &Vector<D>, own: [f64; N], distance: f64) -> [f64; N] {
        let axis = self.place.axis;
        let inward = self.place.inward();
        let mut moment = SMatrix::<f64, D, D>::zeros();
        let mut rises = [Vector::zeros(); N];
        let (mut square, mut steep) = (0.0, [0.0; N]);
        let (mut least, mut most) = (own, own);
        for (apart, part, values) in self.about(position) {
            let across = apart[axis];
            if inward * across <= 0.0 {
                continue;
            }
            let weight = (1.0 - part) * (1.0 - part);
            moment += apart * apart.transpose() * weight;
            let is_ahead = 2.0 * across * across >= apart.norm_squared();
            if is_ahead {
                square += weight * across * across;
            }
            for n in 0..N {
                let rise = weight * (values[n] - own[n]);
                rises[n] += apart * rise;
                if is_ahead {
                    steep[n] += across * rise;
                }
                least[n] = least[n].min(values[n]);
                most[n] = most[n].max(values[n]);
            }
        }
        // A plane where neighbours fix one, a line across the side where they do not.
        let plane = moment
            .try_inverse()
            .filter(|inverse| moment.norm() * inverse.norm() < FLAT);
        std::array::from_fn(|n| {
            let line = if square > 0.0 { steep[n] / square } else { 0.0 };
            let slope = plane.map_or(line, |inverse| (inverse * rises[n])[axis]);
            (own[n] + inward * distance * slope)
                .max(least[n])
                .min(most[n])
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
    fn what_is_before_a_place_is_found_by_a_plane_from_one_side_of_it() {
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
        let [first, second] = upstream.before(&at, value(&at), 0.04);
        let [there, other] = value(&Vector::<2>::new(-0.04, 0.03));
        assert_relative_eq!(first, there, epsilon = 1e-12);
        assert_relative_eq!(second, other, epsilon = 1e-12);
    }

    #[test]
    fn a_row_alone_makes_a_line_along_itself_and_nothing_leaves_all_as_it_is() {
        let place = side(1, 0);
        let mut upstream = Upstream::<2, 2>::new(place, 0.1);
        let here = Vector::<2>::zeros();
        assert_eq!(upstream.before(&here, [1.0; 2], 0.03), [1.0; 2]);
        upstream.add(Vector::<2>::new(0.0, 0.1), [2.0, 1.0]);
        upstream.sort();
        let [first, second] = upstream.before(&here, [1.0; 2], 0.03);
        assert_relative_eq!(first, 1.3, epsilon = 1e-12);
        assert_eq!(second, 1.0);
    }

    /// What lies beside a place, or nearer than a wave goes in a step, has no part in making more of a difference than it is.
    #[test]
    fn no_difference_grows_on_its_way_out() {
        let here = Vector::<2>::zeros();
        let before = |x: f64, y: f64| {
            let mut upstream = Upstream::<2, 1>::new(side(0, 1), 0.1);
            upstream.add(Vector::<2>::new(x, y), [2.0]);
            upstream.sort();
            upstream.before(&here, [1.0], 0.03)[0]
        };
        assert_eq!(before(-1e-9, 0.1), 1.0);
        assert_eq!(before(-0.001, 0.0), 2.0);
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
