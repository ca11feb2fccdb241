//! The sums over the pairs of a particle that its rates are made of: where all pair laws meet.

use aero_geometry::Vector;

use super::super::lanes::Lane;
use super::super::records::{Matrix, Near, Read, State};
use super::super::vectors::{MAX_LANES, Vectors};
use super::artificial_conduction::{shock_speed, uneven_part};
use super::artificial_viscosity::{
    bare_closing_speed, closing_speed, viscous_pressure, whole_closing_speed,
};
use super::density_diffusion::diffusion;
use super::exchange::exchange_rate;
use super::rates::Sought;
use super::{LaneVector, Pair, Target, dot, dot_add, unlane, zeros};

/// What the sums of particle `i` need of its own state, one per lane.
pub struct Own<V: Vectors, const D: usize> {
    pub target: Target<V, D>,
    pub velocity: LaneVector<V, D>,
    pub half_sound: Lane<V>,
    pub energy: Lane<V>,
    pub half_gradient: LaneVector<V, D>,
    /// Rate of strain, on and above the diagonal.
    pub strain: [LaneVector<V, D>; D],
    pub energy_slope: LaneVector<V, D>,
}

/// Running sums, one per lane.
#[derive(Clone, Copy)]
pub struct Sums<V: Vectors, const D: usize> {
    /// `sum V_j grad W`.
    pub gradient: LaneVector<V, D>,
    /// `sum V_j p_j L_j grad W`.
    pub stress: LaneVector<V, D>,
    /// `sum m_j / rho_ij Pi grad W`.
    pub viscous_force: LaneVector<V, D>,
    /// `sum V_j (u_j - u_i) (x) grad W`.
    pub velocity_gradient: [LaneVector<V, D>; D],
    /// `sum V_j (e_j - e_i) grad W`.
    pub energy_gradient: LaneVector<V, D>,
    /// `sum m_j / rho_ij Pi u_ij . grad W`.
    pub viscous_heat: Lane<V>,
    /// Over [`CONDUCTION`].
    pub conduction: Lane<V>,
    /// Over [`DIFFUSION`].
    pub diffusion: Lane<V>,
    pub exchange: Exchange<V, D>,
}

/// What shifted neighbours give, one per lane.
#[derive(Clone, Copy)]
pub struct Exchange<V: Vectors, const D: usize> {
    /// `sum x_ij rho_ij`.
    pub density: Lane<V>,

    /// `sum x_ij (u_j - u_i)`.
    pub velocity: LaneVector<V, D>,
    /// `sum x_ij [e_j - e_i + (u_j - u_i)^2 / 2]`.
    pub energy: Lane<V>,
}

impl<V: Vectors, const D: usize> Own<V, D> {
    #[inline(always)]
    pub fn load(vectors: V, read: Read<'_, D, V::Number>, slot: impl Fn(usize) -> usize) -> Self {
        let state = |l: usize| &read.state[slot(l)];
        Self {
            target: Target::load(vectors, |l| &read.near[slot(l)]),
            velocity: std::array::from_fn(|k| {
                Lane::gather(vectors, |l| read.near[slot(l)].velocity[k])
            }),
            half_sound: Lane::gather(vectors, |l| state(l).half_sound),
            energy: Lane::gather(vectors, |l| state(l).energy),
            half_gradient: std::array::from_fn(|k| {
                Lane::gather(vectors, |l| state(l).half_gradient[k])
            }),
            strain: std::array::from_fn(|a| {
                std::array::from_fn(|b| Lane::gather(vectors, |l| state(l).strain.get(a, b)))
            }),
            energy_slope: std::array::from_fn(|k| {
                Lane::gather(vectors, |l| state(l).energy_slope[k])
            }),
        }
    }
}

impl<V: Vectors, const D: usize> Sums<V, D> {
    #[inline(always)]
    pub fn new(vectors: V) -> Self {
        Self {
            gradient: zeros(vectors),
            stress: zeros(vectors),
            viscous_force: zeros(vectors),
            velocity_gradient: [zeros(vectors); D],
            energy_gradient: zeros(vectors),
            viscous_heat: Lane::splat(vectors, 0.0),
            conduction: Lane::splat(vectors, 0.0),
            diffusion: Lane::splat(vectors, 0.0),
            exchange: Exchange {
                density: Lane::splat(vectors, 0.0),
                velocity: zeros(vectors),
                energy: Lane::splat(vectors, 0.0),
            },
        }
    }

