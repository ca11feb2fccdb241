//! The flux that knows the contact between the two waves of a jump.
//!
//! [Toro, Spruce & Speares 1994; Batten et al. 1997, SIAM J. Sci. Comput. 18, 1553-1570]

use std::array;

use super::hll::{Half, Jump};
use super::real::Real;
use super::state::Conserved;

impl<const D: usize, R: Real> Jump<D, R> {
    /// The HLLC flux through a unit area, from left to right.
    ///
    /// The contact moves at `S = (p_R - p_L + m_L u_L - m_R u_R) / (m_L - m_R)`, `m = rho (wave - u)`; behind the wave of the
    /// side that the face lies on the gas holds `U* = m / (wave - S) (1, u + (S - u_n) n, E / rho + (S - u_n)(S + p / m))`.
    #[inline(always)]
    pub fn hllc(&self) -> Conserved<D, R> {
        let Self { left, right, .. } = self;
        let zero = left.wave.like(0.0);
        let flow = |half: &Half<D, R>| half.state.density * (half.wave - half.speed);
        let (from_left, from_right) = (flow(left), flow(right));
        let contact = (right.state.pressure - left.state.pressure + from_left * left.speed
            - from_right * right.speed)
            / (from_left - from_right);
        // The side of the contact that the face lies on; either one where the contact stands on the face.
        let pick = |left: R, right: R| contact.select(left, right);
        let density = pick(left.state.density, right.state.density);
        let pressure = pick(left.state.pressure, right.state.pressure);
        let speed = pick(left.speed, right.speed);
        let energy = pick(left.energy, right.energy);
        let wave = pick(left.wave, right.wave);
        let flow = pick(from_left, from_right);
        let ahead = pick(wave.min(zero), wave.max(zero));
        let star = flow / (wave - contact);
        let push = contact - speed;
        let mass = density * speed + ahead * (star - density);
        Conserved {
            mass,
            momentum: array::from_fn(|k| {
                let velocity = pick(left.state.velocity[k], right.state.velocity[k]);
                let behind = star * (velocity + push * self.normal[k]);
                density * speed * velocity
                    + pressure * self.normal[k]
                    + ahead * (behind - density * velocity)
            }),
            energy: (energy + pressure) * speed
                + ahead * (star * (energy / density + push * (contact + pressure / flow)) - energy),
        }
    }
}
