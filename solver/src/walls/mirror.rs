//! The state that ghosts show the gas: that of the gas nearby, mirrored at the wall.

use aero_geometry::Vector;
use aero_geometry::parallel::prelude::*;

use super::super::backend::Backend;
use super::super::neighbours::GROWTH;
use super::super::pairs::extrapolation::{Consistency, Interpolated, interpolate};
use super::super::records::{Matrix, Records};
use super::{Ghost, WallLists, Walls, gliding, mirror_seeker, seeker, shares, sticking};
use crate::gas::Gas;
use crate::problem::WallKind;
use crate::scheme::{Extrapolation, WallTreatment};

/// Pressures fall by no more powers of e on the way to a ghost, so that none is lost in what numbers cannot hold where gas is faster than sound and a wall bends within a spacing.
const LARGEST_FALL: f64 = 20.0;

impl<const D: usize> Walls<D> {
    /// Gives every ghost the state of the gas nearby, mirrored at the wall [Villodi &
    /// Ramachandran 2024, section 3.4]. A ghost without gas in reach keeps its last state. `added` accelerates the gas at a point of the wall.
    pub fn extrapolate(
        &mut self,
        backend: &impl Backend,
        lists: &WallLists,
        records: &Records<D>,
        added: Option<&(dyn Fn(&Vector<D>) -> Vector<D> + Sync)>,
    ) {
        let ghosts = &self.ghosts;
        self.found.resize(ghosts.len(), None);
        interpolate(
            backend,
            &lists.near,
            |g| seeker(&ghosts[g]),
            records,
            Consistency::Shepard,
            &mut self.found,
        );
        self.mirrored.clear();
        self.mirrored.resize(ghosts.len(), None);
        if self.treatment.extrapolation == Extrapolation::Wm {
            interpolate(
                backend,
                &lists.mirror,
                |g| mirror_seeker(&ghosts[g]),
                records,
                Consistency::FirstOrder,
                &mut self.mirrored,
            );
            // Across a strong shock a linear fit may undershoot to what no gas can be.
            let least = self.gases.of(false).least_pressure();
            for (ghost, mirrored) in self.ghosts.iter().zip(&mut self.mirrored) {
                *mirrored = mirrored.filter(|gas| ghost.has_mirror && gas.pressure > least);
            }
        }
        if self.gases.are_two() {
            shares::read(&lists.near, records, &mut self.ghosts);
        }
        let (bodies, treatment, gases) = (&self.bodies, self.treatment, self.gases);
        self.ghosts
            .par_iter_mut()
            .zip(&self.found)
            .zip(&self.mirrored)
            .for_each(|((ghost, found), mirrored)| {
                let Some(gas) = mirrored.or(*found) else {
                    return;
                };
                let arm = match mirrored {
                    Some(_) => 2.0 * ghost.depth,
                    None => gas.centroid.dot(&ghost.normal),
                };
                let kind = bodies[ghost.body as usize].kind;
                let added = added.map_or(Vector::zeros(), |added| added(&ghost.foot()));
                let law = gases.mixed(ghost.shown.second);
                show(ghost, &gas, arm, kind, treatment, &law, &added);
                if !treatment.constant_volume {
                    ghost.volume = ghost.reference_mass / ghost.shown.density;
                }
            });
        self.mirror_fallbacks = match self.treatment.extrapolation {
            Extrapolation::Wom => 0,
            Extrapolation::Wm => self
                .mirrored
                .iter()
                .zip(&self.found)
                .filter(|(mirrored, found)| found.is_some() && mirrored.is_none())
                .count(),
        };
    }

    /// Lets each ghost's smoothing length follow that of the gas nearby; once per step.
    pub fn update_smoothing_lengths(&mut self) {
        for ((ghost, found), mirrored) in
            self.ghosts.iter_mut().zip(&self.found).zip(&self.mirrored)
        {
            if let Some(gas) = mirrored.or(*found) {
                ghost.shown.smoothing_length = gas
                    .smoothing_length
                    .min(GROWTH * ghost.shown.smoothing_length);
            }
        }
    }
}

