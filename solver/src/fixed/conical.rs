//! The flow about a cone along a stream that is faster than sound: the same along each ray from its tip.
//!
//! [Taylor & Maccoll 1933, Proc. R. Soc. A 139, 278, doi:10.1098/rspa.1933.0017] Speeds over the largest one, which gas that expands into a vacuum
//! comes to: with `r` along a ray and `t` across it, `u_r' = u_t`, and
//! `u_t' = (u_t^2 u_r - a (2 u_r + u_t cot t)) / (a - u_t^2)`, `a = (gamma - 1) / 2 (1 - u^2)` the square of the speed of sound.

use super::oblique::ratios;

/// Longest step between rays, radians, in parts of the angle of the ray, and in parts of the way to where gas goes across as fast as sound.
const STEPS: [f64; 3] = [0.02, 0.06, 0.2];

/// Parts of a step between which gas changes evenly.
const PARTS: u32 = 4;

/// No shock is steeper than this, radians.
const STEEPEST: f64 = 1.5;

/// How often the speed on the cone is guessed, at most.
const GUESSES: usize = 60;

/// How well it is to be found.
const EXACT: f64 = 1e-12;

/// What gas does on a ray.
#[derive(Clone, Copy, Debug)]
struct Ray {
    angle: f64,
    along: f64,
    across: f64,
}

/// Gas on a ray: density, pressure and the speed over that of the stream along the axis and away from it; the first two over those of the stream.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OnRay {
    pub density: f64,
    pub pressure: f64,
    pub velocity: [f64; 2],
}

/// The flow between a cone and its shock.
#[derive(Clone, Debug)]
pub struct Conical {
    /// Angle of the shock, radians.
    pub shock: f64,
    /// Mach number on the cone.
    pub mach: f64,
    /// From the cone to the shock.
    rays: Vec<(f64, OnRay)>,
}

impl Conical {
    /// Around a cone of this half `angle`, radians, at this square of the Mach number; none where the shock stands ahead of the tip.
    pub fn new(mach_square: f64, gamma: f64, angle: f64) -> Option<Self> {
        let gain = 0.5 * (gamma - 1.0);
        let stream = (gain * mach_square / (1.0 + gain * mach_square)).sqrt();
        let off = |speed: f64| Some(around(speed, gamma, angle)?.stream() - stream);
        // The faster the gas on the cone, the faster the stream, but for strong shocks. No gas on a cone is as fast as the stream.
        let (mut high, mut above) = (stream, f64::INFINITY);
        let mut back = 0.25 * (1.0 - angle.cos()) * stream;
        let mut low = high - back;
        let mut below = loop {
            // Gas that is too fast for a shock turns as through a Mach line, and beyond.
            let found = off(low).unwrap_or(f64::INFINITY);
            if found <= 0.0 {
                break found;
            }
            if found > above || low <= back {
                return None;
            }
            (high, above) = (low, found);
            back *= 1.5;
            low -= back;
        };
        for guess in 0..GUESSES {
            // Regula falsi, and halves now and then for what does not come closer.
            let part = if above.is_finite() && guess % 3 < 2 {
                above / (above - below)
            } else {
                0.5
            };
            let middle = high + (low - high) * part;
            let found = off(middle).unwrap_or(f64::INFINITY);
            if found > 0.0 {
                (high, above) = (middle, found);
            } else {
                (low, below) = (middle, found);
            }
            if found.abs() < EXACT {
                low = middle;
                break;
            }
        }
        let rays = around(low, gamma, angle)?.denser(gamma);
        Some(rays.flow(mach_square, gamma, stream))
    }

    /// Gas on a ray at this angle, where that lies between cone and shock; on the nearer of both otherwise.
    pub fn at(&self, angle: f64) -> OnRay {
        let next = self.rays.partition_point(|(ray, _)| *ray < angle);
        let last = self.rays.len() - 1;
        if next == 0 || next > last {
            return self.rays[next.min(last)].1;
        }
        let [(from, low), (to, high)] = [self.rays[next - 1], self.rays[next]];
        let part = (angle - from) / (to - from);
        let between = |low: f64, high: f64| low + (high - low) * part;
        OnRay {
            density: between(low.density, high.density),
            pressure: between(low.pressure, high.pressure),
            velocity: [0, 1].map(|k| between(low.velocity[k], high.velocity[k])),
        }
    }

    /// Half angle of the cone, radians.
    pub fn angle(&self) -> f64 {
        self.rays[0].0
    }

    /// Gas on the cone.
    pub fn surface(&self) -> OnRay {
        self.rays[0].1
    }
}

/// The rays from a cone to a shock.
#[derive(Clone, Debug, Default)]
struct Rays(Vec<Ray>);

/// The rays around a cone of this half `angle` on which gas is this fast, up to where a shock may stand.
fn around(speed: f64, gamma: f64, angle: f64) -> Option<Rays> {
    let mut ray = Ray {
        angle,
        along: speed,
        across: 0.0,
    };
    let mut rays = vec![ray];
    while ray.angle < STEEPEST {
        let step = ray.step(gamma)?;
        let next = ray.next(step, gamma)?;
        let [low, high] = [ray, next].map(|ray| ray.excess(gamma));
        if high >= 0.0 {
            // The place of the shock, by two secants.
            let mut part = low / (low - high);
            for _ in 0..2 {
                let here = ray.next(step * part, gamma)?.excess(gamma);
                part = (part * low / (low - here)).clamp(0.0, 1.0);
            }
            rays.push(ray.next(step * part, gamma)?);
            return Some(Rays(rays));
        }
        ray = next;
        rays.push(ray);
    }
    None
}

