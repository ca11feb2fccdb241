//! How long and how strongly particles relax. A short smoothing length evens out single gaps, the
//! flow's own one what is left; more steps than these change no figure of merit by much.

use crate::relax::Relaxation;

/// Particles in thin parts, alone.
pub(crate) const THIN_STEPS: Relaxation = gaps(60);

/// Ghosts.
pub(crate) fn ghost_steps<const D: usize>() -> [Relaxation; 2] {
    if D == 2 {
        [gaps(15), waves(20)]
    } else {
        [gaps(12), waves(8)]
    }
}

/// Fluid: longer, because the shell starts from a lattice cut at random.
pub(crate) fn fluid_steps<const D: usize>() -> [Relaxation; 2] {
    if D == 2 {
        [gaps(15), waves(25)]
    } else {
        [gaps(12), waves(12)]
    }
}

/// Steps that act on the spacing of neighbours.
const fn gaps(steps: usize) -> Relaxation {
    Relaxation {
        stage: "closing gaps",
        steps,
        smoothing: 1.0,
        strength: 0.8,
    }
}

/// Steps that act on the density that the flow sees.
const fn waves(steps: usize) -> Relaxation {
    Relaxation {
        stage: "evening out",
        steps,
        smoothing: 1.5,
        strength: 1.5,
    }
}
