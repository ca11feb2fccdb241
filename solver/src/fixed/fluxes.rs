//! What flows through the faces of a block: reconstruct, solve the Riemann problem, add up.

use std::array;

use pulp::{Simd, WithSimd};

use super::gas::Gas;
use super::gradients::Slopes;
use super::hll::Jump;
use super::net::{Block, Face, Net};
use super::real::{Lane, Real};
use super::reconstruction::{Neighbours, rise};
use super::state::{Conserved, Primitive, dot};
use super::walls::push;

/// Most lanes of any processor.
const MAX_LANES: usize = 8;

/// Ratio of pressures across a face below which a shock is strong, and its flux HLL.
const STRONG: f64 = 0.6;

/// Ratio above which there is no shock, and the flux HLLC.
const WEAK: f64 = 0.95;

/// States and slopes of all cells.
#[derive(Clone, Copy, Debug)]
pub struct Flow<'a, const D: usize> {
    /// State of each cell.
    pub states: &'a [Primitive<D>],
    /// Slopes of each cell.
    pub slopes: &'a [Slopes<D>],
}

/// What the cells of a block gain per time.
#[derive(Clone, Debug)]
pub struct Gains<const D: usize> {
    /// Cell by cell.
    pub cells: Vec<Conserved<D>>,
    /// Through walls and sides, all cells.
    pub boundary: Conserved<D>,
}

/// From zero in strong shocks to one elsewhere.
#[inline(always)]
pub fn smoothness<R: Real>(calmness: R) -> R {
    let share = (calmness - STRONG) * (1.0 / (WEAK - STRONG));
    share.max(calmness.like(0.0)).min(calmness.like(1.0))
}

/// Sums up the faces of `block`; pressures on its walls go to `pressures`.
pub struct Exchange<'a, G, const D: usize> {
    /// The gas.
    pub gas: &'a G,
    /// All faces.
    pub net: &'a Net<D>,
    /// Those to sum up.
    pub block: &'a Block<D>,
    /// The flow.
    pub flow: Flow<'a, D>,
    /// Pressure on each wall of the block.
    pub pressures: &'a mut [f64],
}

impl<G: Gas, const D: usize> WithSimd for Exchange<'_, G, D> {
    type Output = Gains<D>;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> Gains<D> {
        let Self {
            gas,
            net,
            block,
            flow,
            pressures,
        } = self;
        let start = block.cells.start;
        let mut cells = vec![Conserved::ZERO; block.cells.len()];
        for faces in block.faces.chunks(S::F64_LANES) {
            let flux = Batch::new(simd, net, faces, flow).flux(gas);
            let flux = stored(&flux);
            for (face, flux) in faces.iter().zip(&flux) {
                for (i, sign) in [(face.i, -1.0), (face.j, 1.0)] {
                    if let Some(cell) = cells.get_mut((i as usize).wrapping_sub(start)) {
                        *cell = cell.plus(sign, flux);
                    }
                }
            }
        }
        let mut boundary = Conserved::ZERO;
        for (wall, pressure) in block.walls.iter().zip(pressures) {
            let i = wall.i as usize;
            let Slopes { along, calmness } = &flow.slopes[i];
            *pressure = wall.pressure(gas, &flow.states[i], along, *calmness);
            let gain = push(&wall.image, *pressure);
            boundary = boundary.plus(1.0, &gain);
            cells[i - start] = cells[i - start].plus(1.0, &gain);
        }
        for side in &block.sides {
            let i = side.i as usize;
            let flux = side.flux(gas, &flow.states[i]);
            boundary = boundary.plus(-side.image.size, &flux);
            cells[i - start] = cells[i - start].plus(-side.image.size, &flux);
        }
        // Rings press outwards on the gas that goes around with them.
        if D > 1 {
            for (cell, i) in cells.iter_mut().zip(block.cells.clone()) {
                cell.momentum[1] += flow.states[i].pressure * net.cell(i).hoop;
            }
        }
        Gains { cells, boundary }
    }
}

/// As many faces as the processor has lanes, with the cells on both sides.
struct Batch<S: Simd, const D: usize> {
    states: [Primitive<D, Lane<S>>; 2],
    slopes: [[Primitive<D, Lane<S>>; D]; 2],
    calmness: Lane<S>,
    area: [Lane<S>; D],
    apart: [Lane<S>; D],
}

