//! Renormalisation and gradients of where the neighbours are: which laws a scheme asks for.

use super::concentration::Concentration;
use super::density_slope::DensitySlope;
use super::renormalisation::{Moments, Neighbourhoods, Renormalisation};
use crate::backend::Backend;
use crate::neighbours::Lists;
use crate::records::Records;
use crate::scheme::{Density, Scheme};

/// Renormalises every listed particle, and sums the gradients that `scheme` asks for.
pub fn renormalise<const D: usize>(
    backend: &impl Backend,
    lists: &Lists,
    records: &Records<D>,
    scheme: &Scheme,
    results: &mut [Renormalisation<D>],
) {
    let neighbourhoods = Neighbourhoods::default();
    let laws = (
        Moments,
        (
            DensitySlope {
                is_sought: scheme.density == Density::Continuity,
            },
            Concentration {
                is_sought: scheme.transport_velocity.asks_for_concentration(),
            },
        ),
    );
    backend.sweep(lists, records, &neighbourhoods, &laws, results);
}
