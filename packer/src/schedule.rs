//! How long and how strongly particles relax. A short smoothing length evens out single gaps, the
//! flow's own one what is left; more steps than these change no figure of merit by much. In space, where there are few, strong momentum
//! over short lengths would have particles swing at edges.

use crate::relax::Relaxation;

/// Particles in thin parts, alone.
pub(crate) fn thin_steps<const D: usize>() -> Relaxation {
    gaps(60, if D == 2 { 0.9 } else { 0.3 })
}

/// Ghosts.
pub(crate) fn ghost_steps<const D: usize>() -> [Relaxation; 2] {
    if D == 2 {
        [gaps(15, 0.9), waves(20, 0.9)]
    } else {
        [gaps(12, 0.3), waves(8, 0.6)]
    }
}

/// Fluid: longer, because the shell starts from a lattice cut at random.
pub(crate) fn fluid_steps<const D: usize>() -> [Relaxation; 2] {
    if D == 2 {
        [gaps(15, 0.9), waves(25, 0.9)]
    } else {
        [gaps(12, 0.6), waves(12, 0.6)]
    }
}

/// Steps that act on the spacing of neighbours.
const fn gaps(steps: usize, momentum: f64) -> Relaxation {
    Relaxation {
        stage: "closing gaps",
        steps,
        smoothing: 1.0,
        strength: 0.8,
        momentum,
    }
}

/// Steps that act on the density that the flow sees.
const fn waves(steps: usize, momentum: f64) -> Relaxation {
    Relaxation {
        stage: "evening out",
        steps,
        smoothing: 1.5,
        strength: 1.5,
        momentum,
    }
}
