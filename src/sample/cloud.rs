//! Points with values, sorted by width and in space, to be asked for the values between them.

use aero_geometry::parallel::prelude::*;
use aero_geometry::{Pencils, Vector};

use super::fit::{Fit, Found};
use super::solids::{Contact, Solids};

/// Width of the weight of a point, in spacings around it.
const WIDTH: f64 = 0.62;

/// Widths beyond which it counts nothing.
const REACH: f64 = 2.6;

/// Widths around a place within which values are as good as on a straight line: what weights leave is no finer.
const STRAIGHT: f64 = 0.6;

/// How much further is looked where too little lies within reach; and from bodies into which the gas is carried on.
const FURTHER: f64 = 2.0;
const FURTHEST: f64 = 64.0;

/// Values at a place, and whether it lies in a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Near<const D: usize, const N: usize> {
    /// The values; means of the gas beside it where the place lies in a body; none where no gas is near.
    pub found: Option<Found<D, N>>,
    /// The place lies in a body.
    pub is_solid: bool,
    /// How far around the place values are as good as on a straight line, and no body is.
    pub clear: f64,
}

/// A point of the gas.
#[derive(Clone, Copy, Debug)]
pub(super) struct Point<const D: usize, const N: usize> {
    pub(super) position: Vector<D>,
    /// Spacing of the points around it.
    pub(super) spacing: f64,
    pub(super) values: [f64; N],
}

/// Points whose spacings are within a factor of two.
#[derive(Debug)]
struct Level<const D: usize, const N: usize> {
    pencils: Pencils<D>,
    points: Vec<Point<D, N>>,
    contacts: Vec<Option<Contact<D>>>,
    /// The largest width.
    width: f64,
}

/// Points with `N` values each.
#[derive(Debug)]
pub struct Cloud<'a, const D: usize, const N: usize> {
    levels: Vec<Level<D, N>>,
    solids: &'a Solids<'a, D>,
    /// The largest width of all.
    width: f64,
    /// How deep into bodies the gas is carried on whatever its spacing.
    carried: f64,
}

/// How far a point of that spacing counts.
pub(super) fn reach(spacing: f64) -> f64 {
    REACH * WIDTH * spacing
}

impl<'a, const D: usize, const N: usize> Cloud<'a, D, N> {
    /// The cloud of points at `position`, `spacing` apart there, with `values`; `solids` hide from one another what lies on two
    /// sides of a thin part. What is not finite is left out.
    pub fn new(
        solids: &'a Solids<'a, D>,
        positions: &[Vector<D>],
        spacings: &[f64],
        values: &[[f64; N]],
    ) -> Self {
        let all = positions.iter().zip(spacings).zip(values);
        let points = all.map(|((position, spacing), values)| Point {
            position: *position,
            spacing: *spacing,
            values: *values,
        });
        Self::of(solids, points.collect())
    }

    pub(super) fn of(solids: &'a Solids<'a, D>, mut points: Vec<Point<D, N>>) -> Self {
        points.retain(|point| {
            let numbers = point.position.iter().chain(&point.values);
            point.spacing > 0.0 && numbers.chain([&point.spacing]).all(|x| x.is_finite())
        });
        let widest = points.iter().fold(0.0, |w: f64, p| w.max(p.spacing));
        let mut levels: Vec<Vec<Point<D, N>>> = Vec::new();
        for point in points {
            let level = (widest / point.spacing).log2().floor() as usize;
            if levels.len() <= level {
                levels.resize_with(level + 1, Vec::new);
            }
            levels[level].push(point);
        }
        levels.retain(|points| !points.is_empty());
        let width = WIDTH * widest;
        let levels = levels.into_iter();
        Self {
            levels: levels.map(|points| Level::new(&points, solids)).collect(),
            solids,
            width,
            carried: 0.0,
        }
    }

    /// Carries the gas so far on into bodies, however fine it is.
    #[must_use]
    pub fn carried_on(self, carried: f64) -> Self {
        Self { carried, ..self }
    }

    /// The values at a place.
    pub fn at(&self, place: &Vector<D>) -> Near<D, N> {
        let contact = self.solids.contact(place, 2.0 * REACH * self.width);
        let is_solid = contact.is_some_and(|contact| contact.distance < 0.0);
        let is_carried =
            contact.is_some_and(|contact| is_solid && -contact.distance <= self.carried);
        let most = if is_carried { FURTHEST } else { FURTHER };
        let mut further = 1.0;
        let mut found: Option<Found<D, N>> = None;
        while further <= most && !found.is_some_and(|found| found.is_plane || is_solid) {
            let mut fit = Fit::new();
            for level in &self.levels {
                level.add_to(&mut fit, place, further, |there, other| {
                    self.solids.hides((place, contact.as_ref()), (there, other))
                });
            }
            found = fit.solved().or(found);
            further *= 2.0;
        }
        // Carried on into a body, a plane would leave what the gas can be.
        if let Some(found) = found.as_mut().filter(|_| is_solid) {
            found.values = found.means;
        }
        let free = contact.map_or(f64::INFINITY, |contact| contact.distance.max(0.0));
        let plane = found.filter(|found| found.is_plane);
        let clear = plane.map_or(0.0, |found| free.min(STRAIGHT * found.width));
        Near {
            found,
            is_solid,
            clear,
        }
    }
}

