//! What viscosity and heat conduction do to a manufactured solution.

use aero_geometry::Vector;
use aero_solver::gas::IdealGas;
use nalgebra::{Matrix3, Vector3};
use num_dual::hessian;

use super::{Manufactured, Rubbed, Values, at};
use crate::scene::formula::Number;

impl<const D: usize> Manufactured<D> {
    /// `mu (lap u + grad div u / 3) + (grad u + grad u^T - 2/3 div u) grad mu`, `tau : grad u` and `div (k grad T)` per mass there and then;
    /// nothing of gas without viscosity.
    pub(super) fn rubbed(&self, position: &Vector<D>, time: f64) -> Rubbed<D> {
        let IdealGas {
            gamma,
            constant,
            transport,
        } = self.gas;
        let Some(transport) = transport else {
            return Rubbed::none();
        };
        let place = Vector3::from_fn(|k, _| at(position, k));
        let (heat, heat_slopes, heat_bends) =
            hessian(|x| heat(&self.values_at([x[0], x[1], x[2]], time)), &place);
        let velocities: [(f64, Vector3<f64>, Matrix3<f64>); D] = std::array::from_fn(|k| {
            hessian(
                |x| self.values_at([x[0], x[1], x[2]], time).velocity[k],
                &place,
            )
        });
        let density = self.state(position, time).density;
        let temperature = heat / constant;
        let viscosity = transport.viscosity.at(temperature);
        // By p / rho.
        let thickening = transport.viscosity.slope(temperature) / constant;
        let conduction = gamma / ((gamma - 1.0) * transport.prandtl);
        let slope = |k: usize, axis: usize| velocities[k].1[axis];
        let divergence: f64 = (0..D).map(|k| slope(k, k)).sum();
        let strain = |k: usize, axis: usize| {
            let round = if k == axis {
                2.0 / 3.0 * divergence
            } else {
                0.0
            };
            slope(k, axis) + slope(axis, k) - round
        };
        let bend = |k: usize| {
            (0..D)
                .map(|axis| velocities[k].2[(axis, axis)])
                .sum::<f64>()
        };
        let spread = |k: usize| (0..D).map(|n| velocities[n].2[(n, k)]).sum::<f64>();
        let thick = |k: usize| {
            let along = (0..D).map(|axis| strain(k, axis) * thickening * heat_slopes[axis]);
            along.sum::<f64>()
        };
        let pairs = (0..D).flat_map(|k| (0..D).map(move |axis| (k, axis)));
        let work: f64 = pairs
            .map(|(k, axis)| strain(k, axis) * slope(k, axis))
            .sum();
        let even: f64 = (0..D).map(|k| heat_bends[(k, k)]).sum();
        let steep: f64 = (0..D).map(|k| heat_slopes[k] * heat_slopes[k]).sum();
        Rubbed {
            strained: Vector::from_fn(|k, _| viscosity * bend(k) / density),
            dilated: Vector::from_fn(|k, _| viscosity * spread(k) / (3.0 * density)),
            thickened: Vector::from_fn(|k, _| thick(k) / density),
            dissipated: viscosity * work / density,
            conducted: conduction * (viscosity * even + thickening * steep) / density,
        }
    }

    fn values_at<T: Number>(&self, position: [T; 3], time: f64) -> Values<T, D> {
        self.values(position, T::from(time))
    }
}

/// `p / rho`.
fn heat<T: Number, const D: usize>(values: &Values<T, D>) -> T {
    values.pressure / values.density
}
