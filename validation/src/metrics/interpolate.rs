//! Particle values at chosen points: along lines and on rasters, for pictures and profiles.
//!
//! Shepard-normalised smoothed particle interpolation with the quintic kernel: exact for constants,
//! never outside the range of the neighbours' values, and nothing where there is no gas.

use super::MetricError;
use super::cells::Cells;
use super::gradient::Cloud;
use super::kernel::{SUPPORT, quintic};

/// Values of one field, ready to be asked for anywhere.
pub struct Sampler<'a> {
    cloud: Cloud<'a>,
    values: &'a [f64],
    cells: Cells,
    reach: f64,
}

/// A rectangle in the plane of the first two axes, sampled at the middles of equal pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Raster {
    /// Least and greatest `x`.
    pub x: [f64; 2],
    /// Least and greatest `y`.
    pub y: [f64; 2],
    /// Number of columns and rows.
    pub size: [usize; 2],
}

impl<'a> Sampler<'a> {
    /// Sorts the particles of `cloud`, which carry `values`.
    pub fn new(cloud: Cloud<'a>, values: &'a [f64]) -> Result<Self, MetricError> {
        let reach = SUPPORT * cloud.check(values)?;
        Ok(Self {
            cells: Cells::new(cloud.position, reach),
            cloud,
            values,
            reach,
        })
    }

    /// Value at `point`; none beyond the reach of every particle.
    pub fn at(&self, point: &[f64; 3]) -> Option<f64> {
        let (mut sum, mut weights) = (0.0, 0.0);
        self.cells.near(point, self.reach, |j| {
            let h = self.cloud.smoothing_length[j];
            let d2: f64 = (0..self.cloud.dimension)
                .map(|a| (self.cloud.position[j][a] - point[a]).powi(2))
                .sum();
            if d2 < (SUPPORT * h).powi(2) {
                let spread = h.powi(self.cloud.dimension as i32);
                let weight = self.cloud.volume[j] * quintic(d2.sqrt() / h) / spread;
                sum += weight * self.values[j];
                weights += weight;
            }
        });
        (weights > 0.0).then(|| sum / weights)
    }

    /// Values at `count` points from `from` to `to`, both included.
    pub fn line(&self, from: &[f64; 3], to: &[f64; 3], count: usize) -> Vec<Option<f64>> {
        let last = count.saturating_sub(1).max(1) as f64;
        (0..count)
            .map(|k| {
                let share = k as f64 / last;
                self.at(&std::array::from_fn(|a| {
                    from[a] + share * (to[a] - from[a])
                }))
            })
            .collect()
    }

    /// Values on a raster at height `z` (zero in the plane), row by row from the lowest `y`.
    pub fn raster(&self, raster: &Raster, z: f64) -> Vec<Option<f64>> {
        let [columns, rows] = raster.size;
        let middle = |span: [f64; 2], k: usize, count: usize| {
            span[0] + (k as f64 + 0.5) / count as f64 * (span[1] - span[0])
        };
        (0..rows * columns)
            .map(|k| {
                self.at(&[
                    middle(raster.x, k % columns, columns),
                    middle(raster.y, k / columns, rows),
                    z,
                ])
            })
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::metrics::testing::Scatter;

    fn sheet() -> Vec<[f64; 3]> {
        let mut scatter = Scatter::new(11);
        (0..400)
            .map(|k| {
                let place = |i: i32| 0.05 * (f64::from(i) + 0.5);
                [
                    place(k % 20) + 0.01 * scatter.next(),
                    place(k / 20) + 0.01 * scatter.next(),
                    0.0,
                ]
            })
            .collect()
    }

    fn with_sampler(f: impl Fn(&[f64; 3]) -> f64, test: impl Fn(&Sampler<'_>)) {
        let position = sheet();
        let volume = vec![0.0025; position.len()];
        let smoothing_length = vec![0.075; position.len()];
        let values: Vec<f64> = position.iter().map(f).collect();
        let cloud = Cloud {
            position: &position,
            volume: &volume,
            smoothing_length: &smoothing_length,
            dimension: 2,
        };
        test(&Sampler::new(cloud, &values).unwrap());
    }

    #[test]
    fn a_constant_is_reproduced_exactly_up_to_the_edge() {
        with_sampler(
            |_| 4.0,
            |sampler| {
                for value in sampler.line(&[0.0; 3], &[1.0, 1.0, 0.0], 30) {
                    assert!((value.unwrap() - 4.0).abs() < 1e-12);
                }
            },
        );
    }

    #[test]
    fn a_smooth_field_is_close_in_the_interior() {
        with_sampler(
            |p| p[0] - 2.0 * p[1],
            |sampler| {
                let value = sampler.at(&[0.5, 0.4, 0.0]).unwrap();
                assert!((value + 0.3).abs() < 0.02, "{value}");
            },
        );
    }

    #[test]
    fn there_is_nothing_where_there_is_no_gas() {
        with_sampler(
            |_| 1.0,
            |sampler| {
                let raster = Raster {
                    x: [0.0, 2.0],
                    y: [0.0, 1.0],
                    size: [4, 2],
                };
                let values = sampler.raster(&raster, 0.0);
                let seen: Vec<bool> = values.iter().map(Option::is_some).collect();
                assert_eq!(seen, [true, true, false, false, true, true, false, false]);
            },
        );
    }
}
