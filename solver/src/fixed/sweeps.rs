//! One implicit step towards the steady state without matrices: lower-upper symmetric Gauss-Seidel.
//!
//! [Yoon & Jameson 1988, AIAA J. 26, 1025-1026; for cells of any shape Sharov & Nakahashi 1998, AIAA J. 36, 484-486]

use super::FixedSimulation;
use super::gas::Gas;
use super::net::Net;
use super::state::{Conserved, Primitive, dot, scaled};
use crate::Failure;

/// A cell changes its density in one step by this part at most.
const MOST: f64 = 0.3;

/// A cell keeps this part of its pressure in one step at least.
const LEAST: f64 = 0.2;

/// How often the change of a cell is halved that would leave less.
const HALVINGS: u32 = 20;

/// A neighbour of a cell.
#[derive(Clone, Copy, Debug)]
struct Link {
    cell: u32,
    shape: u32,
    /// The area points out of the cell, or into it.
    sign: f64,
}

/// Cells in the order of the flow, with their neighbours.
#[derive(Clone, Debug)]
pub struct Sweeps {
    order: Vec<u32>,
    /// Place of each cell in the order.
    rank: Vec<u32>,
    starts: Vec<u32>,
    links: Vec<Link>,
}

impl Sweeps {
    /// The cells of `net`, `along` the flow.
    pub fn new<const D: usize>(net: &Net<D>, along: impl Fn(usize) -> f64) -> Self {
        let count = net.len();
        let mut order: Vec<u32> = (0..count as u32).collect();
        let keys: Vec<f64> = (0..count).map(along).collect();
        order.sort_by(|&a, &b| keys[a as usize].total_cmp(&keys[b as usize]));
        let mut rank = vec![0; count];
        for (place, &i) in (0..).zip(&order) {
            rank[i as usize] = place;
        }
        let mut starts = vec![0_u32; count + 1];
        let each = || {
            net.blocks.iter().flat_map(|block| {
                let is_first = |face: &&super::net::Face| block.cells.contains(&(face.i as usize));
                block.faces.iter().filter(is_first)
            })
        };
        for face in each() {
            starts[face.i as usize + 1] += 1;
            starts[face.j as usize + 1] += 1;
        }
        for i in 0..count {
            starts[i + 1] += starts[i];
        }
        let nothing = Link {
            cell: 0,
            shape: 0,
            sign: 0.0,
        };
        let mut links = vec![nothing; starts[count] as usize];
        let mut next = starts.clone();
        for face in each() {
            for (i, cell, sign) in [(face.i, face.j, 1.0), (face.j, face.i, -1.0)] {
                let place = &mut next[i as usize];
                links[*place as usize] = Link {
                    cell,
                    shape: face.shape,
                    sign,
                };
                *place += 1;
            }
        }
        Self {
            order,
            rank,
            starts,
            links,
        }
    }

    fn links(&self, i: usize) -> &[Link] {
        &self.links[self.starts[i] as usize..self.starts[i + 1] as usize]
    }
}

impl<const D: usize> FixedSimulation<D> {
    /// One implicit step with the Courant number `courant`; returns the square mean of the relative rates of density, times the
    /// time in which a wave crosses a cell.
    ///
    /// With `D_i = L_i (1/2 + 1/(2 c))`, `L_i` the sum of wave speed times area:
    /// forward `dU*_i = [R_i - 1/2 sum_before (dF_j.A - lambda_j A dU*_j)] / D_i`, backward
    /// `dU_i = dU*_i - 1/2 sum_after (dF_j.A - lambda_j A dU_j) / D_i`.
    pub(super) fn sweep(&mut self, courant: f64) -> Result<f64, Failure> {
        self.wake();
        self.find_slopes();
        self.exchange(|_, part, gains| part.before.copy_from_slice(&gains.cells));
        let sweeps = self.sweeps.take().unwrap_or_else(|| {
            let stream = &self.problem.free_stream.velocity;
            Sweeps::new(&self.net, |i| {
                if stream.norm_squared() > 0.0 {
                    self.points[i].dot(stream)
                } else {
                    self.points[i][0]
                }
            })
        });
        let reaches = self.reaches(&sweeps);
        let share = 0.5 + 0.5 / courant;
        let residual = self.residual(&reaches);
        for &i in &sweeps.order {
            let i = i as usize;
            if self.is_awake(i) {
                let sum = self.neighbours(&sweeps, i, |other, own| other < own);
                let diagonal = 1.0 / (share * reaches[i]);
                let change = self.before[i].plus(-0.5, &sum);
                self.before[i] = Conserved::ZERO.plus(diagonal, &change);
            } else {
                self.before[i] = Conserved::ZERO;
            }
        }
        for &i in sweeps.order.iter().rev() {
            let i = i as usize;
            if self.is_awake(i) {
                let sum = self.neighbours(&sweeps, i, |other, own| other > own);
                let diagonal = 0.5 / (share * reaches[i]);
                self.before[i] = self.before[i].plus(-diagonal, &sum);
            }
        }
        for i in 0..self.held.len() {
            if self.is_awake(i) {
                self.held[i] = self.changed(i);
            }
        }
        self.sweeps = Some(sweeps);
        match self.find_states() {
            Ok(()) => Ok(residual),
            Err(bad) => Err(self.failure(bad[0])),
        }
    }