impl<S: Simd, const D: usize> Batch<S, D> {
    #[inline(always)]
    fn new(simd: S, net: &Net<D>, faces: &[Face], flow: Flow<'_, D>) -> Self {
        // The lanes beyond the last face do the last one again.
        let face = |l: usize| &faces[l.min(faces.len() - 1)];
        let shapes: [_; MAX_LANES] = array::from_fn(|l| &net.face_shapes[face(l).shape as usize]);
        let numbers: [[usize; MAX_LANES]; 2] = [
            array::from_fn(|l| face(l).i as usize),
            array::from_fn(|l| face(l).j as usize),
        ];
        let states = numbers.map(|side| {
            let states: [_; MAX_LANES] = array::from_fn(|l| &flow.states[side[l]]);
            gather_state(simd, &states)
        });
        let cells = numbers.map(|side| {
            let cells: [_; MAX_LANES] = array::from_fn(|l| &flow.slopes[side[l]]);
            cells
        });
        let slopes = [0, 1].map(|side: usize| {
            array::from_fn(|axis| {
                let slopes: [_; MAX_LANES] = array::from_fn(|l| &cells[side][l].along[axis]);
                gather_state(simd, &slopes)
            })
        });
        let [first, second] = cells.map(|cells| gather(simd, |l| cells[l].calmness));
        Self {
            states,
            slopes,
            calmness: first.min(second),
            area: array::from_fn(|k| gather(simd, |l| shapes[l].area[k])),
            apart: array::from_fn(|k| gather(simd, |l| shapes[l].apart[k])),
        }
    }

    /// Flux through the whole of each face.
    #[inline(always)]
    fn flux<G: Gas>(&self, gas: &G) -> Conserved<D, Lane<S>> {
        let size = dot(&self.area, &self.area).sqrt();
        let share = size.like(1.0) / size;
        let normal = self.area.map(|area| area * share);
        let smooth = smoothness(self.calmness);
        let [left, right] = Neighbours {
            means: self.states,
            rises: [
                rise(&self.slopes[0], &self.apart),
                rise(&self.slopes[1], &self.apart),
            ],
            smooth,
            order: self.calmness,
        }
        .states();
        let jump = Jump::new(gas, left, right, normal);
        let (sharp, blunt) = (jump.hllc(), jump.hll());
        let is_smooth = smooth - (1.0 - f64::EPSILON);
        let mix = |sharp: Lane<S>, blunt: Lane<S>| {
            is_smooth.select(sharp, blunt + smooth * (sharp - blunt)) * size
        };
        Conserved {
            mass: mix(sharp.mass, blunt.mass),
            momentum: array::from_fn(|k| mix(sharp.momentum[k], blunt.momentum[k])),
            energy: mix(sharp.energy, blunt.energy),
        }
    }
}

#[inline(always)]
fn gather<S: Simd>(simd: S, value: impl Fn(usize) -> f64) -> Lane<S> {
    let mut buffer = [0.0; MAX_LANES];
    for (l, slot) in buffer.iter_mut().enumerate().take(S::F64_LANES) {
        *slot = value(l);
    }
    let (vectors, _) = S::as_simd_f64s(&buffer);
    Lane(simd, vectors[0])
}

#[inline(always)]
fn gather_state<S: Simd, const D: usize>(
    simd: S,
    states: &[&Primitive<D>; MAX_LANES],
) -> Primitive<D, Lane<S>> {
    Primitive {
        density: gather(simd, |l| states[l].density),
        velocity: array::from_fn(|k| gather(simd, |l| states[l].velocity[k])),
        pressure: gather(simd, |l| states[l].pressure),
    }
}

/// Lane by lane.
#[inline(always)]
fn stored<S: Simd, const D: usize>(flux: &Conserved<D, Lane<S>>) -> [Conserved<D>; MAX_LANES] {
    let store = |lane: Lane<S>| {
        let mut buffer = [0.0; MAX_LANES];
        let (vectors, _) = S::as_mut_simd_f64s(&mut buffer);
        vectors[0] = lane.1;
        buffer
    };
    let mass = store(flux.mass);
    let momentum = flux.momentum.map(store);
    let energy = store(flux.energy);
    array::from_fn(|l| Conserved {
        mass: mass[l],
        momentum: array::from_fn(|k| momentum[k][l]),
        energy: energy[l],
    })
}
