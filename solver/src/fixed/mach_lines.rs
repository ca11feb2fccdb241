//! What is beyond a side that waves of a stream faster than sound leave by.
//!
//! They leave along Mach lines, aslant, and not along the side's normal: were the stream left as it is beyond them, part of each would be
//! thrown back. Beyond the side is the stream behind the wave that leaves, as it stands between two streams that meet along the side: of the
//! waves that go in and out there, the one that comes in is the stream's, which has none.

use super::calmness::share;
use super::equation_of_state::EquationOfState;
use super::state::{Primitive, dot};

/// Mach number from which on all of that holds; it fades out towards one, where waves stand still.
const FAST: f64 = 1.1;

/// Gas in the plane of a side's normal and of the flow along the side.
#[derive(Clone, Copy)]
struct Flow {
    density: f64,
    pressure: f64,
    speed: f64,
    /// Angle of the velocity out of the side, radians.
    angle: f64,
    /// Square of the speed of sound.
    sound_square: f64,
}

/// What is beyond a side with this `normal`, out of the domain, that gas in the state `inside` meets the `stream` at.
pub fn beyond<G: EquationOfState, const D: usize>(
    gas: &G,
    inside: &Primitive<D>,
    stream: &Primitive<D>,
    normal: &[f64; D],
) -> Primitive<D> {
    let out = dot(&stream.velocity, normal);
    if inside == stream || out * out >= gas.sound_square(stream.density, stream.pressure) {
        return *stream;
    }
    let Some(along) = along(inside, normal) else {
        return *stream;
    };
    let flows = [inside, stream].map(|state| Flow::of(gas, state, &along, normal));
    let forth = dot(&stream.velocity, &along);
    let Some((behind, share)) = behind(gas, &flows).filter(|_| forth > 0.0) else {
        return *stream;
    };
    let (sine, cosine) = behind.angle.sin_cos();
    let mut velocity = stream.velocity;
    for k in 0..D {
        velocity[k] += share * (behind.speed * cosine - forth) * along[k];
        velocity[k] += share * (behind.speed * sine - out) * normal[k];
    }
    Primitive {
        density: stream.density + share * (behind.density - stream.density),
        velocity,
        pressure: stream.pressure + share * (behind.pressure - stream.pressure),
    }
}

/// The way that gas in this state goes along a side; none of gas that does not.
fn along<const D: usize>(state: &Primitive<D>, normal: &[f64; D]) -> Option<[f64; D]> {
    let out = dot(&state.velocity, normal);
    let mut along = state.velocity;
    for (u, n) in along.iter_mut().zip(normal) {
        *u -= out * n;
    }
    let speed = dot(&along, &along).sqrt();
    (speed > 0.0).then(|| along.map(|u| u / speed))
}

/// The stream behind the wave that leaves gas `inside` for it, and how much of that counts; none where gas is slower than sound.
///
/// Along Mach lines `dθ = ± k d ln p`, `k = sqrt(M^2 - 1) p / (rho u^2)`, `-` through the wave that goes in and `+` through the one that goes
/// out: of the ideal gas Prandtl and Meyer's law [NACA Report 1135 (1953), eq. 171c]. Both have the same mean `k`, by Simpson's rule
/// between the two gases: `θ_i - θ = k ln(p / p_i)` and `θ - θ_s = k ln(p / p_s)`. Shocks are off that by the third power of their
/// strength.
fn behind<G: EquationOfState>(gas: &G, [inside, stream]: &[Flow; 2]) -> Option<(Flow, f64)> {
    let middle = (inside.pressure * stream.pressure).sqrt();
    let middles = [inside.at(gas, middle)?, stream.at(gas, middle)?];
    let ends = inside.turn()? + stream.turn()?;
    let turn = (ends + 2.0 * (middles[0].turn()? + middles[1].turn()?)) / 6.0;
    let ratio = (inside.pressure / stream.pressure).ln();
    let angle = 0.5 * (inside.angle + stream.angle + turn * ratio);
    let rise = 0.5 * (ratio + (inside.angle - stream.angle) / turn);
    let behind = stream.at(gas, stream.pressure * rise.exp())?;
    let slowest = [inside, stream, &behind].map(Flow::mach_square);
    let mach = slowest.into_iter().fold(f64::INFINITY, f64::min).sqrt();
    Some((Flow { angle, ..behind }, share(mach, 1.0, FAST)))
}

impl Flow {
    fn of<G: EquationOfState, const D: usize>(
        gas: &G,
        state: &Primitive<D>,
        along: &[f64; D],
        normal: &[f64; D],
    ) -> Self {
        let (forth, out) = (dot(&state.velocity, along), dot(&state.velocity, normal));
        Self {
            density: state.density,
            pressure: state.pressure,
            speed: forth.hypot(out),
            angle: out.atan2(forth),
            sound_square: gas.sound_square(state.density, state.pressure),
        }
    }

