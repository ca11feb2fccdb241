//! Why a body cannot be packed.

/// Reasons to refuse a packing; each says what to change.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum PackError {
    /// The spacing is zero, negative or not a number.
    #[error("spacing {0} is not a positive number; give a spacing above zero")]
    Spacing(f64),
    /// No layers were asked for.
    #[error("no ghost layers asked for; give at least one, five cover the kernel's support")]
    NoLayers,
    /// Only plane and solid problems are packed.
    #[error("packing works in two and three dimensions, not in {0}")]
    Dimension(usize),
    /// The body does not end and no region says where to stop.
    #[error("the body has no end along axis {axis}; give a region that cuts it off")]
    Endless {
        /// Axis along which the body is infinite.
        axis: usize,
    },
    /// The body is smaller than a spacing or two.
    #[error(
        "spacing {spacing} is too coarse for a body of size {size}; \
         choose a spacing of at most {}", size / 4.0
    )]
    Coarse {
        /// Spacing asked for.
        spacing: f64,
        /// Largest extent of the body.
        size: f64,
    },
    /// More particles than memory holds.
    #[error(
        "spacing {spacing} would give about {estimate:.1e} particles, above the limit of \
         {limit:.1e}; choose a larger spacing"
    )]
    TooMany {
        /// Spacing asked for.
        spacing: f64,
        /// Estimated number of particles.
        estimate: f64,
        /// Largest number accepted.
        limit: f64,
    },
    /// The body is thinner than ghosts can represent.
    #[error(
        "the body is only {thickness:.3} spacings thick near {at:?}; below 0.3 it cannot be \
         packed: choose a spacing of at most {}", spacing * thickness / 0.3
    )]
    Thin {
        /// Thickness in spacings.
        thickness: f64,
        /// Where.
        at: Vec<f64>,
        /// Spacing asked for.
        spacing: f64,
    },
    /// A part of the surface has no ghosts behind it.
    #[error(
        "{percent:.1} % of the surface would be without ghosts, the largest hole {hole:.1} spacings near {at:?}: gas would flow \
         through the body there; choose a spacing of at most {:.2e}, or allow the loss with `--allow-loss`, in a scene with `allow_loss = true` in the body",
        spacing / hole
    )]
    Lost {
        /// Part of the surface, per cent.
        percent: f64,
        /// Largest distance from the surface to a ghost, in spacings.
        hole: f64,
        /// Where that is.
        at: Vec<f64>,
        /// Spacing asked for.
        spacing: f64,
    },
    /// Nothing of the body lies inside the region.
    #[error("no ghosts inside the region; check that the region meets the body")]
    Empty,
}
