//! What is beyond a side of a stream slower than sound, in a flow that settles: gas that has the stream's entropy and total enthalpy, whatever the
//! side does to its speed.
//!
//! What bodies do to such a stream is felt at its sides, by `1 / r` or `1 / r^2`. Were the stream left as it is beyond them, gas that it meets
//! with the speed `U + u'` and the pressure `-rho U u'` would come in with the pressure that sound between both has, and with
//! `-rho a u' (1 - M^2) / 2` of total pressure too much: at Mach 0.3, where a body has slowed the stream by a hundredth, a thirtieth of the dynamic
//! pressure, which stays with the gas all the way to the body.
//!
//! What comes in has five things of the stream, or four in the plane, less the sound that leaves by the side: its entropy, its total enthalpy, and
//! the direction of what is aslant to the side. A side that the stream goes along, in or out, lets a wave in in place of a speed, as the Riemann
//! problem with the stream does: in between, the wave counts by the square of the sine of the angle between both.
//!
//! [Entropy, total enthalpy and direction of what comes in slower than sound, and the invariant `u + 2 a / (gamma - 1)` of the sound that
//! leaves: Hirsch 1990, Numerical Computation of Internal and External Flows 2, section 19.1.2; here with `du + dp / (rho a)`, of any gas]

use super::equation_of_state::EquationOfState;
use super::state::{Primitive, dot};

/// Steps of Newton's method: each squares an error that is at most of the order of the Mach number.
const STEPS: usize = 6;

/// Part of the square of a speed that is rounded.
const ROUNDED: f64 = 1e-12;

/// What is beyond a side with this `normal`, out of the domain, that gas in the state `inside` meets the `stream` at: the stream itself where it
/// leaves, or comes faster than sound.
pub fn beyond<G: EquationOfState, const D: usize>(
    gas: &G,
    inside: &Primitive<D>,
    stream: &Primitive<D>,
    normal: &[f64; D],
) -> Primitive<D> {
    let out = dot(&stream.velocity, normal);
    let sound = gas.sound_square(stream.density, stream.pressure).sqrt();
    if inside == stream || out >= 0.0 || out <= -sound {
        return *stream;
    }
    let isentrope = Isentrope::of(stream, sound);
    let impedance = stream.density * sound;
    let leaving = dot(&inside.velocity, normal) + inside.pressure / impedance;
    // Straight in: the speed at which the stream's total enthalpy meets the sound that leaves.
    let mut speed = out;
    for _ in 0..STEPS {
        let met = isentrope.slowed(0.5 * (out * out - speed * speed));
        let slope = 1.0 - met.density * speed / impedance;
        let step = (speed + met.pressure / impedance - leaving) / slope;
        speed = (speed - step).clamp(-sound, 0.0);
    }
    let straight = isentrope.slowed(0.5 * (out * out - speed * speed));
    let [straight, along] =
        [(speed, straight.pressure), (out, stream.pressure)].map(|(u, p)| u - p / impedance);
    let square = dot(&stream.velocity, &stream.velocity);
    let entering = along + (straight - along) * (out * out / square);
    let speed = 0.5 * (leaving + entering);
    let Some(met) = isentrope.at(0.5 * impedance * (leaving - entering)) else {
        return *stream;
    };
    // What is left of the total enthalpy goes along the side; a stream straight in leaves nothing.
    let beside = square - out * out;
    let left = square - speed * speed - 2.0 * met.heat;
    let share = if beside > ROUNDED * square {
        (left.max(0.0) / beside).sqrt()
    } else {
        0.0
    };
    let mut velocity = stream.velocity;
    for (u, n) in velocity.iter_mut().zip(normal) {
        *u = share * (*u - out * n) + speed * n;
    }
    Primitive {
        density: met.density,
        velocity,
        pressure: met.pressure,
    }
}

/// States of a stream's entropy, with `p ~ rho^g` and `g = rho a^2 / p` as it is there: as they are in an ideal gas.
struct Isentrope {
    density: f64,
    pressure: f64,
    exponent: f64,
}

/// One of them.
struct Met {
    density: f64,
    pressure: f64,
    /// Its enthalpy less the stream's.
    heat: f64,
}

impl Isentrope {
    fn of<const D: usize>(stream: &Primitive<D>, sound: f64) -> Self {
        Self {
            density: stream.density,
            pressure: stream.pressure,
            exponent: stream.density * sound * sound / stream.pressure,
        }
    }

    /// Where its enthalpy is by `heat` higher.
    fn slowed(&self, heat: f64) -> Met {
        let whole = self.exponent / (self.exponent - 1.0);
        let ratio = (1.0 + heat * self.density / (self.pressure * whole)).max(f64::MIN_POSITIVE);
        let pressure = self.pressure * ratio.powf(whole);
        Met {
            density: self.density * (pressure / self.pressure).powf(1.0 / self.exponent),
            pressure,
            heat,
        }
    }

