//! The schemes of liquids in plain numbers: volumes that are summed, density or pressure evolved. In a [`Point`], `strain` is here the whole
//! gradient of the velocity.

use aero_geometry::Vector;

use super::laws::Pair;
use super::{Matrix, Point};

/// A liquid whose pressure is linear in its density, and how it is solved.
#[derive(Clone, Copy, Debug)]
pub struct Liquid {
    /// By averages of pairs, without renormalisation; by differences otherwise.
    pub pairwise: bool,
    pub damped: bool,
    pub sound: f64,
    /// Density without pressure.
    pub density: f64,
    pub viscosity: f64,
}

/// Rates of one particle.
pub struct Rate<const D: usize> {
    pub acceleration: Vector<D>,
    pub wall_acceleration: Vector<D>,
    pub density: f64,
    pub velocity_gradient: Matrix<D>,
}

impl Liquid {
    pub fn pressure(self, density: f64) -> f64 {
        self.sound * self.sound * (density - self.density)
    }

    /// What `j` presses `i` by.
    fn press<const D: usize>(self, pair: &Pair<D>, i: &Point<D>, j: &Point<D>) -> Vector<D> {
        if self.pairwise {
            // Weighed by the density of the other, as masses are equal.
            let weights = [1.0 / i.volume, 1.0 / j.volume];
            let mean =
                (weights[1] * i.pressure + weights[0] * j.pressure) / (weights[0] + weights[1]);
            let squares = i.volume * i.volume + j.volume * j.volume;
            return pair.gradient * (-squares * mean / i.mass);
        }
        i.renormalisation * pair.gradient * (j.volume * (i.pressure - j.pressure) / i.density)
    }

    /// What `j` gives `i` of its density.
    fn damp<const D: usize>(self, pair: &Pair<D>, i: &Point<D>, j: &Point<D>) -> f64 {
        let diffusivity = 0.5 * pair.h * self.sound / 8.0;
        if !self.damped {
            return 0.0;
        }
        if self.pairwise {
            let squares = i.volume * i.volume + j.volume * j.volume;
            return diffusivity * squares / i.volume * (i.density - j.density) * per_square(pair);
        }
        let rise = j.density_gradient - i.density_gradient;
        diffusivity * j.volume * rise.dot(&(i.renormalisation * pair.gradient))
    }

    fn stress<const D: usize>(self, of: &Point<D>) -> Matrix<D> {
        let mut stress = of.strain + of.strain.transpose();
        let divergence: f64 = (0..D).map(|k| of.strain[(k, k)]).sum();
        for k in 0..D {
            stress[(k, k)] -= 2.0 / 3.0 * divergence;
        }
        stress * self.viscosity
    }

    /// What `j` rubs `i` by.
    fn rub<const D: usize>(self, pair: &Pair<D>, i: &Point<D>, j: &Point<D>) -> Vector<D> {
        let exchange = 2.0 * self.viscosity * j.volume * per_square(pair);
        if self.pairwise {
            return pair.u * (exchange / i.density);
        }
        let apart = pair.u - (i.strain + j.strain) * pair.r * 0.5;
        let rise = self.stress(j) - self.stress(i);
        (rise * (i.renormalisation * pair.gradient) * j.volume + apart * exchange) / i.density
    }
}

/// `r.grad W / r^2`; nothing of a particle with itself.
fn per_square<const D: usize>(pair: &Pair<D>) -> f64 {
    if pair.distance > 0.0 {
        pair.r.dot(&pair.gradient) / (pair.distance * pair.distance)
    } else {
        0.0
    }
}

/// The gradient of the velocity at `i`.
pub fn velocity_gradient<const D: usize>(i: &Point<D>, all: &[Point<D>]) -> Matrix<D> {
    let mut slope = Matrix::<D>::zeros();
    for j in all {
        let pair = Pair::new(i, j);
        slope -= pair.u * pair.gradient.transpose() * j.volume;
    }
    slope * i.renormalisation
}

/// The rates of `i`, whose shift and gradients are known.
pub fn rate<const D: usize>(
    liquid: Liquid,
    i: &Point<D>,
    gas: &[Point<D>],
    ghosts: &[Point<D>],
) -> Rate<D> {
    let all = [gas, ghosts].concat();
    let velocity_gradient = velocity_gradient(i, &all);
    let divergence: f64 = (0..D).map(|k| velocity_gradient[(k, k)]).sum();
    let mut rate = Rate {
        acceleration: velocity_gradient * i.shift,
        wall_acceleration: Vector::zeros(),
        density: i.density_gradient.dot(&i.shift) - i.density * divergence,
        velocity_gradient,
    };
    for j in gas {
        let pair = Pair::new(i, j);
        rate.acceleration += liquid.press(&pair, i, j) + liquid.rub(&pair, i, j);
        rate.density += liquid.damp(&pair, i, j);
    }
    for j in ghosts {
        rate.wall_acceleration += liquid.press(&Pair::new(i, j), i, j);
    }
    rate.acceleration += rate.wall_acceleration;
    rate
}
