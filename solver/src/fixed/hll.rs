//! The waves that a jump sends out, and the flux between them as if they held one state alone.
//!
//! [Harten, Lax & van Leer 1983; speeds of Einfeldt 1988, SIAM J. Numer. Anal. 25, 294-318]

use super::equation_of_state::EquationOfState;
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
    pub fn new<G: EquationOfState>(
        gas: &G,
        left: Primitive<D, R>,
        right: Primitive<D, R>,
        normal: [R; D],
    ) -> Self {
        let mut sides = [
            Half::new(gas, left, &normal),
            Half::new(gas, right, &normal),
        ];
        let sounds = [
            gas.sound_square(left.density, left.pressure),
            gas.sound_square(right.density, right.pressure),
        ];
        let weights = [left.density.sqrt(), right.density.sqrt()];
        let share = weights[0].like(1.0) / (weights[0] + weights[1]);
        let (left_share, right_share) = (weights[0] * share, weights[1] * share);
        let mean = left_share * sides[0].speed + right_share * sides[1].speed;
        let apart = sides[1].speed - sides[0].speed;
        let sound = (left_share * sounds[0]
            + right_share * sounds[1]
            + left_share * right_share * apart * apart * 0.5)
            .sqrt();
        sides[0].wave = (sides[0].speed - sounds[0].sqrt()).min(mean - sound);
        sides[1].wave = (sides[1].speed + sounds[1].sqrt()).max(mean + sound);
        let [left, right] = sides;
        Self {
            left,
            right,
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
        let a = left.state.flux(left.energy, left.speed, &self.normal);
        let b = right.state.flux(right.energy, right.speed, &self.normal);
        let mut momentum = a.momentum;
        for k in 0..D {
            let apart = right.state.density * right.state.velocity[k]
                - left.state.density * left.state.velocity[k];
            momentum[k] = from_left * a.momentum[k] + from_right * b.momentum[k] + both * apart;
        }
        Conserved {
            mass: from_left * a.mass
                + from_right * b.mass
                + both * (right.state.density - left.state.density),
            momentum,
            energy: from_left * a.energy
                + from_right * b.energy
                + both * (right.energy - left.energy),
        }
    }
}

impl<const D: usize, R: Real> Half<D, R> {
    /// A side in this state; its wave is yet to be found.
    #[inline(always)]
    fn new<G: EquationOfState>(gas: &G, state: Primitive<D, R>, normal: &[R; D]) -> Self {
        let speed = dot(&state.velocity, normal);
        Self {
            state,
            speed,
            energy: gas.internal_energy(state.density, state.pressure)
                + state.density * dot(&state.velocity, &state.velocity) * 0.5,
            wave: speed,
        }
    }
}
