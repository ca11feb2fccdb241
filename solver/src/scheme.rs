//! A scheme as data: one part per question that a particle method has to answer, to be combined at will.
//!
//! The combinations that have a name stand in `schemes.rs`.
//!
//! In the formulas sums go over the neighbours `j` of a particle `i`, ghosts included where it does not say otherwise: `x_ij = x_i - x_j`, `V = m / rho` volumes, `W_ij` the
//! kernel, `grad_i W_ij` its gradient at `i`, `L_i` the matrix that renormalises it, `F_ij = -(x_ij . grad_i W_ij) / x_ij^2`; letters with both indices are means of both.

/// Equations and boundary treatment of particles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scheme {
    /// Name in scenes and summaries of the combination that it came from.
    pub name: &'static str,
    /// How state goes through time.
    pub integrator: Integrator,
    /// What bounds a step.
    pub step: StepBound,
    /// Where densities come from.
    pub density: Density,
    /// How sums over pairs stand for gradients.
    pub operators: Operators,
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
    /// The undisturbed free stream is moved on without pair sums.
    pub skip_undisturbed: bool,
    /// In what numbers pairs are computed.
    pub precision: Precision,
}

/// How sums over pairs stand for gradients.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Operators {
    /// What spreads a density that is evolved.
    pub damping: Damping,
    /// How large particles are.
    pub volume: Volume,
    /// How pressure accelerates.
    pub pressure: PressureGradient,
    /// How the gas's own viscosity does.
    pub stress: Stress,
    /// Gradients of the kernel are corrected by where the neighbours are.
    pub renormalised: bool,
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
    /// The equation of continuity, `d rho_i / dt = -rho_i sum_j V_j (u_j - u_i) . L_i grad_i W_ij` and its damping [Villodi & Ramachandran 2024, eqs 10 and 17].
    Continuity,
    /// The sum over the particles around, `rho_i = sum_j m_j W_ij`, over the part of the kernel that they fill.
    Summation,
}

/// What spreads a density that is evolved; in a liquid the pressure that it stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Damping {
    /// Nothing.
    None,
    /// The diffusion of delta-SPH, `delta sum_j V_j c_ij h_ij D_ij . grad_i W_ij` with `D_ij = 2 x_ji / x_ij^2 [(rho_j - rho_i) - (g_i + g_j) . x_ji / 2]` and `g` the
    /// gradients of the density; within the gas [Villodi & Ramachandran 2024, eqs 10-11].
    Delta,
    /// That of an evolved pressure, by differences of gradients: `nu sum_j V_j (g_j - g_i) . L_i grad_i W_ij`, `nu = h c / 16` [Negi & Ramachandran 2021, eqs 12-13].
    Coupled,
    /// The same by pairs, `nu sum_j (V_i^2 + V_j^2) / V_i (rho_i - rho_j) F_ij` [Ramachandran & Puri 2019].
    Pairwise,
}

/// How large particles are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Volume {
    /// Mass over density.
    OfDensity,
    /// As much room as there is, `1 / sum W`, whatever their density is, and all of the same mass [Negi & Ramachandran 2021, eq. 31].
    Summed,
}

/// How pressure accelerates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PressureGradient {
    /// By sums of pressures, `-1/rho_i sum_j V_j (p_i L_i + p_j L_j) grad_i W_ij`: pairs exchange momentum alike [Villodi & Ramachandran 2024, eq. 12].
    Pairwise,
    /// By differences, `-1/rho_i sum_j V_j (p_j - p_i) L_i grad_i W_ij`, exact where it is linear [Negi & Ramachandran 2021, eq. 8].
    Difference,
    /// By a mean of the two, `-1/m_i sum_j (V_i^2 + V_j^2) (V_i p_i + V_j p_j) / (V_i + V_j) grad_i W_ij` [Adami, Hu & Adams 2013].
    Averaged,
}

