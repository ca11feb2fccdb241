//! The passes over the gas: density, renormalisation, shifts, rates. `gas` and `ghosts` hold all there is, images and the
//! particle itself included.

use aero_geometry::Vector;

use super::laws::{Pair, closing_speed, conduction, crowding, diffusion, sound, viscous_pressure};
use super::{Laws, Matrix, Point, Rate, Transport, kernel};

/// Density that is read off the particles: `[sum m_j W_ij + sum V_g s_g.r_gi W_ig] / (1 - sum V_g W_ig)`, with the slopes of the density at walls, where
/// the ghosts' share is at most 0.7 and their slopes no more than halve or double the sum, over the same sum on a lattice.
pub fn density<const D: usize>(i: &Point<D>, gas: &[Point<D>], ghosts: &[Point<D>]) -> f64 {
    let lattice = kernel::lattice::<D>().0;
    let weight = |j: &Point<D>| {
        let apart = (i.position - j.position).norm();
        kernel::value::<D>(apart, f64::midpoint(i.h, j.h)) / lattice
    };
    // What is of another gas counts as of its own.
    let mass = |j: &Point<D>| j.mass + i.unlike(j) * (i.mass - j.mass);
    let mass: f64 = gas.iter().map(|j| mass(j) * weight(j)).sum();
    let share: f64 = ghosts.iter().map(|j| j.volume * weight(j)).sum();
    let rise = |j: &Point<D>| j.volume * j.density_gradient.dot(&(j.position - i.position));
    let rise: f64 = ghosts.iter().map(|j| rise(j) * weight(j)).sum();
    (mass + rise).clamp(0.5 * mass, 2.0 * mass) / (1.0 - share.min(0.7))
}

/// What the renormalisation pass finds.
pub struct Renormalised<const D: usize> {
    pub matrix: Matrix<D>,
    pub density_gradient: Vector<D>,
    pub concentration_gradient: Vector<D>,
    /// The ghosts' part of it.
    pub wall_gradient: Vector<D>,
}

/// `L_i = [sum V_j (r_j - r_i) (x) grad W]^-1` and the gradients [Villodi & Ramachandran 2024, eqs 7-8].
pub fn renormalise<const D: usize>(
    i: &Point<D>,
    gas: &[Point<D>],
    ghosts: &[Point<D>],
) -> Renormalised<D> {
    let mut moments = Matrix::<D>::zeros();
    let [mut slope, mut crowds, mut crowds_by_walls] = [Vector::<D>::zeros(); 3];
    for (j, is_ghost) in with_kind(gas, ghosts) {
        let pair = Pair::new(i, j);
        moments -= pair.r * pair.gradient.transpose() * j.volume;
        slope += pair.gradient * (j.volume * (j.density - i.density));
        let crowd = pair.gradient * (j.volume * crowding(&pair));
        crowds += crowd;
        if is_ghost {
            crowds_by_walls += crowd;
        }
    }
    let mean = moments.trace() / D as f64;
    let is_regular = mean > 0.4 && determinant(&moments) > 0.1 * mean.powi(D as i32);
    let matrix = if is_regular {
        inverse(&moments)
    } else {
        Matrix::identity()
    };
    let surrounded = if mean > 0.75 { 1.0 } else { 0.0 };
    Renormalised {
        matrix,
        density_gradient: matrix * slope,
        concentration_gradient: crowds * surrounded,
        wall_gradient: crowds_by_walls * surrounded,
    }
}

fn with_kind<'a, const D: usize>(
    gas: &'a [Point<D>],
    ghosts: &'a [Point<D>],
) -> impl Iterator<Item = (&'a Point<D>, bool)> {
    let gas = gas.iter().map(|j| (j, false));
    gas.chain(ghosts.iter().map(|j| (j, true)))
}

fn dynamic<const D: usize>(matrix: &Matrix<D>) -> nalgebra::DMatrix<f64> {
    nalgebra::DMatrix::from_fn(D, D, |a, b| matrix[(a, b)])
}

fn determinant<const D: usize>(matrix: &Matrix<D>) -> f64 {
    dynamic(matrix).determinant()
}

fn inverse<const D: usize>(matrix: &Matrix<D>) -> Matrix<D> {
    let inverse = dynamic(matrix).try_inverse().expect("a regular matrix");
    Matrix::from_fn(|a, b| inverse[(a, b)])
}

/// The drift towards even spacing, `-2 Ma c h grad C` with `Ma = 0.1`, of at most `Ma c / 2`, none into a wall, none in a
/// shock.
pub fn drift<const D: usize>(i: &Point<D>, renormalised: &Renormalised<D>) -> Vector<D> {
    let sound = sound(i);
    let mut drift = renormalised.concentration_gradient * (-0.2 * sound * i.h);
    let wall = renormalised.wall_gradient;
    if wall.norm() * i.h > 0.36 {
        let into = wall.normalize();
        let speed = drift.dot(&into);
        if speed > 0.0 {
            drift -= into * speed;
        }
    }
    if drift.norm() > 0.05 * sound {
        drift = drift.normalize() * (0.05 * sound);
    }
    drift * i.smoothness
}

