//! The state of the gas in a cell: what it holds, and what it feels like.

use super::equation_of_state::EquationOfState;
use super::real::Real;
use crate::problem::State;

/// Density, velocity and pressure.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Primitive<const D: usize, R = f64> {
    /// Density, kg/m^3.
    pub density: R,
    /// Velocity, m/s.
    pub velocity: [R; D],
    /// Pressure, Pa.
    pub pressure: R,
}

/// Mass, momentum and energy: per volume, in sum, or per time through a face.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Conserved<const D: usize, R = f64> {
    /// Mass.
    pub mass: R,
    /// Momentum.
    pub momentum: [R; D],
    /// Internal and kinetic energy.
    pub energy: R,
}

/// `a.b`.
#[inline(always)]
pub fn dot<R: Real, const D: usize>(a: &[R; D], b: &[R; D]) -> R {
    let mut sum = a[0] * b[0];
    for k in 1..D {
        sum = sum + a[k] * b[k];
    }
    sum
}

/// `a + factor b`.
#[inline(always)]
fn plus<const D: usize>(a: &[f64; D], factor: f64, b: &[f64; D]) -> [f64; D] {
    let mut sum = *a;
    for k in 0..D {
        sum[k] += factor * b[k];
    }
    sum
}

/// `factor a`.
///
/// A loop, as in all that is done lane by lane: the closures of `array::map` and `array::from_fn` are not compiled with the
/// processor's vector instructions.
#[inline(always)]
pub fn scaled<R: Real, const D: usize>(a: &[R; D], factor: R) -> [R; D] {
    let mut scaled = *a;
    for k in 0..D {
        scaled[k] = a[k] * factor;
    }
    scaled
}

impl<const D: usize, R: Real> Primitive<D, R> {
    /// Mass, momentum and energy per volume.
    #[inline(always)]
    pub fn conserved<G: EquationOfState>(&self, gas: &G) -> Conserved<D, R> {
        let kinetic = self.density * dot(&self.velocity, &self.velocity) * 0.5;
        Conserved {
            mass: self.density,
            momentum: scaled(&self.velocity, self.density),
            energy: gas.internal_energy(self.density, self.pressure) + kinetic,
        }
    }

    /// Flux through a unit area whose normal the gas moves along at `speed`: `u.n U + p (0, n, u.n)`.
    #[inline(always)]
    pub fn flux(&self, energy: R, speed: R, normal: &[R; D]) -> Conserved<D, R> {
        let mass = self.density * speed;
        let mut momentum = self.velocity;
        for k in 0..D {
            momentum[k] = mass * self.velocity[k] + self.pressure * normal[k];
        }
        Conserved {
            mass,
            momentum,
            energy: (energy + self.pressure) * speed,
        }
    }

    /// `p / rho`, the temperature times the gas constant.
    #[inline(always)]
    pub fn heat(&self) -> R {
        self.pressure / self.density
    }

    /// How much more `p / rho` is where the state has changed by `rise`, to first order.
    #[inline(always)]
    pub fn warming(&self, rise: &Self) -> R {
        (rise.pressure - self.heat() * rise.density) / self.density
    }

    /// The same state seen in a mirror across the unit `normal`.
    #[inline(always)]
    pub fn mirrored(&self, normal: &[R; D]) -> Self {
        let twice = dot(&self.velocity, normal) * 2.0;
        let mut velocity = self.velocity;
        for k in 0..D {
            velocity[k] = velocity[k] - twice * normal[k];
        }
        Self { velocity, ..*self }
    }
}

impl<const D: usize> Primitive<D> {
    /// The state of a case, as an array.
    pub fn of(state: &State<D>) -> Self {
        Self {
            density: state.density,
            velocity: state.velocity.into(),
            pressure: state.pressure,
        }
    }

    /// True of a gas.
    pub fn makes_sense(&self) -> bool {
        self.density > 0.0
            && self.pressure > 0.0
            && self.density.is_finite()
            && self.pressure.is_finite()
            && self.velocity.iter().all(|u| u.is_finite())
    }

