//! Points near a place, of any spacing: boxes around runs of consecutive points, and boxes around those.

use aero_geometry::Vector;
use aero_geometry::parallel::prelude::*;

/// Points or boxes in a box.
const RUN: usize = 8;

/// The boxes over points whose neighbours in the list are near in space.
#[derive(Clone, Debug)]
pub struct Nearby<'a, const D: usize> {
    points: &'a [Vector<D>],
    /// From the smallest boxes to the one around all.
    levels: Vec<Vec<[Vector<D>; 2]>>,
}

impl<'a, const D: usize> Nearby<'a, D> {
    /// The boxes over `points`.
    pub fn new(points: &'a [Vector<D>]) -> Self {
        let around = |run: &[[Vector<D>; 2]]| {
            run.iter()
                .copied()
                .reduce(|a, b| [a[0].inf(&b[0]), a[1].sup(&b[1])])
                .unwrap_or([Vector::zeros(); 2])
        };
        let mut levels: Vec<Vec<[Vector<D>; 2]>> = vec![
            points
                .par_chunks(RUN)
                .map(|run| {
                    let (low, high) = run
                        .iter()
                        .fold((run[0], run[0]), |(low, high), p| (low.inf(p), high.sup(p)));
                    [low, high]
                })
                .collect(),
        ];
        while levels[levels.len() - 1].len() > 1 {
            let below = &levels[levels.len() - 1];
            levels.push(below.par_chunks(RUN).map(around).collect());
        }
        Self { points, levels }
    }

    /// Adds all points within `radius` of `place`: distance squared and number, in the order of the list.
    pub fn within(&self, place: &Vector<D>, radius: f64, found: &mut Vec<(f64, u32)>) {
        if self.points.is_empty() {
            return;
        }
        let top = self.levels.len() - 1;
        for node in 0..self.levels[top].len() {
            self.descend(top, node, place, radius * radius, found);
        }
    }

    /// The nearest of all points, looked for from `radius` on; none where none is anywhere near.
    pub fn nearest(&self, place: &Vector<D>, mut radius: f64) -> Option<u32> {
        const TRIES: usize = 40;
        let mut near = Vec::new();
        for _ in 0..TRIES {
            self.within(place, radius, &mut near);
            let best = near
                .iter()
                .min_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
            if let Some(&(_, other)) = best {
                return Some(other);
            }
            radius *= 2.0;
        }
        None
    }

    fn descend(
        &self,
        level: usize,
        node: usize,
        place: &Vector<D>,
        most: f64,
        found: &mut Vec<(f64, u32)>,
    ) {
        let [low, high] = &self.levels[level][node];
        let mut away = 0.0;
        for k in 0..D {
            let outside = (low[k] - place[k]).max(place[k] - high[k]).max(0.0);
            away += outside * outside;
        }
        if away > most {
            return;
        }
        let first = node * RUN;
        if level > 0 {
            let last = (first + RUN).min(self.levels[level - 1].len());
            for child in first..last {
                self.descend(level - 1, child, place, most, found);
            }
            return;
        }
        let last = (first + RUN).min(self.points.len());
        for number in first..last {
            let distance = (self.points[number] - place).norm_squared();
            if distance <= most {
                found.push((distance, number as u32));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_found_is_what_a_full_search_finds() {
        let points: Vec<Vector<3>> = (0..777)
            .map(|n| {
                let t = f64::from(n) * 0.01;
                Vector::<3>::new(t, (5.0 * t).sin(), (3.0 * t).cos())
            })
            .collect();
        let nearby = Nearby::new(&points);
        for place in points.iter().step_by(50) {
            let mut found = Vec::new();
            nearby.within(place, 0.9, &mut found);
            let brute = points.iter().filter(|p| (*p - place).norm() <= 0.9).count();
            assert_eq!(found.len(), brute);
        }
    }
}
