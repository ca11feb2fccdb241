//! Faces on the sides of the domain: what is beyond them, and what flows through.

use super::cells::SideFace;
use super::gas::{Gas, IdealGas};
use super::hll::Jump;
use super::slopes::Slopes;
use super::state::{Conserved, Primitive, dot};
use super::walls::Image;
use crate::problem::{Problem, Side as SideKind};
use crate::sides::{Place, Reservoir};
use aero_geometry::Vector;

/// What is beyond a side.
#[derive(Clone, Copy, Debug)]
pub enum Beyond<const D: usize> {
    /// Gas in this state: inlets and free streams.
    Stream(Primitive<D>),
    /// More of the same gas.
    Same,
    /// The mirror image.
    Mirror,
    /// A reservoir, for a gas of this ratio of specific heats.
    Reservoir(Reservoir, f64),
}

impl<const D: usize> Beyond<D> {
    /// What is beyond the side of `problem` at the lower or upper `end` of an `axis`.
    ///
    /// # Errors
    /// Of a side that has no open faces.
    pub fn of(problem: &Problem<D>, axis: usize, end: usize) -> Result<Self, String> {
        let stream = Primitive::of(&problem.free_stream);
        match problem.domain.sides[axis][end] {
            SideKind::Inlet | SideKind::FreeStream => Ok(Self::Stream(stream)),
            SideKind::Outlet => Ok(Self::Same),
            SideKind::Symmetry | SideKind::Axis => Ok(Self::Mirror),
            SideKind::Reservoir => {
                let face = problem.domain.face(axis, end);
                let reservoir = Reservoir::new(problem, Place { axis, end, face });
                let gamma = IdealGas::of(&problem.gas).gamma;
                Ok(Self::Reservoir(reservoir, gamma))
            }
            side @ (SideKind::Periodic | SideKind::Wall { .. } | SideKind::Body) => Err(format!(
                "side {end} of axis {axis} is {side:?} and should have no open faces"
            )),
        }
    }

    /// True where the state beyond counts in the gradients.
    pub fn is_known(&self) -> bool {
        matches!(self, Self::Stream(_) | Self::Mirror)
    }
}

/// A face on a side.
#[derive(Clone, Copy, Debug)]
pub struct Side<const D: usize> {
    /// Cell.
    pub i: u32,
    /// The cell's image beyond it.
    pub image: Image<D>,
    /// What is there.
    pub beyond: Beyond<D>,
}

impl<const D: usize> Side<D> {
    /// The side `face` of the cell at `point`.
    pub fn new(face: &SideFace<D>, point: &Vector<D>, beyond: Beyond<D>) -> Self {
        Self {
            i: face.i,
            image: Image::new(&face.area, point, &face.centre),
            beyond,
        }
    }

    /// State at the image of `cell`, where it counts in the gradients.
    #[inline]
    pub fn known(&self, cell: &Primitive<D>) -> Option<Primitive<D>> {
        match self.beyond {
            Beyond::Stream(state) => Some(state),
            Beyond::Mirror => Some(cell.mirrored(&self.image.normal)),
            Beyond::Same | Beyond::Reservoir(..) => None,
        }
    }

    /// Flux through a unit area, out of the domain; `slopes` are the cell's.
    pub fn flux<G: Gas>(&self, gas: &G, cell: &Primitive<D>, slopes: &Slopes<D>) -> Conserved<D> {
        let normal = self.image.normal;
        let other = match &self.beyond {
            Beyond::Stream(state) => *state,
            Beyond::Same => *cell,
            Beyond::Mirror => {
                // The mean of a cell moves away from the plane that gas parts at; at the plane itself it does not.
                let inner = self.image.inner(cell, &slopes.along, slopes.calmness);
                let speed = dot(&inner.velocity, &normal);
                let pressure = gas.wall_pressure(inner.density, inner.pressure, speed);
                return Conserved {
                    mass: 0.0,
                    momentum: normal.map(|n| pressure * n),
                    energy: 0.0,
                };
            }
            Beyond::Reservoir(reservoir, gamma) => {
                let sound = gas.sound_square(cell.density, cell.pressure).sqrt();
                let wave = -dot(&cell.velocity, &normal) - 2.0 * sound / (gamma - 1.0);
                let (speed, density, pressure) = reservoir.entering(wave, *gamma);
                Primitive {
                    density,
                    velocity: normal.map(|n| -speed * n),
                    pressure,
                }
            }
        };
        Jump::new(gas, *cell, other, normal).hllc()
    }
}
