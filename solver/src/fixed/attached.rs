//! The shock that stands at a sharp concave bend of a wall in the plane, where a stream that is faster than sound turns into it.
//!
//! Up to some spacings from the bend there are fewer cells between shock and wall than a captured shock is wide: the first walls behind the bend
//! would feel a shock that is not done, and the gas that goes along them would keep what it got there. But how the gas is there is known: as in front
//! on one side of a straight shock, as behind it on the other.

use super::bend::Bend;
use super::equation_of_state::EquationOfState;
use super::fan::{SONIC, SUPERSONIC, rise};
use super::oblique::{largest_turn, ratios, weak_shock};
use super::state::{Conserved, Primitive, dot};

/// Part of the largest turn that a shock at the bend may make from which on it may stand ahead of the bend.
const NEARLY: f64 = 0.95;

/// Turn below which there is nothing but rounding in a shock, radians.
const LEAST: f64 = 1e-3;

/// Up to here from its bend, in spacings, a shock stands as it would if nothing but the bend were there.
const NEAR: f64 = 96.0;

/// No shock is looked for farther than this from its bend, in spacings.
pub const FARTHEST: f64 = 128.0;

/// How far the energy behind a shock of a gas whose ratio of specific heats does not change may be off for another gas, in parts of it.
const SAME: f64 = 1e-6;

/// A straight shock at a bend.
#[derive(Clone, Debug)]
pub struct AttachedShock<const D: usize> {
    /// Gas in front.
    pub front: Primitive<D>,
    /// Gas behind.
    pub rear: Primitive<D>,
    /// Unit normal of the shock, to the gas in front.
    pub normal: [f64; D],
    /// Logarithm of the pressure behind over that in front.
    strength: f64,
    /// How much of it there is: from none of gas that is slower than sound, or whose shock stands ahead of the bend, to one.
    pub share: f64,
}

/// How far gas in the state `front` meets a bend from a wall along `before` to one along `along` without knowing of it: from not at all,
/// where it is slower than sound or its shock stands ahead of the bend, to one.
pub fn share<G: EquationOfState, const D: usize>(
    gas: &G,
    front: &Primitive<D>,
    before: &[f64; D],
    along: &[f64; D],
) -> f64 {
    let sound = gas.sound_square(front.density, front.pressure);
    let gamma = sound * front.density / front.pressure;
    let towards = dot(&front.velocity, before);
    if towards <= 0.0 {
        return 0.0;
    }
    let fast = rise(towards * towards / sound, SONIC, SUPERSONIC);
    let speed = dot(&front.velocity, &front.velocity);
    let cosine = dot(&front.velocity, along) / speed.sqrt();
    let turn = cosine.clamp(-1.0, 1.0).acos();
    let largest = largest_turn(speed / sound, gamma);
    fast * (1.0 - rise(turn, NEARLY * largest, largest))
}

/// From one near a bend to zero so far from it, in spacings, that no shock is looked for.
pub fn nearness(away: f64) -> f64 {
    1.0 - rise(away, NEAR, FARTHEST)
}

impl<const D: usize> AttachedShock<D> {
    /// The shock at `bend` of gas in the state `front` ahead of it, if one stands there.
    pub fn new<G: EquationOfState>(gas: &G, front: &Primitive<D>, bend: &Bend<D>) -> Option<Self> {
        let share = share(gas, front, &bend.before, &bend.along);
        if share <= 0.0 {
            return None;
        }
        let sound = gas.sound_square(front.density, front.pressure);
        let gamma = sound * front.density / front.pressure;
        let square = dot(&front.velocity, &front.velocity);
        let speed = square.sqrt();
        let onwards = front.velocity.map(|u| u / speed);
        let rising = dot(&bend.up, &onwards);
        let mut aside = bend.up;
        for k in 0..D {
            aside[k] -= rising * onwards[k];
        }
        let size = dot(&aside, &aside).sqrt();
        let aside = aside.map(|part| part / size);
        let turn = dot(&bend.along, &aside).atan2(dot(&bend.along, &onwards));
        if turn < LEAST {
            return None;
        }
        let elevation = weak_shock(square / sound, gamma, turn)?;
        let (sine, cosine) = elevation.sin_cos();
        let mut normal = [0.0; D];
        for k in 0..D {
            normal[k] = cosine * aside[k] - sine * onwards[k];
        }
        let [density, pressure] = ratios(square / sound * sine * sine, gamma);
        let mut rear = Primitive {
            density: density * front.density,
            velocity: front.velocity,
            pressure: pressure * front.pressure,
        };
        // Gas slows straight across the shock alone.
        for k in 0..D {
            rear.velocity[k] += speed * sine * (1.0 - 1.0 / density) * normal[k];
        }
        let energy = rear.pressure / (gamma - 1.0);
        let ground =
            gas.internal_energy(front.density, front.pressure) - front.pressure / (gamma - 1.0);
        let other = gas.internal_energy(rear.density, rear.pressure) - ground * density;
        if (other - energy).abs() > SAME * energy {
            return None;
        }
        Some(Self {
            front: *front,
            rear,
            normal,
            strength: pressure.ln(),
            share,
        })
    }

    /// The mean of a cell of which this part is in front.
    pub fn mean<G: EquationOfState>(&self, gas: &G, part: f64) -> Primitive<D> {
        if part >= 1.0 {
            self.front
        } else if part <= 0.0 {
            self.rear
        } else {
            let [front, rear] = [&self.front, &self.rear].map(|state| state.conserved(gas));
            let sum = Conserved::ZERO.plus(part, &front).plus(1.0 - part, &rear);
            sum.primitive(gas)
        }
    }

    /// How far gas in the state `own` may be taken for what is `known` of it: not where its pressure is off by what the whole shock changes,
    /// and wholly up to half of that.
    pub fn agreement(&self, own: &Primitive<D>, known: &Primitive<D>) -> f64 {
        let off = (own.pressure / known.pressure).ln().abs();
        if dot(&own.velocity, &known.velocity) > 0.0 {
            1.0 - rise(off / self.strength, 0.5, 1.0)
        } else {
            0.0
        }
    }
}