impl<const D: usize, const N: usize> Level<D, N> {
    fn new(points: &[Point<D, N>], solids: &Solids<'_, D>) -> Self {
        let width = WIDTH * points.iter().fold(0.0, |w: f64, p| w.max(p.spacing));
        let positions: Vec<Vector<D>> = points.iter().map(|point| point.position).collect();
        let pencils = Pencils::new(&positions, REACH * width);
        let order = pencils.order().par_iter();
        let points: Vec<Point<D, N>> = order.map(|&n| points[n as usize]).collect();
        let near = |point: &Point<D, N>| solids.contact(&point.position, 2.0 * REACH * width);
        Self {
            contacts: points.par_iter().map(near).collect(),
            pencils,
            points,
            width,
        }
    }

    fn add_to(
        &self,
        fit: &mut Fit<D, N>,
        place: &Vector<D>,
        further: f64,
        is_hidden: impl Fn(&Vector<D>, Option<&Contact<D>>) -> bool,
    ) {
        let reach = REACH * self.width * further;
        let (low, high) = (place.add_scalar(-reach), place.add_scalar(reach));
        let edge = (-REACH * REACH).exp();
        self.pencils.for_each_run(&low, &high, |run| {
            for n in run {
                let point = &self.points[n];
                let width = WIDTH * point.spacing * further;
                let offset = point.position - place;
                let weight = (-offset.norm_squared() / (width * width)).exp() - edge;
                if weight > 0.0 && !is_hidden(&point.position, self.contacts[n].as_ref()) {
                    fit.add(weight, &offset, &point.values, width);
                }
            }
        });
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Points of a lattice, finer beyond `x = 0.5`, each off its place by up to a fifth.
    fn lattice() -> Vec<(Vector<2>, f64)> {
        let mut points = Vec::new();
        let mut seed = 1_u64;
        let mut shake = || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            ((seed >> 33) as f64 / (1_u64 << 31) as f64 - 0.5) * 0.4
        };
        for (spacing, from) in [(0.05, 0.0), (0.025, 0.5)] {
            let (columns, rows) = ((0.5 / spacing) as usize, (1.0 / spacing) as usize);
            for n in 0..columns * rows {
                let place = |k: usize, off: f64| (k as f64 + 0.5 + off) * spacing;
                let position = Vector::<2>::new(
                    from + place(n % columns, shake()),
                    place(n / columns, shake()),
                );
                points.push((position, spacing));
            }
        }
        points
    }

    #[test]
    fn linear_values_are_met_to_round_off_between_points_of_any_arrangement() {
        let line = |p: &Vector<2>| [1e5 + 3e4 * p[0] - 2e4 * p[1], p[1]];
        let points = lattice();
        let positions: Vec<_> = points.iter().map(|(p, _)| *p).collect();
        let spacings: Vec<_> = points.iter().map(|(_, s)| *s).collect();
        let values: Vec<_> = positions.iter().map(line).collect();
        let solids = Solids::none();
        let cloud = Cloud::new(&solids, &positions, &spacings, &values);
        for n in 0..400 {
            let place = Vector::<2>::new(f64::from(n % 20) / 19.0, f64::from(n / 20) / 19.0);
            let found = cloud.at(&place).found.expect("gas");
            let wanted = line(&place);
            assert!((found.values[0] / wanted[0] - 1.0).abs() < 1e-12);
            assert!((found.values[1] - wanted[1]).abs() < 1e-12);
            assert!((found.slopes[0] - Vector::<2>::new(3e4, -2e4)).norm() < 1e-6);
        }
    }

    #[test]
    fn far_from_all_points_nothing_is_found() {
        let solids = Solids::none();
        let place = Vector::<2>::new(0.5, 0.5);
        let cloud = Cloud::new(&solids, &[place], &[0.1], &[[2.0]]);
        assert_eq!(
            cloud.at(&place).found.map(|found| found.values),
            Some([2.0])
        );
        assert!(cloud.at(&Vector::<2>::new(0.9, 0.5)).found.is_none());
    }
}
