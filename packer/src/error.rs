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
         choose a spacing of at most {}", rounded_down(size / 4.0)
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
        "the body is only {thickness:.3} spacings thick near {}; below 0.3 it cannot be \
         packed: choose a spacing of at most {}", place(at), rounded_down(spacing * thickness / 0.3)
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
        "{percent:.1} % of the surface would be without ghosts, the largest hole {hole:.1} spacings near {}: gas would flow \
         through the body there; choose a spacing of at most {}, or allow the loss with `--allow-loss`, in a scene with `allow_loss = true` in the body",
        place(at), rounded_down(spacing / hole)
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

/// A place for people.
fn place(at: &[f64]) -> String {
    let numbers = at.iter().map(|x| {
        let brief: f64 = format!("{x:.4e}").parse().unwrap_or(*x);
        brief.to_string()
    });
    format!("({})", numbers.collect::<Vec<_>>().join(", "))
}

/// A bound for people: two digits, and never above `value`.
fn rounded_down(value: f64) -> f64 {
    let rounded = format!("{value:.1e}").parse().unwrap_or(value);
    if rounded <= value {
        return rounded;
    }
    // One less in the second digit.
    let less = value - 0.05 * 10.0_f64.powf(value.log10().floor());
    format!("{less:.1e}").parse().unwrap_or(value)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short_and_bounds_are_kept() {
        let thin = PackError::Thin {
            thickness: 0.024,
            at: vec![1.471_421_758_113_588_2, 0.329_197_690_066_953_9, -2e-7],
            spacing: 0.041_576_851_868_494_06,
        };
        let text = thin.to_string();
        assert!(
            text.contains("near (1.4714, 0.3292, -0.0000002);"),
            "{text}"
        );
        assert!(text.ends_with("at most 0.0033"), "{text}");
        for value in [0.003_39, 0.003_31, 0.25, 9.99, 1.0, 1.04e-9, 123.0] {
            let rounded = rounded_down(value);
            assert!(
                rounded <= value && rounded > 0.9 * value,
                "{value} {rounded}"
            );
        }
    }
}
