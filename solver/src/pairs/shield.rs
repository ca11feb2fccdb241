//! The penetration shield.

use aero_geometry::Vector;
use aero_geometry::kernel::QuinticSpline;
use aero_geometry::parallel::prelude::*;

use super::super::neighbours::Lists;
use super::super::particles::{Particle, Rates};
use super::super::records::Near;

/// Sets the transport shift of every particle that heads for a wall nearer than its own spacing:
/// `du_i = -2 (1 - s / s_nom) (n.u_rel) n` with `s` the distance to the nearest ghost,
/// `s_nom = (m_i / rho_i)^(1/D)`, `n` the kernel-weighted normal of the ghosts around and
/// `u_rel` the velocity relative to the wall [Villodi & Ramachandran 2024, eq. 32].
///
/// `wall` gives the wall's normal and velocity at a ghost's slot in the records.
pub fn shield<const D: usize>(
    lists: &Lists,
    near: &[Near<D>],
    particles: &[Particle<D>],
    wall: impl Fn(usize) -> (Vector<D>, Vector<D>) + Sync,
    rates: &mut [Rates<D>],
) {
    let per_run = lists.run_targets();
    lists
        .par_runs()
        .zip(rates.par_chunks_mut(per_run))
        .enumerate()
        .for_each(|(number, (run, rates))| {
            for cluster in run.clusters {
                let ghosts = &run.entries[cluster.wall.clone()];
                for i in cluster.targets.clone() {
                    rates[i - number * per_run].shift =
                        shift(&near[i], &particles[i], near, ghosts, &wall);
                }
            }
        });
}

fn shift<const D: usize>(
    own: &Near<D>,
    particle: &Particle<D>,
    near: &[Near<D>],
    ghosts: &[u32],
    wall: &impl Fn(usize) -> (Vector<D>, Vector<D>),
) -> Vector<D> {
    let mut nearest = f64::INFINITY;
    let mut normal = Vector::zeros();
    let mut wall_velocity = Vector::zeros();
    let mut weight = 0.0;
    for &j in ghosts {
        let other = &near[j as usize];
        let distance = (own.position - other.position).norm();
        let h = own.half_h + other.half_h;
        let w = other.volume * QuinticSpline::<D>::value(distance, h);
        if w > 0.0 {
            let (outward, velocity) = wall(j as usize);
            nearest = nearest.min(distance);
            normal += outward * w;
            wall_velocity += velocity * w;
            weight += w;
        }
    }
    let spacing = own.volume.powf(1.0 / D as f64);
    let length = normal.norm();
    if nearest >= spacing || length <= 0.0 {
        return Vector::zeros();
    }
    let normal = normal / length;
    let approach = normal.dot(&(particle.velocity - wall_velocity / weight));
    if approach < 0.0 {
        normal * (-2.0 * (1.0 - nearest / spacing) * approach)
    } else {
        Vector::zeros()
    }
}