    fn mach_square(&self) -> f64 {
        self.speed * self.speed / self.sound_square
    }

    /// `dθ / d ln p` through a wave, radians; none of gas slower than sound.
    fn turn(&self) -> Option<f64> {
        let square = self.mach_square();
        let pressures = self.pressure / (self.density * self.speed * self.speed);
        (square > 1.0).then(|| (square - 1.0).sqrt() * pressures)
    }

    /// The same gas at another `pressure`, by its entropy and total enthalpy, with `p ~ rho^g` and `g = rho c^2 / p` as it is here: as they are
    /// in an ideal gas. None where it would come to rest before.
    fn at<G: EquationOfState>(&self, gas: &G, pressure: f64) -> Option<Self> {
        let exponent = self.density * self.sound_square / self.pressure;
        let density = self.density * (pressure / self.pressure).powf(1.0 / exponent);
        let heat = pressure / density - self.pressure / self.density;
        let square = self.speed * self.speed - 2.0 * exponent / (exponent - 1.0) * heat;
        (square > 0.0).then(|| Self {
            density,
            pressure,
            speed: square.sqrt(),
            angle: self.angle,
            sound_square: gas.sound_square(density, pressure),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::super::prandtl_meyer;
    use super::*;
    use crate::gas::Air;
    use crate::gas::IdealGas;

    const GAS: IdealGas = IdealGas::new(1.4);

    /// A turn by ten degrees, radians.
    const TURN: f64 = 0.174_532_925;

    /// Part of a wave that may come back.
    const BACK: f64 = 0.01;

    /// Of density 1.4 and pressure 1, at this Mach number and angle.
    fn gas(mach: f64, angle: f64) -> Primitive<2> {
        Primitive {
            density: 1.4,
            velocity: [mach * angle.cos(), mach * angle.sin()],
            pressure: 1.0,
        }
    }

    /// What is beyond the upper side.
    fn above(inside: &Primitive<2>, stream: &Primitive<2>) -> Primitive<2> {
        beyond(&GAS, inside, stream, &[0.0, 1.0])
    }

    /// Gas of `stream`, which goes along the first axis, turned away from the upper side by Prandtl and Meyer.
    fn expanded(mach: f64, turn: f64) -> Primitive<2> {
        let slowness = 6.0_f64.sqrt();
        let slope = (mach * mach - 1.0).sqrt();
        let angle = prandtl_meyer::angle(slope, slowness) + turn;
        let square = prandtl_meyer::slope_of(angle, 0.0, slowness).powi(2) + 1.0;
        let heat = (1.0 + 0.2 * mach * mach) / (1.0 + 0.2 * square);
        let speed = (square * heat).sqrt();
        Primitive {
            density: 1.4 * heat.powf(2.5),
            velocity: [speed * turn.cos(), -speed * turn.sin()],
            pressure: heat.powf(3.5),
        }
    }

    /// Gas behind the oblique shock of this `ratio` of pressures, turned towards the upper side [NACA Report 1135 (1953), eqs 128-132].
    fn shocked(mach: f64, ratio: f64) -> Primitive<2> {
        let square = (6.0 * ratio + 1.0) / 7.0;
        let denser = 6.0 * square / (square + 5.0);
        let sine = square.sqrt() / mach;
        let cosine = (1.0 - sine * sine).sqrt();
        let (along, across) = (mach * cosine, mach * sine / denser);
        Primitive {
            density: 1.4 * denser,
            velocity: [
                along * cosine + across * sine,
                along * sine - across * cosine,
            ],
            pressure: ratio,
        }
    }

    /// How far the state beyond is from that inside, in parts of the jump of the pressure between inside and the stream.
    fn back(inside: &Primitive<2>, stream: &Primitive<2>) -> f64 {
        let beyond = above(inside, stream);
        let turned = |state: &Primitive<2>| state.velocity[1].atan2(state.velocity[0]);
        let wave = (inside.pressure - stream.pressure).abs();
        let off = (beyond.pressure - inside.pressure).abs() / wave;
        let turn = (turned(&beyond) - turned(inside)).abs() / turned(inside).abs();
        off.max(turn)
    }

    #[test]
    fn simple_waves_leave() {
        for (mach, turn) in [(1.5, TURN), (2.5, TURN), (4.0, TURN), (2.5, -TURN)] {
            let left = back(&expanded(mach, turn), &gas(mach, 0.0));
            assert!(left < BACK, "Mach {mach}, {turn}: {left}");
        }
    }

    #[test]
    fn oblique_shocks_leave() {
        for (mach, ratio) in [(1.5, 1.3), (1.5, 1.6), (2.5, 1.8), (4.0, 2.5)] {
            let left = back(&shocked(mach, ratio), &gas(mach, 0.0));
            assert!(left < BACK, "Mach {mach}, {ratio}: {left}");
        }
    }

    /// What comes in is the stream's alone: of a wave that goes in, to first order, nothing is left beyond.
    #[test]
    fn waves_come_in_from_the_stream_alone() {
        let stream = gas(2.0, 0.0);
        let turn = 1e-4;
        let mut inside = expanded(2.0, turn);
        inside.velocity[1] = -inside.velocity[1];
        let beyond = above(&inside, &stream);
        let wave = inside.pressure - stream.pressure;
        assert!((beyond.pressure - stream.pressure).abs() < 1e-3 * wave.abs());
        assert!(beyond.velocity[1].abs() < 1e-3 * inside.velocity[1].abs());
    }

    #[test]
    fn sides_are_alike_below_and_above_and_turned_in_space() {
        let (inside, stream) = (shocked(2.0, 1.5), gas(2.0, 0.02));
        let flat = above(&inside, &stream);
        let flipped = |state: &Primitive<2>| state.mirrored(&[0.0, 1.0]);
        let below = beyond(&GAS, &flipped(&inside), &flipped(&stream), &[0.0, -1.0]);
        assert_eq!(flipped(&below), flat);
        let (sine, cosine) = 0.7_f64.sin_cos();
        let turned = |state: &Primitive<2>| Primitive::<3> {
            density: state.density,
            velocity: [
                state.velocity[0] * cosine,
                -state.velocity[1],
                state.velocity[0] * sine,
            ],
            pressure: state.pressure,
        };
        let space = beyond(&GAS, &turned(&inside), &turned(&stream), &[0.0, -1.0, 0.0]);
        let off = space.plus(-1.0, &turned(&flat));
        let far = off
            .velocity
            .iter()
            .fold(off.pressure.abs(), |far, u| far.max(u.abs()));
        assert!(far < 1e-14, "{off:?}");
    }

    /// Gas of the stream, and gas off it by a few bits.
    #[test]
    fn the_stream_stays_as_it_is() {
        let stream = gas(1.5, 0.1);
        assert_eq!(above(&stream, &stream), stream);
        let mut inside = stream;
        inside.pressure *= 1.0 + 1e-15;
        let off = above(&inside, &stream).plus(-1.0, &stream);
        assert!(off.pressure.abs() < 1e-14 && off.velocity[1].abs() < 1e-14);
    }

    /// A stream that crosses the side faster than sound, in or out, and one slower than sound, or gas inside that is.
    #[test]
    fn other_streams_are_left_alone() {
        let inside = shocked(2.0, 1.5);
        for angle in [-1.5, -0.6, 0.6, 1.5] {
            assert_eq!(above(&inside, &gas(2.0, angle)), gas(2.0, angle));
        }
        assert_eq!(above(&inside, &gas(0.9, 0.0)), gas(0.9, 0.0));
        assert_eq!(above(&gas(0.9, 0.3), &gas(1.5, 0.0)), gas(1.5, 0.0));
        assert_eq!(above(&gas(1.5, 3.0), &gas(1.5, 0.0)), gas(1.5, 0.0));
    }

    /// The change to that is without a jump.
    #[test]
    fn the_law_fades_out_towards_the_speed_of_sound() {
        let stream = gas(1.5, 0.0);
        let part = |mach: f64| {
            let pressure = above(&gas(mach, 0.1), &stream).pressure;
            assert!((1.0..1.5).contains(&pressure), "{mach}: {pressure}");
            pressure
        };
        for k in 0..400 {
            let mach = 0.98 + 0.0005 * f64::from(k);
            assert!((part(mach + 0.0005) - part(mach)).abs() < 0.01, "{mach}");
        }
    }

    /// Air in equilibrium, expanded along its isentrope in small steps, `du = -dp / (rho u)`, `d rho = dp / c^2`.
    #[test]
    fn waves_of_hot_air_leave() {
        let air = Air::Equilibrium;
        let stream = Primitive::<2> {
            density: 0.01,
            velocity: [4000.0, 0.0],
            pressure: 12_000.0,
        };
        let (mut flow, steps) = (Flow::of(&air, &stream, &[1.0, 0.0], &[0.0, 1.0]), 2000);
        let part = -0.6 / f64::from(steps);
        for _ in 0..steps {
            let change = flow.pressure * part;
            flow.angle += part * flow.turn().unwrap();
            flow.density += change / flow.sound_square;
            flow.speed -= change / (flow.density * flow.speed);
            flow.pressure += change;
            flow.sound_square = EquationOfState::sound_square(&air, flow.density, flow.pressure);
        }
        let inside = Primitive {
            density: flow.density,
            velocity: [flow.speed * flow.angle.cos(), flow.speed * flow.angle.sin()],
            pressure: flow.pressure,
        };
        let beyond = beyond(&air, &inside, &stream, &[0.0, 1.0]);
        let off = (beyond.pressure - inside.pressure) / (inside.pressure - stream.pressure);
        assert!(off.abs() < BACK, "{off}");
    }
}
