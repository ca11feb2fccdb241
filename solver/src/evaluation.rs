//! From where the particles are to their rates: reads the density off them, lets ghosts take the state of the gas, sums.
//! Moves none.

use aero_geometry::kernel::SMOOTHING_RATIO;
use rayon::prelude::*;

use super::Simulation;
use super::neighbours::GROWTH;
use super::pairs::rates::{Sought, Transport, rates};
use super::pairs::renormalisation::{Gradients, Renormalisation, renormalise};
use super::pairs::shield::shield;
use super::pairs::summation::densities;
use super::records::{FLOW_IMAGES, FLUID, GHOSTS, Records};
use super::shock_sensor::find_shocks;
use crate::problem::Equations;

impl<const D: usize> Simulation<D> {
    /// Replaces each density by the sum over the particles, and the smoothing length with it
    /// (`h = 1.5 (m / rho)^(1/D)`), so that neither can drift from the particles' spacing.
    ///
    /// In rarefied gas the smoothing length stops growing where [`Self::widest`] says.
    pub(super) fn read_densities(&mut self) {
        let widest = self.widest();
        self.round_near();
        self.densities.resize(self.fluid.len(), 0.0);
        densities(
            self.arch,
            &self.lists,
            &self.records,
            self.lattice_sum,
            &mut self.densities,
        );
        let rings = self.rings;
        self.fluid
            .par_iter_mut()
            .zip(&self.densities)
            .zip(widest)
            .for_each(|((particle, &density), widest)| {
                particle.density = density;
                let mass = rings.spanned_mass(particle);
                let h = SMOOTHING_RATIO * edge::<D>(mass / density);
                particle.smoothing_length = h.min(GROWTH * particle.smoothing_length).min(widest);
            });
    }

    /// Reads the density off the particles where they and the walls are `ahead` of the start of the step.
    pub(super) fn sum_densities(&mut self, ahead: f64) {
        self.fill_near(ahead);
        self.move_walls(ahead);
        self.fill_ghosts();
        self.read_densities();
    }

    /// Moves the walls to where they are `ahead` of the start of the step.
    fn move_walls(&mut self, ahead: f64) {
        if self.walls.are_moving() {
            self.walls.move_to(self.time + ahead);
        }
    }

    /// Rates of the fluid `ahead` of the start of the step.
    pub(super) fn evaluate(&mut self, ahead: f64) {
        self.fill_gas(ahead);
        self.move_walls(ahead);
        self.walls
            .extrapolate(self.arch, &self.wall_lists, &self.records);
        self.fill_ghosts();
        self.renormalise();
        if self.problem.scheme.shield {
            self.shield();
        }
        if self.problem.scheme.shifting {
            self.shift();
        }
        self.sum_rates();
        find_shocks(&self.problem, self.rings, &self.rates, &mut self.fluid);
        self.rings
            .stretch(&self.fluid, &self.problem.gas, &mut self.rates);
    }

    /// Sums the rates of the fluid.
    pub(super) fn sum_rates(&mut self) {
        rates(
            self.arch,
            &self.lists,
            &self.records,
            &self.renormalisations,
            self.sought(),
            &mut self.rates,
        );
    }

    /// The sums that the scheme asks for.
    pub(super) fn sought(&self) -> Sought {
        let scheme = &self.problem.scheme;
        Sought {
            equations: scheme.equations,
            transport: match (scheme.equations, scheme.shifting, scheme.shield) {
                (_, false, false) => Transport::None,
                (Equations::Conservative, true, _) => Transport::Exchange,
                _ => Transport::Advection,
            },
            limits_viscosity: scheme.limited_viscosity,
            limits_conduction: scheme.limited_conduction,
        }
    }

    /// Renormalisation of the fluid; buffers keep theirs, and ghosts have that of a lattice.
    pub(super) fn renormalise(&mut self) {
        self.renormalisations
            .resize(self.fluid.len(), Renormalisation::default());
        self.round_near();
        renormalise(
            self.arch,
            &self.lists,
            &self.records,
            Gradients {
                of_density: self.problem.scheme.equations == Equations::Paper,
                of_concentration: self.problem.scheme.shifting,
            },
            &mut self.renormalisations,
        );
        let Records { near, state, .. } = &mut self.records;
        state
            .par_iter_mut()
            .zip(near.par_iter())
            .zip(&self.renormalisations)
            .for_each(|((state, near), r)| {
                state.renormalise(&r.matrix, &r.density_gradient, near.volume);
            });
        self.flow_images
            .refresh(&mut self.records, FLUID, FLOW_IMAGES);
        if self.arch.is_mixed() {
            let Records { state, rounded, .. } = &mut self.records;
            rounded.round_state(state);
        }
    }

    /// Rounds the geometry where pairs are computed in `f32`.
    fn round_near(&mut self) {
        if self.arch.is_mixed() {
            let Records { near, rounded, .. } = &mut self.records;
            rounded.round_near(near);
        }
    }

    pub(super) fn shield(&mut self) {
        let first = self.records.start[GHOSTS];
        let (ghosts, images) = (&self.walls.ghosts, &self.ghost_images);
        let wall = |slot: usize| {
            let (ghost, sign) = images.seen(ghosts, slot - first);
            (
                sign.component_mul(&ghost.normal),
                sign.component_mul(&ghost.wall_velocity),
            )
        };
        shield(
            &self.lists,
            &self.records.near,
            &self.fluid,
            wall,
            &mut self.rates,
        );
    }
}

/// Edge of a cube of this `D`-dimensional volume.
fn edge<const D: usize>(volume: f64) -> f64 {
    match D {
        1 => volume,
        2 => volume.sqrt(),
        _ => volume.cbrt(),
    }
}
