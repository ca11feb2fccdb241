//! All bodies of a scene as one: how far the gas at a point is from them, and where a line meets them.

use std::sync::Arc;

use aero_geometry::{Bounds, Closest, Shape, Vector};

/// Distance in spacings up to which gas counts as part of the body: rounding must not decide about facets in the wall.
const SKIN: f64 = 1e-9;

/// Parts of bodies thinner than this, in spacings, may be missed by a line.
const THINNEST: f64 = 0.05;

/// Lines shorter than this, in spacings, that end on different sides meet the surface once.
const SIMPLE: f64 = 0.1;

/// The bodies.
#[derive(Clone, Debug)]
pub struct Solids<const D: usize> {
    bodies: Vec<(Arc<dyn Shape<D>>, Bounds<D>)>,
    /// Gas that is nearer than this counts as part of the body.
    skin: f64,
}

/// A line in the gas or through the wall, and what is measured in its unit.
#[derive(Clone, Copy, Debug)]
pub struct Line<const D: usize> {
    /// Start.
    pub from: Vector<D>,
    /// End.
    pub to: Vector<D>,
    /// Spacing of the points here.
    pub unit: f64,
}

impl<const D: usize> Solids<D> {
    /// The union of `shapes`, among points of this spacing.
    pub fn new(shapes: impl IntoIterator<Item = Arc<dyn Shape<D>>>, spacing: f64) -> Self {
        let bodies = shapes.into_iter().map(|shape| {
            let bounds = shape.bounds();
            (shape, bounds)
        });
        Self {
            bodies: bodies.collect(),
            skin: SKIN * spacing,
        }
    }

    /// True where there is none.
    pub fn is_empty(&self) -> bool {
        self.bodies.is_empty()
    }

    /// Longest edge of the box around the body of which that is least; infinite where none has an end.
    pub fn smallest(&self) -> f64 {
        let sizes = self.bodies.iter().map(|(_, bounds)| bounds.size().max());
        sizes.fold(f64::INFINITY, f64::min)
    }

    /// Body `number`.
    pub fn shape(&self, number: u32) -> &dyn Shape<D> {
        &*self.bodies[number as usize].0
    }

    /// The nearest body and its closest point; inside of several, the one in which the point is deepest.
    pub fn closest(&self, point: &Vector<D>) -> Option<(u32, Closest<D>)> {
        let mut best: Option<(u32, Closest<D>)> = None;
        for (number, (shape, bounds)) in self.bodies.iter().enumerate() {
            let away = distance_to_box(bounds, point);
            if best.is_some_and(|(_, known)| known.distance <= away) {
                continue;
            }
            let found = shape.closest(point);
            if best.is_none_or(|(_, known)| found.distance < known.distance) {
                best = Some((number as u32, found));
            }
        }
        best
    }

    /// Distance to the nearest body, negative inside; infinite where there is none.
    pub fn distance(&self, point: &Vector<D>) -> f64 {
        self.closest(point)
            .map_or(f64::INFINITY, |(_, closest)| closest.distance)
    }

    /// The distance less the skin: above zero in the gas.
    pub fn height(&self, point: &Vector<D>) -> f64 {
        self.distance(point) - self.skin
    }

    /// Where a line passes through the surface, as parts of its length in order. `ends` are the heights of its ends.
    pub fn crossings(&self, line: &Line<D>, ends: [f64; 2]) -> Vec<f64> {
        let mut found = Vec::new();
        let length = (line.to - line.from).norm();
        if length > 0.0 {
            let whole = Stretch {
                from: 0.0,
                to: 1.0,
                heights: ends,
            };
            self.search(line, length, whole, &mut found);
        }
        found
    }

    fn search(&self, line: &Line<D>, length: f64, part: Stretch, found: &mut Vec<f64>) {
        let long = (part.to - part.from) * length;
        let [low, high] = part.heights;
        // No point is nearer to the surface than its distance: the balls around both ends are clear.
        let cover = low.abs() + high.abs();
        let crosses = (low > 0.0) != (high > 0.0);
        if crosses && (long < SIMPLE * line.unit || cover > 0.99 * long) {
            found.push(self.root(line, part));
            return;
        }
        if !crosses && (cover >= long || long < THINNEST * line.unit) {
            return;
        }
        let middle = 0.5 * (part.from + part.to);
        let height = self.height(&line.at(middle));
        let (first, second) = part.halves(middle, height);
        self.search(line, length, first, found);
        self.search(line, length, second, found);
    }

