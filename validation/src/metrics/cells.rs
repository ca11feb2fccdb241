//! Particles sorted into equal cubic cells, to find those near a point.
//!
//! A plain counting sort, independent of the solver's own neighbour search.

/// Particles' indices by cell; particles at non-finite positions are left out.
pub(super) struct Cells {
    origin: [f64; 3],
    size: f64,
    counts: [usize; 3],
    starts: Vec<usize>,
    order: Vec<usize>,
}

impl Cells {
    /// Sorts `positions` into cells of about `size`, larger if the box would need many more cells
    /// than there are particles.
    pub(super) fn new(positions: &[[f64; 3]], size: f64) -> Self {
        let mut low = [f64::INFINITY; 3];
        let mut high = [f64::NEG_INFINITY; 3];
        let finite = |p: &[f64; 3]| p.iter().all(|v| v.is_finite());
        for p in positions.iter().filter(|p| finite(p)) {
            for axis in 0..3 {
                low[axis] = low[axis].min(p[axis]);
                high[axis] = high[axis].max(p[axis]);
            }
        }
        if low[0] > high[0] {
            (low, high) = ([0.0; 3], [0.0; 3]);
        }
        let limit = 8.0 * positions.len() as f64 + 64.0;
        let cells_at = |size: f64| -> f64 {
            (0..3)
                .map(|a| ((high[a] - low[a]) / size).floor() + 1.0)
                .product()
        };
        let mut size = size.max(f64::MIN_POSITIVE);
        while cells_at(size) > limit {
            size *= 1.5;
        }
        let counts = std::array::from_fn(|a| ((high[a] - low[a]) / size) as usize + 1);
        let mut this = Self {
            origin: low,
            size,
            counts,
            starts: Vec::new(),
            order: Vec::new(),
        };
        let cell_of: Vec<Option<usize>> = positions
            .iter()
            .map(|p| finite(p).then(|| this.index(this.cell(p))))
            .collect();
        let mut starts = vec![0; counts.iter().product::<usize>() + 1];
        for cell in cell_of.iter().flatten() {
            starts[cell + 1] += 1;
        }
        for k in 1..starts.len() {
            starts[k] += starts[k - 1];
        }
        let mut next = starts.clone();
        this.order = vec![0; starts[starts.len() - 1]];
        for (particle, cell) in cell_of.iter().enumerate() {
            if let Some(cell) = cell {
                this.order[next[*cell]] = particle;
                next[*cell] += 1;
            }
        }
        this.starts = starts;
        this
    }

    /// Calls `visit` with every particle in the cells that a ball touches: all inside it, and some
    /// outside.
    pub(super) fn near(&self, centre: &[f64; 3], radius: f64, mut visit: impl FnMut(usize)) {
        let low = self.cell(&centre.map(|v| v - radius));
        let high = self.cell(&centre.map(|v| v + radius));
        for k in low[2]..=high[2] {
            for j in low[1]..=high[1] {
                let first = self.index([low[0], j, k]);
                let last = self.index([high[0], j, k]);
                for &particle in &self.order[self.starts[first]..self.starts[last + 1]] {
                    visit(particle);
                }
            }
        }
    }

    /// Cell of a point, the nearest one for points outside the box.
    fn cell(&self, p: &[f64; 3]) -> [usize; 3] {
        std::array::from_fn(|a| {
            let cell = ((p[a] - self.origin[a]) / self.size).floor().max(0.0);
            (cell as usize).min(self.counts[a] - 1)
        })
    }

    fn index(&self, [i, j, k]: [usize; 3]) -> usize {
        (k * self.counts[1] + j) * self.counts[0] + i
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn every_particle_within_the_radius_is_visited_once(
            points in proptest::collection::vec(
                [-3.0_f64..3.0, -1.0_f64..1.0, -0.1_f64..0.1], 0..200),
            centre in [-4.0_f64..4.0, -2.0_f64..2.0, -1.0_f64..1.0],
            radius in 0.01_f64..2.0, size in 0.02_f64..1.0,
        ) {
            let cells = Cells::new(&points, size);
            let mut seen = vec![0; points.len()];
            cells.near(&centre, radius, |k| seen[k] += 1);
            for (point, count) in points.iter().zip(seen) {
                let d2: f64 = (0..3).map(|a| (point[a] - centre[a]).powi(2)).sum();
                prop_assert!(count <= 1);
                prop_assert!(count == 1 || d2 > radius * radius);
            }
        }
    }

    #[test]
    fn lost_particles_are_left_out_and_tiny_cells_are_enlarged() {
        let points = [[0.0; 3], [f64::NAN, 0.0, 0.0], [1e6, 1e6, 1e6]];
        let cells = Cells::new(&points, 1e-6);
        let mut seen = Vec::new();
        cells.near(&[0.0; 3], 1e7, |k| seen.push(k));
        seen.sort_unstable();
        assert_eq!(seen, [0, 2]);
    }
}
