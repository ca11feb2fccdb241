//! Gas as the waves that cross a plane: entropy, and two sounds.

use aero_geometry::Vector;

use super::model::Place;
use crate::particles::Particle;

/// Depth, in spacings, of the layer of gas in which a wave on its way out is read.
const LAYER: f64 = 2.0;

/// The part of a state that moves along one direction, with speeds `u + c`, `u - c` and `u`: the invariants that sound carries
/// [Riemann 1860; e.g. Toro 2009, section 3.1.3], and what the gas carries.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Waves {
    /// `u + 2 c / (gamma - 1)`.
    pub ahead: f64,
    /// `u - 2 c / (gamma - 1)`.
    pub back: f64,
    /// `p / rho^gamma`.
    pub entropy: f64,
}

/// Density, speed along the direction, and pressure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Along {
    /// Density.
    pub density: f64,
    /// Speed along the direction.
    pub speed: f64,
    /// Pressure.
    pub pressure: f64,
}

impl Along {
    /// Speed of sound.
    pub fn sound(&self, gamma: f64) -> f64 {
        (gamma * self.pressure / self.density).sqrt()
    }

    /// Seen from the other side.
    #[must_use]
    pub fn turned(self) -> Self {
        Self {
            speed: -self.speed,
            ..self
        }
    }

    /// Speed, and the pressure as what the speed of sound rises with in gas of one entropy, `p^((gamma - 1) / (2 gamma))`.
    pub fn speed_and_rise(&self, gamma: f64) -> [f64; 2] {
        [self.speed, self.pressure.powf(0.5 * (gamma - 1.0) / gamma)]
    }

    /// As waves.
    pub fn waves(&self, gamma: f64) -> Waves {
        let sound = 2.0 * self.sound(gamma) / (gamma - 1.0);
        Waves {
            ahead: self.speed + sound,
            back: self.speed - sound,
            entropy: self.pressure / self.density.powf(gamma),
        }
    }
}

impl Waves {
    /// The state that they make; none where they leave a vacuum.
    pub fn state(&self, gamma: f64) -> Option<Along> {
        let sound = 0.25 * (gamma - 1.0) * (self.ahead - self.back);
        if sound <= 0.0 {
            return None;
        }
        let square = sound * sound;
        let density = (square / (gamma * self.entropy)).powf(1.0 / (gamma - 1.0));
        Some(Along {
            density,
            speed: 0.5 * (self.ahead + self.back),
            pressure: density * square / gamma,
        })
    }
}

/// Mean over the mass of gas next to `place` of the invariant `u - 2 c / (gamma - 1)` that sound carries out against the
/// flow, with `u` into the domain; none where no gas is near. Drawn out to the side it would feed on itself.
pub fn outgoing<const D: usize>(
    place: &Place,
    spacing: f64,
    gamma: f64,
    fluid: &[Particle<D>],
) -> Option<f64> {
    let heat = gamma - 1.0;
    let (mut sum, mut mass) = (0.0, 0.0);
    for particle in fluid {
        let is_near = -place.depth(&particle.position) < LAYER * spacing;
        if is_near && place.faces(&particle.position) {
            let sound = (gamma * heat * particle.energy).sqrt();
            let wave = place.inward() * particle.velocity[place.axis] - 2.0 * sound / heat;
            sum += particle.mass * wave;
            mass += particle.mass;
        }
    }
    (mass > 0.0).then(|| sum / mass)
}

/// A velocity along the axis of `place`, at this speed into the domain.
pub fn inwards<const D: usize>(place: &Place, speed: f64) -> Vector<D> {
    let mut velocity = Vector::zeros();
    velocity[place.axis] = place.inward() * speed;
    velocity
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn waves_and_state_are_inverse() {
        let along = Along {
            density: 1.3,
            speed: -0.4,
            pressure: 0.7,
        };
        let again = along.waves(1.4).state(1.4).unwrap();
        assert_relative_eq!(again.density, along.density, epsilon = 1e-14);
        assert_relative_eq!(again.speed, along.speed, epsilon = 1e-14);
        assert_relative_eq!(again.pressure, along.pressure, epsilon = 1e-14);
    }

    #[test]
    fn gas_that_parts_faster_than_it_expands_leaves_a_vacuum() {
        let waves = Waves {
            ahead: 1.0,
            back: 1.5,
            entropy: 1.0,
        };
        assert_eq!(waves.state(1.4), None);
    }
}
