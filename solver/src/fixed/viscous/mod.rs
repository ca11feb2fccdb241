//! Viscosity and heat conduction: the stress `mu (grad u + grad u^T - 2/3 div u)` and the heat `k grad T` through faces.
//!
//! None of this is asked for where the gas has no viscosity. What heat flows down is its measure, see [`warmth`].

mod boundaries;
mod faces;
mod stick;
mod uneven;
mod warmth;

use super::cells::RADIAL;
use super::net::Net;
use super::slopes::Slopes;
use super::state::{Primitive, dot};
use aero_geometry::Vector;

pub use boundaries::WallShare;
pub use faces::Rubbing;
pub use stick::stick;
pub use warmth::Viscous;

/// Gradients of velocity and of the measure of heat.
#[derive(Clone, Copy, Debug)]
struct Gradient<const D: usize> {
    /// Derivative of the velocity along each axis.
    velocity: [[f64; D]; D],
    heat: [f64; D],
}

impl<const D: usize> Gradient<D> {
    /// That in a cell.
    #[inline(always)]
    fn of(viscous: &Viscous, state: &Primitive<D>, slopes: &Slopes<D>) -> Self {
        let mut gradient = Self {
            velocity: [[0.0; D]; D],
            heat: [0.0; D],
        };
        for (axis, slope) in slopes.along.iter().enumerate() {
            gradient.velocity[axis] = slope.velocity;
            gradient.heat[axis] = viscous.warming(state, slope);
        }
        gradient
    }

    /// The mean of two.
    #[inline(always)]
    fn mean(&self, other: &Self) -> Self {
        let mut mean = *self;
        for axis in 0..D {
            for k in 0..D {
                mean.velocity[axis][k] = 0.5 * (self.velocity[axis][k] + other.velocity[axis][k]);
            }
            mean.heat[axis] = 0.5 * (self.heat[axis] + other.heat[axis]);
        }
        mean
    }

    /// The same where both rise so much over this way.
    #[inline(always)]
    fn along(mut self, way: &[f64; D], rise: &[f64; D], heat: f64) -> Self {
        let share = 1.0 / dot(way, way);
        for k in 0..D {
            let mut known = 0.0;
            for axis in 0..D {
                known += self.velocity[axis][k] * way[axis];
            }
            let lack = (rise[k] - known) * share;
            for axis in 0..D {
                self.velocity[axis][k] += lack * way[axis];
            }
        }
        let lack = (heat - dot(&self.heat, way)) * share;
        for axis in 0..D {
            self.heat[axis] += lack * way[axis];
        }
        self
    }

    /// Divergence of the velocity, without what comes of an axis.
    #[inline(always)]
    fn divergence(&self) -> f64 {
        let mut sum = 0.0;
        for axis in 0..D {
            sum += self.velocity[axis][axis];
        }
        sum
    }

    /// `mu (grad u + grad u^T - 2/3 div u) A`.
    #[inline(always)]
    fn stress(&self, viscosity: f64, divergence: f64, area: &[f64; D]) -> [f64; D] {
        let mut stress = [0.0; D];
        for k in 0..D {
            let mut sum = -2.0 / 3.0 * divergence * area[k];
            for axis in 0..D {
                sum += (self.velocity[axis][k] + self.velocity[k][axis]) * area[axis];
            }
            stress[k] = viscosity * sum;
        }
        stress
    }
}

/// `v / r` of gas at a radius about an axis.
#[inline(always)]
fn around<const D: usize>(velocity: &[f64; D], radius: f64) -> f64 {
    velocity[RADIAL.min(D - 1)] / radius
}

/// Adds what viscosity spreads through the faces of cells to the sums of their wave speeds: what it is in cells `start` and after.
pub fn add_reaches<const D: usize>(
    viscous: &Viscous,
    net: &Net<D>,
    block: &super::net::Block<D>,
    states: &[Primitive<D>],
    viscosities: &[f64],
    mut add: impl FnMut(usize, f64),
) {
    for face in &block.faces {
        let shape = &net.face_shapes[face.shape as usize];
        let apart = dot(&shape.apart, &shape.apart).sqrt();
        let cells = [face.i as usize, face.j as usize];
        let both = cells.map(|i| viscosities[i]);
        for i in cells {
            if block.cells.contains(&i) {
                add(i, viscous.reach(both, states[i].density, shape.size, apart));
            }
        }
    }
    let walls = block.walls.iter().map(|wall| (wall.i, &wall.image));
    let sides = block.sides.iter().map(|side| (side.i, &side.image));
    for (i, image) in walls.chain(sides).filter(|(_, image)| image.size > 0.0) {
        let i = i as usize;
        let distance = boundaries::distance(image, width(net, i));
        let both = [viscosities[i]; 2];
        add(
            i,
            viscous.reach(both, states[i].density, image.size, distance),
        );
    }
}

/// About how wide a cell is.
fn width<const D: usize>(net: &Net<D>, i: usize) -> f64 {
    let shape = net.cell(i);
    // About an axis the volume is that of a ring.
    if shape.hoop > 0.0 {
        shape.hoop.sqrt()
    } else {
        shape.volume.powf(1.0 / D as f64)
    }
}

/// Where a cell is from the axis.
fn radius<const D: usize>(point: &Vector<D>) -> f64 {
    point[RADIAL.min(D - 1)]
}