    /// At this pressure; none where it is none.
    fn at(&self, pressure: f64) -> Option<Met> {
        if pressure.is_nan() || pressure <= 0.0 {
            return None;
        }
        let density = self.density * (pressure / self.pressure).powf(1.0 / self.exponent);
        let whole = self.exponent / (self.exponent - 1.0);
        let heat = whole * (pressure / density - self.pressure / self.density);
        Some(Met {
            density,
            pressure,
            heat,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gas::IdealGas;

    const GAS: IdealGas = IdealGas::new(1.4);

    /// At Mach 0.3 of sound at a speed of one, at this angle to the inwards normal of the lower side of the first axis, degrees.
    fn stream(angle: f64) -> Primitive<2> {
        let (sine, cosine) = angle.to_radians().sin_cos();
        Primitive {
            density: 1.4,
            velocity: [0.3 * cosine, 0.3 * sine],
            pressure: 1.0,
        }
    }

    fn met(inside: &Primitive<2>, stream: &Primitive<2>) -> Primitive<2> {
        beyond(&GAS, inside, stream, &[-1.0, 0.0])
    }

    /// Total enthalpy and entropy.
    fn totals(state: &Primitive<2>) -> [f64; 2] {
        let heat = 3.5 * state.pressure / state.density;
        [
            heat + 0.5 * dot(&state.velocity, &state.velocity),
            state.pressure / state.density.powf(1.4),
        ]
    }

    #[test]
    fn what_comes_in_has_the_total_enthalpy_and_the_entropy_of_the_stream() {
        let inside = Primitive {
            density: 1.43,
            velocity: [0.27, 0.02],
            pressure: 1.02,
        };
        for angle in [0.0, 1.0, 30.0, 60.0, 85.0, -40.0] {
            let stream = stream(angle);
            let found = totals(&met(&inside, &stream));
            for (found, of_stream) in found.iter().zip(totals(&stream)) {
                assert!((found / of_stream - 1.0).abs() < 1e-12, "{angle}: {found}");
            }
        }
    }

    /// Gas that a body has slowed without loss, straight ahead of it.
    #[test]
    fn gas_of_the_total_state_that_comes_straight_in_stays_as_it_is() {
        let stream = stream(0.0);
        let speed = 0.28_f64;
        // 0.2 (0.3^2 - u^2) more enthalpy, over the stream's 2.5.
        let pressure = (1.0 + 0.2 * (0.09 - speed * speed)).powf(3.5);
        let inside = Primitive {
            density: 1.4 * pressure.powf(1.0 / 1.4),
            velocity: [speed, 0.0],
            pressure,
        };
        let found = met(&inside, &stream);
        assert!(
            (found.pressure - pressure).abs() < 1e-9,
            "{found:?} {inside:?}"
        );
        assert!((found.velocity[0] - speed).abs() < 1e-9);
    }

    /// Beside a stream along the side pressure and speed across are those of the sound between both.
    #[test]
    fn a_stream_along_the_side_lets_its_wave_in() {
        let stream = stream(89.999_99);
        let inside = Primitive {
            velocity: [-0.004, 0.31],
            pressure: 1.01,
            ..stream
        };
        let found = met(&inside, &stream);
        assert!(
            (found.pressure - (1.005 + 0.7 * 0.004)).abs() < 1e-6,
            "{found:?}"
        );
        assert!(
            (found.velocity[0] + 0.5 * 0.004 + 0.005 / 1.4).abs() < 1e-6,
            "{found:?}"
        );
    }

    /// By the square of the cosine of its angle: a quarter at 60 degrees.
    #[test]
    fn a_stream_aslant_lets_in_part_of_both_waves() {
        let aslant = stream(60.0);
        let straight = Primitive {
            velocity: [aslant.velocity[0], 0.0],
            ..aslant
        };
        let inside = Primitive {
            velocity: [0.12, 0.25],
            pressure: 1.02,
            ..aslant
        };
        let wave = |state: &Primitive<2>| -state.velocity[0] - state.pressure / 1.4;
        let [found, straight] = [&aslant, &straight].map(|stream| wave(&met(&inside, stream)));
        let along = wave(&aslant);
        assert!((straight - along).abs() > 1e-3);
        assert!((found - along - 0.25 * (straight - along)).abs() < 1e-12);
    }

    #[test]
    fn a_stream_that_leaves_or_is_faster_than_sound_stays_as_it_is() {
        for velocity in [[-0.3, 0.1], [1.2, 0.1]] {
            let stream = Primitive {
                velocity,
                ..stream(0.0)
            };
            let inside = Primitive {
                pressure: 1.1,
                ..stream
            };
            assert_eq!(met(&inside, &stream), stream);
        }
    }
}
