//! The waves that a jump sends out, and the flux between them as if they held one state alone.
//!
//! [Harten, Lax & van Leer 1983; speeds of Einfeldt 1988, SIAM J. Numer. Anal. 25, 294-318]

use std::array;

use super::gas::Gas;
use super::real::Real;
use super::state::{Conserved, Primitive, dot};

/// One side of a face.
#[derive(Clone, Copy, Debug)]
pub struct Half<const D: usize, R> {
    /// State there.
    pub state: Primitive<D, R>,
    /// Its velocity along the normal.
    pub speed: R,
    /// Its energy per volume.
    pub energy: R,
    /// Speed of the wave into this side, along the normal.
    pub wave: R,
}

/// A jump and the waves that it sends out, in the frame of the face's unit normal, left to right.
#[derive(Clone, Copy, Debug)]
pub struct Jump<const D: usize, R> {
    /// Left side.
    pub left: Half<D, R>,
    /// Right side.
    pub right: Half<D, R>,
    /// Unit normal.
    pub normal: [R; D],
}

impl<const D: usize, R: Real> Jump<D, R> {
    /// Between two states. The speeds are `min(u_L - a_L, u - a)` and `max(u_R + a_R, u + a)` with means over
    /// `sqrt(rho)`, `a^2 = <a^2> + (sqrt(rho_L rho_R) / (sqrt(rho_L) + sqrt(rho_R))^2 / 2) (u_R - u_L)^2` [Einfeldt 1988, section 5].
    #[inline(always)]
    pub fn new<G: Gas>(
        gas: &G,
        left: Primitive<D, R>,
        right: Primitive<D, R>,
        normal: [R; D],
    ) -> Self {
        let speeds = [dot(&left.velocity, &normal), dot(&right.velocity, &normal)];
        let sounds = [
            gas.sound_square(left.density, left.pressure),
            gas.sound_square(right.density, right.pressure),
        ];
        let weights = [left.density.sqrt(), right.density.sqrt()];
        let sum = weights[0] + weights[1];
        let share = sum.like(1.0) / sum;
        let [left_share, right_share] = weights.map(|weight| weight * share);
        let mean = left_share * speeds[0] + right_share * speeds[1];
        let apart = speeds[1] - speeds[0];
        let sound = (left_share * sounds[0]
            + right_share * sounds[1]
            + left_share * right_share * apart * apart * 0.5)
            .sqrt();
        let half = |state: Primitive<D, R>, speed, wave| Half {
            energy: gas.internal_energy(state.density, state.pressure)
                + state.density * dot(&state.velocity, &state.velocity) * 0.5,
            state,
            speed,
            wave,
        };
        Self {
            left: half(
                left,
                speeds[0],
                (speeds[0] - sounds[0].sqrt()).min(mean - sound),
            ),
            right: half(
                right,
                speeds[1],
                (speeds[1] + sounds[1].sqrt()).max(mean + sound),
            ),
            normal,
        }
    }

    /// The HLL flux through a unit area, from left to right.
    #[inline(always)]
    pub fn hll(&self) -> Conserved<D, R> {
        let Self { left, right, .. } = self;
        let zero = left.wave.like(0.0);
        let (slow, fast) = (left.wave.min(zero), right.wave.max(zero));
        let share = zero.like(1.0) / (fast - slow);
        let (from_left, from_right, both) = (fast * share, -slow * share, slow * fast * share);
        let [a, b] =
            [left, right].map(|half| half.state.flux(half.energy, half.speed, &self.normal));
        let mix = |a: R, b: R, apart: R| from_left * a + from_right * b + both * apart;
        let momentum = |half: &Half<D, R>, k: usize| half.state.density * half.state.velocity[k];
        Conserved {
            mass: mix(a.mass, b.mass, right.state.density - left.state.density),
            momentum: array::from_fn(|k| {
                mix(
                    a.momentum[k],
                    b.momentum[k],
                    momentum(right, k) - momentum(left, k),
                )
            }),
            energy: mix(a.energy, b.energy, right.energy - left.energy),
        }
    }
}
