//! The flux that knows the contact between the two waves of a jump.
//!
//! [Toro, Spruce & Speares 1994; Batten et al. 1997, SIAM J. Sci. Comput. 18, 1553-1570]

use super::hll::Jump;
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
        let from_left = left.state.density * (left.wave - left.speed);
        let from_right = right.state.density * (right.wave - right.speed);
        let contact = (right.state.pressure - left.state.pressure + from_left * left.speed
            - from_right * right.speed)
            / (from_left - from_right);
        // The side of the contact that the face lies on; either one where the contact stands on the face.
        let density = contact.select(left.state.density, right.state.density);
        let pressure = contact.select(left.state.pressure, right.state.pressure);
        let speed = contact.select(left.speed, right.speed);
        let energy = contact.select(left.energy, right.energy);
        let wave = contact.select(left.wave, right.wave);
        let flow = contact.select(from_left, from_right);
        let ahead = contact.select(wave.min(zero), wave.max(zero));
        let star = flow / (wave - contact);
        let push = contact - speed;
        let mut momentum = self.normal;
        for k in 0..D {
            let velocity = contact.select(left.state.velocity[k], right.state.velocity[k]);
            let behind = star * (velocity + push * self.normal[k]);
            momentum[k] = density * speed * velocity
                + pressure * self.normal[k]
                + ahead * (behind - density * velocity);
        }
        let behind = star * (energy / density + push * (contact + pressure / flow));
        Conserved {
            mass: density * speed + ahead * (star - density),
            momentum,
            energy: (energy + pressure) * speed + ahead * (behind - energy),
        }
    }
}
