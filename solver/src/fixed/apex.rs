//! Tips of cones about an axis: where they are, and the flow that stands there.

use aero_geometry::Vector;

use super::attached::{AttachedShock, is_perfect};
use super::bend::Bend;
use super::cells::RADIAL;
use super::chain::Chain;
use super::conical::{Conical, OnRay};
use super::equation_of_state::EquationOfState;
use super::fan::{SONIC, SUPERSONIC, rise};
use super::state::{Primitive, dot};
use super::tips::{AHEAD, FAR};

/// Square of the Mach number on a cone from which on its shock does not stand ahead of the tip; from [`SONIC`] on less and less.
const ATTACHED: f64 = 1.3;

/// A wall is straight as far as it turns by less than this part of its angle to the axis.
const STRAIGHT: f64 = 0.1;

/// So far, in spacings, it is at least.
const LEAST: f64 = 2.0;

/// Gas behind the shock may be off the flow of the cone by what the shock changes up to so far from the tip, in spacings, by the inverse square of the distance
/// from there on, and by a part of it at least: that of a nose that bends is another, which slopes know better.
const BEGINNING: f64 = 8.0;

/// See [`BEGINNING`].
const OFF: [f64; 2] = [0.02, 0.5];

impl<const D: usize> Chain<'_, D> {
    /// All tips on the axis that a `stream` along it meets, and how far the wall goes on straight from each, in spacings.
    pub fn apexes(&self, stream: &Vector<D>) -> Vec<(Bend<D>, f64)> {
        let long = (0..self.solid).filter(|&wall| self.is_long(wall));
        let ends = long.flat_map(|wall| [(wall, 0), (wall, 1)]);
        ends.filter_map(|(wall, back)| self.apex(wall, back, stream))
            .collect()
    }

    /// The tip that a wall begins at, if nothing goes on from it the way `back`.
    fn apex(&self, wall: usize, back: usize, stream: &Vector<D>) -> Option<(Bend<D>, f64)> {
        let along = self.way(wall) * if back == 1 { 1.0 } else { -1.0 };
        let mut before = Vector::zeros();
        before[0] = along[0].signum();
        let is_met = along[RADIAL] > 0.0 && along[0] != 0.0 && stream.dot(&before) > 0.0;
        if !is_met || !self.is_last(wall, back) {
            return None;
        }
        let (foot, unit) = (self.walls[wall].foot, self.units[wall]);
        let away = foot[RADIAL] / along[RADIAL];
        let at = foot - along * away;
        let straight = self.straight(wall, 1 - back, &at) / unit;
        if away > FAR * unit || straight < LEAST {
            return None;
        }
        let donors = self.gas_at(&(at - before * (AHEAD * unit)), unit)?;
        let mut up = [0.0; D];
        up[RADIAL] = 1.0;
        let bend = Bend {
            at: at.into(),
            edge: [0.0; D],
            donors,
            along: along.into(),
            before: before.into(),
            up,
            unit,
        };
        Some((bend, straight))
    }

    /// How far from a place the walls are straight that go on from `wall` this `way`: to the middle of the first that has turned by a part of the angle to the axis;
    /// endless where none does.
    fn straight(&self, wall: usize, way: usize, from: &Vector<D>) -> f64 {
        let along = self.way(wall);
        let most = STRAIGHT * along[RADIAL].abs().atan2(along[0].abs());
        let mut here = wall;
        // As many as there are, should they go round.
        for _ in 0..self.walls.len() {
            let Some(next) = self.links[way][here] else {
                break;
            };
            if self.turn(wall, next).abs() > most {
                return (self.walls[next].foot - from).norm();
            }
            here = next;
        }
        f64::INFINITY
    }
}

/// The gas between a cone and its shock.
#[derive(Clone, Debug)]
pub struct Field<const D: usize> {
    conical: Conical,
    front: Primitive<D>,
    speed: f64,
    /// Directions of the axis and away from it.
    axes: [[f64; D]; 2],
}

impl<const D: usize> Field<D> {
    /// The gas at a place as seen from the tip.
    pub fn at(&self, place: &[f64; D]) -> Primitive<D> {
        let [along, away] = self.axes.map(|axis| dot(place, &axis));
        self.state(&self.conical.at(away.atan2(along)))
    }

    /// How far gas in the state `own`, so many spacings `away` from the tip, may be taken for what is `known` of it.
    pub fn agreement(&self, own: &Primitive<D>, known: &Primitive<D>, away: f64) -> f64 {
        let strength = self.conical.surface().pressure.ln();
        let off = (own.pressure / known.pressure).ln().abs() / strength;
        let least = (OFF[1] * (BEGINNING / away).powi(2)).clamp(OFF[0], OFF[1]);
        1.0 - rise(off, least, 2.0 * least)
    }

    /// How far from the tip the shock is reached by what happens on the cone so far from there: along Mach lines.
    pub fn felt(&self, away: f64) -> f64 {
        let angle = (1.0 / self.conical.mach).asin();
        let rise = self.conical.shock - self.conical.angle();
        away * angle.sin() / (angle - rise).sin().max(f64::MIN_POSITIVE)
    }

    /// How far a place is from the axis.
    pub fn radius(&self, place: &[f64; D]) -> f64 {
        dot(place, &self.axes[1])
    }

    fn state(&self, on: &OnRay) -> Primitive<D> {
        let [along, away] = on.velocity.map(|part| part * self.speed);
        let [axis, out] = &self.axes;
        Primitive {
            density: self.front.density * on.density,
            velocity: std::array::from_fn(|k| along * axis[k] + away * out[k]),
            pressure: self.front.pressure * on.pressure,
        }
    }
}

impl<const D: usize> AttachedShock<D> {
    /// The shock at the tip of a cone of gas in the state `front` ahead of it, if one stands there. Behind it, as told once for all of it, is gas on the cone.
    pub fn at_apex<G: EquationOfState>(
        gas: &G,
        front: &Primitive<D>,
        bend: &Bend<D>,
    ) -> Option<Self> {
        let sound = gas.sound_square(front.density, front.pressure);
        let gamma = sound * front.density / front.pressure;
        let speed = dot(&front.velocity, &bend.before);
        if speed <= 0.0 {
            return None;
        }
        let square = speed * speed / sound;
        let angle = dot(&bend.along, &bend.up).atan2(dot(&bend.along, &bend.before));
        let conical = Conical::new(square, gamma, angle)?;
        let on_cone = conical.mach * conical.mach;
        let share = rise(square, SONIC, SUPERSONIC) * rise(on_cone, SONIC, ATTACHED);
        let (sine, cosine) = conical.shock.sin_cos();
        let surface = conical.surface();
        let field = Field {
            conical,
            front: *front,
            speed,
            axes: [bend.before, bend.up],
        };
        let rear = field.state(&surface);
        (share > 0.0 && is_perfect(gas, gamma, front, &rear)).then(|| Self {
            rear,
            normal: std::array::from_fn(|k| cosine * bend.up[k] - sine * bend.before[k]),
            strength: surface.pressure.ln(),
            share,
            field: Some(field),
        })
    }
}