/// Mirrors the state of the gas at the wall. `arm` is the distance along the normal from the
/// ghost to where the gas was read; `added` accelerates the gas.
fn show<const D: usize>(
    ghost: &mut Ghost<D>,
    gas: &Interpolated<D>,
    arm: f64,
    kind: WallKind,
    treatment: WallTreatment,
    law: &Gas,
    added: &Vector<D>,
) {
    let wall = ghost.wall.velocity;
    let slide = gas.velocity - wall;
    let across = slide.dot(&ghost.normal);
    let along = slide - ghost.normal * across;
    ghost.shown.velocity = match kind {
        // Eqs 26-28 with the normal into the gas: the normal component relative to the wall turns round.
        WallKind::Slip if treatment.slopes => {
            let mirrored = gliding::across(ghost, gas, across, arm);
            gas.velocity - ghost.normal * (across + mirrored)
        }
        WallKind::Slip => gas.velocity - ghost.normal * (2.0 * across),
        WallKind::NoSlip(_) => sticking::velocity(ghost, gas, arm),
    };
    // Beyond a slip wall the flow is the mirror image; beyond the other kind it goes on.
    ghost.shown.strain = match kind {
        WallKind::Slip => mirrored_strain(ghost, gas, &along),
        WallKind::NoSlip(_) => gas.strain,
    };
    // Eqs 29-30: dp/dn = -rho a.n, so a wall that accelerates into the gas raises the pressure, and so does what drives gas into the
    // wall; gas that slides along a bent wall is accelerated by its bend, and by the turn of a turning one.
    let slide = match kind {
        WallKind::Slip => along,
        WallKind::NoSlip(_) => Vector::zeros(),
    };
    let density = law.density(gas.pressure, gas.energy);
    let slope = density
        * ((ghost.wall.acceleration - added).dot(&ghost.normal) + ghost.wall.coriolis.dot(&slide)
            - slide.dot(&(ghost.wall.curvature * slide)));
    let least = law.least_pressure();
    let risen = |arm: f64| continued(gas.pressure - least, arm * slope) + least;
    ghost.shown.pressure = risen(arm);
    ghost.shown.wall_pressure = risen(arm - ghost.depth);
    ghost.shown.energy = match kind {
        WallKind::Slip => gas.energy,
        WallKind::NoSlip(wall) => sticking::energy(ghost, gas, arm, wall.heat, law),
    };
    // Pressure varies across the layer at the wall, entropy hardly [Dadone & Grossman 1994].
    let keeps_entropy = treatment.keeps_entropy && slope != 0.0 && !kind.conducts();
    let pressed = |pressure: f64| {
        if keeps_entropy {
            law.isentropic_energy(gas.energy, gas.pressure, pressure)
        } else {
            gas.energy
        }
    };
    if keeps_entropy {
        ghost.shown.energy = pressed(ghost.shown.pressure);
    }
    ghost.shown.density = law.density(ghost.shown.pressure, ghost.shown.energy);
    let mut rise = 0.0;
    if treatment.slopes && slope != 0.0 {
        let surface = ghost.shown.wall_pressure;
        let height = sticking::above(ghost, arm - ghost.depth);
        rise = (density - law.density(surface, pressed(surface))) / height;
    }
    // A step that failed is tried again from here.
    let rise = if rise.is_finite() { rise } else { 0.0 };
    ghost.shown.density_gradient = ghost.normal * rise;
}

/// Rate of strain beyond a slip wall past which gas goes at `along`: `M E M - (n (x) S u + S u (x) n)`, `M` the mirror and
/// `S` the wall's shape operator. Gas that follows a bent wall has `n.u = 0` along a normal that turns: the part of `E` across the wall that this makes does not
/// change its sign beyond it, since the velocities that ghosts show follow the bend as well.
fn mirrored_strain<const D: usize>(
    ghost: &Ghost<D>,
    gas: &Interpolated<D>,
    along: &Vector<D>,
) -> Matrix<D> {
    let normal = ghost.normal;
    let mirror = Matrix::identity() - normal * normal.transpose() * 2.0;
    let bend = normal * (ghost.wall.curvature * along).transpose();
    mirror * gas.strain * mirror - (bend + bend.transpose())
}

/// A pressure over the least that rises by `rise` to first order and as an exponential does to second, and stays positive where it falls.
fn continued(pressure: f64, rise: f64) -> f64 {
    let part = rise / pressure;
    if rise == 0.0 {
        pressure
    } else if part < 0.0 {
        pressure * part.max(-LARGEST_FALL).exp()
    } else {
        pressure + rise * (1.0 + 0.5 * part)
    }
}
