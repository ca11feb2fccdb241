//! Faces on the sides of the domain, and what flows through them.

use super::beyond::Beyond;
use super::calmness::{share, smoothness};
use super::cells::SideFace;
use super::equation_of_state::EquationOfState;
use super::hll::Jump;
use super::image::Image;
use super::mach_lines;
use super::reconstruction::rise;
use super::slopes::Slopes;
use super::state::{Conserved, Primitive, dot};
use super::total;
use crate::sides::Along;
use aero_geometry::Vector;

/// A face on a side.
#[derive(Clone, Copy, Debug)]
pub struct Side<const D: usize> {
    /// Cell.
    pub i: u32,
    /// The cell's image beyond it.
    pub image: Image<D>,
    /// From the cell's point to the middle of the face, along the side: at a wall that is not square to it, they lie apart.
    pub aside: [f64; D],
    /// What is there.
    pub beyond: Beyond<D>,
}

impl<const D: usize> Side<D> {
    /// The side `face` of the cell at `point`.
    pub fn new(face: &SideFace<D>, point: &Vector<D>, beyond: Beyond<D>) -> Self {
        let image = Image::new(&face.area, point, &face.centre);
        let normal = Vector::from(image.normal);
        let way = face.centre - point;
        Self {
            i: face.i,
            image,
            aside: (way - normal * way.dot(&normal)).into(),
            beyond,
        }
    }

    /// The same of a ring at this `radius` about an axis.
    #[must_use]
    pub fn at_radius(self, radius: f64) -> Self {
        Self {
            image: self.image.at_radius(radius),
            ..self
        }
    }

    /// State at the image of `cell`, where it counts in the gradients.
    #[inline]
    pub fn known<G: EquationOfState>(&self, gas: &G, cell: &Primitive<D>) -> Option<Primitive<D>> {
        match &self.beyond {
            Beyond::Stream(state) => Some(mach_lines::beyond(gas, cell, state, &self.image.normal)),
            Beyond::Total(state) => Some(total::beyond(gas, cell, state, &self.image.normal)),
            Beyond::Mirror => Some(cell.mirrored(&self.image.normal)),
            Beyond::Same | Beyond::OneWay | Beyond::Answers(..) | Beyond::Rides(..) => None,
        }
    }

    /// Flux through a unit area, out of the domain; `slopes` are the cell's, `rubbed` is what viscosity and heat conduction give it per volume.
    pub fn flux<G: EquationOfState>(
        &self,
        gas: &G,
        cell: &Primitive<D>,
        slopes: &Slopes<D>,
        rubbed: Option<&Conserved<D>>,
    ) -> Conserved<D> {
        let normal = self.image.normal;
        let drawn = match (&self.beyond, rubbed) {
            (Beyond::Same | Beyond::OneWay, Some(_)) => self.leaving(cell, slopes),
            (Beyond::Same | Beyond::OneWay, None) => self.outrunning(gas, cell, slopes),
            (Beyond::Answers(..) | Beyond::Rides(..), _) => drawn_out(cell, slopes, &self.way()),
            _ => *cell,
        };
        let other = match &self.beyond {
            Beyond::Stream(state) => mach_lines::beyond(gas, cell, state, &normal),
            Beyond::Total(state) => total::beyond(gas, cell, state, &normal),
            Beyond::Same => drawn,
            Beyond::OneWay => {
                let speed = dot(&drawn.velocity, &normal);
                if speed < 0.0 {
                    let pressure = gas.wall_pressure(drawn.density, drawn.pressure, speed);
                    return pushed(pressure, &normal);
                }
                drawn
            }
            Beyond::Mirror => {
                // The mean of a cell moves away from the plane that gas parts at; at the plane itself it does not.
                let inner = self.image.inner(cell, &slopes.along, slopes.calmness);
                let speed = dot(&inner.velocity, &normal);
                let pressure = gas.wall_pressure(inner.density, inner.pressure, speed);
                return pushed(pressure, &normal);
            }
            Beyond::Answers(answering, drift) => {
                let inside = along(&drawn, &normal);
                let mean = along(&drawn_out(cell, slopes, &self.aside), &normal);
                let outside = answering.beyond(&inside, &mean, self.image.distance);
                entering(&outside, drift, &normal)
            }
            Beyond::Rides(riding, drift) => {
                entering(&riding.beyond(&along(&drawn, &normal)), drift, &normal)
            }
        };
        Jump::new(gas, drawn, other, normal).hllc()
    }

