//! The wave that goes out goes on through what has left, and the one that comes in relaxes: the project's outlet that holds a pressure.

use crate::outlets::duct::{Crowd, DENSITY};
use crate::outlets::particle::Particle;
use crate::outlets::treatment::{Next, Sight, Treatment};
use aero_geometry::kernel::QuinticSpline;

/// `dJ+/dt = -c dJ+/dx` along the particle's way, with the slope of what is upstream of it; `J-` rides along and relaxes,
/// `dJ-/dt = sigma (1 - M^2) p / (rho L)` [Poinsot & Lele 1992, eq 40]. `J = u +- p / (rho c)`.
pub struct Evolved;

/// The solver's default.
const RELAXATION: f64 = 0.25;

impl Treatment for Evolved {
    fn name(&self) -> &'static str {
        "evolved characteristics"
    }

    fn next(&self, one: &Particle, sight: &Sight<'_>) -> Next {
        let (duct, impedance) = (sight.duct, sight.impedance());
        let ahead = |one: &Particle| one.state[1] + one.state[0] / impedance;
        let back = one.state[1] - one.state[0] / impedance;
        let (mut rise, mut square) = (0.0, 0.0);
        let mut add = |crowd: &Crowd, particles: &[Particle]| {
            crowd.cloud.near(&one.position, |j, arm| {
                if arm.x < 0.0 {
                    let weight = QuinticSpline::<2>::value(arm.norm(), crowd.cloud.smoothing);
                    rise += weight * arm.x * (ahead(&particles[crowd.owner(j)]) - ahead(one));
                    square += weight * arm.x * arm.x;
                }
            });
        };
        add(sight.gas_crowd, sight.gas);
        add(sight.beyond_crowd, sight.beyond);
        let slope = if square > 0.0 { rise / square } else { 0.0 };
        let mach = one.state[1] / duct.sound;
        let pull = RELAXATION * (1.0 - mach * mach) * one.state[0] / (DENSITY * duct.length);
        let step = duct.step();
        let ahead = ahead(one) - step * duct.sound * slope;
        let back = back + step * pull;
        let pressure = 0.5 * impedance * (ahead - back);
        Next::with([pressure, 0.5 * (ahead + back), one.state[2]])
    }
}
