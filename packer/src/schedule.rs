//! How long and how strongly particles relax.

use crate::relax::Relaxation;

/// Particles in thin parts, alone.
pub(crate) const THIN_STEPS: Relaxation = Relaxation {
    steps: 60,
    smoothing: 1.0,
    strength: 0.8,
};

/// Ghosts: a short smoothing length evens out single gaps, the flow's own one what is left.
pub(crate) const GHOST_STEPS: [Relaxation; 2] = [
    Relaxation {
        steps: 15,
        smoothing: 1.0,
        strength: 0.8,
    },
    Relaxation {
        steps: 20,
        smoothing: 1.5,
        strength: 1.5,
    },
];

/// Fluid: the same, longer, because the shell starts from a lattice cut at random.
pub(crate) const FLUID_STEPS: [Relaxation; 2] = [
    Relaxation {
        steps: 15,
        smoothing: 1.0,
        strength: 0.8,
    },
    Relaxation {
        steps: 25,
        smoothing: 1.5,
        strength: 1.5,
    },
];