    /// The same in metres, where the records are in lengths of their own: all sums go by the inverse of a length.
    #[inline(always)]
    pub fn per_length(&self, factor: Lane<V>) -> Self {
        let all = |vector: LaneVector<V, D>| vector.map(|sum| sum * factor);
        Self {
            gradient: all(self.gradient),
            stress: all(self.stress),
            viscous_force: all(self.viscous_force),
            velocity_gradient: self.velocity_gradient.map(all),
            energy_gradient: all(self.energy_gradient),
            viscous_heat: self.viscous_heat * factor,
            conduction: self.conduction * factor,
            diffusion: self.diffusion * factor,
            exchange: Exchange {
                density: self.exchange.density * factor,
                velocity: all(self.exchange.velocity),
                energy: self.exchange.energy * factor,
            },
        }
    }

    /// Adds what `j` gives `i` where both are shifted. The heat `(u_j - u_i)^2 / 2` is half the kinetic energy
    /// that the pair loses.
    #[inline(always)]
    pub fn exchange(
        &mut self,
        vectors: V,
        i: &Own<V, D>,
        own_shift: &LaneVector<V, D>,
        read: Read<'_, D, V::Number>,
        j: usize,
    ) {
        let (near, state) = (&read.near[j], &read.state[j]);
        let pair = Pair::new(vectors, &i.target, near);
        let shift: LaneVector<V, D> =
            std::array::from_fn(|k| own_shift[k] - Lane::splat(vectors, read.shift[j][k]));
        let pairwise = Lane::splat(vectors, near.mass) * pair.inverse_density;
        let rate = exchange_rate(&pair, &shift, pairwise);
        let jump: LaneVector<V, D> =
            std::array::from_fn(|k| Lane::splat(vectors, near.velocity[k]) - i.velocity[k]);
        let energy = Lane::splat(vectors, state.energy) - i.energy;
        let energy = (Lane::splat(vectors, 0.5) * dot(&jump, &jump)) + energy;
        let sums = &mut self.exchange;
        let half_density = Lane::splat(vectors, near.half_density);
        sums.density = rate.mul_add(half_density + i.target.half_density, sums.density);
        sums.energy = rate.mul_add(energy, sums.energy);
        for k in 0..D {
            sums.velocity[k] = rate.mul_add(jump[k], sums.velocity[k]);
        }
    }