impl Ray {
    /// How the speeds change from ray to ray, and by how much the square of that of sound is above that of the gas across it; none where it is not.
    fn slope(&self, gamma: f64) -> Option<([f64; 2], f64)> {
        let Self {
            angle,
            along,
            across,
        } = *self;
        let sound = 0.5 * (gamma - 1.0) * (1.0 - along * along - across * across);
        let room = sound - across * across;
        let change =
            (across * across * along - sound * (2.0 * along + across / angle.tan())) / room;
        (room > 0.0).then_some(([across, change], room))
    }

    /// As far as one may go to the next ray.
    fn step(&self, gamma: f64) -> Option<f64> {
        let ([_, change], room) = self.slope(gamma)?;
        let nearing = (gamma + 1.0) * (self.across * change).abs();
        let step = STEPS[0].min(STEPS[1] * self.angle);
        Some(step.min(STEPS[2] * room / nearing.max(f64::MIN_POSITIVE)))
    }

    /// The ray so far on [Runge & Kutta, of fourth order]; none where gas goes across as fast as sound.
    fn next(&self, step: f64, gamma: f64) -> Option<Self> {
        let slope = |ray: &Self| ray.slope(gamma).map(|(slope, _)| slope);
        let moved = |step: f64, [along, across]: [f64; 2]| Self {
            angle: self.angle + step,
            along: self.along + step * along,
            across: self.across + step * across,
        };
        let a = slope(self)?;
        let b = slope(&moved(0.5 * step, a))?;
        let c = slope(&moved(0.5 * step, b))?;
        let d = slope(&moved(step, c))?;
        let mean = [0, 1].map(|k| (a[k] + 2.0 * (b[k] + c[k]) + d[k]) / 6.0);
        Some(moved(step, mean))
    }

    /// Whether a shock stands on the ray, by how much more gas goes across it than a stream along the axis leaves behind one: nothing there
    /// [Prandtl's relation, NACA Report 1135 (1953), eq. 126].
    fn excess(&self, gamma: f64) -> f64 {
        let before = self.along * self.angle.tan();
        before * -self.across - (gamma - 1.0) / (gamma + 1.0) * (1.0 - self.along * self.along)
    }
}

impl Rays {
    /// The same with more between them: near enough to be straight from one to the next.
    fn denser(&self, gamma: f64) -> Self {
        let between = self.0.windows(2).flat_map(|pair| {
            let step = (pair[1].angle - pair[0].angle) / f64::from(PARTS);
            let inner = (1..PARTS).filter_map(move |n| pair[0].next(step * f64::from(n), gamma));
            std::iter::once(pair[0]).chain(inner)
        });
        Self(between.chain(self.0.last().copied()).collect())
    }

    /// Speed of the stream ahead of the shock.
    fn stream(&self) -> f64 {
        let last = self.0[self.0.len() - 1];
        last.along / last.angle.cos()
    }

    /// The flow, over that of a `stream` at this square of the Mach number.
    fn flow(&self, mach_square: f64, gamma: f64, stream: f64) -> Conical {
        let last = self.0[self.0.len() - 1];
        let [density, pressure] = ratios(mach_square * last.angle.sin().powi(2), gamma);
        let warmth = |ray: &Ray| 1.0 - ray.along * ray.along - ray.across * ray.across;
        let rays = self.0.iter().map(|ray| {
            let warmer = warmth(ray) / warmth(&last);
            let (sine, cosine) = ray.angle.sin_cos();
            let on = OnRay {
                density: density * warmer.powf(1.0 / (gamma - 1.0)),
                pressure: pressure * warmer.powf(gamma / (gamma - 1.0)),
                velocity: [
                    (ray.along * cosine - ray.across * sine) / stream,
                    (ray.along * sine + ray.across * cosine) / stream,
                ],
            };
            (ray.angle, on)
        });
        let first = &self.0[0];
        Conical {
            shock: last.angle,
            mach: first.along / (0.5 * (gamma - 1.0) * warmth(first)).sqrt(),
            rays: rays.collect(),
        }
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    /// By the same equations in steps of a thousandth; Sims 1964, NASA SP-3004 has them too.
    #[test]
    fn cones_have_the_shocks_and_pressures_of_the_tables() {
        for (mach, degrees, shock, pressure) in [
            (3.0_f64, 20.0, 29.615, 2.790_9),
            (2.0, 10.0, 31.206, 1.292_52),
            (6.0, 9.588_225, 13.998, 2.678_92),
        ] {
            let found = Conical::new(mach * mach, 1.4, f64::to_radians(degrees)).unwrap();
            assert_relative_eq!(found.shock.to_degrees(), shock, epsilon = 1e-3);
            assert_relative_eq!(found.surface().pressure, pressure, epsilon = 5e-5);
            let [u, v] = found.surface().velocity;
            assert_relative_eq!(v / u, f64::to_radians(degrees).tan(), epsilon = 1e-9);
        }
    }

    #[test]
    fn no_shock_stands_at_the_tip_of_a_cone_that_is_too_blunt_or_in_gas_that_is_too_slow() {
        for (mach, degrees) in [(2.0_f64, 45.0), (1.01, 10.0), (10.0, 60.0)] {
            assert!(Conical::new(mach * mach, 1.4, f64::to_radians(degrees)).is_none());
        }
        for (mach, degrees) in [(2.0_f64, 35.0), (1.1, 5.0), (20.0, 50.0), (8.0, 1.0)] {
            assert!(
                Conical::new(mach * mach, 1.4, f64::to_radians(degrees)).is_some(),
                "{mach} {degrees}"
            );
        }
    }
}
