//! The schemes of liquids in plain numbers: volumes that are summed, density or pressure evolved. In a [`Point`], `strain` is here the whole
//! gradient of the velocity.

use aero_geometry::Vector;

use super::gas::Renormalised;
use super::laws::Pair;
use super::wall::{continued, look, mirrored, normal_acceleration};
use super::{Matrix, Point, Viscous, Wall, diffusion};

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

    /// The pressure of no density.
    fn least(self) -> f64 {
        self.pressure(0.0)
    }

    /// Its viscosity as that of gas.
    pub fn viscous(self) -> Viscous {
        Viscous {
            viscosity: self.viscosity,
            exponent: 0.0,
            prandtl: 1.0,
        }
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
        let pair = Pair::new(i, j);
        rate.wall_acceleration += liquid.press(&pair, i, j) + liquid.rub(&pair, i, j);
    }
    rate.acceleration += rate.wall_acceleration;
    rate
}

/// What the ghost shows of the liquid, and the pressure at the wall.
pub fn show<const D: usize>(
    liquid: Liquid,
    wall: &Wall<D>,
    gas: &[Point<D>],
    mirrors: bool,
) -> Wall<D> {
    let least = liquid.least();
    let Some((seen, height)) = look(wall, gas, mirrors, least) else {
        return *wall;
    };
    let density = |pressure: f64| liquid.density + pressure / (liquid.sound * liquid.sound);
    let slope = density(seen.pressure) * normal_acceleration(wall, &seen);
    let risen = |height: f64| continued(seen.pressure - least, slope * height) + least;
    let pressure = risen(height);
    let shown = Point {
        pressure,
        density: density(pressure),
        energy: seen.energy,
        mass: density(pressure) * wall.point.volume,
        ..mirrored(wall, &seen, height, false)
    };
    Wall {
        point: shown,
        surface_pressure: risen(height - wall.depth),
        ..*wall
    }
}

/// Force on a ghost by the pressure of the liquid: what it presses by is given back where pairs share it alike; differences leave out
/// the pressure that is the same on both sides, and the wall has all of it.
pub fn thrust<const D: usize>(liquid: Liquid, ghost: &Point<D>, gas: &[Point<D>]) -> Vector<D> {
    let each = gas.iter().map(|i| {
        let pair = Pair::new(i, ghost);
        if liquid.pairwise {
            return liquid.press(&pair, i, ghost) * -i.mass;
        }
        let stress = i.renormalisation * i.pressure + ghost.renormalisation * ghost.pressure;
        stress * pair.gradient * (i.volume * ghost.volume)
    });
    each.sum()
}

/// Force on a ghost by the friction of the liquid: sums of stresses that are not renormalised, and the exchange of pairs.
pub fn friction<const D: usize>(liquid: Liquid, ghost: &Point<D>, gas: &[Point<D>]) -> Vector<D> {
    let plain = |of: &Point<D>| Point {
        strain: if liquid.pairwise {
            Matrix::zeros()
        } else {
            of.strain
        },
        renormalisation: Matrix::identity(),
        ..*of
    };
    let gas: Vec<_> = gas.iter().map(plain).collect();
    diffusion::friction(liquid.viscous(), &plain(ghost), &gas)
}

/// Moves `i` once towards even spacing, along `-h^2 / 2 grad C` by `h / 5` at most and not into a wall; velocity and density become
/// those of where it comes to.
pub fn evened_out<const D: usize>(i: &Point<D>, renormalised: &Renormalised<D>) -> Point<D> {
    let mut way = renormalised.concentration_gradient * (-0.5 * i.h * i.h);
    let wall = renormalised.wall_gradient;
    if wall.norm() * i.h > 0.36 {
        let into = wall.normalize();
        way -= into * way.dot(&into).max(0.0);
    }
    if way.norm() > 0.2 * i.h {
        way = way.normalize() * (0.2 * i.h);
    }
    Point {
        position: i.position + way,
        velocity: i.velocity + i.strain * way,
        density: i.density + i.density_gradient.dot(&way),
        ..*i
    }
}
