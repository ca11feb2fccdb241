//! Particles that meet and act on each other: what all laws of motion, heat and density share.

use aero_geometry::Vector;

use super::law::Basis;
use super::pair::{LaneVector, Pair, Target, dot};
use super::renormalisation::{Renormalisation, even_renormalisation};
use super::unlike::{share, unlike};
use crate::each::each;
use crate::lanes::Lane;
use crate::particles::Rates;
use crate::records::{GHOSTS, Matrix, Near, Read, Records, State};
use crate::vectors::Vectors;

/// What a pass over encounters reads.
pub struct Encounters<'a, const D: usize> {
    records: &'a Records<D>,
    /// Of the fluid.
    renormalisations: &'a [Renormalisation<D>],
    /// That of ghosts.
    even: Renormalisation<D>,
    first: usize,
}

impl<'a, const D: usize> Encounters<'a, D> {
    /// Those of the fluid with gas and ghosts.
    pub fn of_fluid(records: &'a Records<D>, renormalisations: &'a [Renormalisation<D>]) -> Self {
        Self {
            records,
            renormalisations,
            even: Renormalisation::default(),
            first: 0,
        }
    }

    /// Those of the ghosts with the gas.
    pub fn of_ghosts(records: &'a Records<D>) -> Self {
        let matrix = even_renormalisation();
        Self {
            records,
            renormalisations: &[],
            even: Renormalisation {
                matrix,
                ..Renormalisation::default()
            },
            first: records.start[GHOSTS],
        }
    }
}

/// State of the particles `i`, one per lane.
#[derive(Clone, Copy)]
pub struct Own<V: Vectors, const D: usize> {
    /// Geometry.
    pub target: Target<V, D>,
    velocity: LaneVector<V, D>,
    half_sound: Lane<V>,
    energy: Lane<V>,
    /// Share of the second gas.
    second: Lane<V>,
}

/// A pair that meets.
#[derive(Clone, Copy)]
pub struct Encounter<V: Vectors, const D: usize> {
    /// Its geometry.
    pub pair: Pair<V, D>,
    /// `V_j`.
    pub volume: Lane<V>,
    /// `V_j F`.
    pub gradient_volume: Lane<V>,
    /// `m_j / rho_ij`.
    pub pairwise: Lane<V>,
    /// `h_ij F`.
    pub reach: Lane<V>,
    /// `u_j - u_i`.
    pub jump: LaneVector<V, D>,
    /// `u_ij . r_ij`.
    pub approach: Lane<V>,
    /// `c_ij`, the mean speed of sound.
    pub sound: Lane<V>,
    /// `e_j - e_i`; none of it between two gases.
    pub energy: Lane<V>,
    /// Minus the speed at which the pair closes: left by the viscosity.
    pub closing: Lane<V>,
}

/// A particle whose sums are complete.
pub struct Site<'a, const D: usize> {
    /// Its geometry.
    pub near: &'a Near<D>,
    /// Its state.
    pub state: &'a State<D>,
    /// Its renormalisation.
    pub renormalisation: &'a Renormalisation<D>,
    /// `sum V_j (u_j - u_i) (x) grad W`, not renormalised: left by the velocity gradient.
    pub slope: Matrix<D>,
    /// Divergence of the velocity: left by the velocity gradient.
    pub divergence: f64,
    /// `sum V_j (e_j - e_i) grad W`: left by the energy gradient.
    pub energy_slope: Vector<D>,
    /// Acceleration by gas and walls.
    pub acceleration: Vector<D>,
    /// Acceleration by the return of shifts, of which walls have no part.
    pub carried: Vector<D>,
}

impl<const D: usize> Basis<D> for Encounters<'_, D> {
    type Own<V: Vectors> = Own<V, D>;
    type Pair<V: Vectors> = Encounter<V, D>;
    type Site<'a>
        = Site<'a, D>
    where
        Self: 'a;
    type Result = Rates<D>;

    fn first(&self) -> usize {
        self.first
    }

    #[inline(always)]
    fn load<V: Vectors>(
        &self,
        vectors: V,
        read: Read<'_, D, V::Number>,
        slot: impl Fn(usize) -> usize,
    ) -> Own<V, D> {
        let (near, state) = (
            |l: usize| &read.near[slot(l)],
            |l: usize| &read.state[slot(l)],
        );
        Own {
            target: Target::load(vectors, read, &slot),
            velocity: each(|k| Lane::gather(vectors, |l| near(l).velocity[k])),
            half_sound: Lane::gather(vectors, |l| state(l).half_sound),
            energy: Lane::gather(vectors, |l| state(l).energy),
            second: share(vectors, &self.records.second, &slot),
        }
    }

    #[inline(always)]
    fn meet<V: Vectors>(
        &self,
        vectors: V,
        i: &Own<V, D>,
        read: Read<'_, D, V::Number>,
        j: usize,
    ) -> Encounter<V, D> {
        let (near, state) = (&read.near[j], &read.state[j]);
        let pair = Pair::new(vectors, &i.target, near);
        let volume = Lane::broadcast(vectors, near.volume);
        let jump: LaneVector<V, D> =
            each(|k| Lane::broadcast(vectors, near.velocity[k]) - i.velocity[k]);
        let mut energy = Lane::broadcast(vectors, state.energy) - i.energy;
        if let Some(&second) = self.records.second.get(j) {
            energy = energy - energy * unlike(vectors, i.second, second);
        }
        Encounter {
            volume,
            gradient_volume: volume * pair.gradient_factor,
            pairwise: Lane::broadcast(vectors, near.mass) * pair.inverse_density,
            reach: pair.h * pair.gradient_factor,
            approach: -dot(&jump, &pair.separation),
            jump,
            sound: i.half_sound + Lane::broadcast(vectors, state.half_sound),
            energy,
            closing: Lane::splat(vectors, 0.0),
            pair,
        }
    }

    fn rest(&self, _: usize, rates: &mut Rates<D>) {
        *rates = Rates::default();
    }

    /// The shift in `rates` is read and kept; all else is overwritten.
    #[inline(always)]
    fn open(&self, slot: usize, rates: &mut Rates<D>) -> Site<'_, D> {
        // Field by field: a whole written first and then copied waits for its own bytes.
        let Rates {
            acceleration,
            wall_acceleration,
            density,
            energy,
            by_pressure,
            velocity_gradient,
            energy_gradient,
            shift: _,
        } = rates;
        for vector in [
            acceleration,
            wall_acceleration,
            &mut by_pressure.acceleration,
            energy_gradient,
        ] {
            vector.fill(0.0);
        }
        for number in [density, energy, &mut by_pressure.heating] {
            *number = 0.0;
        }
        velocity_gradient.fill(0.0);
        Site {
            near: &self.records.near[slot],
            state: &self.records.state[slot],
            renormalisation: self.renormalisations.get(slot).unwrap_or(&self.even),
            slope: Matrix::zeros(),
            divergence: 0.0,
            energy_slope: Vector::zeros(),
            acceleration: Vector::zeros(),
            carried: Vector::zeros(),
        }
    }

    #[inline(always)]
    fn close(&self, site: Site<'_, D>, rates: &mut Rates<D>) {
        rates.wall_acceleration = site.acceleration - rates.acceleration;
        rates.acceleration += site.carried;
    }
}
