//! Slow viscous flow between two plane walls, from rest.
//!
//! Source: J. P. Morris, P. J. Fox & Y. Zhu, "Modeling low Reynolds number incompressible flows using SPH", J. Comput. Phys. 136 (1997)
//! 214-226, eqs 35 and 36.

use std::f64::consts::PI;

/// Terms of a series: the last is nothing even soon after the start.
const TERMS: u32 = 60;

/// Walls at zero and at `height`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Channel {
    /// Distance of the walls.
    pub height: f64,
    /// Kinematic viscosity.
    pub viscosity: f64,
}

impl Channel {
    /// Velocity that a force per mass along the walls has made of rest after `time`, at a height [eq. 35].
    pub fn driven(&self, force: f64, height: f64, time: f64) -> f64 {
        let y = height / self.height;
        let unit = force * self.height * self.height / self.viscosity;
        let term = |n: u32| {
            let n = f64::from(2 * n + 1);
            4.0 / (n * PI).powi(3) * (n * PI * y).sin() * self.faded(n, time)
        };
        unit * (0.5 * y * (1.0 - y) - (0..TERMS).map(term).sum::<f64>())
    }

    /// The same that the upper wall has made, which slides at `speed` [eq. 36].
    pub fn dragged(&self, speed: f64, height: f64, time: f64) -> f64 {
        let y = height / self.height;
        let term = |n: u32| {
            let sign = if n.is_multiple_of(2) { 1.0 } else { -1.0 };
            let n = f64::from(n);
            2.0 / (n * PI) * sign * (n * PI * y).sin() * self.faded(n, time)
        };
        speed * (y + (1..TERMS).map(term).sum::<f64>())
    }

    /// What time leaves of the wave that fits `n` half times between the walls.
    fn faded(&self, n: f64, time: f64) -> f64 {
        (-self.viscosity * (n * PI / self.height).powi(2) * time).exp()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const CHANNEL: Channel = Channel {
        height: 2.0,
        viscosity: 0.3,
    };

    /// `du/dt = nu u'' + F` by differences, rest at the start and at the walls.
    fn solves(speed: impl Fn(f64, f64) -> f64, force: f64, upper: f64) {
        const STEP: f64 = 1e-3;
        for y in [0.3, 1.0, 1.9] {
            let rate = (speed(y, 0.5 + STEP) - speed(y, 0.5 - STEP)) / (2.0 * STEP);
            let [below, here, above] = [-STEP, 0.0, STEP].map(|by| speed(y + by, 0.5));
            let bend = (below - 2.0 * here + above) / (STEP * STEP);
            let lack = rate - CHANNEL.viscosity * bend - force;
            assert!(lack.abs() < 1e-4, "{lack} at {y}");
            assert!(speed(y, 1e-3).abs() < 2e-2 || y > 1.8);
        }
        assert!(speed(0.0, 0.7).abs() < 1e-12);
        assert!((speed(2.0, 0.7) - upper).abs() < 1e-12);
    }

    #[test]
    fn both_flows_solve_the_equation_of_momentum() {
        solves(|y, t| CHANNEL.driven(0.7, y, t), 0.7, 0.0);
        solves(|y, t| CHANNEL.dragged(0.7, y, t), 0.0, 0.7);
    }

    #[test]
    fn both_flows_come_to_their_steady_ends() {
        let parabola = 0.5 * 0.7 / 0.3 * 0.6 * (2.0 - 0.6);
        assert!((CHANNEL.driven(0.7, 0.6, 1e3) - parabola).abs() < 1e-12);
        assert!((CHANNEL.dragged(0.7, 0.6, 1e3) - 0.21).abs() < 1e-12);
    }
}
