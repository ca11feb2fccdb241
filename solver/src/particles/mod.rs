//! The particles of the gas from birth to death: every column that belongs to a particle is kept here, and [`Particles::add`],
//! [`Particles::remove`] and [`Particles::permute`] are the only ways in, out and about. What a particle *is*, and what is kept of
//! it in a checkpoint, is [`Particle`]; what an evaluation makes of it are [`Rates`] and the rest of [`Columns`].

use std::ops::{Deref, DerefMut};

use aero_geometry::parallel::prelude::*;

mod particle;
mod rooms;
mod start;

pub use particle::{ByPressure, Particle, Rates, Spared};
pub use start::start;

use super::pairs::renormalisation::Renormalisation;

/// Gas that moves by the equations; as a slice, its states.
#[derive(Clone, Debug, Default)]
pub struct Particles<const D: usize> {
    /// What a checkpoint keeps.
    state: Vec<Particle<D>>,
    /// State at the start of the step; between two steps, room for a new order.
    saved: Vec<Particle<D>>,
    /// Rates at the last evaluation.
    rates: Vec<Rates<D>>,
    /// Renormalisations at the last evaluation.
    renormalisations: Vec<Renormalisation<D>>,
    /// Densities by the last summation.
    densities: Vec<f64>,
    /// False once particles have changed places, until the next evaluation.
    is_evaluated: bool,
}

/// All columns at once, of equal lengths but for `saved`, which has a meaning within a step only.
#[derive(Debug)]
pub struct Columns<'a, const D: usize> {
    /// States.
    pub state: &'a mut [Particle<D>],
    /// States at the start of the step.
    pub saved: &'a [Particle<D>],
    /// Rates at the last evaluation.
    pub rates: &'a mut [Rates<D>],
    /// Renormalisations at the last evaluation.
    pub renormalisations: &'a mut [Renormalisation<D>],
    /// Densities by the last summation.
    pub densities: &'a mut [f64],
}

impl<const D: usize> Particles<D> {
    /// Particles of these states, not yet evaluated.
    pub fn new(state: Vec<Particle<D>>) -> Self {
        let mut particles = Self {
            state,
            ..Self::default()
        };
        particles.make_room();
        particles
    }

    /// Adds a particle at the end; its rates are zero until the next evaluation.
    pub fn add(&mut self, particle: Particle<D>) {
        self.state.push(particle);
        self.make_room();
    }

    /// Removes the particles at these places, which ascend. The last particles take the places.
    pub fn remove(&mut self, places: impl DoubleEndedIterator<Item = usize>) {
        // From the end, so that the last particle is never one that goes.
        for place in places.rev() {
            self.state.swap_remove(place);
            self.rates.swap_remove(place);
            self.renormalisations.swap_remove(place);
            self.densities.swap_remove(place);
        }
    }

    /// Brings the particles into a new order: the one at place `order[n]` goes to `n`. Only states move on; what an evaluation
    /// made is made anew before anyone asks for it.
    pub fn permute(&mut self, order: &[u32]) {
        let state = &self.state;
        let moved = order.par_iter().map(|&n| state[n as usize]);
        // Between two steps nothing is saved: that room takes the new order, and no third one is needed.
        moved.collect_into_vec(&mut self.saved);
        std::mem::swap(&mut self.state, &mut self.saved);
        self.is_evaluated = false;
    }

    /// Keeps the states of now as those at the start of the step. The states are to be written anew from these: they are
    /// those of some step before.
    pub fn save(&mut self) {
        std::mem::swap(&mut self.state, &mut self.saved);
        self.state.truncate(self.saved.len());
        let missing = &self.saved[self.state.len()..];
        self.state.extend_from_slice(missing);
    }

    /// Goes back to the states at the start of the step.
    pub fn restore(&mut self) {
        self.state.clone_from(&self.saved);
    }

    /// The columns, to write one from others.
    pub fn columns(&mut self) -> Columns<'_, D> {
        Columns {
            state: &mut self.state,
            saved: &self.saved,
            rates: &mut self.rates,
            renormalisations: &mut self.renormalisations,
            densities: &mut self.densities,
        }
    }

    /// Takes note that the columns hold an evaluation of the states of now.
    pub fn mark_evaluated(&mut self) {
        self.is_evaluated = true;
    }

    /// Rates at the last evaluation.
    pub fn rates(&self) -> &[Rates<D>] {
        debug_assert!(self.is_evaluated, "rates of particles in another order");
        &self.rates
    }

    /// Renormalisations at the last evaluation.
    pub fn renormalisations(&self) -> &[Renormalisation<D>] {
        debug_assert!(self.is_evaluated, "matrices of particles in another order");
        &self.renormalisations
    }

    /// Lets all columns hold as many values as there are particles.
    fn make_room(&mut self) {
        let count = self.state.len();
        self.rates.resize(count, Rates::default());
        self.renormalisations
            .resize(count, Renormalisation::default());
        self.densities.resize(count, 0.0);
    }
}

impl<const D: usize> Deref for Particles<D> {
    type Target = [Particle<D>];

    fn deref(&self) -> &[Particle<D>] {
        &self.state
    }
}

impl<const D: usize> DerefMut for Particles<D> {
    fn deref_mut(&mut self) -> &mut [Particle<D>] {
        &mut self.state
    }
}

impl<'a, const D: usize> IntoIterator for &'a Particles<D> {
    type Item = &'a Particle<D>;
    type IntoIter = std::slice::Iter<'a, Particle<D>>;

    fn into_iter(self) -> Self::IntoIter {
        self.state.iter()
    }
}

impl<'a, const D: usize> IntoIterator for &'a mut Particles<D> {
    type Item = &'a mut Particle<D>;
    type IntoIter = std::slice::IterMut<'a, Particle<D>>;

    fn into_iter(self) -> Self::IntoIter {
        self.state.iter_mut()
    }
}