    /// True of a face on a plane of symmetry, but not of none on an axis.
    pub fn is_mirror(&self) -> bool {
        matches!(self.beyond, Beyond::Mirror) && self.image.size > 0.0
    }

    /// From the cell's point to the middle of the face.
    pub fn way(&self) -> [f64; D] {
        std::array::from_fn(|k| self.aside[k] + self.image.distance * self.image.normal[k])
    }

    /// How fast gas parts along the side, per time: the divergence of what moves along it.
    pub fn parting(&self, slopes: &Slopes<D>) -> f64 {
        let normal = &self.image.normal;
        let across = |k: usize| normal[k] * dot(&slopes.along[k].velocity, normal);
        (0..D)
            .map(|k| slopes.along[k].velocity[k] - across(k))
            .sum()
    }

    /// Gas of `cell` that reaches the middle of the face.
    pub fn reached(&self, cell: &Primitive<D>, slopes: &Slopes<D>) -> Primitive<D> {
        drawn_out(cell, slopes, &self.way())
    }

    /// The same, its speed out of the domain.
    pub fn reaching(&self, cell: &Primitive<D>, slopes: &Slopes<D>) -> Along {
        along(&self.reached(cell, slopes), &self.image.normal)
    }

    /// The state of `cell` at the side itself, where gas leaves as it is; the cell's own where it would not. A layer along a wall changes all the
    /// way up to the side: were it to leave as it is half a cell before, that half would be missing in all that balances there.
    fn leaving(&self, cell: &Primitive<D>, slopes: &Slopes<D>) -> Primitive<D> {
        let drawn = drawn_out(cell, slopes, &self.way());
        let leaves = dot(&drawn.velocity, &self.image.normal) > 0.0;
        if leaves { drawn } else { *cell }
    }

    /// The state of `cell` at the side itself, as far as gas leaves faster than sound; from Mach 1.1 on, all of it. Slower gas leaves as it is in the
    /// cell: sound that comes back would be drawn out as well, and grow.
    fn outrunning<G: EquationOfState>(
        &self,
        gas: &G,
        cell: &Primitive<D>,
        slopes: &Slopes<D>,
    ) -> Primitive<D> {
        let speed = dot(&cell.velocity, &self.image.normal);
        let sound = gas.sound_square(cell.density, cell.pressure).sqrt();
        let part = share(speed / sound, 1.0, 1.1);
        drawn_out(cell, slopes, &self.way().map(|d| part * d))
    }
}

/// The state of `cell` at the end of this `way`; the cell's own where that is none, or in shocks.
fn drawn_out<const D: usize>(
    cell: &Primitive<D>,
    slopes: &Slopes<D>,
    way: &[f64; D],
) -> Primitive<D> {
    let share = smoothness(slopes.calmness);
    let drawn = cell.plus(1.0, &rise(&slopes.along, &way.map(|d| share * d)));
    if drawn.makes_sense() { drawn } else { *cell }
}

/// Flux through a face that nothing passes.
pub fn pushed<const D: usize>(pressure: f64, normal: &[f64; D]) -> Conserved<D> {
    Conserved {
        mass: 0.0,
        momentum: normal.map(|n| pressure * n),
        energy: 0.0,
    }
}

/// Gas that is `outside`, and moves along the side with this `drift`: what leaves takes its own along, what comes back in has none of that of the gas
/// in front of it, or it would go faster and faster along the side.
fn entering<const D: usize>(outside: &Along, drift: &[f64; D], normal: &[f64; D]) -> Primitive<D> {
    let mut velocity = normal.map(|n| outside.speed * n);
    for (u, along) in velocity.iter_mut().zip(drift) {
        *u += along;
    }
    Primitive {
        density: outside.density,
        velocity,
        pressure: outside.pressure,
    }
}

/// What of `state` moves along `normal`.
fn along<const D: usize>(state: &Primitive<D>, normal: &[f64; D]) -> Along {
    Along {
        density: state.density,
        speed: dot(&state.velocity, normal),
        pressure: state.pressure,
    }
}

#[cfg(test)]
mod tests;
