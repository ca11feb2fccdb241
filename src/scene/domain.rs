//! From the file's `[domain]` to a box with sides, and what the two must satisfy together.

use aero_geometry::{Bounds, Vector};

use super::error::SceneError;
use super::file::{SceneFile, SidesEntry};
use super::surface;
use super::vector::{side_key, vector};
use super::words::MotionWord;
use aero_solver::layers;
use aero_solver::problem::{AXES, Domain, Side};

/// Support radius of the kernel in spacings: three smoothing lengths of one and a half spacings
/// (Villodi & Ramachandran, section 4).
pub(super) const SUPPORT: f64 = 4.5;

/// Depth of open boundaries' buffers in spacings.
pub(super) const BUFFER: f64 = layers::BUFFER as f64;

/// How far an edge may be from a whole number of spacings, in spacings: round-off of decimal
/// fractions, not more.
pub(super) const WHOLE: f64 = 1e-6;

/// Box and sides of the scene.
pub(super) fn domain<const D: usize>(file: &SceneFile) -> Result<Domain<D>, SceneError> {
    let min: Vector<D> = vector("domain.min", &file.domain.min)?;
    let max: Vector<D> = vector("domain.max", &file.domain.max)?;
    let sides = sides(&file.domain.sides)?;
    let spacing = file.spacing.get();
    for k in 0..D {
        axis(AXES[k], [min[k], max[k]], sides[k], spacing)?;
        // Points that stay meet their own image without harm: a cell that spans the box has no face towards itself.
        if sides[k][0] == Side::Periodic && file.scheme.motion != Some(MotionWord::Fixed) {
            holds_a_support(AXES[k], max[k] - min[k], spacing)?;
        }
    }
    let bounds = Bounds::new(min, max);
    Ok(Domain {
        bounds,
        sides,
        openings: Vec::new(),
    })
}

/// The box that particles of the gas may lie in: the domain with its open boundaries' buffers.
pub(super) fn region<const D: usize>(domain: &Domain<D>, spacing: f64) -> Bounds<D> {
    grown(domain, |axis, end| {
        if domain.opens(axis, end) {
            BUFFER * spacing
        } else {
            0.0
        }
    })
}

/// The box that ghosts may lie in: grown by `margin` past sides that are open or closed by a
/// body; not grown where a mirror, an image or a wall's own ghosts take over.
pub(super) fn ghost_region<const D: usize>(domain: &Domain<D>, margin: f64) -> Bounds<D> {
    grown(domain, |axis, end| {
        if domain.opens(axis, end) || domain.sides[axis][end] == Side::Body {
            margin
        } else {
            0.0
        }
    })
}

fn grown<const D: usize>(domain: &Domain<D>, margin: impl Fn(usize, usize) -> f64) -> Bounds<D> {
    let mut region = domain.bounds;
    for k in 0..D {
        region.min[k] -= margin(k, 0);
        region.max[k] += margin(k, 1);
    }
    region
}

fn sides<const D: usize>(entry: &SidesEntry) -> Result<[[Side; 2]; D], SceneError> {
    let all = [
        [Some(&entry.x_min), Some(&entry.x_max)],
        [entry.y_min.as_ref(), entry.y_max.as_ref()],
        [entry.z_min.as_ref(), entry.z_max.as_ref()],
    ];
    for k in D..all.len() {
        if let Some(end) = (0..2).find(|&end| all[k][end].is_some()) {
            return Err(SceneError::value(
                side_key(k, end),
                format!("the scene has dimension {D} and no such side; leave it out"),
            ));
        }
    }
    let mut sides = [[Side::Outlet; 2]; D];
    for k in 0..D {
        for end in 0..2 {
            let side = all[k][end].ok_or_else(|| {
                SceneError::value(
                    side_key(k, end),
                    "missing; say what bounds the domain there",
                )
            })?;
            sides[k][end] = side.side;
            if let Some(velocity) = &side.velocity {
                surface::set_velocity::<D>(&mut sides[k][end], &side_key(k, end), k, velocity)?;
            }
        }
        let periodic = sides[k].map(|side| side == Side::Periodic);
        if periodic[0] != periodic[1] {
            return Err(SceneError::value(
                side_key(k, usize::from(periodic[1])),
                "is periodic, but the opposite side is not; make both periodic or neither",
            ));
        }
    }
    Ok(sides)
}

