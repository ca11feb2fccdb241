//! Viscosity and heat conduction in plain numbers. In a [`Point`], `strain` and `energy_slope` are here the whole gradients of velocity and
//! energy.

use aero_geometry::Vector;

use super::laws::Pair;
use super::{GAMMA, Heat, Matrix, Point, Rate, Viscous, Wall, kernel};

impl Viscous {
    /// `mu_0 T^n` of gas whose gas constant is one.
    pub fn viscosity(self, energy: f64) -> f64 {
        self.viscosity * ((GAMMA - 1.0) * energy).powf(self.exponent)
    }

    /// `k / c_v = gamma mu / Pr`.
    pub fn conductivity(self, energy: f64) -> f64 {
        GAMMA * self.viscosity(energy) / self.prandtl
    }

    /// What heat of this flux from a wall makes of the slope of the energy.
    pub fn slope(self, flux: f64, energy: f64) -> f64 {
        -flux / self.conductivity(energy)
    }

    /// The longest step, 1/8 h^2 over the larger diffusivity.
    pub fn stable_step<const D: usize>(self, gas: &[Point<D>]) -> f64 {
        let each = gas.iter().map(|i| {
            let diffusivity = self.conductivity(i.energy).max(self.viscosity(i.energy));
            0.125 * i.h * i.h * i.density / diffusivity
        });
        each.fold(f64::INFINITY, f64::min)
    }

    fn stress<const D: usize>(self, i: &Point<D>) -> Matrix<D> {
        let mut stress = i.strain + i.strain.transpose();
        let divergence: f64 = (0..D).map(|k| i.strain[(k, k)]).sum();
        for k in 0..D {
            stress[(k, k)] -= 2.0 / 3.0 * divergence;
        }
        stress * self.viscosity(i.energy)
    }

    /// Force on `i` from `j`, of the departure from their gradients alone.
    fn departure<const D: usize>(self, pair: &Pair<D>, i: &Point<D>, j: &Point<D>) -> Vector<D> {
        let apart = pair.u - (i.strain + j.strain) * pair.r * 0.5;
        let viscosity = f64::midpoint(self.viscosity(i.energy), self.viscosity(j.energy));
        apart * (2.0 * viscosity * per_square(pair) * i.volume * j.volume)
    }

    /// Heat from `j` to `i`.
    fn heat<const D: usize>(self, pair: &Pair<D>, i: &Point<D>, j: &Point<D>) -> f64 {
        let flux =
            |of: &Point<D>| of.renormalisation * of.energy_slope * self.conductivity(of.energy);
        let slope = (i.energy_slope + j.energy_slope) * 0.5;
        let apart = i.energy - j.energy - slope.dot(&pair.r);
        let conductivity = f64::midpoint(self.conductivity(i.energy), self.conductivity(j.energy));
        let both = (flux(i) + flux(j)).dot(&pair.gradient);
        (both + 2.0 * conductivity * apart * per_square(pair)) * i.volume * j.volume
    }

    /// Force on `i` from `j`.
    fn force<const D: usize>(self, pair: &Pair<D>, i: &Point<D>, j: &Point<D>) -> Vector<D> {
        let carried = |of: &Point<D>| self.stress(of) * of.renormalisation;
        let both = (carried(i) + carried(j)) * pair.gradient * (i.volume * j.volume);
        both + self.departure(pair, i, j)
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

/// Adds to the rates of `i`.
pub fn add<const D: usize>(
    viscous: Viscous,
    i: &Point<D>,
    gas: &[Point<D>],
    ghosts: &[Point<D>],
    rate: &mut Rate<D>,
) {
    let mass = i.density * i.volume;
    for (j, is_ghost) in gas
        .iter()
        .map(|j| (j, false))
        .chain(ghosts.iter().map(|j| (j, true)))
    {
        let pair = Pair::new(i, j);
        let acceleration = viscous.force(&pair, i, j) / mass;
        rate.acceleration += acceleration;
        if is_ghost {
            rate.wall_acceleration += acceleration;
        }
        rate.energy += viscous.heat(&pair, i, j) / mass;
        rate.energy -= 0.5 * viscous.departure(&pair, i, j).dot(&pair.u) / mass;
    }
    rate.energy += viscous.stress(i).dot(&i.strain) / i.density;
}

/// Force on a ghost by the gas's friction.
pub fn friction<const D: usize>(viscous: Viscous, ghost: &Point<D>, gas: &[Point<D>]) -> Vector<D> {
    let each = gas
        .iter()
        .map(|j| viscous.force(&Pair::new(ghost, j), ghost, j));
    each.sum()
}

/// Heat that goes into a ghost.
pub fn heat<const D: usize>(viscous: Viscous, ghost: &Point<D>, gas: &[Point<D>]) -> f64 {
    let each = gas
        .iter()
        .map(|j| viscous.heat(&Pair::new(ghost, j), ghost, j));
    each.sum()
}

/// The ghost with the gradients that it takes from the gas.
pub fn with_gradients<const D: usize>(
    viscous: Viscous,
    wall: &Wall<D>,
    gas: &[Point<D>],
) -> Point<D> {
    let mut point = wall.point;
    let (mut velocity, mut energy, mut total) = (Matrix::<D>::zeros(), Vector::<D>::zeros(), 0.0);
    for j in gas {
        let apart = (point.position - j.position).norm();
        let weight = kernel::value::<D>(apart, f64::midpoint(point.h, j.h));
        velocity += j.strain * weight;
        energy += j.energy_slope * weight;
        total += weight;
    }
    if total == 0.0 {
        point.strain = Matrix::zeros();
        point.energy_slope = Vector::zeros();
        return point;
    }
    let n = wall.normal;
    let reflect = Matrix::<D>::identity() - n * n.transpose() * 2.0;
    let (velocity, energy) = (velocity / total, energy / total);
    point.strain = if wall.slips {
        reflect * velocity * reflect
    } else {
        velocity
    };
    point.energy_slope = match wall.heat {
        Heat::Kept => reflect * energy,
        Heat::Passes { .. } => energy,
        Heat::Flows(flux) => reflect * energy + n * (2.0 * viscous.slope(flux, point.energy)),
    };
    point
}
