//! What a flow about fixed points shows of itself: frames, totals and counts. A point is a particle with volume.

use std::array;

use aero_geometry::kernel::SMOOTHING_RATIO;
use aero_geometry::{Bounds, Vector};

use super::FixedSimulation;
use super::equation_of_state::EquationOfState;
use super::face_list::Join;
use super::net::Block;
use super::state::Conserved;
use crate::Statistics;
use crate::frame::{Frame, Kind, SurfaceFrame, Totals};
use crate::walls::rigid::pad;

impl<const D: usize> FixedSimulation<D> {
    /// All points now.
    pub fn frame(&self) -> Frame {
        self.frame_of(|_| true)
    }

    /// The points within a box now.
    pub fn frame_within(&self, region: &Bounds<D>) -> Frame {
        self.frame_of(|position| region.contains(position))
    }

    fn frame_of(&self, is_shown: impl Fn(&Vector<D>) -> bool) -> Frame {
        let mut frame = Frame {
            time: self.tally.time,
            ..Frame::default()
        };
        let shown = self.points.iter().filter(|point| is_shown(point)).count();
        frame.reserve_exact(shown);
        for (i, (point, state)) in self.points.iter().zip(&self.columns.states).enumerate() {
            if !is_shown(point) {
                continue;
            }
            let velocity = Vector::from(state.velocity);
            let sound = self
                .fluid
                .gas
                .sound_square(state.density, state.pressure)
                .sqrt();
            let energy = self
                .fluid
                .gas
                .internal_energy(state.density, state.pressure)
                / state.density;
            frame.position.push(pad(point).into());
            frame.velocity.push(pad(&velocity).into());
            frame.density.push(state.density);
            frame.pressure.push(state.pressure);
            frame.energy.push(energy);
            frame.mach.push(velocity.norm() / sound);
            let size = self.net.cell(i).volume.powf(1.0 / D as f64);
            frame.smoothing_length.push(SMOOTHING_RATIO * size);
            frame.volume.push(self.around() * self.net.cell(i).volume);
            frame.extra.spacing.push(self.spacing_at(i));
            frame.kind.push(Kind::Fluid as u8);
            frame.id.push(i as u64);
        }
        frame
    }

    /// Volume of each cell, in the order of a frame of all points; per radian about an axis.
    pub fn volumes(&self) -> Vec<f64> {
        (0..self.points.len())
            .map(|i| self.net.cell(i).volume)
            .collect()
    }

    /// State on the surfaces now, wall by wall.
    pub fn surface(&self) -> SurfaceFrame {
        let stream = &self.problem.free_stream;
        let dynamic_pressure = 0.5 * stream.density * stream.velocity.norm_squared();
        let mut surface = SurfaceFrame {
            time: self.tally.time,
            ..SurfaceFrame::default()
        };
        for (wall, pressure) in self.walls() {
            surface.position.push(pad(&wall.foot).into());
            let normal = -Vector::from(wall.image.normal);
            surface.normal.push(pad(&normal).into());
            surface.pressure.push(pressure);
            surface.area.push(self.around() * wall.image.size);
            let over = pressure - stream.pressure;
            surface
                .pressure_coefficient
                .push(if dynamic_pressure > 0.0 {
                    over / dynamic_pressure
                } else {
                    0.0
                });
            surface.body.push(wall.owner);
        }
        surface
    }

    /// Conserved totals of the gas now.
    pub fn totals(&self) -> Totals {
        let nothing = Conserved::ZERO;
        let sum = self
            .holdings()
            .fold(nothing, |sum, own| sum.plus(1.0, &own.sum));
        self.totals_of(&sum)
    }

    /// All around an axis; what points away from it cancels there.
    pub(super) fn totals_of(&self, sum: &Conserved<D>) -> Totals {
        let around = self.around();
        let is_axisymmetric = self.problem.domain.is_axisymmetric();
        Totals {
            mass: around * sum.mass,
            momentum: array::from_fn(|k| match k {
                1 if is_axisymmetric => 0.0,
                k if k < D => around * sum.momentum[k],
                _ => 0.0,
            }),
            energy: around * sum.energy,
        }
    }

    /// Mass of the gas now, and its centre; missing axes zero.
    pub fn mass_and_centre(&self) -> (f64, [f64; 3]) {
        let mut mass = 0.0;
        let mut moment = Vector::<D>::zeros();
        for own in self.holdings() {
            mass += own.sum.mass;
            moment += own.moment;
        }
        (self.around() * mass, pad(&(moment / mass)).into())
    }

    /// What blocks hold, in their order.
    fn holdings(&self) -> impl Iterator<Item = Holding<D>> {
        let blocks = self.net.blocks.iter().zip(&self.quiet.blocks);
        blocks.map(|(block, rest)| {
            if rest.is_awake {
                self.holding(block)
            } else {
                rest.holding
            }
        })
    }

    /// What `block` holds.
    pub(super) fn holding(&self, block: &Block<D>) -> Holding<D> {
        let mut holding = Holding::NOTHING;
        for i in block.cells.clone() {
            let volume = self.net.cell(i).volume;
            let held = &self.columns.held[i];
            holding.sum = holding.sum.plus(volume, held);
            holding.moment += self.points[i] * (volume * held.mass);
        }
        holding
    }

    /// Counts and extremes.
    pub fn statistics(&self) -> Statistics {
        let faces: usize = self.net.blocks.iter().map(inner_faces).sum();
        Statistics {
            fluid: self.points.len(),
            ghost: self.net.blocks.iter().map(|block| block.walls.len()).sum(),
            particle_updates: self.tally.updates,
            neighbours_mean: 2.0 * faces as f64 / self.points.len() as f64,
            leaked: self.net.lost,
            returned: 0,
            mirror_fallbacks: 0,
            min_density: self.tally.min_density,
            min_energy: self.tally.min_energy,
        }
    }
}

/// What a block of cells holds, per radian about an axis.
#[derive(Clone, Copy, Debug)]
pub struct Holding<const D: usize> {
    /// All of it.
    pub sum: Conserved<D>,
    /// The moment of its mass.
    pub moment: Vector<D>,
}

impl<const D: usize> Holding<D> {
    /// Nothing.
    pub const NOTHING: Self = Self {
        sum: Conserved::ZERO,
        moment: Vector::<D>::from_array_storage(nalgebra::ArrayStorage([[0.0; D]])),
    };
}

/// Faces whose first cell is in this block: each face once, over all blocks.
fn inner_faces<const D: usize>(block: &Block<D>) -> usize {
    let is_first = |face: &&Join| block.cells.contains(&(face.i as usize));
    block.faces.iter().filter(is_first).count()
}