/// Checks one axis: not empty, wide enough, and a whole number of spacings where particles must
/// line up with the upper side.
fn axis(
    name: &str,
    [low, high]: [f64; 2],
    sides: [Side; 2],
    spacing: f64,
) -> Result<(), SceneError> {
    let place = format!("domain.max, {name}");
    let width = high - low;
    if width <= 0.0 {
        return Err(SceneError::value(
            place,
            format!("the domain spans {low} to {high}, which leaves nothing; max must exceed min"),
        ));
    }
    let count = width / spacing;
    if count < 1.0 {
        return Err(SceneError::value(
            place,
            format!(
                "the domain is {width} wide, less than one spacing of {spacing}; widen it or refine"
            ),
        ));
    }
    // The lattice starts at the lower corner, so only the upper side can be out of step.
    let aligned = matches!(
        sides[1],
        Side::Periodic | Side::Symmetry | Side::Wall { .. }
    );
    if aligned && (count - count.round()).abs() > WHOLE * count.max(1.0) {
        let whole = count.round().max(1.0);
        return Err(SceneError::value(
            place,
            format!(
                "the domain is {width} wide, which is {count:.4} spacings; a periodic, symmetry or wall side needs a whole number: set spacing = {}",
                shortest(width / whole, width, whole)
            ),
        ));
    }
    Ok(())
}

/// Checks that no particle meets its own image across a periodic axis.
fn holds_a_support(name: &str, width: f64, spacing: f64) -> Result<(), SceneError> {
    if width / spacing + WHOLE >= 2.0 * SUPPORT {
        return Ok(());
    }
    Err(SceneError::value(
        format!("domain.max, {name}"),
        format!(
            "the domain is {width} wide and periodic, but a particle reaches {} to either side and would meet its own image; widen it to {} or set spacing = {}",
            number(SUPPORT * spacing),
            number((2.0 * SUPPORT).ceil() * spacing),
            number(width / (2.0 * SUPPORT).ceil()),
        ),
    ))
}

/// `spacing` with the fewest decimals that still divides `width` into `whole` parts.
fn shortest(spacing: f64, width: f64, whole: f64) -> String {
    (0..=15)
        .map(|decimals| format!("{spacing:.decimals$}"))
        .find(|text| {
            let value: f64 = text.parse().unwrap_or(0.0);
            value > 0.0 && (width / value - whole).abs() <= WHOLE
        })
        .unwrap_or_else(|| spacing.to_string())
}

/// Six significant digits.
pub(super) fn number(value: f64) -> String {
    format!("{value:.5e}")
        .parse::<f64>()
        .map_or_else(|_| value.to_string(), |rounded| rounded.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_periodic_axis_must_be_a_whole_number_of_spacings() {
        let sides = [Side::Periodic; 2];
        let error = axis("y", [0.0, 1.0], sides, 0.03).unwrap_err();
        assert!(
            error.to_string().contains("set spacing = 0.030303"),
            "{error}"
        );
        assert!(axis("y", [0.0, 1.0], sides, 0.05).is_ok());
        assert!(axis("y", [0.0, 0.02], sides, 0.002).is_ok());
    }

    #[test]
    fn a_periodic_axis_must_hold_two_supports() {
        let error = holds_a_support("y", 0.8, 0.1).unwrap_err();
        assert!(error.to_string().contains("widen it to 0.9"), "{error}");
        assert!(holds_a_support("y", 0.9, 0.1).is_ok());
    }

    #[test]
    fn an_open_axis_may_be_any_width_above_one_spacing() {
        let sides = [Side::Inlet, Side::Outlet];
        assert!(axis("x", [0.0, 1.0], sides, 0.03).is_ok());
        assert!(axis("x", [0.0, 1.0], sides, 1.5).is_err());
        assert!(axis("x", [1.0, 1.0], sides, 0.1).is_err());
    }
}
