//! The undisturbed free stream: gas that needs no pair sums, because they would be zero.
//!
//! A particle is *calm* while its state is that of the free stream, and its rates are zero, to a
//! tolerance. Those in cells that see nothing but calm particles are moved on as they are; whatever disturbs
//! a neighbour's neighbour wakes them, two reaches ahead of it. What is left out is below the tolerance, and so is
//! what it could have become: no sound is lost that a sum of zeros would have carried.

use aero_geometry::Vector;
use aero_geometry::kernel::{SMOOTHING_RATIO, SUPPORT};

use crate::neighbours::GROWTH;
use crate::particles::{Particle, Rates};
use crate::problem::{Problem, Side};
use crate::records::Near;
use crate::scheme::Precision;

/// What counts as nothing: differences of density, energy and smoothing length over their values, of velocity
/// over the speed of sound, and what the rates make of these in the time that sound takes for a
/// smoothing length.
const TOLERANCE: f64 = 1e-9;

/// The same in mixed precision, some ten times what rounding leaves of a lattice's sums.
const MIXED_TOLERANCE: f64 = 1e-5;

/// Edge of a cell of the map, in spacings: about a cluster of particles.
const CELL: f64 = 2.0;

/// Cells around the domain, for images, ghosts and buffers that are seen from within.
const MARGIN: f64 = 3.0;

/// Map of what is calm.
#[derive(Clone, Debug)]
pub struct Calm<const D: usize> {
    tolerance: f64,
    density: f64,
    velocity: Vector<D>,
    energy: f64,
    sound: f64,
    h: f64,
    origin: Vector<D>,
    cell: f64,
    cells: [usize; D],
    /// How far something in the cell that is not calm is seen; zero where all is calm.
    seen: Vec<f64>,
    disturbed: Vec<bool>,
}

impl<const D: usize> Calm<D> {
    /// The free stream of `problem`; none where it has no side that keeps one up, is to be summed in full, or where a source disturbs it.
    pub fn new(problem: &Problem<D>) -> Option<Self> {
        let domain = &problem.domain;
        let has_stream = domain.has(Side::keeps_free_stream);
        let has_other_gas = domain.has(|side| side.lets_in() && !side.keeps_free_stream());
        let is_disturbed = has_other_gas || problem.source.is_some();
        if !problem.skips_undisturbed() || !has_stream || is_disturbed {
            return None;
        }
        let gas = &problem.free_stream;
        let cell = CELL * problem.resolution.lattice();
        let bounds = &problem.domain.bounds;
        Some(Self {
            tolerance: match problem.scheme.precision {
                Precision::Double => TOLERANCE,
                Precision::Mixed => MIXED_TOLERANCE,
            },
            density: gas.density,
            velocity: gas.velocity,
            energy: problem.gas.energy(gas.density, gas.pressure),
            sound: problem.gas.sound_speed_at(gas.density, gas.pressure),
            h: SMOOTHING_RATIO * problem.resolution.lattice(),
            origin: bounds.min.add_scalar(-MARGIN * cell),
            cell,
            cells: std::array::from_fn(|k| {
                (bounds.size()[k] / cell + 2.0 * MARGIN).ceil().max(1.0) as usize
            }),
            seen: Vec::new(),
            disturbed: Vec::new(),
        })
    }

    /// True of a particle whose state and `rates` are those of the free stream.
    pub fn holds(&self, particle: &Particle<D>, rates: &Rates<D>) -> bool {
        let speed = self.tolerance * self.sound;
        let time = self.h / self.sound;
        let acceleration = rates.acceleration + rates.wall_acceleration;
        let is_near = |value: f64, expected: f64, rate: f64| {
            let least = self.tolerance * expected;
            (value - expected).abs() < least && rate.abs() * time < least
        };
        is_near(particle.density, self.density, rates.density)
            && is_near(particle.energy, self.energy, rates.energy)
            && is_near(particle.smoothing_length, self.h, 0.0)
            && (particle.velocity - self.velocity).norm_squared() < speed * speed
            && acceleration.norm_squared() * time * time < speed * speed
            && rates.shift.norm_squared() < speed * speed
            && rates.velocity_gradient.norm_squared() * self.h * self.h < speed * speed
    }

    /// Draws the map for a step whose half is `half_step` long: `near` are all records, `is_calm` tells of
    /// each.
    pub fn draw(&mut self, near: &[Near<D>], is_calm: impl Fn(usize) -> bool, half_step: f64) {
        let count = self.cells.iter().product();
        self.seen.clear();
        self.seen.resize(count, 0.0);
        self.disturbed.clear();
        self.disturbed.resize(count, false);
        for (slot, near) in near.iter().enumerate() {
            if is_calm(slot) {
                continue;
            }
            // A step asks for neighbours twice: what changes a particle's density, or its first rates, changes the forces on
            // all that see it.
            let reach = GROWTH * SUPPORT * (near.half_h + 1.5 * self.h)
                + half_step * (near.velocity - self.velocity).norm();
            let number = self.number(&self.place(&near.position));
            self.seen[number] = self.seen[number].max(reach);
        }
        for number in 0..count {
            if self.seen[number] > 0.0 {
                let place = self.cell_of(number);
                let rings = (self.seen[number] / self.cell).ceil() as usize;
                let from = place.map(|at| at.saturating_sub(rings));
                let to = std::array::from_fn(|k| (place[k] + rings).min(self.cells[k] - 1));
                self.disturb(from, to);
            }
        }
    }

    /// True where nothing in the cell around `position` sees anything but calm particles. Each particle is asked for by itself:
    /// whom it shares a cluster with, which depends on the processor's vectors, decides nothing.
    pub fn covers(&self, position: &Vector<D>) -> bool {
        !self.disturbed[self.number(&self.place(position))]
    }

    /// Marks the box of cells `from..=to` as disturbed, row by row.
    fn disturb(&mut self, from: [usize; D], to: [usize; D]) {
        let across = to[D - 1] - from[D - 1];
        let mut cell = from;
        loop {
            let start = self.number(&cell);
            self.disturbed[start..=start + across].fill(true);
            if !next_row(&mut cell, &from, &to) {
                return;
            }
        }
    }

    /// The cell around `position`, or the nearest one.
    fn place(&self, position: &Vector<D>) -> [usize; D] {
        std::array::from_fn(|k| {
            let at = ((position[k] - self.origin[k]) / self.cell).max(0.0);
            (at as usize).min(self.cells[k] - 1)
        })
    }

    fn number(&self, cell: &[usize; D]) -> usize {
        (0..D).fold(0, |number, k| number * self.cells[k] + cell[k])
    }

    fn cell_of(&self, mut number: usize) -> [usize; D] {
        let mut cell = [0; D];
        for k in (0..D).rev() {
            cell[k] = number % self.cells[k];
            number /= self.cells[k];
        }
        cell
    }
}

/// Goes on to the next row of cells, along the last axis, of the box `from..=to`; false after the last.
fn next_row<const D: usize>(cell: &mut [usize; D], from: &[usize; D], to: &[usize; D]) -> bool {
    for k in (0..D - 1).rev() {
        if cell[k] < to[k] {
            cell[k] += 1;
            return true;
        }
        cell[k] = from[k];
    }
    false
}