    fn is_awake(&self, i: usize) -> bool {
        self.quiet.blocks[i / super::net::BLOCK].is_awake
    }

    /// Sum of wave speed times area over all faces of each cell.
    fn reaches(&self, sweeps: &Sweeps) -> Vec<f64> {
        let mut reaches: Vec<f64> = (0..self.held.len())
            .map(|i| {
                let state = &self.states[i];
                let sound = self.sound(state);
                let each = sweeps.links(i).iter().map(|link| {
                    let shape = &self.net.face_shapes[link.shape as usize];
                    dot(&state.velocity, &shape.area).abs() + sound * shape.size
                });
                each.sum()
            })
            .collect();
        for block in &self.net.blocks {
            let walls = block.walls.iter().map(|wall| (wall.i, &wall.image));
            let sides = block.sides.iter().map(|side| (side.i, &side.image));
            for (i, image) in walls.chain(sides) {
                let state = &self.states[i as usize];
                let speed = dot(&state.velocity, &image.normal).abs() + self.sound(state);
                reaches[i as usize] += speed * image.size;
            }
        }
        reaches
    }

    fn sound(&self, state: &Primitive<D>) -> f64 {
        self.gas.sound_square(state.density, state.pressure).sqrt()
    }

    /// Mean over the cells that are awake of how much of its mass each gains while a wave crosses it.
    fn residual(&self, reaches: &[f64]) -> f64 {
        let (mut sum, mut count) = (0.0, 0.0);
        for (i, reach) in reaches.iter().enumerate() {
            if self.is_awake(i) {
                let part = self.before[i].mass / (self.held[i].mass * reach);
                sum += part * part;
                count += 1.0;
            }
        }
        if count > 0.0 {
            f64::sqrt(sum / count)
        } else {
            0.0
        }
    }

    /// `sum (dF_j.A_ij - lambda_j A_ij dU_j)` over the neighbours whose rank and the cell's are `chosen`.
    fn neighbours(
        &self,
        sweeps: &Sweeps,
        i: usize,
        chosen: impl Fn(u32, u32) -> bool,
    ) -> Conserved<D> {
        let mut sum = Conserved::ZERO;
        for link in sweeps.links(i) {
            let j = link.cell as usize;
            if !chosen(sweeps.rank[j], sweeps.rank[i]) {
                continue;
            }
            let change = &self.before[j];
            let shape = &self.net.face_shapes[link.shape as usize];
            let area = scaled(&shape.area, link.sign);
            let state = &self.states[j];
            let held = self.held[j].plus(1.0, change);
            let changed = held.primitive(&self.gas);
            let speed = dot(&state.velocity, &area);
            let before = state.flux(self.held[j].energy, speed, &area);
            let after = changed.flux(held.energy, dot(&changed.velocity, &area), &area);
            let wave = speed.abs() + self.sound(state) * shape.size;
            sum = sum
                .plus(1.0, &after)
                .plus(-1.0, &before)
                .plus(-wave, change);
        }
        sum
    }

    /// What cell `i` holds after its change, which is cut where it would take or give too much.
    fn changed(&self, i: usize) -> Conserved<D> {
        let (held, change) = (&self.held[i], &self.before[i]);
        let mut part = (MOST * held.mass / change.mass.abs()).min(1.0);
        let least = LEAST * self.states[i].pressure;
        for _ in 0..HALVINGS {
            let changed = held.plus(part, change);
            if changed.primitive(&self.gas).pressure > least {
                return changed;
            }
            part *= 0.5;
        }
        *held
    }
}
