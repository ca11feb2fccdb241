//! A scheme as data: one part per question that a particle method has to answer, to be combined at will.
//!
//! [`Scheme::PAPER`] and [`Scheme::CONSERVATIVE`] are two such combinations; a third is a constant in
//! [`Scheme::NAMED`].

/// Equations and boundary treatment of particles.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(clippy::struct_excessive_bools)] // switches that do not depend on each other
pub struct Scheme {
    /// Name in scenes and summaries of the combination that it came from.
    pub name: &'static str,
    /// How state goes through time.
    pub integrator: Integrator,
    /// What bounds a step.
    pub step: StepBound,
    /// Where densities come from.
    pub density: Density,
    /// Artificial viscosity.
    pub viscosity: Viscosity,
    /// Artificial conduction.
    pub conduction: Conduction,
    /// How internal energy is kept.
    pub energy: Energy,
    /// How particles move otherwise than their gas.
    pub transport_velocity: TransportVelocity,
    /// What ghosts show the gas.
    pub wall: WallTreatment,
    /// Gas on one side of a thin part feels neither gas nor ghosts of the other side.
    pub surface_tags: bool,
    /// The undisturbed free stream is moved on without pair sums.
    pub skip_undisturbed: bool,
    /// In what numbers pairs are computed.
    pub precision: Precision,
}

/// How state goes through time. Both are second order but for the dissipation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Integrator {
    /// Evaluates, predicts, evaluates and corrects [Villodi & Ramachandran 2024, section 3.6].
    PredictorCorrector,
    /// Drifts, kicks and drifts, and evaluates once: its prediction of velocity and energy goes by what pressure did in the
    /// step before, so that viscosity and conduction bear steps twice as long.
    Leapfrog,
}

/// What bounds a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StepBound {
    /// Over what the bounds are taken.
    pub rule: StepRule,
    /// Courant number `C_CFL` [Villodi & Ramachandran 2024, eq. 33; 0.5 in section 3.4].
    pub cfl: f64,
}

/// Over what the bounds of a step are taken, by sound and by acceleration [Villodi & Ramachandran 2024, eqs 33-35].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StepRule {
    /// The smallest smoothing length, the fastest sound and the largest acceleration, wherever they are.
    Extremes,
    /// The smallest bound of any one particle, which also lets no density or energy change by too much.
    EachParticle,
}

/// Where densities come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Density {
    /// The equation of continuity, with the diffusion of delta-SPH [Villodi & Ramachandran 2024, eqs 10-11, 17].
    Continuity,
    /// The sum over the particles around.
    Summation,
}

/// What of the approach of a pair the artificial viscosity acts on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Viscosity {
    /// None: the gas's own viscosity is to do.
    None,
    /// All, over the distance [Villodi & Ramachandran 2024, eq. 13].
    Bare,
    /// All, over a distance softened [Monaghan 1992, eq. 4.2].
    Softened,
    /// That, without what varies linearly.
    Limited,
}

/// How pairs conduct heat.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Conduction {
    /// None: the gas's own conduction is to do.
    None,
    /// Weighed by the neighbour's volume, as printed [Villodi & Ramachandran 2024, eq. 14]; conserves no energy.
    ByVolume,
    /// By what both give and take alike, with a flux that cools shocked walls [Noh 1987].
    Pairwise,
    /// That, of what does not vary linearly.
    Limited,
    /// The flux that cools shocked walls alone: gas that conducts heat itself needs no more.
    InShocks,
}

/// How internal energy is kept.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Energy {
    /// By its rate alone.
    ByRate,
    /// What forces do and the kinetic energy does not show is heat, which settles the total energy to round-off.
    Settled,
}

/// How particles move otherwise than their gas: through the transport velocity.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TransportVelocity {
    /// They are shifted towards even spacing.
    pub shifting: bool,
    /// Walls shield themselves from penetration.
    pub shield: bool,
    /// How the flow is kept in place where particles are shifted.
    pub return_of_shift: ReturnOfShift,
}

/// How the flow is kept in place where particles are shifted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ReturnOfShift {
    /// By advection terms [Villodi & Ramachandran 2024, eqs 19-21].
    Advection,
    /// By exchange between pairs.
    Exchange,
}

/// What ghosts show the gas.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct WallTreatment {
    /// How ghosts get their state.
    pub extrapolation: Extrapolation,
    /// Gas that slides along a bent wall is accelerated by its bend.
    pub follows_the_bend: bool,
    /// Gas keeps its entropy across the layer at a wall; otherwise its temperature.
    pub keeps_entropy: bool,
    /// Ghost volumes stay constant; false only to show what happens otherwise.
    pub constant_volume: bool,
}

/// How ghosts get the state of the gas.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Extrapolation {
    /// Without ghost mirrors: Shepard interpolation at the ghost.
    Wom,
    /// With ghost mirrors: first-order consistent interpolation at the mirror point.
    Wm,
}

/// In what numbers the arithmetic of a pair of particles is done; all else is `f64`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Precision {
    /// In `f64`.
    Double,
    /// In `f32`: faster, with noise of about a part in a million.
    Mixed,
}

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
        viscosity: Viscosity::Limited,
        conduction: Conduction::Limited,
        energy: Energy::Settled,
        transport_velocity: TransportVelocity {
            shifting: false,
            shield: false,
            return_of_shift: ReturnOfShift::Exchange,
        },
        wall: WallTreatment {
            extrapolation: Extrapolation::Wom,
            follows_the_bend: true,
            keeps_entropy: true,
            constant_volume: true,
        },
        surface_tags: true,
        skip_undisturbed: true,
        precision: Precision::Double,
    };

    /// The combinations that have a name.
    pub const NAMED: [Self; 2] = [Self::CONSERVATIVE, Self::PAPER];

    /// The combination called `name`.
    pub fn named(name: &str) -> Option<Self> {
        Self::NAMED.into_iter().find(|scheme| scheme.name == name)
    }

    /// With or without the limiter of the viscosity, where it has one.
    pub fn limit_viscosity(&mut self, limits: bool) {
        self.viscosity = match self.viscosity {
            Viscosity::None => Viscosity::None,
            Viscosity::Bare => Viscosity::Bare,
            _ if limits => Viscosity::Limited,
            _ => Viscosity::Softened,
        };
    }

    /// The same for gas with viscosity and conduction of its own. What the limiter of the artificial conduction leaves of it where
    /// temperature bends takes a twentieth of the heat of friction out of a shear layer of twenty spacings.
    #[must_use]
    pub fn of_viscous_gas(mut self) -> Self {
        if self.conduction == Conduction::Limited {
            self.conduction = Conduction::InShocks;
        }
        self
    }

    /// The same for a liquid, which carries no heat.
    #[must_use]
    pub fn of_liquid(mut self) -> Self {
        self.conduction = Conduction::None;
        self
    }

    /// With or without the limiter of the conduction, where it has one.
    pub fn limit_conduction(&mut self, limits: bool) {
        self.conduction = match self.conduction {
            Conduction::None => Conduction::None,
            Conduction::ByVolume => Conduction::ByVolume,
            Conduction::InShocks if limits => Conduction::InShocks,
            _ if limits => Conduction::Limited,
            _ => Conduction::Pairwise,
        };
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
