//! Who gets the volume of the thin parts.

use aero_geometry::Vector;
use aero_geometry::parallel::prelude::*;

use crate::cloud::Cloud;
use crate::nearest::Nearest;
use crate::plan::Plan;
use crate::plan::to_rows::Bit;

/// How far, in spacings, a piece of a thin part looks for a particle of its own.
const OWN: f64 = 1.5;

/// And how far for any.
const ANY: f64 = 4.0;

/// Most that a particle takes, of a full one's volume: what a row a spacing and a half thick gives it.
const MOST: f64 = 1.5;

/// A particle that has too much passes pieces on to others at most this far from them, in spacings.
const PASSED: f64 = 2.0;

/// Gives each piece of the thin parts to the nearest particle of a row, those from `first` on, or of the layers where no row is near. What is too much for one
/// is passed on to its neighbours that have room, the pieces nearest to them first: where rows end in a wedge, the last one would have what
/// lies between it and the layers all to itself.
pub(super) fn share_out<const D: usize>(
    plan: &Plan<'_, D>,
    cloud: &mut Cloud<D>,
    first: usize,
    bits: &[Bit<D>],
) {
    let mut shares = Shares::new(plan, cloud, first, bits);
    for n in 0..cloud.len() {
        shares.pass_on(n, cloud);
    }
    for (n, held) in shares.held.into_iter().enumerate() {
        cloud.volume[n] = held;
    }
}

/// Owners of all pieces.
struct Shares<'a, const D: usize> {
    plan: &'a Plan<'a, D>,
    bits: &'a [Bit<D>],
    all: Nearest<D>,
    /// Pieces of each particle.
    owned: Vec<Vec<usize>>,
    /// Volume of each particle.
    held: Vec<f64>,
}

impl<'a, const D: usize> Shares<'a, D> {
    fn new(plan: &'a Plan<'a, D>, cloud: &Cloud<D>, first: usize, bits: &'a [Bit<D>]) -> Self {
        let spacing = plan.options.spacing;
        let thin = Nearest::new(&plan.mirrors, &cloud.position[first..], OWN * spacing);
        let all = Nearest::new(&plan.mirrors, &cloud.position, ANY * spacing);
        let owners: Vec<Option<usize>> = bits
            .par_iter()
            .map(|(place, _)| {
                let own = thin.find(place, OWN * spacing, |_| true);
                let own = own.map(|(n, _)| first + n as usize);
                own.or_else(|| {
                    let any = all.find(place, ANY * spacing, |_| true);
                    any.map(|(n, _)| n as usize)
                })
            })
            .collect();
        let mut owned = vec![Vec::new(); cloud.len()];
        let mut held = cloud.volume.clone();
        for (bit, owner) in owners.into_iter().enumerate() {
            if let Some(n) = owner {
                owned[n].push(bit);
                held[n] += bits[bit].1 / plan.mirrors.share(&cloud.position[n]);
            }
        }
        Self {
            plan,
            bits,
            all,
            owned,
            held,
        }
    }

    /// Passes on what particle `n` has too much.
    fn pass_on(&mut self, n: usize, cloud: &Cloud<D>) {
        let most = MOST * self.plan.particle_volume();
        if self.held[n] <= most {
            return;
        }
        let reach = PASSED * self.plan.options.spacing;
        let share = |m: usize| self.plan.mirrors.share(&cloud.position[m]);
        let room =
            |held: &[f64], m: usize, volume: f64| m != n && held[m] + volume / share(m) <= most;
        let mut offers: Vec<(f64, usize)> = std::mem::take(&mut self.owned[n])
            .into_iter()
            .map(|bit| {
                (
                    self.detour(bit, &cloud.position[n], |m| room(&self.held, m, 0.0)),
                    bit,
                )
            })
            .collect();
        offers.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        for (_, bit) in offers {
            let (place, volume) = self.bits[bit];
            let taker = if self.held[n] > most {
                let found =
                    (self.all).find(&place, reach, |m| room(&self.held, m as usize, volume));
                found.map(|(m, _)| m as usize)
            } else {
                None
            };
            if let Some(m) = taker {
                self.held[n] -= volume / share(n);
                self.held[m] += volume / share(m);
                self.owned[m].push(bit);
            } else {
                self.owned[n].push(bit);
            }
        }
    }

    /// How much farther a piece is from the nearest of the particles that `may` take it than from its owner's place.
    fn detour(&self, bit: usize, own: &Vector<D>, may: impl Fn(usize) -> bool) -> f64 {
        let place = self.bits[bit].0;
        let reach = PASSED * self.plan.options.spacing;
        let found = self.all.find(&place, reach, |m| may(m as usize));
        found.map_or(f64::INFINITY, |(_, way)| way - (place - own).norm())
    }
}