/// How the gas's own viscosity accelerates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stress {
    /// By sums of stresses, and the departure from their gradients: pairs exchange momentum alike.
    Conservative,
    /// By differences of stresses, and the departure.
    Coupled,
    /// By pairs alone, `-2 mu sum_j V_j (u_i - u_j) F_ij` over the density [Morris, Fox & Zhu 1997].
    Pairwise,
}

/// What of the approach of a pair the artificial viscosity acts on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Viscosity {
    /// None: the gas's own viscosity is to do.
    None,
    /// All, over the distance: `sum_j m_j / rho_ij Pi_ij grad_i W_ij` with `Pi_ij = alpha c_ij mu - beta mu^2` and `mu = h_ij (u_ij . x_ij) / x_ij^2` of pairs that close
    /// [Villodi & Ramachandran 2024, eq. 13].
    Bare,
    /// All, over a distance softened: `mu = h_ij (u_ij . x_ij) / (x_ij^2 + 0.01 h_ij^2)` [Monaghan 1992, eq. 4.2].
    Softened,
    /// That, without what of `u_ij . x_ij` varies linearly, as both particles' rates of strain say [Frontiere, Raskin & Owen 2017, section 2.4]; and of pairs that part where
    /// gas expands, `Pi_ij = 2 c_ij mu`, without which a fan that springs from a corner rings.
    Limited,
}

/// How pairs conduct heat.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Conduction {
    /// None: the gas's own conduction is to do.
    None,
    /// Weighed by the neighbour's volume, as printed: `kappa sum_j V_j c_ij h_ij E_ij . grad_i W_ij` with `E_ij = 2 (e_j - e_i) x_ji / x_ij^2`
    /// [Villodi & Ramachandran 2024, eqs 14-15]; conserves no energy.
    ByVolume,
    /// By what both give and take alike, `m_j / rho_ij` for `V_j`, with a flux that cools shocked walls, the speed of closing added to `c_ij` [Noh 1987].
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
    /// They are shifted towards even spacing, against the gradient of `sum_j V_j W_ij`: `-Ma c 2h grad C` at most [Sun et al. 2019].
    pub shifting: bool,
    /// Walls shield themselves from penetration: `-2 (1 - s / s_nom) (n . u) n` is added to the motion of what heads for a wall at a distance `s` below its own
    /// spacing `s_nom` [Villodi & Ramachandran 2024, eq. 32].
    pub shield: bool,
    /// How the flow is kept in place where particles are shifted.
    pub return_of_shift: ReturnOfShift,
    /// After so many steps they are moved apart until they stand evenly, and take the state of where they come to.
    pub evened_out: Option<u64>,
    /// They stay where they are, and the flow passes them.
    pub at_rest: bool,
}

impl TransportVelocity {
    /// True where somebody asks where particles crowd.
    pub fn asks_for_concentration(self) -> bool {
        self.shifting || self.evened_out.is_some()
    }
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
#[allow(clippy::struct_excessive_bools)] // switches that do not depend on each other
pub struct WallTreatment {
    /// How ghosts get their state.
    pub extrapolation: Extrapolation,
    /// Gas that slides along a bent wall is accelerated by its bend.
    pub follows_the_bend: bool,
    /// Gas keeps its entropy across the layer at a wall; otherwise its temperature.
    pub keeps_entropy: bool,
    /// The flow varies across the layer at a wall along which it slides, and ghosts and sums that densities are read off know how; otherwise it is even there.
    pub slopes: bool,
    /// Ghost volumes stay constant; false only to show what happens otherwise.
    pub constant_volume: bool,
    /// Gas that a step has carried into a wall comes back as off a mirror; otherwise it is left there.
    pub sends_back: bool,
    /// Gas on one side of a thin part feels neither gas nor ghosts of the other side.
    pub surface_tags: bool,
}

/// How ghosts get the state of the gas.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Extrapolation {
    /// Without ghost mirrors: Shepard interpolation at the ghost, `sum_j V_j q_j W / sum_j V_j W` over the gas.
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
    /// True of those whose density is none of the particles' own, which liquids alone can do with.
    pub fn is_of_liquids(&self) -> bool {
        self.operators.volume == Volume::Summed
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
