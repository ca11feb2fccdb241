//! One implicit step towards the steady state without matrices: lower-upper symmetric Gauss-Seidel.
//!
//! Cells that no face joins are computed side by side, in an order that no number of threads changes.
//!
//! [Yoon & Jameson 1988, AIAA J. 26, 1025-1026; for cells of any shape Sharov & Nakahashi 1998, AIAA J. 36, 484-486; the fluxes of changes linearised, as in the first]

use aero_geometry::parallel::prelude::*;

use super::columns::Columns;
use super::gas::Gas;
use super::net::Net;
use super::order::{Link, levels};
use super::state::{Conserved, Primitive, dot, scaled};
use super::viscous::add_reaches;
use super::{FixedSimulation, Fluid};
use crate::Failure;

/// A cell changes its density in one step by this part at most.
const MOST: f64 = 0.3;

/// A cell keeps this part of its pressure in one step at least.
const LEAST: f64 = 0.2;

/// How often the change of a cell is halved that would leave less.
const HALVINGS: u32 = 20;

/// Cells of a level that one thread takes at a time.
const CHUNK: usize = 64;

/// Cells in the order of the flow, with their neighbours.
///
/// Cells stand in levels: no two cells of a level are neighbours, and a cell's level is above those of all its neighbours upstream. All
/// cells of a level can then be computed at once, and whoever computes them, the sums are the same.
#[derive(Clone, Debug)]
pub struct Sweeps {
    /// Cells by level, and by number within one.
    order: Vec<u32>,
    /// Where each level starts in the order, and where the last one ends.
    levels: Vec<usize>,
    /// Where the links of the cell at each place start.
    starts: Vec<u32>,
    links: Vec<Link>,
}

