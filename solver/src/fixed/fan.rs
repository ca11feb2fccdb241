//! The fan in which a stream that is faster than sound turns round a sharp convex bend of its wall: gas on a ray from the bend is in one
//! state [Prandtl 1907; Meyer 1908; NACA Report 1135 (1953), eqs. 44 and 171c].
//!
//! Along an edge in space nothing changes: what gas moves along it stays as it is, and the fan is that of what it moves across.

use std::f64::consts::FRAC_PI_2;

use super::bend::Bend;
use super::equation_of_state::EquationOfState;
use super::prandtl_meyer::{angle, slope_of};
use super::state::{Primitive, dot};

/// Square of the Mach number towards the bend below which gas knows of it, and no fan stands at it.
pub const SONIC: f64 = 1.0;

/// The same above which there is nothing but the fan.
pub const SUPERSONIC: f64 = 2.0;

/// Turn up to which gas follows a wall, radians; farther round it leaves the wall.
const STEEP: f64 = 0.25 * std::f64::consts::PI;

/// Turn from which on there is no saying where the gas goes, radians.
pub const STEEPEST: f64 = 5.0 / 18.0 * std::f64::consts::PI;

/// Turn below which there is nothing but rounding in a fan, radians.
const LEAST: f64 = 1e-9;

/// Change of the logarithm of the pressure from one cell to the next, across a fan, up to which cells see it: a third of the pressure.
const SEEN: f64 = 0.4;

/// Up to here from its bend, in spacings, at least, a fan is too narrow for cells to see.
const NEAREST: f64 = 6.0;

/// Cells see it wholly so much farther from where they begin to.
const FARTHER: f64 = 4.0 / 3.0;

/// No fan is looked for farther than this from its bend, in spacings: in the plane, and in space, where much more lies within it.
const FARTHEST: [f64; 2] = [48.0, 16.0];

/// The same in `D` dimensions.
pub const fn farthest<const D: usize>() -> f64 {
    FARTHEST[(D > 2) as usize]
}

/// A fan.
#[derive(Clone, Debug)]
pub struct Fan<const D: usize> {
    /// Ratio of specific heats; of other gas, of that in front.
    gamma: f64,
    /// `sqrt((gamma + 1) / (gamma - 1))`.
    slowness: f64,
    /// Gas in front.
    front: Primitive<D>,
    /// Gas behind.
    rear: Primitive<D>,
    /// `1 + (gamma - 1) / 2 M^2` in front.
    heat: f64,
    /// Prandtl and Meyer's angle in front.
    start: f64,
    /// Ways of the gas in front.
    ways: Ways<D>,
    /// Elevation of its first and last ray above the gas's way.
    rays: [f64; 2],
    /// Cosines and sines of these.
    turns: [[f64; 2]; 2],
    /// Logarithm of the pressure in front over that behind.
    strength: f64,
    /// Up to here from the bend, in spacings, cells are too coarse for it.
    near: f64,
    /// How much of it there is: from none of gas that is slower than sound to one.
    pub share: f64,
}

/// Where the gas in front of a fan goes.
#[derive(Clone, Debug)]
struct Ways<const D: usize> {
    /// Velocity along the edge, in space.
    carried: [f64; D],
    /// Direction of the rest of it, across the edge.
    onwards: [f64; D],
    /// Across both, away from the wall.
    aside: [f64; D],
}

impl<const D: usize> Fan<D> {
    /// The fan at `bend` of gas in the state `front` ahead of it, if one stands there.
    pub fn new<G: EquationOfState>(gas: &G, front: &Primitive<D>, bend: &Bend<D>) -> Option<Self> {
        let square = gas.sound_square(front.density, front.pressure);
        let gamma = square * front.density / front.pressure;
        let slide = dot(&front.velocity, &bend.edge);
        let carried = bend.edge.map(|part| slide * part);
        let across = less(&front.velocity, &carried);
        let towards = dot(&across, &bend.before);
        let fast = rise(towards * towards / square, SONIC, SUPERSONIC);
        if towards <= 0.0 || fast <= 0.0 {
            return None;
        }
        let speed = dot(&across, &across).sqrt();
        let onwards = across.map(|u| u / speed);
        let rising = dot(&bend.up, &onwards);
        let aside = less(&bend.up, &onwards.map(|part| rising * part));
        let size = dot(&aside, &aside).sqrt();
        // Gas that goes straight at a side of a tip does not turn round it.
        if size < LEAST {
            return None;
        }
        let aside = aside.map(|part| part / size);
        let turn = (-dot(&bend.along, &aside)).atan2(dot(&bend.along, &onwards));
        let share = fast * (1.0 - rise(turn, STEEP, STEEPEST));
        let slowness = ((gamma + 1.0) / (gamma - 1.0)).sqrt();
        let mach_square = speed * speed / square;
        let slope = (mach_square - 1.0).sqrt();
        let start = angle(slope, slowness);
        // Up to here there is gas left.
        let most = (slowness - 1.0) * FRAC_PI_2;
        if turn < LEAST || share <= 0.0 || start + turn >= most {
            return None;
        }
        let mut fan = Self {
            gamma,
            slowness,
            front: *front,
            rear: *front,
            heat: 1.0 + 0.5 * (gamma - 1.0) * mach_square,
            start,
            ways: Ways {
                carried,
                onwards,
                aside,
            },
            rays: [0.0; 2],
            turns: [[1.0, 0.0]; 2],
            strength: 0.0,
            near: 0.0,
            share,
        };
        let last = slope_of(start + turn, slope, slowness);
        fan.rays = [(1.0 / slope).atan(), (1.0 / last).atan() - turn];
        fan.rear = fan.turned(last);
        fan.turns = fan.rays.map(|ray| [ray.cos(), ray.sin()]);
        fan.strength = (front.pressure / fan.rear.pressure).ln();
        let width = fan.rays[0] - fan.rays[1];
        fan.near = (fan.strength / (SEEN * width)).clamp(NEAREST, farthest::<D>() / FARTHER);
        Some(fan)
    }

