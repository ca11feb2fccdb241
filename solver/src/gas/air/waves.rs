//! What waves make of air: along isentropes, and where a wall stops gas or draws away from it.

use super::{Air, EXACT, STEPS};

/// Pressure rises or falls by no more than this part of itself in a step along an isentrope.
const SHORT: f64 = 0.1;

/// Most steps along one.
const LONGEST: f64 = 400.0;

impl Air {
    /// Density at `pressure` of gas that had this density at the pressure `before`, at constant entropy [Runge & Kutta's fourth order].
    pub fn isentropic_density(self, density: f64, before: f64, pressure: f64) -> f64 {
        let way = (pressure / before).ln();
        let steps = (way.abs() / SHORT).ceil().clamp(1.0, LONGEST);
        let step = way / steps;
        // By the logarithm of the pressure: `d ln rho / d ln p = 1 / (1 + g)`.
        let slope = |log_density: f64, log_pressure: f64| {
            let ratio = self.ratio(log_density.exp(), (log_pressure - log_density).exp());
            1.0 / (1.0 + ratio.growth())
        };
        let (mut x, mut y) = (density.ln(), before.ln());
        for _ in 0..steps as usize {
            x += runge_kutta(slope, x, y, step);
            y += step;
        }
        x.exp()
    }

    /// Pressure on a wall at rest that gas moves into at `speed`, or away from where it is negative: the Riemann problem between the gas and
    /// its mirror image.
    pub fn wall_pressure(self, density: f64, pressure: f64, speed: f64) -> f64 {
        if speed > 0.0 {
            self.stopped(density, pressure, speed)
        } else if speed < 0.0 {
            self.drawn(density, pressure, -speed)
        } else {
            pressure
        }
    }

    /// Behind the shock that stops gas: with a rise of the pressure `d` the density grows as `1 / (1 - rho u^2 / d)` and the energy by
    /// `(p + d / 2) u^2 / d` [Rankine & Hugoniot]. Weak ones are those of an ideal gas with the same speed of sound.
    fn stopped(self, density: f64, pressure: f64, speed: f64) -> f64 {
        /// Part of the speed of sound below which a shock is weak.
        const WEAK: f64 = 1e-3;
        let square = self.sound_square(density, pressure);
        let gamma = square * density / pressure;
        let flow = density * speed * speed;
        let quarter = 0.25 * (gamma + 1.0) * flow;
        let first = quarter + (quarter * quarter + flow * density * square).sqrt();
        if speed * speed < WEAK * WEAK * square {
            return pressure + first;
        }
        let energy = self.energy(density, pressure);
        let off = |rise: f64| {
            let part = flow / rise;
            let behind = energy + (pressure + 0.5 * rise) * part / density;
            self.energy(density / (1.0 - part), pressure + rise) - behind
        };
        // It is stiffer, never softer, than gas that could be squeezed without end.
        secant(off, [first, first * 1.01], 1.000_001 * flow) + pressure
    }

    /// Behind the expansion of gas that leaves at `speed`: `dp = rho c du` along an isentrope.
    fn drawn(self, density: f64, pressure: f64, speed: f64) -> f64 {
        /// Part of the speed of sound in a step.
        const STEP: f64 = 0.05;
        let (mut x, mut y, mut left) = (density.ln(), pressure.ln(), speed);
        let slopes = |x: f64, y: f64| {
            let heat = (y - x).exp();
            let square = heat * (1.0 + self.ratio(x.exp(), heat).growth());
            let sound = square.sqrt();
            [-1.0 / sound, -sound / heat]
        };
        while left > 0.0 {
            let first = slopes(x, y);
            let step = left.min(-STEP / first[0]);
            // What is left comes to as good as nothing.
            if y < pressure.ln() - LONGEST {
                return 0.0;
            }
            let middle = slopes(x + 0.5 * step * first[0], y + 0.5 * step * first[1]);
            let again = slopes(x + 0.5 * step * middle[0], y + 0.5 * step * middle[1]);
            let last = slopes(x + step * again[0], y + step * again[1]);
            let mean = |k: usize| (first[k] + 2.0 * (middle[k] + again[k]) + last[k]) / 6.0;
            x += step * mean(0);
            y += step * mean(1);
            left -= step;
        }
        y.exp()
    }
}

/// A step of the classical method of fourth order.
fn runge_kutta(slope: impl Fn(f64, f64) -> f64, x: f64, y: f64, step: f64) -> f64 {
    let first = slope(x, y);
    let middle = slope(x + 0.5 * step * first, y + 0.5 * step);
    let again = slope(x + 0.5 * step * middle, y + 0.5 * step);
    let last = slope(x + step * again, y + step);
    step * (first + 2.0 * (middle + again) + last) / 6.0
}

/// Where `off` is nothing, above `least`, by the secant method from two guesses.
fn secant(off: impl Fn(f64) -> f64, guesses: [f64; 2], least: f64) -> f64 {
    let [mut a, mut b] = guesses;
    let mut at_a = off(a);
    for _ in 0..STEPS {
        let at_b = off(b);
        if at_b == at_a {
            break;
        }
        let next = (b - at_b * (b - a) / (at_b - at_a)).max(0.5 * (b + least));
        (a, at_a, b) = (b, at_b, next);
        if (b - a).abs() <= EXACT * b {
            break;
        }
    }
    b
}
