//! The sums of the scheme, EDAC with transport velocity [Ramachandran & Puri 2019, doi:10.1016/j.compfluid.2018.11.023; Negi et al. 2020,
//! eqs 4 to 11]: each pair's slope is kept for a step.

use aero_geometry::Vector;
use aero_geometry::kernel::QuinticSpline;
use rayon::prelude::*;

use super::duct::{Crowd, DENSITY, Duct};

/// Of the smoothing length's square, which keeps pairs apart [eq 6].
const APART: f64 = 0.01;
/// Particles that one thread takes at least.
const SHARE: usize = 128;

/// A neighbour: its point, the kernel's slope, and `r . grad W / (r^2 + 0.01 h^2)`.
#[derive(Clone, Copy, Debug)]
struct Neighbour {
    point: u32,
    slope: Vector<2>,
    spread: f64,
}

/// The neighbours of the gas, and the volumes of all points.
#[derive(Default)]
pub struct Sums {
    rows: Vec<Vec<Neighbour>>,
    volume: Vec<f64>,
    mass: f64,
}

impl Sums {
    /// Finds those of the first `count` of `all` particles, which come first in a crowd.
    pub fn gather(&mut self, crowd: &Crowd, duct: &Duct, count: usize, all: usize) {
        let h = crowd.cloud.smoothing;
        let fill = |(place, row): (&Vector<2>, &mut Vec<Neighbour>)| {
            row.clear();
            let mut number = 0.0;
            crowd.cloud.near(place, |j, arm| {
                let r = arm.norm();
                number += QuinticSpline::<2>::value(r, h);
                let slope = -arm * QuinticSpline::<2>::gradient_factor(r, h);
                row.push(Neighbour {
                    point: j as u32,
                    slope,
                    spread: -arm.dot(&slope) / (r * r + APART * h * h),
                });
            });
            1.0 / number
        };
        self.rows.resize_with(all.max(self.rows.len()), Vec::new);
        let places = crowd.cloud.points[..all].par_iter().with_min_len(SHARE);
        let own: Vec<f64> = places.zip(&mut self.rows[..all]).map(fill).collect();
        self.rows.truncate(count);
        let points = 0..crowd.cloud.points.len();
        self.volume.clear();
        self.volume
            .extend(points.map(|point| own[crowd.owner(point)]));
        self.mass = DENSITY * duct.spacing * duct.spacing;
    }

    /// What `pair` makes of each particle of the gas and a neighbour, summed.
    fn each<const N: usize>(
        &self,
        pair: impl Fn(usize, &Neighbour, f64) -> [f64; N] + Sync,
    ) -> Vec<[f64; N]> {
        let sum = |(i, row): (usize, &Vec<Neighbour>)| {
            let mut sum = [0.0; N];
            for neighbour in row {
                let both = self.volume[i].powi(2) + self.volume[neighbour.point as usize].powi(2);
                let term = pair(i, neighbour, both / self.mass);
                for k in 0..N {
                    sum[k] += term[k];
                }
            }
            sum
        };
        let rows = self.rows.par_iter().with_min_len(SHARE).enumerate();
        rows.map(sum).collect()
    }

    /// Accelerations by pressure and viscosity [eqs 6 to 8], and those that even out the particles, per Pa of background pressure [eq 11].
    pub fn pushes(&self, states: &[[f64; 3]], viscosity: f64) -> Vec<[f64; 4]> {
        let mean: Vec<f64> = self
            .rows
            .iter()
            .map(|row| {
                row.iter().map(|n| states[n.point as usize][0]).sum::<f64>() / row.len() as f64
            })
            .collect();
        self.each(|i, n, both| {
            let j = n.point as usize;
            let [vi, vj] = [i, j].map(|k| self.volume[k]);
            // Densities are the mass over the volumes.
            let pressure =
                (vi * (states[i][0] - mean[i]) + vj * (states[j][0] - mean[i])) / (vi + vj);
            let drag = 2.0 * self.mass / (vi + vj) * viscosity * n.spread;
            let [du, dv] = [1, 2].map(|k| states[i][k] - states[j][k]);
            [
                both * (drag * du - pressure * n.slope.x),
                both * (drag * dv - pressure * n.slope.y),
                -both * n.slope.x,
                -both * n.slope.y,
            ]
        })
    }

    /// Rates of pressure [eq 9].
    pub fn pressings(&self, states: &[[f64; 3]], stiffness: f64, diffusion: f64) -> Vec<f64> {
        let rates =
            self.each(|i, n, both| {
                let j = n.point as usize;
                let [vi, vj] = [i, j].map(|k| self.volume[k]);
                let [dp, du, dv] = [0, 1, 2].map(|k| states[i][k] - states[j][k]);
                let parting = du * n.slope.x + dv * n.slope.y;
                let density = 2.0 * self.mass / (vi + vj);
                [self.mass / vi * stiffness * vj * parting
                    + both * density * diffusion * dp * n.spread]
            });
        rates.into_iter().map(|[rate]| rate).collect()
    }
}
