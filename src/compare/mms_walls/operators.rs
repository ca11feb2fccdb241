//! The sums of the second-order scheme L-IPST-C [Negi & Ramachandran 2022, eqs 3, 4] as numbers: particles stay, so they are made once.

use aero_geometry::Vector;
use aero_geometry::kernel::QuinticSpline;
use nalgebra::Matrix2;
use rayon::prelude::*;

use crate::points::cloud::Cloud;

/// Pressure and velocity of each particle.
pub type Fields = Vec<[f64; 3]>;
/// Gradients of the three.
pub type Gradients = Vec<[[f64; 2]; 3]>;

/// The corrected gradient, `sum_j (f_j - f_i) L_i grad W omega_j` with `L_i = (sum_j (x_j - x_i) grad W omega_j)^-1` [Bonet & Lok 1999] and
/// `omega_j = 1 / sum_k W_jk`, of the particles in front.
#[derive(Clone, Debug)]
pub struct Gradient {
    start: Vec<usize>,
    neighbour: Vec<u32>,
    weight: Vec<[f64; 2]>,
}

impl Gradient {
    /// For the first `count` points of a cloud of these volumes.
    pub fn new(cloud: &Cloud, volume: &[f64], count: usize) -> Self {
        let rows: Vec<Vec<(u32, [f64; 2])>> = cloud.points[..count]
            .par_iter()
            .map(|place| row(cloud, volume, place))
            .collect();
        let mut gradient = Self {
            start: vec![0],
            neighbour: Vec::new(),
            weight: Vec::new(),
        };
        for row in rows {
            for (neighbour, weight) in row {
                gradient.neighbour.push(neighbour);
                gradient.weight.push(weight);
            }
            gradient.start.push(gradient.neighbour.len());
        }
        gradient
    }

    fn row(&self, i: usize) -> impl Iterator<Item = (usize, [f64; 2])> {
        let range = self.start[i]..self.start[i + 1];
        let neighbours = self.neighbour[range.clone()].iter();
        neighbours
            .map(|&j| j as usize)
            .zip(self.weight[range].iter().copied())
    }

    /// Gradients of the three fields.
    pub fn of(&self, fields: &Fields) -> Gradients {
        let at = |i: usize| {
            let mut sum = [[0.0; 2]; 3];
            for (j, weight) in self.row(i) {
                for k in 0..3 {
                    let difference = fields[j][k] - fields[i][k];
                    sum[k][0] += weight[0] * difference;
                    sum[k][1] += weight[1] * difference;
                }
            }
            sum
        };
        (0..self.start.len() - 1).into_par_iter().map(at).collect()
    }

    /// The Laplacian of the velocity at `i`: the divergence of its gradient [eq 4].
    pub fn laplacian(&self, i: usize, gradients: &Gradients) -> [f64; 2] {
        let mut sum = [0.0; 2];
        for (j, weight) in self.row(i) {
            for k in 0..2 {
                let [a, b] =
                    [0, 1].map(|axis| gradients[j][k + 1][axis] - gradients[i][k + 1][axis]);
                sum[k] += weight[0] * a + weight[1] * b;
            }
        }
        sum
    }
}

/// `1 / sum_k W_jk` of all points, m^2.
pub fn volumes(cloud: &Cloud) -> Vec<f64> {
    let volume = |place: &Vector<2>| {
        let mut sum = 0.0;
        cloud.near(place, |_, arm| {
            sum += QuinticSpline::<2>::value(arm.norm(), cloud.smoothing);
        });
        1.0 / sum
    };
    cloud.points.par_iter().map(volume).collect()
}

/// Neighbours of one point and their weights.
fn row(cloud: &Cloud, volume: &[f64], place: &Vector<2>) -> Vec<(u32, [f64; 2])> {
    let mut slopes: Vec<(u32, Vector<2>)> = Vec::new();
    let mut moment = Matrix2::zeros();
    cloud.near(place, |j, arm| {
        let factor = QuinticSpline::<2>::gradient_factor(arm.norm(), cloud.smoothing);
        let slope = -arm * factor * volume[j];
        moment += slope * arm.transpose();
        slopes.push((j as u32, slope));
    });
    // Where neighbours lie along a line there is no gradient across it.
    let correction = moment.pseudo_inverse(LEAST_MOMENT).unwrap_or_default();
    slopes
        .into_iter()
        .map(|(j, slope)| {
            let weight = correction * slope;
            (j, [weight.x, weight.y])
        })
        .collect()
}

/// Moments below this, of one where neighbours are all around, are taken for none.
const LEAST_MOMENT: f64 = 1e-3;