    /// Gas of the fan with this `sqrt(M^2 - 1)`.
    fn turned(&self, slope: f64) -> Primitive<D> {
        let gamma = self.gamma;
        let square = 1.0 + slope * slope;
        let cooled = self.heat / (1.0 + 0.5 * (gamma - 1.0) * square);
        let pressure = self.front.pressure * cooled.powf(gamma / (gamma - 1.0));
        let density = self.front.density * cooled.powf(1.0 / (gamma - 1.0));
        let speed = (square * gamma * pressure / density).sqrt();
        let (sine, cosine) = (angle(slope, self.slowness) - self.start).sin_cos();
        let Ways {
            carried,
            onwards,
            aside,
        } = &self.ways;
        let mut velocity = [0.0; D];
        for k in 0..D {
            let across = cosine * onwards[k] - sine * aside[k];
            velocity[k] = speed * across + carried[k];
        }
        Primitive {
            density,
            velocity,
            pressure,
        }
    }

    /// Elevation of a `place`, as seen from the bend, above the way of the gas in front.
    pub fn elevation(&self, place: &[f64; D]) -> f64 {
        let [along, height] = self.seen(place);
        if along < 0.0 {
            2.0 * FRAC_PI_2
        } else {
            height.atan2(along)
        }
    }

    /// From one up to where cells begin to see it to zero where they do: so far, in spacings, from the bend.
    pub fn nearness(&self, away: f64) -> f64 {
        1.0 - rise(away, self.near, FARTHER * self.near)
    }

    /// True where all these places, as seen from the bend, are in front of the fan, or all behind it: the gas there is the same.
    pub fn is_even<'a>(&self, places: impl Iterator<Item = &'a [f64; D]> + Clone) -> bool {
        let last = self.turns[1];
        self.is_behind(places.clone())
            || places
                .map(|place| self.seen(place))
                .all(|place| place[0] >= 0.0 && !is_above(&place, last))
    }

    /// True where the whole fan is behind all these places, as seen from the bend.
    pub fn is_behind<'a>(&self, places: impl Iterator<Item = &'a [f64; D]>) -> bool {
        let first = self.turns[0];
        places
            .map(|place| self.seen(place))
            .all(|place| place[0] < 0.0 || is_above(&place, first))
    }

    /// The place that lies so far down the way of the gas in front from another.
    pub fn onwards_from(&self, place: &[f64; D], far: f64) -> [f64; D] {
        let mut there = *place;
        for (part, way) in there.iter_mut().zip(self.ways.onwards) {
            *part += far * way;
        }
        there
    }

    /// A place along and across the way of the gas in front.
    fn seen(&self, place: &[f64; D]) -> [f64; 2] {
        [dot(place, &self.ways.onwards), dot(place, &self.ways.aside)]
    }

    /// The state at an elevation: within the fan that ray is a Mach line, `elevation = mu - (nu - nu_1)`, and
    /// `nu - mu + pi / 2 = k atan(sqrt(M^2 - 1) / k)`, `k^2 = (gamma + 1) / (gamma - 1)`.
    pub fn state(&self, elevation: f64) -> Primitive<D> {
        let [first, last] = self.rays;
        if elevation >= first {
            self.front
        } else if elevation <= last {
            self.rear
        } else {
            let part = (self.start - elevation + FRAC_PI_2) / self.slowness;
            self.turned(self.slowness * part.tan())
        }
    }

    /// How far gas in the state `own` may be taken for what the fan has there, `known`: not where it is slower than sound, nor where its
    /// pressure is off by what the whole fan changes, and wholly up to half of that.
    pub fn agreement<G: EquationOfState>(
        &self,
        gas: &G,
        own: &Primitive<D>,
        known: &Primitive<D>,
    ) -> f64 {
        let [across, way] = [own, known].map(|state| less(&state.velocity, &self.ways.carried));
        let speed = dot(&way, &way).sqrt();
        let along = dot(&across, &way).max(0.0) / speed;
        let square = along * along / gas.sound_square(own.density, own.pressure);
        let off = (own.pressure / known.pressure).ln().abs();
        rise(square, SONIC, SUPERSONIC) * (1.0 - rise(off / self.strength, 0.5, 1.0))
    }
}

/// True of a place on a ray of this cosine and sine or above it.
fn is_above(place: &[f64; 2], way: [f64; 2]) -> bool {
    place[1] * way[0] >= place[0] * way[1]
}

/// `a - b`.
fn less<const D: usize>(a: &[f64; D], b: &[f64; D]) -> [f64; D] {
    let mut less = *a;
    for k in 0..D {
        less[k] -= b[k];
    }
    less
}

/// From zero at `low` to one at `high`.
pub fn rise(value: f64, low: f64, high: f64) -> f64 {
    ((value - low) / (high - low)).clamp(0.0, 1.0)
}

#[cfg(test)]
mod tests;
