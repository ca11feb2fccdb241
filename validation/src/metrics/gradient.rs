//! First-order consistent gradients on scattered particles.
//!
//! The renormalised gradient of smoothed particle hydrodynamics: exact for linear fields on any
//! arrangement that surrounds the particle. Source: Randles & Libersky, Comput. Methods Appl. Mech.
//! Eng. 139 (1996) 375 (doi:10.1016/S0045-7825(96)01090-0).

use super::cells::Cells;
use super::kernel::{SUPPORT, quintic_fall};
use super::least_squares::solve;
use super::{MetricError, positive, same_length};

/// Particles as carriers of a field.
#[derive(Clone, Copy, Debug)]
pub struct Cloud<'a> {
    /// Positions.
    pub position: &'a [[f64; 3]],
    /// Volumes, `m / rho`.
    pub volume: &'a [f64],
    /// Smoothing lengths.
    pub smoothing_length: &'a [f64],
    /// Number of axes in use, 1 to 3: the first ones.
    pub dimension: usize,
}

impl Cloud<'_> {
    /// Checks the arrays' lengths and returns the largest smoothing length.
    pub(super) fn check(&self, values: &[f64]) -> Result<f64, MetricError> {
        let count = self.position.len();
        same_length("volume", self.volume, count)?;
        same_length("smoothing_length", self.smoothing_length, count)?;
        same_length("values", values, count)?;
        let largest = self.smoothing_length.iter().copied().fold(0.0, f64::max);
        if count > 0 {
            positive("the largest smoothing length", largest)?;
        }
        Ok(largest)
    }
}

/// Gradient of `values` at every particle:
/// `grad f_i = L_i sum_j V_j (f_j - f_i) grad_i W_ij`,
/// `L_i = [sum_j V_j (r_j - r_i) (x) grad_i W_ij]^-1`, with the quintic kernel at the mean smoothing
/// length of the pair. Particles whose neighbours do not span the space get zero.
pub fn gradient(cloud: &Cloud<'_>, values: &[f64]) -> Result<Vec<[f64; 3]>, MetricError> {
    let largest = cloud.check(values)?;
    let cells = Cells::new(cloud.position, SUPPORT * largest);
    Ok((0..values.len())
        .map(|i| match cloud.dimension {
            1 => at::<1>(cloud, values, &cells, i, largest),
            2 => at::<2>(cloud, values, &cells, i, largest),
            _ => at::<3>(cloud, values, &cells, i, largest),
        })
        .collect())
}

fn at<const D: usize>(
    cloud: &Cloud<'_>,
    values: &[f64],
    cells: &Cells,
    i: usize,
    largest: f64,
) -> [f64; 3] {
    let here = &cloud.position[i];
    let own = cloud.smoothing_length[i];
    let mut matrix = [[0.0; D]; D];
    let mut right = [0.0; D];
    cells.near(here, SUPPORT * 0.5 * (own + largest), |j| {
        let h = 0.5 * (own + cloud.smoothing_length[j]);
        let apart: [f64; D] = std::array::from_fn(|a| cloud.position[j][a] - here[a]);
        let distance = apart.iter().map(|v| v * v).sum::<f64>().sqrt();
        if j == i || distance >= SUPPORT * h || distance == 0.0 {
            return;
        }
        let fall = quintic_fall(distance / h) / h.powi(D as i32 + 1);
        let weight = cloud.volume[j] * fall / distance;
        for a in 0..D {
            for b in 0..D {
                matrix[a][b] += weight * apart[a] * apart[b];
            }
            right[a] += weight * (values[j] - values[i]) * apart[a];
        }
    });
    let mut gradient = [0.0; 3];
    if let Some(solution) = solve(matrix, right) {
        gradient[..D].copy_from_slice(&solution);
    }
    gradient
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::metrics::testing::Scatter;

    fn cloud(dimension: usize) -> Vec<[f64; 3]> {
        let mut scatter = Scatter::new(3);
        let per_axis: usize = if dimension == 3 { 8 } else { 14 };
        let mut points = Vec::new();
        for k in 0..per_axis.pow(dimension as u32) {
            let index = [
                k % per_axis,
                k / per_axis % per_axis,
                k / per_axis / per_axis,
            ];
            let mut point = [0.0; 3];
            for a in 0..dimension {
                point[a] = 0.1 * (index[a] as f64 + 0.3 * scatter.next());
            }
            points.push(point);
        }
        points
    }

    #[test]
    fn linear_fields_are_differentiated_exactly_in_every_dimension() {
        for dimension in 1..=3 {
            let position = cloud(dimension);
            let volume = vec![0.1_f64.powi(dimension as i32); position.len()];
            let smoothing_length: Vec<f64> = (0..position.len())
                .map(|k| 0.13 + 0.02 * (k % 3) as f64)
                .collect();
            let values: Vec<f64> = position
                .iter()
                .map(|p| 1.0 + 2.0 * p[0] - 3.0 * p[1] + 0.5 * p[2])
                .collect();
            let cloud = Cloud {
                position: &position,
                volume: &volume,
                smoothing_length: &smoothing_length,
                dimension,
            };
            let expected = [2.0, -3.0, 0.5];
            for slope in gradient(&cloud, &values).unwrap() {
                for a in 0..dimension {
                    assert!(
                        (slope[a] - expected[a]).abs() < 1e-9,
                        "{dimension} {slope:?}"
                    );
                }
            }
        }
    }

    #[test]
    fn an_isolated_particle_has_no_gradient() {
        let cloud = Cloud {
            position: &[[0.0; 3], [5.0, 0.0, 0.0]],
            volume: &[1.0; 2],
            smoothing_length: &[0.1; 2],
            dimension: 2,
        };
        assert_eq!(gradient(&cloud, &[1.0, 2.0]).unwrap(), [[0.0; 3]; 2]);
    }
}
