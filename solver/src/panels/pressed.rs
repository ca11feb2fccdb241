//! What a panel is pressed with, and what it is made of.

use aero_geometry::Vector;

use super::bend::{Bent, Front};

/// A panel is in a corner where other walls fill this part of its front, of a kernel's half, as a spacing from the foot of a ramp of 15
/// degrees; below, it is the less so the less they fill.
const IN_A_CORNER: f64 = 0.02;

/// Spread of the pressure of the gas in front, over its mean, up to which it is even, and from which on it is not.
const EVEN: [f64; 2] = [0.02, 0.1];

/// What a panel is pressed with.
#[derive(Clone, Copy, Debug)]
pub struct Pressed<const D: usize> {
    /// Pressure.
    pub pressure: f64,
    /// Force per area that no pressure makes.
    pub friction: Vector<D>,
    /// Mach number of the gas in front.
    pub mach: f64,
}

impl<const D: usize> Pressed<D> {
    /// With this pressure, of gas at rest.
    pub fn calm(pressure: f64) -> Self {
        Self {
            pressure,
            friction: Vector::zeros(),
            mach: 0.0,
        }
    }
}

/// What comes together on a panel.
#[derive(Clone, Copy, Debug)]
pub struct Sum<const D: usize> {
    pub force: f64,
    /// Part of the kernel that is gas, times the area.
    pub gas: f64,
    /// The same of its pressure.
    pub gas_pressure: f64,
    /// The same of its square.
    pub gas_square: f64,
    /// The same of how far it reaches.
    pub gas_reach: f64,
    pub weight: f64,
    /// Weighted.
    pub mach: f64,
    pub friction: Vector<D>,
    /// Part of the kernel that is solid in front of it.
    pub solid: f64,
}

impl<const D: usize> Sum<D> {
    /// Of a panel that nothing has come to.
    pub fn none() -> Self {
        Self {
            force: 0.0,
            gas: 0.0,
            gas_pressure: 0.0,
            gas_square: 0.0,
            gas_reach: 0.0,
            weight: 0.0,
            mach: 0.0,
            friction: Vector::zeros(),
            solid: 0.0,
        }
    }

    /// Force per area on a free wall, mean pressure of even gas in front in a corner.
    fn pressure(&self, size: f64) -> f64 {
        let free = self.force / size;
        let filled = 2.0 * self.solid;
        if filled <= 0.0 || self.gas <= 0.0 {
            return free;
        }
        let mean = self.mean_pressure();
        // Gas would press where the other walls are.
        let free = free + filled.min(1.0) * mean;
        let even = 1.0 - rise(self.spread(), EVEN[0], EVEN[1]);
        free + even * (filled / IN_A_CORNER).min(1.0) * (mean - free)
    }

    /// The gas in front, on the mean.
    pub fn front(&self) -> Option<Front> {
        (self.gas > 0.0).then(|| Front {
            reach: self.gas_reach / self.gas,
            pressure: self.mean_pressure(),
        })
    }

    /// Of the gas in front; none where there is none.
    fn mean_pressure(&self) -> f64 {
        if self.gas > 0.0 {
            self.gas_pressure / self.gas
        } else {
            0.0
        }
    }

    /// How far the pressure of the gas in front is spread about its mean, over the root of its mean square.
    fn spread(&self) -> f64 {
        let (mean, square) = (self.mean_pressure(), self.gas_square / self.gas);
        let spread = (square - mean * mean).max(0.0).sqrt();
        if spread > 0.0 {
            spread / square.sqrt()
        } else {
            0.0
        }
    }

    /// What presses a panel of this `size` and `normal` where the surface bends as `bent` says.
    pub fn pressed(&self, size: f64, (normal, bent): (Vector<D>, Bent<D>)) -> Pressed<D> {
        let pressure = self.pressure(size) - 2.0 * bent.beyond * self.mean_pressure();
        // What is no pressure.
        let other = normal * (pressure - self.force / size);
        Pressed {
            pressure,
            friction: self.friction / size + other - bent.pull,
            mach: if self.weight > 0.0 {
                self.mach / self.weight
            } else {
                0.0
            },
        }
    }
}

/// From zero at `low` to one at `high`.
fn rise(value: f64, low: f64, high: f64) -> f64 {
    ((value - low) / (high - low)).clamp(0.0, 1.0)
}