/// The rates of `i` [Villodi & Ramachandran 2024, eqs 9-14 and 19-21].
pub fn rate<const D: usize>(
    laws: Laws,
    i: &Point<D>,
    gas: &[Point<D>],
    ghosts: &[Point<D>],
) -> Rate<D> {
    let [mut pressure, mut viscosity, mut by_walls] = [Vector::<D>::zeros(); 3];
    let [mut heat, mut conducted, mut diffused] = [0.0; 3];
    let mut velocity_gradient = Matrix::<D>::zeros();
    let mut energy_gradient = Vector::<D>::zeros();
    let mut exchanged = (0.0, Vector::<D>::zeros(), 0.0);
    for (j, is_ghost) in with_kind(gas, ghosts) {
        let pair = Pair::new(i, j);
        if pair.distance == 0.0 || pair.distance >= 3.0 * pair.h {
            continue;
        }
        let corrected = i.renormalisation * pair.gradient;
        let push = (corrected * i.pressure + j.renormalisation * pair.gradient * j.pressure)
            * (-j.volume / i.density);
        let closing = closing_speed(laws, &pair, i, j);
        let viscous = pair.gradient * (j.mass / pair.density * viscous_pressure(laws, &pair, i, j));
        pressure += push;
        viscosity += viscous;
        heat -= viscous.dot(&pair.u) / 2.0;
        velocity_gradient -= pair.u * corrected.transpose() * j.volume;
        energy_gradient += corrected * (j.volume * (j.energy - i.energy) * (1.0 - i.unlike(j)));
        if is_ghost {
            by_walls += push + viscous;
            continue;
        }
        conducted += conduction(laws, &pair, i, j, closing);
        if laws.published {
            diffused += diffusion(&pair, i, j);
        }
        if laws.transport == Transport::Exchange {
            let towards = i.renormalisation * i.shift - j.renormalisation * j.shift;
            let x = j.mass / pair.density * towards.dot(&pair.gradient);
            exchanged.0 += x * pair.density;
            exchanged.1 -= pair.u * x;
            exchanged.2 += x * (j.energy - i.energy + pair.u.norm_squared() / 2.0);
        }
    }
    let divergence = velocity_gradient.trace();
    let heating = -i.pressure / i.density * divergence;
    let mut rate = Rate {
        acceleration: pressure + viscosity + exchanged.1,
        wall_acceleration: by_walls,
        density: -i.density * divergence + diffused + exchanged.0,
        energy: heating + heat + conducted + exchanged.2,
        acceleration_by_pressure: pressure,
        heating_by_pressure: heating,
        velocity_gradient,
        energy_gradient,
        shift: i.shift,
    };
    if laws.transport == Transport::Advection {
        rate.acceleration += velocity_gradient * i.shift;
        rate.energy += energy_gradient.dot(&i.shift);
        if laws.published {
            rate.density += i.density_gradient.dot(&i.shift);
        }
    }
    rate
}

/// How smooth the flow is: `1 - d^2 / (d^2 + |curl u|^2 + (0.05 c / h)^2)` with `d` the rate of compression, to which the growth
/// of rings adds [Ducros et al. 1999; Bhagatwala & Lele 2009].
pub fn smoothness<const D: usize>(i: &Point<D>, rate: &Rate<D>, growth: f64) -> f64 {
    let gradient = &rate.velocity_gradient;
    let compression = (gradient.trace() + growth).min(0.0).powi(2);
    let mut curl = 0.0;
    for a in 0..D {
        for b in 0..a {
            curl += (gradient[(a, b)] - gradient[(b, a)]).powi(2);
        }
    }
    let onset = 0.05 * (i.gamma() * (i.gamma() - 1.0) * i.energy).sqrt() / i.h;
    1.0 - compression / (compression + curl + onset * onset)
}

/// The stable step at Courant number `cfl` [Villodi & Ramachandran 2024, eqs 33-35]: of the extremes of all particles as published,
/// else the least of each particle's own, and of the times in which its density would change and its energy fall by all there
/// is.
pub fn stable_step<const D: usize>(
    laws: Laws,
    cfl: f64,
    gas: &[Point<D>],
    rates: &[Rate<D>],
) -> f64 {
    let sound = |i: &Point<D>| (i.gamma() * (i.gamma() - 1.0) * i.energy).sqrt();
    let both = || gas.iter().zip(rates);
    if laws.published {
        let h = gas.iter().map(|i| i.h).fold(f64::INFINITY, f64::min);
        let fastest = gas.iter().map(sound).fold(0.0, f64::max);
        let strongest = rates.iter().map(|r| r.acceleration.norm());
        let strongest = strongest.fold(0.0, f64::max);
        let tame = cfl * (h / fastest).min(0.5 * (h / strongest).sqrt());
        return laws
            .viscous
            .map_or(tame, |viscous| tame.min(viscous.stable_step(gas)));
    }
    let each = both().map(|(i, rate)| {
        let acoustic = i.h / sound(i);
        let force = 0.5 * (i.h / rate.acceleration.norm()).sqrt();
        let thins = i.density / rate.density.abs();
        let cools = if rate.energy < 0.0 {
            -i.energy / rate.energy
        } else {
            f64::INFINITY
        };
        acoustic.min(force).min(thins).min(cools)
    });
    let tame = cfl * each.fold(f64::INFINITY, f64::min);
    laws.viscous
        .map_or(tame, |viscous| tame.min(viscous.stable_step(gas)))
}

/// The largest smoothing length that `i` may have: its kernel ends within the five layers of ghosts behind a wall, or `room` and
/// five spacings away; 1.5 times that of the lattice it has always, 1000, 4 or 2.5 times at most.
pub fn widest<const D: usize>(i: &Point<D>, ghosts: &[Point<D>], spacing: f64, room: f64) -> f64 {
    let lattice = kernel::RATIO * spacing;
    let distances = ghosts
        .iter()
        .map(|ghost| (i.position - ghost.position).norm());
    let from_wall = distances.fold(f64::INFINITY, f64::min) - spacing / 2.0;
    let fits = (from_wall.min(room) + 5.0 * spacing) / 3.0;
    let anywhere = [1000.0, 4.0, 2.5][D - 1] * lattice;
    fits.max(1.5 * lattice).min(anywhere)
}
