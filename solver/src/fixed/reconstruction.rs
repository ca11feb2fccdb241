//! The states on both sides of a face, from the cells' means and slopes.

use std::array;

use super::limiter::{minmod, van_leer};
use super::real::Real;
use super::state::{Primitive, dot};

/// Two cells that share a face, and how much they change towards each other.
#[derive(Clone, Copy, Debug)]
pub struct Neighbours<const D: usize, R> {
    /// Means of both.
    pub means: [Primitive<D, R>; 2],
    /// Slopes of both along the line from the first to the second cell, times its length.
    pub rises: [Primitive<D, R>; 2],
    /// From zero in strong shocks to one elsewhere.
    pub smooth: R,
    /// Below zero where no slope may be used at all.
    pub order: R,
}

impl<const D: usize, R: Real> Neighbours<D, R> {
    /// States on both sides of the face, halfway between: `q_i + phi(2 rise_i - D, D) / 2` and `q_j - phi(2 rise_j - D, D) / 2`,
    /// `D = q_j - q_i`, [van Leer 1977's extrapolation with the slope beyond each cell read off its gradient]. The limiter is van
    /// Leer's, and minmod in strong shocks. A side whose density or pressure would not be positive takes its cell's mean.
    #[inline(always)]
    pub fn states(&self) -> [Primitive<D, R>; 2] {
        let [first, second] = &self.means;
        let [rise, other_rise] = &self.rises;
        let sides = |a: R, b: R, rise: R, other_rise: R| {
            let jump = b - a;
            let step = |rise: R| {
                let beyond = rise * 2.0 - jump;
                let careful = minmod(beyond, jump);
                (careful + self.smooth * (van_leer(beyond, jump) - careful)) * 0.5
            };
            [a + step(rise), b - step(other_rise)]
        };
        let density = sides(
            first.density,
            second.density,
            rise.density,
            other_rise.density,
        );
        let pressure = sides(
            first.pressure,
            second.pressure,
            rise.pressure,
            other_rise.pressure,
        );
        let velocity: [[R; 2]; D] = array::from_fn(|k| {
            sides(
                first.velocity[k],
                second.velocity[k],
                rise.velocity[k],
                other_rise.velocity[k],
            )
        });
        array::from_fn(|side| {
            let mean = &self.means[side];
            let least = density[side].min(pressure[side]).min(self.order);
            Primitive {
                density: least.select(density[side], mean.density),
                velocity: array::from_fn(|k| least.select(velocity[k][side], mean.velocity[k])),
                pressure: least.select(pressure[side], mean.pressure),
            }
        })
    }
}

/// `slopes . apart` for every variable.
#[inline(always)]
pub fn rise<R: Real, const D: usize>(
    slopes: &[Primitive<D, R>; D],
    apart: &[R; D],
) -> Primitive<D, R> {
    let [density, pressure] = [
        array::from_fn(|k| slopes[k].density),
        array::from_fn(|k| slopes[k].pressure),
    ]
    .map(|values| dot(&values, apart));
    Primitive {
        density,
        velocity: array::from_fn(|k| dot(&array::from_fn(|axis| slopes[axis].velocity[k]), apart)),
        pressure,
    }
}
