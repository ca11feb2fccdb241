//! Rates of density, velocity and energy of all particles: which laws a scheme asks for.

use super::advection::Advection;
use super::artificial_conduction::ArtificialConduction;
use super::artificial_viscosity::ArtificialViscosity;
use super::averaged_pressure::AveragedPressure;
use super::density_diffusion::DensityDiffusion;
use super::encounter::Encounters;
use super::energy_gradient::EnergyGradient;
use super::exchange::Exchange;
use super::pressure_damping::PressureDamping;
use super::pressure_force::PressureForce;
use super::pressure_slope::PressureSlope;
use super::renormalisation::Renormalisation;
use super::velocity_gradient::VelocityGradient;
use crate::backend::Backend;
use crate::neighbours::Lists;
use crate::particles::Rates;
use crate::records::Records;
use crate::scheme::{Conduction, Density, PressureGradient, ReturnOfShift, Scheme};

/// Rates of every listed particle of the fluid [Villodi & Ramachandran 2024, eqs 10, 12, 14; signs as
/// derived from the continuum equations].
///
/// The shifts in `rates` are read and kept; all else is overwritten.
pub fn rates<const D: usize>(
    backend: &impl Backend,
    lists: &Lists,
    records: &Records<D>,
    renormalisations: &[Renormalisation<D>],
    scheme: &Scheme,
    rates: &mut [Rates<D>],
) {
    if scheme.is_of_liquids() {
        return rates_of_liquids(backend, lists, records, renormalisations, scheme, rates);
    }
    let is_exchanged = scheme.transport_velocity.shifting
        && scheme.transport_velocity.return_of_shift == ReturnOfShift::Exchange;
    let is_advected =
        (scheme.transport_velocity.shifting || scheme.transport_velocity.shield) && !is_exchanged;
    let gradients = (
        VelocityGradient,
        EnergyGradient {
            is_sought: is_advected
                || records.is_viscous
                || scheme.conduction == Conduction::Limited,
        },
    );
    // The conduction goes by what the viscosity finds.
    let dissipation = (
        ArtificialViscosity::of(scheme),
        ArtificialConduction(scheme.conduction),
    );
    let flow = (gradients, (dissipation, PressureForce));
    let carried = Advection { acts: is_advected };
    let met = Encounters::of_fluid(records, renormalisations);
    // Laws that few schemes ask for are left out where they are not; what is written out here is compiled, one pass each.
    match (scheme.density, is_exchanged) {
        (Density::Continuity, false) => {
            let laws = (flow, (DensityDiffusion, carried));
            backend.sweep(lists, records, &met, &laws, rates);
        }
        (Density::Continuity, true) => {
            let laws = (flow, (DensityDiffusion, Exchange));
            backend.sweep(lists, records, &met, &laws, rates);
        }
        (Density::Summation, false) => {
            backend.sweep(lists, records, &met, &(flow, carried), rates);
        }
        (Density::Summation, true) => {
            backend.sweep(lists, records, &met, &(flow, Exchange), rates);
        }
    }
}

/// The same where volumes are summed, and density or pressure of a liquid is evolved without heat.
fn rates_of_liquids<const D: usize>(
    backend: &impl Backend,
    lists: &Lists,
    records: &Records<D>,
    renormalisations: &[Renormalisation<D>],
    scheme: &Scheme,
    rates: &mut [Rates<D>],
) {
    let transport = scheme.transport_velocity;
    let pressure = (
        PressureSlope {
            acts: scheme.operators.pressure == PressureGradient::Difference,
        },
        AveragedPressure {
            acts: scheme.operators.pressure == PressureGradient::Averaged,
        },
    );
    let carried = Advection {
        acts: transport.shifting || transport.shield || transport.at_rest,
    };
    let laws = (
        (VelocityGradient, pressure),
        (PressureDamping(scheme.operators.damping), carried),
    );
    let met = Encounters::of_fluid(records, renormalisations);
    backend.sweep(lists, records, &met, &laws, rates);
}

/// Accelerations that the gas would give ghosts of mass `rho V`. Where pairs share their momentum alike the forces are minus those of the
/// ghosts on the gas. Differences of pressures leave out what is the same on both sides, and a wall bears that too: there it is the sum of
/// pressures that presses on it.
pub fn reactions<const D: usize>(
    backend: &impl Backend,
    lists: &Lists,
    records: &Records<D>,
    scheme: &Scheme,
    rates: &mut [Rates<D>],
) {
    let met = Encounters::of_ghosts(records);
    if scheme.operators.pressure == PressureGradient::Averaged {
        let pressure = AveragedPressure { acts: true };
        return backend.sweep_in_double(lists, records, &met, &pressure, rates);
    }
    let forces = (ArtificialViscosity::of(scheme), PressureForce);
    backend.sweep_in_double(lists, records, &met, &forces, rates);
}
