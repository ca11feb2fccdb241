//! Return of shifts by advection terms.

use super::encounter::{Encounter, Encounters, Own, Site};
use super::law::{Law, Neighbour};
use crate::particles::Rates;
use crate::records::Read;
use crate::vectors::Vectors;

/// What particles see pass by as they are shifted relative to the gas, `du.grad u`, `du.grad e` and `du.grad rho` [Villodi &
/// Ramachandran 2024, eqs 19-21].
#[derive(Clone, Copy, Debug)]
pub struct Advection {
    /// False where nothing is shifted, or the return is by exchange.
    pub acts: bool,
}

impl<const D: usize> Law<Encounters<'_, D>, D> for Advection {
    type Own<V: Vectors> = ();
    type Sums<V: Vectors> = ();
    type Number = ();

    #[inline(always)]
    fn load<V: Vectors>(
        &self,
        _: V,
        _: Read<'_, D, V::Number>,
        _: impl Fn(usize) -> usize + Copy,
    ) -> Self::Own<V> {
    }

    #[inline(always)]
    fn add<V: Vectors>(
        &self,
        _: (&Own<V, D>, &Self::Own<V>),
        _: &mut Encounter<V, D>,
        _: Neighbour<'_, V, D>,
        (): &mut Self::Sums<V>,
    ) {
    }

    #[inline(always)]
    fn finish(
        &self,
        (): Self::Number,
        (): Self::Number,
        site: &mut Site<'_, D>,
        rates: &mut Rates<D>,
    ) {
        if self.acts {
            let shift = site.renormalisation.matrix * rates.shift;
            site.carried += site.slope * shift;
            rates.energy += site.energy_slope.dot(&shift);
            rates.density += site.renormalisation.density_gradient.dot(&rates.shift);
        }
    }
}
