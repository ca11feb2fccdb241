//! Tips of cones about an axis: where they are, and the flow that stands there.

use aero_geometry::Vector;

use super::attached::{AttachedShock, is_perfect};
use super::bend::Bend;
use super::cells::RADIAL;
use super::chain::Chain;
use super::cone_field::Field;
use super::conical::Conical;
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
        let field = Field::new(conical, front, speed, [bend.before, bend.up]);
        let rear = field.on_cone();
        (share > 0.0 && is_perfect(gas, gamma, front, &rear)).then(|| Self {
            rear,
            normal: std::array::from_fn(|k| cosine * bend.up[k] - sine * bend.before[k]),
            strength: surface.pressure.ln(),
            share,
            field: Some(field),
        })
    }
}
