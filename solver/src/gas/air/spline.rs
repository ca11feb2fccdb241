//! A smooth function of two variables through values on a lattice: cubic B-splines, with two continuous derivatives.

/// Where a lattice begins along an axis, how far apart its nodes are, and how many there are.
#[derive(Clone, Copy, Debug)]
pub struct Axis {
    /// The first node.
    pub start: f64,
    /// Distance between nodes.
    pub step: f64,
    /// Number of nodes.
    pub count: usize,
}

impl Axis {
    /// Of `count` nodes between two ends.
    pub fn new([start, end]: [f64; 2], count: usize) -> Self {
        Self {
            start,
            step: (end - start) / (count - 1) as f64,
            count,
        }
    }

    /// A node.
    pub fn node(&self, number: usize) -> f64 {
        self.start + self.step * number as f64
    }

    /// The last node.
    pub fn end(&self) -> f64 {
        self.node(self.count - 1)
    }

    /// The node before `place`, which is not beyond the ends, and how far behind it that is, in steps.
    pub fn cell(&self, place: f64) -> (usize, f64) {
        let steps = ((place - self.start) / self.step).max(0.0);
        let number = (steps as usize).min(self.count - 2);
        (number, steps - number as f64)
    }
}

/// The function.
#[derive(Debug)]
pub struct Spline {
    axes: [Axis; 2],
    /// Coefficients, one more than there are nodes at each end; the second axis runs first.
    coefficients: Vec<f64>,
}

impl Spline {
    /// Through `values` on the lattice of `axes`, the second of which runs first; straight across the ends.
    pub fn new(axes: [Axis; 2], values: &[f64]) -> Self {
        let [rows, columns] = axes.map(|axis| axis.count);
        let wide = columns + 2;
        let mut along = vec![0.0; rows * wide];
        for (row, values) in along
            .chunks_exact_mut(wide)
            .zip(values.chunks_exact(columns))
        {
            row.copy_from_slice(&filtered(values));
        }
        let mut coefficients = vec![0.0; (rows + 2) * wide];
        for column in 0..wide {
            let values: Vec<f64> = (0..rows).map(|row| along[row * wide + column]).collect();
            for (row, value) in filtered(&values).into_iter().enumerate() {
                coefficients[row * wide + column] = value;
            }
        }
        Self { axes, coefficients }
    }

    /// Its value and its derivatives at a place within the lattice.
    pub fn at(&self, place: [f64; 2]) -> [f64; 3] {
        let [rows, columns] = &self.axes;
        let wide = columns.count + 2;
        let (row, s) = rows.cell(place[0]);
        let (column, t) = columns.cell(place[1]);
        let (down, down_slope) = weights(s);
        let (across, across_slope) = weights(t);
        let mut sums = [0.0; 3];
        for k in 0..4 {
            let start = (row + k) * wide + column;
            let four = &self.coefficients[start..start + 4];
            let (mut value, mut slope) = (0.0, 0.0);
            for l in 0..4 {
                value += across[l] * four[l];
                slope += across_slope[l] * four[l];
            }
            sums[0] += down[k] * value;
            sums[1] += down_slope[k] * value;
            sums[2] += down[k] * slope;
        }
        [sums[0], sums[1] / rows.step, sums[2] / columns.step]
    }
}

/// Values of the four B-splines that reach a place `t` steps after a node, and their derivatives per step.
fn weights(t: f64) -> ([f64; 4], [f64; 4]) {
    let back = 1.0 - t;
    let (square, cube) = (t * t, t * t * t);
    let values = [
        back * back * back / 6.0,
        (3.0 * cube - 6.0 * square + 4.0) / 6.0,
        (3.0 * (t + square - cube) + 1.0) / 6.0,
        cube / 6.0,
    ];
    let slopes = [
        -0.5 * back * back,
        1.5 * square - 2.0 * t,
        0.5 + t - 1.5 * square,
        0.5 * square,
    ];
    (values, slopes)
}

/// Coefficients `c` with `(c_(k-1) + 4 c_k + c_(k+1)) / 6` the values, and no second derivative at the ends: `c` is the value there.
fn filtered(values: &[f64]) -> Vec<f64> {
    let count = values.len();
    let last = count - 1;
    let mut found = vec![0.0; count + 2];
    found[1] = values[0];
    found[last + 1] = values[last];
    // Thomas' algorithm for the rest.
    let mut pivots = vec![0.0; count];
    let mut right = values.to_vec();
    for k in 1..last {
        let pivot = 1.0 / (4.0 - pivots[k - 1]);
        pivots[k] = pivot;
        right[k] = (6.0 * values[k] - right[k - 1]) * pivot;
    }
    for k in (1..last).rev() {
        found[k + 1] = right[k] - pivots[k] * found[k + 2];
    }
    found[0] = 2.0 * found[1] - found[2];
    found[count + 1] = 2.0 * found[count] - found[last];
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn it_goes_through_its_nodes_and_is_as_smooth_as_what_it_stands_for() {
        let axes = [Axis::new([0.0, 2.0], 41), Axis::new([1.0, 3.0], 81)];
        let function = |x: f64, y: f64| (1.3 * x).sin() * (0.7 * y).exp();
        let mut values = Vec::new();
        for i in 0..41 {
            for j in 0..81 {
                values.push(function(axes[0].node(i), axes[1].node(j)));
            }
        }
        let spline = Spline::new(axes, &values);
        assert_relative_eq!(
            spline.at([axes[0].node(7), axes[1].node(30)])[0],
            values[7 * 81 + 30],
            epsilon = 1e-12
        );
        let (x, y) = (0.983, 2.114);
        let [value, by_x, by_y] = spline.at([x, y]);
        assert_relative_eq!(value, function(x, y), max_relative = 1e-6);
        assert_relative_eq!(
            by_x,
            1.3 * (1.3 * x).cos() * (0.7 * y).exp(),
            max_relative = 1e-4
        );
        assert_relative_eq!(by_y, 0.7 * function(x, y), max_relative = 1e-4);
    }
}