    /// The one crossing of a stretch (Illinois variant of regula falsi; Dowell & Jarratt 1971).
    fn root(&self, line: &Line<D>, part: Stretch) -> f64 {
        const STEPS: usize = 60;
        let (mut a, mut b) = (part.from, part.to);
        let [mut low, mut high] = part.heights;
        let mut side = 0;
        for _ in 0..STEPS {
            let place = (a * high - b * low) / (high - low);
            if !(a.min(b) < place && place < a.max(b)) {
                break;
            }
            let height = self.height(&line.at(place));
            if height.abs() < 1e-15 * line.unit {
                return place;
            }
            if (height > 0.0) == (high > 0.0) {
                (b, high) = (place, height);
                low *= if side == 1 { 0.5 } else { 1.0 };
                side = 1;
            } else {
                (a, low) = (place, height);
                high *= if side == -1 { 0.5 } else { 1.0 };
                side = -1;
            }
        }
        if low.abs() < high.abs() { a } else { b }
    }

    /// True where no body is in the way.
    pub fn sees(&self, line: &Line<D>) -> bool {
        let ends = [&line.from, &line.to].map(|end| self.height(end));
        let length = (line.to - line.from).norm();
        self.is_clear(
            line,
            length,
            Stretch {
                from: 0.0,
                to: 1.0,
                heights: ends,
            },
        )
    }

    fn is_clear(&self, line: &Line<D>, length: f64, part: Stretch) -> bool {
        let [low, high] = part.heights;
        if low <= 0.0 || high <= 0.0 {
            return false;
        }
        let long = (part.to - part.from) * length;
        if low + high >= long || long < THINNEST * line.unit {
            return true;
        }
        let middle = 0.5 * (part.from + part.to);
        let height = self.height(&line.at(middle));
        let (first, second) = part.halves(middle, height);
        self.is_clear(line, length, first) && self.is_clear(line, length, second)
    }
}

impl<const D: usize> Line<D> {
    /// The point at a part of the length.
    pub fn at(&self, part: f64) -> Vector<D> {
        self.from + (self.to - self.from) * part
    }
}

/// Part of a line, and the heights of its ends.
#[derive(Clone, Copy)]
struct Stretch {
    from: f64,
    to: f64,
    heights: [f64; 2],
}

impl Stretch {
    fn halves(self, middle: f64, height: f64) -> (Self, Self) {
        let [low, high] = self.heights;
        let first = Self {
            to: middle,
            heights: [low, height],
            ..self
        };
        let second = Self {
            from: middle,
            heights: [height, high],
            ..self
        };
        (first, second)
    }
}

fn distance_to_box<const D: usize>(bounds: &Bounds<D>, point: &Vector<D>) -> f64 {
    let mut sum = 0.0;
    for k in 0..D {
        let outside = (bounds.min[k] - point[k])
            .max(point[k] - bounds.max[k])
            .max(0.0);
        sum += outside * outside;
    }
    // Inside of the box the body may be anywhere.
    if sum > 0.0 {
        sum.sqrt()
    } else {
        f64::NEG_INFINITY
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use aero_geometry::bodies;
    use approx::assert_relative_eq;

    fn plate(thickness: f64) -> Solids<2> {
        let plate: Arc<dyn Shape<2>> = Arc::new(bodies::rectangle(10.0, thickness, 0.0).unwrap());
        Solids::new([plate], 1.0)
    }

    fn line(from: [f64; 2], to: [f64; 2]) -> Line<2> {
        Line {
            from: from.into(),
            to: to.into(),
            unit: 1.0,
        }
    }

    #[test]
    fn a_line_meets_both_sides_of_a_thin_plate() {
        for thickness in [0.06, 0.3, 2.0] {
            let plate = plate(thickness);
            let line = line([0.2, -1.4], [0.3, 1.3]);
            let ends = [line.from, line.to].map(|end| plate.height(&end));
            let found = plate.crossings(&line, ends);
            assert_eq!(found.len(), 2, "{thickness}");
            for (part, height) in found.iter().zip([-0.5, 0.5]) {
                assert_relative_eq!(line.at(*part).y, height * thickness, epsilon = 2e-9);
            }
        }
    }

    #[test]
    fn sight_ends_at_a_plate_and_passes_beside_it() {
        let plate = plate(0.1);
        assert!(!plate.sees(&line([0.0, -0.4], [0.3, 0.5])));
        assert!(plate.sees(&line([0.0, 0.2], [4.0, 0.2])));
        assert!(plate.sees(&line([5.2, -0.4], [5.2, 0.5])));
        assert!(!plate.sees(&line([4.9, -0.4], [5.02, 0.5])));
    }
}
