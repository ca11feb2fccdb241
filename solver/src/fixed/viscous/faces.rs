//! What viscosity and heat conduction take through the faces between cells.

use aero_geometry::Vector;

use super::super::cells::RADIAL;
use super::super::gains::Gains;
use super::super::net::{Block, Net};
use super::super::slopes::Flow;
use super::super::state::{Conserved, dot};
use super::uneven::uneven;
use super::{Gradient, Viscous, WallShare, around, radius};

/// What there is to know of a viscous flow beside its states and slopes.
#[derive(Clone, Copy, Debug)]
pub struct Rubbing<'a, const D: usize> {
    /// The gas.
    pub viscous: &'a Viscous,
    /// Viscosity of each cell.
    pub viscosities: &'a [f64],
    /// Where the cells are.
    pub points: &'a [Vector<D>],
    /// True about an axis.
    pub is_axisymmetric: bool,
}

impl<const D: usize> Rubbing<'_, D> {
    /// Adds what a block gains; what its walls give goes to `shares`.
    pub fn add(
        &self,
        net: &Net<D>,
        block: &Block<D>,
        flow: Flow<'_, D>,
        gains: &mut Gains<D>,
        shares: &mut [WallShare<D>],
    ) {
        let start = block.cells.start;
        let gradients: Vec<Gradient<D>> = block
            .cells
            .clone()
            .map(|i| Gradient::of(self.viscous, &flow.states[i], &flow.slopes[i]))
            .collect();
        let gradient = |i: usize| {
            let known = gradients.get(i.wrapping_sub(start)).copied();
            known.unwrap_or_else(|| Gradient::of(self.viscous, &flow.states[i], &flow.slopes[i]))
        };
        for face in &block.faces {
            let (i, j) = (face.i as usize, face.j as usize);
            let shape = &net.face_shapes[face.shape as usize];
            let [a, b] = [&flow.states[i], &flow.states[j]];
            let rise = b.plus(-1.0, a).velocity;
            let heat = self.viscous.measure(b) - self.viscous.measure(a);
            let at = gradient(i)
                .mean(&gradient(j))
                .along(&shape.apart, &rise, heat);
            let mut velocity = a.velocity;
            for k in 0..D {
                velocity[k] += 0.5 * rise[k];
                for axis in 0..D {
                    velocity[k] += shape.skew[axis] * at.velocity[axis][k];
                }
            }
            let mut divergence = at.divergence();
            if self.is_axisymmetric {
                let between = 0.5 * (radius(&self.points[i]) + radius(&self.points[j]));
                let middle = between + shape.skew[RADIAL.min(D - 1)];
                divergence += around(&velocity, middle);
            }
            let viscosity = 0.5 * (self.viscosities[i] + self.viscosities[j]);
            let stress = at.stress(viscosity, divergence, &shape.area);
            let conducted = self.viscous.conductivity(viscosity) * dot(&at.heat, &shape.area);
            let gain = Conserved {
                mass: 0.0,
                momentum: stress,
                energy: dot(&velocity, &stress) + conducted,
            };
            let slopes = [&flow.slopes[i], &flow.slopes[j]];
            let gain = gain.plus(-1.0, &uneven(self.viscous, [a, b], slopes, shape));
            for (number, sign) in [(i, 1.0), (j, -1.0)] {
                if let Some(cell) = gains.cells.get_mut(number.wrapping_sub(start)) {
                    *cell = cell.plus(sign, &gain);
                }
            }
        }
        for (wall, share) in block.walls.iter().zip(shares) {
            let i = wall.i as usize;
            *share = self.of_wall(net, wall, &flow.states[i], &gradient(i));
            let gain = share.gain(wall);
            gains.boundary = gains.boundary.plus(1.0, &gain);
            gains.cells[i - start] = gains.cells[i - start].plus(1.0, &gain);
        }
        for side in block.sides.iter().filter(|side| side.image.size > 0.0) {
            let i = side.i as usize;
            let gain = self.of_side(net, side, &flow.states[i], &gradient(i));
            gains.boundary = gains.boundary.plus(1.0, &gain);
            gains.cells[i - start] = gains.cells[i - start].plus(1.0, &gain);
        }
        if self.is_axisymmetric && D > 1 {
            for (k, i) in block.cells.clone().enumerate() {
                gains.cells[k].momentum[1] -=
                    self.hoop_stress(i, flow, &gradients[k]) * net.cell(i).hoop;
            }
        }
    }

    /// Stress along the rings of cell `i`, `mu (2 v / r - 2/3 div u)`.
    fn hoop_stress(&self, i: usize, flow: Flow<'_, D>, gradient: &Gradient<D>) -> f64 {
        let ring = around(&flow.states[i].velocity, radius(&self.points[i]));
        let divergence = gradient.divergence() + ring;
        self.viscosities[i] * (2.0 * ring - 2.0 / 3.0 * divergence)
    }
}