    /// Change of the flux through `area` with a small `change` of what the gas of this state and `energy` holds per volume: the flux's
    /// derivative times it, which is of first order however large the change.
    #[inline(always)]
    pub fn flux_change<G: EquationOfState>(
        &self,
        gas: &G,
        energy: f64,
        area: &[f64; D],
        change: &Conserved<D>,
    ) -> Conserved<D> {
        let speed = dot(&self.velocity, area);
        let mass = dot(&change.momentum, area);
        let faster = (mass - speed * change.mass) / self.density;
        let kinetic = dot(&self.velocity, &change.momentum)
            - 0.5 * dot(&self.velocity, &self.velocity) * change.mass;
        let pressure = gas.pressure_change(
            self.density,
            self.pressure,
            [change.mass, change.energy - kinetic],
        );
        let mut momentum = change.momentum;
        for k in 0..D {
            momentum[k] = change.momentum[k] * speed
                + self.density * self.velocity[k] * faster
                + pressure * area[k];
        }
        Conserved {
            mass,
            momentum,
            energy: (change.energy + pressure) * speed + (energy + self.pressure) * faster,
        }
    }

    /// All variables zero.
    pub const ZERO: Self = Self {
        density: 0.0,
        velocity: [0.0; D],
        pressure: 0.0,
    };

    /// `self + factor other`.
    #[inline(always)]
    #[must_use]
    pub fn plus(&self, factor: f64, other: &Self) -> Self {
        Self {
            density: self.density + factor * other.density,
            velocity: plus(&self.velocity, factor, &other.velocity),
            pressure: self.pressure + factor * other.pressure,
        }
    }
}

impl<const D: usize> Conserved<D> {
    /// Nothing.
    pub const ZERO: Self = Self {
        mass: 0.0,
        momentum: [0.0; D],
        energy: 0.0,
    };

    /// Density, velocity and pressure of what holds this much per volume; not of a gas where the pressure is not above zero.
    #[inline(always)]
    pub fn primitive<G: EquationOfState>(&self, gas: &G) -> Primitive<D> {
        let volume = 1.0 / self.mass;
        let velocity = scaled(&self.momentum, volume);
        let kinetic = 0.5 * dot(&self.momentum, &velocity);
        Primitive {
            density: self.mass,
            velocity,
            pressure: gas.pressure(self.mass, self.energy - kinetic),
        }
    }

    /// `self + factor other`.
    #[inline(always)]
    #[must_use]
    pub fn plus(&self, factor: f64, other: &Self) -> Self {
        Self {
            mass: self.mass + factor * other.mass,
            momentum: plus(&self.momentum, factor, &other.momentum),
            energy: self.energy + factor * other.energy,
        }
    }
}

/// Gas of Mach 3 along the first axis, whose speed of sound is one, ahead of a shock.
#[cfg(test)]
pub fn front() -> Primitive<2> {
    Primitive {
        density: 1.4,
        velocity: [3.0, 0.0],
        pressure: 1.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gas::IdealGas;
    use approx::assert_relative_eq;

    #[test]
    fn the_flux_changes_as_its_derivative_says() {
        let gas = IdealGas::new(1.4);
        let held = Conserved {
            mass: 1.3,
            momentum: [0.7, -1.1],
            energy: 4.2,
        };
        let area = [0.8, -0.3];
        let change = Conserved {
            mass: 0.4,
            momentum: [-0.9, 0.5],
            energy: 0.6,
        };
        let flux = |part: f64| {
            let held = held.plus(part, &change);
            let state = held.primitive(&gas);
            state.flux(held.energy, dot(&state.velocity, &area), &area)
        };
        let step = 1e-5;
        let slope = flux(step).plus(-1.0, &flux(-step));
        let told = held
            .primitive(&gas)
            .flux_change(&gas, held.energy, &area, &change);
        assert_relative_eq!(slope.mass / (2.0 * step), told.mass, epsilon = 1e-8);
        assert_relative_eq!(slope.energy / (2.0 * step), told.energy, epsilon = 1e-8);
        for k in 0..2 {
            assert_relative_eq!(
                slope.momentum[k] / (2.0 * step),
                told.momentum[k],
                epsilon = 1e-8
            );
        }
    }
}
