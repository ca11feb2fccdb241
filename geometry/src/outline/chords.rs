//! Pieces of an outline as chords, where a region is.

use super::piece::Piece;
use crate::{Bounds, Vector};

/// Chords turn no more than this (radians; 5 degrees), so that their length is the arc's to a part in three thousand.
const CHORD_TURN: f64 = std::f64::consts::PI / 36.0;

impl Piece {
    /// The part of the piece in `region` as chords, and maybe more: one of a straight piece, of an arc pieces about `size` long, those near
    /// the region alone.
    pub(crate) fn chords(&self, size: f64, region: &Bounds<2>) -> Vec<[Vector<2>; 2]> {
        let [mut from, mut to] = self.range();
        let mut parts = 1.0;
        match self {
            Self::Line(line) => {
                for axis in 0..2 {
                    let slope = line.direction[axis];
                    let ends = [region.min[axis], region.max[axis]].map(|x| x - line.origin[axis]);
                    if slope == 0.0 {
                        if ends[0] > 0.0 || ends[1] < 0.0 {
                            return Vec::new();
                        }
                        continue;
                    }
                    let [a, b] = ends.map(|end| end / slope);
                    from = from.max(a.min(b));
                    to = to.min(a.max(b));
                }
            }
            Self::Arc(arc) => {
                let turn = arc.sweep.abs() / CHORD_TURN;
                parts = (self.length() / size).max(turn).ceil().max(1.0);
            }
        }
        if !(to > from && (to - from).is_finite()) {
            return Vec::new();
        }
        Chords::new(self, [from, to], parts, region).all()
    }
}

/// A piece cut into equal parts.
pub(super) struct Chords<'a> {
    piece: &'a Piece,
    range: [f64; 2],
    parts: f64,
    region: &'a Bounds<2>,
}

impl<'a> Chords<'a> {
    /// Of the part of `piece` in this range of arc lengths.
    pub(super) fn new(
        piece: &'a Piece,
        range: [f64; 2],
        parts: f64,
        region: &'a Bounds<2>,
    ) -> Self {
        Self {
            piece,
            range,
            parts,
            region,
        }
    }

    /// Those that may meet the region, in order.
    pub(super) fn all(&self) -> Vec<[Vector<2>; 2]> {
        let mut found = Vec::new();
        self.find(0, self.parts as usize, &mut found);
        found
    }

    fn place(&self, n: f64) -> Vector<2> {
        let [from, to] = self.range;
        self.piece.point(from + (to - from) * n / self.parts)
    }

    /// Adds the chords from number `first` to that before `last` whose arcs may meet the region. No place of an arc is farther from its middle than
    /// half of its length, so that of an arc of millions of chords only those in question are looked at.
    fn find(&self, first: usize, last: usize, found: &mut Vec<[Vector<2>; 2]>) {
        let ends = [first as f64, last as f64];
        let middle = self.place(0.5 * (ends[0] + ends[1]));
        let away = middle - middle.sup(&self.region.min).inf(&self.region.max);
        let share = (ends[1] - ends[0]) / self.parts;
        if away.norm() > share * self.piece.length() {
            return;
        }
        if last - first <= 1 {
            found.push(ends.map(|n| self.place(n)));
            return;
        }
        let half = first + (last - first) / 2;
        self.find(first, half, found);
        self.find(half, last, found);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn of_a_circle_however_large_only_what_is_near_the_region_is_divided() {
        let size = 0.1;
        let region = Bounds::new(Vector::<2>::new(-0.5, -0.3), Vector::<2>::new(0.5, 0.4));
        for radius in [2.0, 1e3, 1e7] {
            let centre = Vector::<2>::new(0.0, -radius);
            let arc = Piece::arc(centre, radius, 0.0, std::f64::consts::TAU);
            let chords = arc.chords(size, &region);
            assert!(chords.len() < 130, "{radius}: {}", chords.len());
            let mut x: Vec<f64> = chords.iter().flatten().map(|end| end.x).collect();
            x.sort_by(f64::total_cmp);
            let within = chords
                .iter()
                .filter(|[a, b]| region.contains(a) && region.contains(b));
            assert!(within.count() >= 8, "{radius}");
            for pair in x.windows(2) {
                let is_inside = pair[0].abs() < 0.5 && pair[1].abs() < 0.5;
                assert!(
                    !is_inside || pair[1] - pair[0] < 1.01 * size,
                    "{radius}: {pair:?}"
                );
            }
        }
    }
}