impl Sweeps {
    /// The cells of `net`, `along` the flow.
    pub fn new<const D: usize>(net: &Net<D>, along: impl Fn(usize) -> f64) -> Self {
        let count = net.len();
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
            place: 0,
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
                    place: 0,
                    shape: face.shape,
                    sign,
                };
                *place += 1;
            }
        }
        let keys: Vec<f64> = (0..count).map(along).collect();
        let level_of = levels(&starts, &links, &keys);
        Self::ordered(&level_of, &starts, &links)
    }

    /// The same links in the order of the levels.
    fn ordered(level_of: &[u32], starts: &[u32], links: &[Link]) -> Self {
        let mut order: Vec<u32> = (0..level_of.len() as u32).collect();
        order.sort_by_key(|&i| (level_of[i as usize], i));
        let mut places = vec![0_u32; order.len()];
        let mut sweeps = Self {
            order: Vec::new(),
            levels: Vec::new(),
            starts: vec![0],
            links: Vec::with_capacity(links.len()),
        };
        for (place, &i) in (0..).zip(&order) {
            places[i as usize] = place;
        }
        for (place, &i) in order.iter().enumerate() {
            let level = level_of[i as usize] as usize;
            if level == sweeps.levels.len() {
                sweeps.levels.push(place);
            }
            let range = starts[i as usize] as usize..starts[i as usize + 1] as usize;
            sweeps.links.extend(links[range].iter().map(|link| Link {
                place: places[link.cell as usize],
                ..*link
            }));
            sweeps.starts.push(sweeps.links.len() as u32);
        }
        sweeps.levels.push(order.len());
        sweeps.order = order;
        sweeps
    }

    /// Neighbours of the cell at `place`.
    fn links(&self, place: usize) -> &[Link] {
        &self.links[self.starts[place] as usize..self.starts[place + 1] as usize]
    }

    /// First and last place of each level, in their order.
    fn levels(&self) -> impl DoubleEndedIterator<Item = (usize, usize)> {
        self.levels.windows(2).map(|ends| (ends[0], ends[1]))
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
        self.add_steady_source();
        let sweeps = self.settling.sweeps.take().unwrap_or_else(|| {
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
        let residual = self.residual(&sweeps, &reaches);
        let share = 0.5 + 0.5 / courant;
        let mut changes = vec![Conserved::<D>::ZERO; sweeps.order.len()];
        for (start, end) in sweeps.levels() {
            let (before, rest) = changes.split_at_mut(start);
            let level = rest[..end - start].par_iter_mut().enumerate();
            level.with_min_len(CHUNK).for_each(|(k, change)| {
                let place = start + k;
                let i = sweeps.order[place] as usize;
                if self.is_awake(i) {
                    let links = sweeps.links(place).iter();
                    let known =
                        links.filter_map(|link| Some((link, before.get(link.place as usize)?)));
                    let gain = self.columns.before[i].plus(-0.5, &self.neighbours(known));
                    *change = Conserved::ZERO.plus(1.0 / (share * reaches[place]), &gain);
                }
            });
        }
        for (start, end) in sweeps.levels().rev() {
            let (front, after) = changes.split_at_mut(end);
            let level = front[start..].par_iter_mut().enumerate();
            level.with_min_len(CHUNK).for_each(|(k, change)| {
                let place = start + k;
                if self.is_awake(sweeps.order[place] as usize) {
                    let links = sweeps.links(place).iter();
                    let known = links.filter_map(|link| {
                        Some((link, after.get((link.place as usize).wrapping_sub(end))?))
                    });
                    *change = change.plus(-0.5 / (share * reaches[place]), &self.neighbours(known));
                }
            });
        }
        for (change, &i) in changes.iter().zip(&sweeps.order) {
            let i = i as usize;
            if self.is_awake(i) {
                self.columns.held[i] = self.changed(i, change);
            }
        }
        self.settling.sweeps = Some(sweeps);
        match self.find_states() {
            Ok(()) => Ok(residual),
            Err(bad) => Err(self.failure(bad[0])),
        }
    }

    fn is_awake(&self, i: usize) -> bool {
        self.quiet.blocks[i / super::net::BLOCK].is_awake
    }

    /// Sum of wave speed times area over all faces of each cell that is awake, place by place.
    fn reaches(&self, sweeps: &Sweeps) -> Vec<f64> {
        let mut ends = vec![0.0; self.columns.held.len()];
        for (block, rest) in self.net.blocks.iter().zip(&self.quiet.blocks) {
            if !rest.is_awake {
                continue;
            }
            let walls = block.walls.iter().map(|wall| (wall.i, &wall.image));
            let sides = block.sides.iter().map(|side| (side.i, &side.image));
            for (i, image) in walls.chain(sides) {
                let state = &self.columns.states[i as usize];
                let speed = dot(&state.velocity, &image.normal).abs() + self.sound(state);
                ends[i as usize] += speed * image.size;
            }
            if let Some(viscous) = &self.fluid.viscous {
                let Columns {
                    states,
                    viscosities,
                    ..
                } = &self.columns;
                let add = |i: usize, reach| ends[i] += reach;
                add_reaches(viscous, &self.net, block, states, viscosities, add);
            }
        }
        let places = sweeps.order.par_iter().enumerate().with_min_len(CHUNK);
        let reach = |(place, &i): (usize, &u32)| {
            let i = i as usize;
            if !self.is_awake(i) {
                return 1.0;
            }
            let state = &self.columns.states[i];
            let sound = self.sound(state);
            let mut sum = ends[i];
            for link in sweeps.links(place) {
                let shape = &self.net.face_shapes[link.shape as usize];
                sum += dot(&state.velocity, &shape.area).abs() + sound * shape.size;
            }
            sum
        };
        places.map(reach).collect()
    }

    fn sound(&self, state: &Primitive<D>) -> f64 {
        self.fluid
            .gas
            .sound_square(state.density, state.pressure)
            .sqrt()
    }

    /// Mean over the cells that are awake of how much of its mass each gains while a wave crosses it.
    fn residual(&self, sweeps: &Sweeps, reaches: &[f64]) -> f64 {
        let (mut sum, mut count) = (0.0, 0.0);
        for (&i, reach) in sweeps.order.iter().zip(reaches) {
            let i = i as usize;
            if self.is_awake(i) {
                let part = self.columns.before[i].mass / (self.columns.held[i].mass * reach);
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

    /// `sum (dF_j.A_ij - lambda_j A_ij dU_j)` over the neighbours with `known` changes.
    fn neighbours<'a>(
        &self,
        known: impl Iterator<Item = (&'a Link, &'a Conserved<D>)>,
    ) -> Conserved<D> {
        let Fluid { gas, viscous } = &self.fluid;
        let mut sum = Conserved::ZERO;
        for (link, change) in known {
            let j = link.cell as usize;
            let shape = &self.net.face_shapes[link.shape as usize];
            let area = scaled(&shape.area, link.sign);
            let state = &self.columns.states[j];
            let speed = dot(&state.velocity, &area);
            let moved = state.flux_change(gas, self.columns.held[j].energy, &area, change);
            let mut wave = speed.abs() + self.sound(state) * shape.size;
            if let Some(viscous) = viscous {
                let apart = dot(&shape.apart, &shape.apart).sqrt();
                let viscosities = [self.columns.viscosities[j]; 2];
                wave += viscous.reach(viscosities, state.density, shape.size, apart);
            }
            sum = sum.plus(1.0, &moved).plus(-wave, change);
        }
        sum
    }

    /// What cell `i` holds after its `change`, which is cut where it would take or give too much.
    fn changed(&self, i: usize, change: &Conserved<D>) -> Conserved<D> {
        let held = &self.columns.held[i];
        let mut part = (MOST * held.mass / change.mass.abs()).min(1.0);
        let least = LEAST * self.columns.states[i].pressure;
        for _ in 0..HALVINGS {
            let changed = held.plus(part, change);
            if changed.primitive(&self.fluid.gas).pressure > least {
                return changed;
            }
            part *= 0.5;
        }
        *held
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::lattice::{lattice, problem};
    use super::*;
    use crate::problem::Side;

    #[test]
    fn no_neighbours_share_a_level_and_the_stream_goes_upwards() {
        let problem = problem::<2>(
            [7, 6],
            1.0,
            [[Side::Inlet, Side::Outlet], [Side::Periodic; 2]],
        );
        let cells = lattice(&problem);
        let x: Vec<f64> = cells.points.iter().map(|point| point[0]).collect();
        let flow = FixedSimulation::on(cells, problem).unwrap();
        let sweeps = Sweeps::new(&flow.net, |i| x[i]);
        let mut level_of = vec![0; x.len()];
        for (level, (start, end)) in sweeps.levels().enumerate() {
            for &i in &sweeps.order[start..end] {
                level_of[i as usize] = level;
            }
        }
        for (place, &i) in sweeps.order.iter().enumerate() {
            assert!(sweeps.links(place).len() >= 3);
            for link in sweeps.links(place) {
                let (i, j) = (i as usize, link.cell as usize);
                assert_eq!(sweeps.order[link.place as usize], link.cell);
                assert_ne!(level_of[i], level_of[j]);
                assert!(x[i] <= x[j] || level_of[i] > level_of[j]);
            }
        }
        // One for each column, and one more for every other cell of it.
        assert_eq!(sweeps.levels().count(), 8);
    }
}