    /// Adds the terms of `i` with `j`; `GAS` adds conduction and diffusion, which act within
    /// the gas only (`phi_ij` of Villodi & Ramachandran 2024, below eq. 10).
    #[inline(always)]
    pub fn add<const GAS: bool, const CONSERVATIVE: bool, const SHIFTED: bool>(
        &mut self,
        vectors: V,
        sought: Sought,
        i: &Own<V, D>,
        (near, state): (&Near<D, V::Number>, &State<D, V::Number>),
    ) {
        let pair = Pair::new(vectors, &i.target, near);
        let volume = Lane::splat(vectors, near.volume);
        let reach = pair.h * pair.gradient_factor;
        let mass = Lane::splat(vectors, near.mass);
        let gradient_volume = volume * pair.gradient_factor;
        let pairwise = mass * pair.inverse_density;
        let jump: LaneVector<V, D> =
            std::array::from_fn(|k| Lane::splat(vectors, near.velocity[k]) - i.velocity[k]);
        let approach = -dot(&jump, &pair.separation);
        let sound = i.half_sound + Lane::splat(vectors, state.half_sound);
        let closing = if CONSERVATIVE && sought.limits_viscosity {
            let (mut own, mut other) = (Lane::splat(vectors, 0.0), Lane::splat(vectors, 0.0));
            for b in 0..D {
                let twice = pair.separation[b] + pair.separation[b];
                for a in 0..=b {
                    let factor = if a == b { pair.separation[b] } else { twice };
                    let product = pair.separation[a] * factor;
                    own = i.strain[a][b].mul_add(product, own);
                    other = Lane::splat(vectors, state.strain.get(a, b)).mul_add(product, other);
                }
            }
            closing_speed(vectors, &pair, approach, own, other)
        } else if CONSERVATIVE {
            whole_closing_speed(vectors, &pair, approach)
        } else {
            bare_closing_speed(vectors, &pair, approach)
        };
        let viscous = pairwise * viscous_pressure(vectors, closing, sound) * pair.gradient_factor;
        let energy = Lane::splat(vectors, state.energy) - i.energy;

        self.viscous_heat = viscous.mul_add(approach, self.viscous_heat);
        for a in 0..D {
            let r = pair.separation[a];
            self.gradient[a] = gradient_volume.mul_add(r, self.gradient[a]);
            let row: LaneVector<V, D> =
                std::array::from_fn(|b| Lane::splat(vectors, state.stress.get(a, b)));
            let stress = dot(&row, &pair.separation);
            self.stress[a] = stress.mul_add(pair.gradient_factor, self.stress[a]);
            self.viscous_force[a] = viscous.mul_add(r, self.viscous_force[a]);
            if SHIFTED || (CONSERVATIVE && sought.limits_conduction) {
                self.energy_gradient[a] =
                    (gradient_volume * energy).mul_add(r, self.energy_gradient[a]);
            }
            let weight = gradient_volume * jump[a];
            for b in 0..D {
                self.velocity_gradient[a][b] =
                    weight.mul_add(pair.separation[b], self.velocity_gradient[a][b]);
            }
        }
        if GAS {
            if !CONSERVATIVE {
                self.conduction = (sound * energy * reach).mul_add(volume, self.conduction);
                let slopes: LaneVector<V, D> = std::array::from_fn(|k| {
                    i.half_gradient[k] + Lane::splat(vectors, state.half_gradient[k])
                });
                let rise = Lane::splat(vectors, near.half_density) - i.target.half_density;
                let deviation = dot_add(&slopes, &pair.separation, rise + rise);
                let flow = diffusion(deviation, sound, reach);
                self.diffusion = flow.mul_add(volume, self.diffusion);
                return;
            }
            let uneven = if sought.limits_conduction {
                let slope = |k| Lane::splat(vectors, state.energy_slope[k]);
                let theirs: LaneVector<V, D> = std::array::from_fn(slope);
                let own = -dot(&i.energy_slope, &pair.separation);
                let other = -dot(&theirs, &pair.separation);
                uneven_part(vectors, energy, own, other)
            } else {
                energy
            };
            let exchanged = sound.mul_add(uneven, shock_speed(vectors, closing) * energy);
            self.conduction = (exchanged * reach).mul_add(pairwise, self.conduction);
        }
    }
}

/// The sums that make up the acceleration, as numbers.
pub struct Forces<const D: usize> {
    pub gradient: [[f64; MAX_LANES]; D],
    pub stress: [[f64; MAX_LANES]; D],
    pub viscous: [[f64; MAX_LANES]; D],
}

impl<const D: usize> Forces<D> {
    #[inline(always)]
    pub fn from<V: Vectors>(sums: &Sums<V, D>) -> Self {
        Self {
            gradient: sums.gradient.map(Lane::to_array),
            stress: sums.stress.map(Lane::to_array),
            viscous: sums.viscous_force.map(Lane::to_array),
        }
    }

    /// `-1/rho_i sum V_j (p_i L_i + p_j L_j) grad W + sum m_j / rho_ij Pi grad W` of lane `l`.
    #[inline(always)]
    pub fn acceleration(
        &self,
        l: usize,
        near: &Near<D>,
        pressure: f64,
        renormalisation: &Matrix<D>,
    ) -> Vector<D> {
        self.by_pressure(l, near, pressure, renormalisation) + unlane(&self.viscous, l)
    }

    /// The same without the viscosity.
    #[inline(always)]
    pub fn by_pressure(
        &self,
        l: usize,
        near: &Near<D>,
        pressure: f64,
        renormalisation: &Matrix<D>,
    ) -> Vector<D> {
        let own = renormalisation * unlane(&self.gradient, l) * pressure;
        -(own + unlane(&self.stress, l)) / near.density()
    }
}
