//! The flow behind the shock of a cone, as it stands in a scene.

use super::conical::{Conical, OnRay};
use super::fan::rise;
use super::state::{Primitive, dot};

/// Gas behind the shock may be off the flow of the cone by what the shock changes up to so far from the tip, in spacings, by the inverse square of the distance
/// from there on, and by a part of it at least: that of a nose that bends is another, which slopes know better.
const BEGINNING: f64 = 8.0;

/// See [`BEGINNING`].
const OFF: [f64; 2] = [0.02, 0.5];

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
    /// Behind the shock of gas in the state `front` that comes to the tip at this speed, along the axis; with the directions of that and away from it.
    pub fn new(conical: Conical, front: &Primitive<D>, speed: f64, axes: [[f64; D]; 2]) -> Self {
        Self {
            conical,
            front: *front,
            speed,
            axes,
        }
    }

    /// The gas on the cone.
    pub fn on_cone(&self) -> Primitive<D> {
        self.state(&self.conical.surface())
    }

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
