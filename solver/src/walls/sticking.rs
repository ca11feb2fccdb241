//! Walls that gas sticks to: what ghosts below them show of motion and heat.
//!
//! The state at the wall is known, or its slope; the gas goes on beyond it as a straight line does, from where it was read through the
//! wall to the ghost. Where a Shepard sum over the gas in reach has read it, that is at the gas's centroid, not at the mirror point: a
//! mirrored state would then be too small, which costs a plane Couette flow its second order.

use aero_geometry::Vector;

use super::Ghost;
use crate::diffusive::Gradients;
use crate::gas::Gas;
use crate::pairs::extrapolation::Interpolated;
use crate::problem::{WallHeat, WallKind};
use crate::records::Matrix;

/// Heights over the wall count for at least so many smoothing lengths.
const LEAST_HEIGHT: f64 = 0.1;

/// A ghost's energy is at least this part of that of the gas or the wall, whichever is less.
const LEAST_ENERGY: f64 = 0.1;

/// The height above the wall at which gas was read, as far as slopes ask for it.
pub fn above<const D: usize>(ghost: &Ghost<D>, height: f64) -> f64 {
    height.max(LEAST_HEIGHT * ghost.shown.smoothing_length)
}

/// How far a straight line is drawn on: the depth of the ghost over the height above the wall at which gas was read, `arm` from it.
fn stretch<const D: usize>(ghost: &Ghost<D>, arm: f64) -> f64 {
    ghost.depth / above(ghost, arm - ghost.depth)
}

/// Velocity of a ghost below a surface at which the gas has the wall's velocity.
pub fn velocity<const D: usize>(ghost: &Ghost<D>, gas: &Interpolated<D>, arm: f64) -> Vector<D> {
    let surface = ghost.wall.velocity + ghost.wall.slide;
    surface - (gas.velocity - surface) * stretch(ghost, arm)
}

/// Specific internal energy of a ghost below a wall that does this to heat.
pub fn energy<const D: usize>(
    ghost: &Ghost<D>,
    gas: &Interpolated<D>,
    arm: f64,
    heat: WallHeat,
    law: &Gas,
) -> f64 {
    match heat {
        WallHeat::Adiabatic => gas.energy,
        WallHeat::Temperature(temperature) => {
            let wall = law.energy_at(gas.pressure, temperature);
            let beyond = wall - (gas.energy - wall) * stretch(ghost, arm);
            beyond.max(LEAST_ENERGY * wall.min(gas.energy))
        }
        WallHeat::Flux(flux) => {
            let beyond = gas.energy - arm * slope(gas.pressure, gas.energy, flux, law);
            beyond.max(LEAST_ENERGY * gas.energy)
        }
    }
}

/// Gradients at a ghost where the gas nearby has those `inside`: the flow goes on beyond a wall that it sticks to, or is mirrored at one along
/// which it slides; heat goes on where it passes, or is mirrored.
pub fn beyond<const D: usize>(
    law: &Gas,
    kind: WallKind,
    ghost: &Ghost<D>,
    inside: &Gradients<D>,
) -> Gradients<D> {
    let mirror = Matrix::identity() - ghost.normal * ghost.normal.transpose() * 2.0;
    let mirrored = mirror * inside.energy;
    match kind {
        WallKind::Slip => Gradients {
            velocity: mirror * inside.velocity * mirror,
            energy: mirrored,
        },
        WallKind::NoSlip(wall) => Gradients {
            velocity: inside.velocity,
            energy: match wall.heat {
                WallHeat::Adiabatic => mirrored,
                WallHeat::Temperature(_) => inside.energy,
                WallHeat::Flux(flux) => {
                    let (pressure, energy) = (ghost.shown.pressure, ghost.shown.energy);
                    mirrored + ghost.normal * (2.0 * slope(pressure, energy, flux, law))
                }
            },
        },
    }
}

/// Slope of the specific internal energy along the normal where this `flux` of heat goes from the wall into gas of a state.
fn slope(pressure: f64, energy: f64, flux: f64, law: &Gas) -> f64 {
    let density = law.density(pressure, energy);
    let coefficients = law.coefficients(density, energy);
    -flux / coefficients.conductivity
}
