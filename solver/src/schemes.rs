//! The schemes that have a name: combinations of the parts in [`crate::scheme`].

use crate::scheme::{
    Conduction, Damping, Density, Energy, Extrapolation, Integrator, Operators, Precision,
    PressureGradient, ReturnOfShift, Scheme, StepBound, StepRule, Stress, TransportVelocity,
    Viscosity, Volume, WallTreatment,
};

impl Scheme {
    /// The scheme of the paper [Villodi & Ramachandran 2024, eqs 5-17 and 19-23], misprints corrected.
    pub const PAPER: Self = Self {
        name: "paper",
        integrator: Integrator::PredictorCorrector,
        step: StepBound {
            rule: StepRule::Extremes,
            ..Self::CONSERVATIVE.step
        },
        density: Density::Continuity,
        viscosity: Viscosity::Bare,
        conduction: Conduction::ByVolume,
        energy: Energy::ByRate,
        transport_velocity: TransportVelocity {
            return_of_shift: ReturnOfShift::Advection,
            ..Self::CONSERVATIVE.transport_velocity
        },
        wall: WallTreatment {
            follows_the_bend: false,
            keeps_entropy: false,
            slopes: false,
            sends_back: false,
            ..Self::CONSERVATIVE.wall
        },
        ..Self::CONSERVATIVE
    };

    /// Its conservative successor: what pairs exchange they exchange alike, and densities are read off the particles.
    pub const CONSERVATIVE: Self = Self {
        name: "conservative",
        integrator: Integrator::Leapfrog,
        step: StepBound {
            rule: StepRule::EachParticle,
            cfl: 0.5,
        },
        density: Density::Summation,
        operators: Operators {
            damping: Damping::Delta,
            volume: Volume::OfDensity,
            pressure: PressureGradient::Pairwise,
            stress: Stress::Conservative,
            renormalised: true,
        },
        viscosity: Viscosity::Limited,
        conduction: Conduction::Limited,
        energy: Energy::Settled,
        transport_velocity: TransportVelocity {
            shifting: false,
            shield: false,
            return_of_shift: ReturnOfShift::Exchange,
            evened_out: None,
            at_rest: false,
        },
        wall: WallTreatment {
            extrapolation: Extrapolation::Wom,
            follows_the_bend: true,
            keeps_entropy: true,
            slopes: true,
            constant_volume: true,
            sends_back: true,
            surface_tags: true,
        },
        skip_undisturbed: true,
        precision: Precision::Double,
    };

    /// Density evolved, gradients by differences, particles evened out after every ten steps: "Lagrangian, iterative particle shifting,
    /// coupled" [Negi & Ramachandran 2021, eqs 7-11].
    pub const L_IPST_C: Self = Self {
        name: "L-IPST-C",
        step: StepBound {
            cfl: 0.25,
            ..Self::PAPER.step
        },
        operators: Operators {
            damping: Damping::None,
            volume: Volume::Summed,
            pressure: PressureGradient::Difference,
            stress: Stress::Coupled,
            renormalised: true,
        },
        viscosity: Viscosity::None,
        conduction: Conduction::None,
        transport_velocity: TransportVelocity {
            return_of_shift: ReturnOfShift::Advection,
            evened_out: Some(10),
            ..Self::CONSERVATIVE.transport_velocity
        },
        wall: WallTreatment {
            sends_back: true,
            ..Self::PAPER.wall
        },
        skip_undisturbed: false,
        ..Self::PAPER
    };

    /// The same with the pressure evolved and damped, as its density [Negi & Ramachandran 2021, eqs 12-14].
    pub const PE_IPST_C: Self = Self {
        name: "PE-IPST-C",
        operators: Operators {
            damping: Damping::Coupled,
            ..Self::L_IPST_C.operators
        },
        ..Self::L_IPST_C
    };

    /// Particles shifted as they go, by a transport velocity [Negi & Ramachandran 2021, eqs 15-16].
    pub const TV_C: Self = Self {
        name: "TV-C",
        transport_velocity: TransportVelocity {
            shifting: true,
            evened_out: None,
            ..Self::L_IPST_C.transport_velocity
        },
        ..Self::L_IPST_C
    };

    /// Particles at rest, past which the flow goes [Negi & Ramachandran 2021, eq. 17].
    pub const E_C: Self = Self {
        name: "E-C",
        transport_velocity: TransportVelocity {
            at_rest: true,
            evened_out: None,
            ..Self::L_IPST_C.transport_velocity
        },
        ..Self::L_IPST_C
    };

    /// Pressure evolved and damped pair by pair, gradients not renormalised, particles shifted as they go [Ramachandran & Puri 2019; Negi &
    /// Ramachandran 2021, eqs 18-19].
    pub const EDAC: Self = Self {
        name: "EDAC",
        operators: Operators {
            damping: Damping::Pairwise,
            pressure: PressureGradient::Averaged,
            stress: Stress::Pairwise,
            renormalised: false,
            ..Self::TV_C.operators
        },
        ..Self::TV_C
    };

    /// The combinations that have a name.
    pub const NAMED: [Self; 7] = [
        Self::CONSERVATIVE,
        Self::PAPER,
        Self::L_IPST_C,
        Self::PE_IPST_C,
        Self::TV_C,
        Self::E_C,
        Self::EDAC,
    ];

    /// The combination called `name`.
    pub fn named(name: &str) -> Option<Self> {
        Self::NAMED.into_iter().find(|scheme| scheme.name == name)
    }
}

impl Default for Scheme {
    /// What a scene gets that names nothing.
    fn default() -> Self {
        Self::CONSERVATIVE
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_combination_is_found_by_its_own_name() {
        for scheme in Scheme::NAMED {
            assert_eq!(Scheme::named(scheme.name), Some(scheme));
        }
        assert_eq!(Scheme::named("none"), None);
    }
}
