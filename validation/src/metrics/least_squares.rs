//! Small linear least squares, plain and with outliers left out.

use super::median;

/// Solves `a x = b` by elimination with row exchange; none if `a` is singular to round-off.
pub(super) fn solve<const N: usize>(mut a: [[f64; N]; N], mut b: [f64; N]) -> Option<[f64; N]> {
    let size = a.iter().flatten().fold(0.0, |m: f64, v| m.max(v.abs()));
    for k in 0..N {
        let pivot = (k..N).max_by(|&i, &j| a[i][k].abs().total_cmp(&a[j][k].abs()))?;
        if a[pivot][k].is_nan() || a[pivot][k].abs() <= 1e-13 * size {
            return None;
        }
        a.swap(k, pivot);
        b.swap(k, pivot);
        for row in k + 1..N {
            let factor = a[row][k] / a[k][k];
            for column in k..N {
                a[row][column] -= factor * a[k][column];
            }
            b[row] -= factor * b[k];
        }
    }
    let mut x = [0.0; N];
    for k in (0..N).rev() {
        let sum: f64 = (k + 1..N).map(|j| a[k][j] * x[j]).sum();
        x[k] = (b[k] - sum) / a[k][k];
    }
    Some(x)
}

/// One observation: the regressors and the value they should give.
#[derive(Clone, Copy, Debug)]
pub(super) struct Row<const N: usize> {
    pub(super) terms: [f64; N],
    pub(super) value: f64,
}

impl<const N: usize> Row<N> {
    fn residual(&self, x: &[f64; N]) -> f64 {
        self.value - self.terms.iter().zip(x).map(|(t, c)| t * c).sum::<f64>()
    }
}

/// Coefficients, root mean square of the residuals, and number of rows kept.
#[derive(Clone, Copy, Debug)]
pub(super) struct Fit<const N: usize> {
    pub(super) x: [f64; N],
    pub(super) rms: f64,
    pub(super) kept: usize,
}

/// Least-squares coefficients of `rows`; none if they do not determine them.
pub(super) fn fit<const N: usize>(rows: &[Row<N>]) -> Option<Fit<N>> {
    if rows.len() < N {
        return None;
    }
    let mut a = [[0.0; N]; N];
    let mut b = [0.0; N];
    for row in rows {
        for i in 0..N {
            for j in 0..N {
                a[i][j] += row.terms[i] * row.terms[j];
            }
            b[i] += row.terms[i] * row.value;
        }
    }
    let x = solve(a, b)?;
    let squares: f64 = rows.iter().map(|r| r.residual(&x).powi(2)).sum();
    Some(Fit {
        x,
        rms: (squares / rows.len() as f64).sqrt(),
        kept: rows.len(),
    })
}

/// The same with rows left out whose residual exceeds three robust standard deviations (1.4826
/// median absolute residuals), repeated until nothing changes.
pub(super) fn robust_fit<const N: usize>(rows: &[Row<N>]) -> Option<Fit<N>> {
    let mut best = fit(rows)?;
    for _ in 0..10 {
        let mut residuals: Vec<f64> = rows.iter().map(|r| r.residual(&best.x).abs()).collect();
        let limit = 3.0 * 1.4826 * median(&mut residuals);
        let kept: Vec<Row<N>> = rows
            .iter()
            .filter(|r| r.residual(&best.x).abs() <= limit)
            .copied()
            .collect();
        let Some(next) = fit(&kept) else { break };
        let settled = next.kept == best.kept;
        best = next;
        if settled {
            break;
        }
    }
    Some(best)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line(x: f64, value: f64) -> Row<2> {
        Row {
            terms: [1.0, x],
            value,
        }
    }

    #[test]
    fn a_plane_system_is_solved_with_row_exchange() {
        let x = solve([[0.0, 2.0], [3.0, 1.0]], [4.0, 5.0]).unwrap();
        assert!((x[0] - 1.0).abs() < 1e-14 && (x[1] - 2.0).abs() < 1e-14);
    }

    #[test]
    fn a_singular_system_has_no_solution() {
        assert!(solve([[1.0, 2.0], [2.0, 4.0]], [1.0, 2.0]).is_none());
        assert!(solve([[f64::NAN, 0.0], [0.0, 1.0]], [1.0, 2.0]).is_none());
    }

    #[test]
    fn outliers_do_not_move_the_robust_line() {
        let mut rows: Vec<Row<2>> = (0..40)
            .map(|k| f64::from(k) / 10.0)
            .map(|x| line(x, 1.0 + 0.5 * x + 0.01 * (7.0 * x).sin()))
            .collect();
        rows[5].value += 30.0;
        rows[30].value -= 10.0;
        let fit = robust_fit(&rows).unwrap();
        assert!((fit.x[1] - 0.5).abs() < 0.005, "{:?}", fit.x);
        assert_eq!(fit.kept, 38);
        assert!(fit.rms < 0.01);
    }
}
