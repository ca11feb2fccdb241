//! What lanes read from cells one by one, and give back.

use pulp::Simd;

use super::real::{Lane, MAX_LANES};
use super::state::{Conserved, Primitive};

/// A value of each lane.
#[inline(always)]
pub fn gather<S: Simd>(simd: S, value: impl Fn(usize) -> f64) -> Lane<S> {
    let mut buffer = [0.0; MAX_LANES];
    for (l, slot) in buffer.iter_mut().enumerate().take(S::F64_LANES) {
        *slot = value(l);
    }
    let (vectors, _) = S::as_simd_f64s(&buffer);
    Lane(simd, vectors[0])
}

/// The states of the lanes.
#[inline(always)]
pub fn gather_state<S: Simd, const D: usize>(
    simd: S,
    states: &[&Primitive<D>; MAX_LANES],
    into: &mut Primitive<D, Lane<S>>,
) {
    into.density = gather(simd, |l| states[l].density);
    for k in 0..D {
        into.velocity[k] = gather(simd, |l| states[l].velocity[k]);
    }
    into.pressure = gather(simd, |l| states[l].pressure);
}

#[inline(always)]
fn store<S: Simd>(lane: Lane<S>) -> [f64; MAX_LANES] {
    let mut buffer = [0.0; MAX_LANES];
    let (vectors, _) = S::as_mut_simd_f64s(&mut buffer);
    vectors[0] = lane.1;
    buffer
}

/// Lane by lane.
#[inline(always)]
pub fn stored<S: Simd, const D: usize>(flux: &Conserved<D, Lane<S>>) -> [Conserved<D>; MAX_LANES] {
    let mut all = [Conserved::ZERO; MAX_LANES];
    let (mass, energy) = (store(flux.mass), store(flux.energy));
    for l in 0..MAX_LANES {
        (all[l].mass, all[l].energy) = (mass[l], energy[l]);
    }
    for k in 0..D {
        let momentum = store(flux.momentum[k]);
        for l in 0..MAX_LANES {
            all[l].momentum[k] = momentum[l];
        }
    }
    all
}
