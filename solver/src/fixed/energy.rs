//! How energy goes through faces.

use super::calmness::share;
use super::equation_of_state::EquationOfState;
use super::real::Real;
use super::state::{Primitive, dot};
use crate::problem::Problem;

/// Part of the stream's total enthalpy that a cell may be off by, as next to shocks, for energy to go by waves alone.
const ALIKE: f64 = 0.02;

/// Part from which on it goes with the mass alone.
const ANOTHER: f64 = 0.1;

/// The same of cells that pressures jump around, from where on it is no shock that does it: within a captured bow shock at Mach 6 to 20 cells
/// are off by a tenth.
const NO_SHOCK: f64 = 0.15;

/// Part from which on energy goes with the mass alone whatever pressures do.
const ANYWHERE: f64 = 0.3;

/// What energy goes by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum EnergyFlux {
    /// By the waves of each jump, as mass and momentum do.
    Waves,
    /// With the mass, each part of which takes its total enthalpy along, where that is another than this one and pressure is smooth, or far
    /// another.
    Enthalpy(f64),
}

impl EnergyFlux {
    /// In a flow of `problem`.
    ///
    /// A steady flow out of one stream has the total enthalpy of that stream everywhere, and one whose energy goes with the mass comes to
    /// just that [as of the schemes of Liou 1996, J. Comput. Phys. 129, 364-382, section 2.2]. Waves do not see to it: where gas circles
    /// behind a body they warm it by friction and let hardly any of the heat out, to several times the energy that the stream brings.
    /// In time flows have any, and so have those that sources heat, that several streams feed, and that conduct heat.
    pub fn of<const D: usize>(problem: &Problem<D>) -> Self {
        if problem.method.settles() && problem.has_one_enthalpy() && !problem.gas.is_viscous() {
            let stream = &problem.free_stream;
            let heat = problem.gas.energy(stream.density, stream.pressure);
            let square = stream.velocity.norm_squared();
            Self::Enthalpy(heat + stream.pressure / stream.density + 0.5 * square)
        } else {
            Self::Waves
        }
    }
}

/// The energy that so much `mass` takes through a face, from the left state to the right one where there is more than none of it, and how
/// much of the energy is to go that way, from zero to one, where the stream brings `enthalpy` and pressures are `smooth`, from zero in shocks
/// to one. Of first order where the total enthalpies differ, exact where they do not.
#[inline(always)]
pub fn carried<G: EquationOfState, const D: usize, R: Real>(
    gas: &G,
    mass: R,
    [left, right]: &[Primitive<D, R>; 2],
    enthalpy: f64,
    smooth: R,
) -> (R, R) {
    let [left, right] = [total_enthalpy(gas, left), total_enthalpy(gas, right)];
    let one = mass.like(1.0);
    let off =
        (left.max(right) * (1.0 / enthalpy) - one).max(one - left.min(right) * (1.0 / enthalpy));
    let part = smooth * share(off, ALIKE, ANOTHER);
    let part = part.max(share(off, NO_SHOCK, ANYWHERE));
    (mass * mass.select(left, right), part)
}

/// `e + p / rho + u^2 / 2`.
#[inline(always)]
fn total_enthalpy<G: EquationOfState, const D: usize, R: Real>(
    gas: &G,
    state: &Primitive<D, R>,
) -> R {
    let energy = gas.internal_energy(state.density, state.pressure);
    (energy + state.pressure) / state.density + dot(&state.velocity, &state.velocity) * 0.5
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::super::tests::lattice::problem;
    use super::*;
    use crate::gas::IdealGas;
    use crate::method::{FixedPoints, Method, Time};
    use crate::problem::{Given, Opening, Side};
    use approx::assert_relative_eq;

    #[test]
    fn energy_goes_with_the_mass_where_a_flow_settles_that_one_stream_feeds() {
        let mut flow = problem([4], 0.25, [[Side::Inlet, Side::Outlet]]);
        assert_eq!(EnergyFlux::of(&flow), EnergyFlux::Waves);
        flow.method = Method::Fixed(FixedPoints {
            time: Time::Settle,
            ..FixedPoints::default()
        });
        assert!(matches!(EnergyFlux::of(&flow), EnergyFlux::Enthalpy(_)));
        let stream = flow.free_stream;
        flow.domain.openings.push(Opening {
            axis: 0,
            end: 0,
            part: None,
            side: Side::Inlet,
            given: Some(Given(Arc::new(move |_, _| stream))),
        });
        assert_eq!(EnergyFlux::of(&flow), EnergyFlux::Waves);
    }

    #[test]
    fn mass_takes_the_total_enthalpy_of_where_it_comes_from_if_that_is_not_the_streams() {
        let gas = IdealGas::new(1.4);
        let sides = [
            Primitive {
                density: 1.4,
                velocity: [3.0, 1.0],
                pressure: 1.0,
            },
            Primitive {
                density: 0.7,
                velocity: [0.0, 2.0],
                pressure: 3.0,
            },
        ];
        let (energy, _) = carried(&gas, 0.5, &sides, 7.5, 1.0);
        assert_relative_eq!(energy, 0.5 * (2.5 + 5.0), epsilon = 1e-14);
        let (energy, share) = carried(&gas, -0.5, &sides, 7.5, 1.0);
        assert_relative_eq!(energy, -0.5 * (15.0 + 2.0), epsilon = 1e-14);
        assert_eq!(share, 1.0);
        let in_gas = |enthalpy: f64, smooth| carried(&gas, 0.5, &[sides[0]; 2], enthalpy, smooth).1;
        let alike = |enthalpy: f64| in_gas(enthalpy, 1.0);
        assert_eq!([alike(7.5), alike(7.6), alike(7.4)], [0.0; 3]);
        assert_relative_eq!(alike(7.5 / 1.06), 0.5, epsilon = 1e-12);
        assert_relative_eq!(alike(7.5 / 0.94), 0.5, epsilon = 1e-12);
        // Where pressures jump, shocks are left alone.
        let jumps = |part: f64| in_gas(7.5 / part, 0.0);
        assert_eq!([jumps(0.87), jumps(1.0), jumps(1.13)], [0.0; 3]);
        assert_relative_eq!(jumps(1.225), 0.5, epsilon = 1e-12);
        assert_relative_eq!(jumps(0.775), 0.5, epsilon = 1e-12);
        assert_eq!([jumps(0.5), jumps(7.7)], [1.0; 2]);
    }
}
