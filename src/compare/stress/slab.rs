//! The section of the thin plate in space: a slab ten spacings wide between two symmetry planes, thinner than a spacing and thicker.

use aero_validation::table::Check;

use super::plate::{EDGE, INCIDENCE, MACH, PLATE, THEORY, coefficients};
use super::trial::Trial;
use crate::context::{CompareError, Context, Level};
use crate::row::Row;
use crate::surface::{Facet, as_shape, prism};
use crate::variant::{Motion, Scheme};

/// Spacings along the chord, and across the slab.
const CHORD: f64 = 60.0;
const WIDTH: f64 = 10.0;

/// Thicknesses in spacings: all, and that of the quick level.
const THICKNESSES: [f64; 6] = [0.3, 0.5, 1.0, 1.5, 2.0, 3.0];
const QUICK: [f64; 1] = [1.0];

/// Flies the slabs by points that stay, at the full level by particles as well: two minutes of processor time each.
pub(super) fn compare(context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    let points = Scheme::USUAL.by_points(Motion::Settled);
    let (thicknesses, schemes): (&[f64], &[Scheme]) = match context.level {
        Level::Quick => (&QUICK, &[points]),
        Level::Full => (&THICKNESSES, &[points, Scheme::USUAL]),
    };
    let mut checks = Vec::new();
    for scheme in schemes {
        for thickness in thicknesses {
            checks.extend(slab(*thickness, *scheme, context)?);
        }
    }
    Ok(checks)
}

/// Lift and drag of a slab so many spacings thick.
fn slab(thickness: f64, scheme: Scheme, context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    let half = 0.5 * thickness / CHORD;
    let (lift, drag) = coefficients(half)?;
    let width = WIDTH / CHORD;
    let name = format!("slab-{thickness:?}");
    let shape = as_shape("plate", context.out, &name, &facets(half, width))?;
    // Particles are followed for nearly three chords, of which the last fifth counts.
    let end_time = if scheme.is_of_points() { 10.0 } else { 1.4 };
    let trial = Trial::new(PLATE, scheme)
        .called(format!("slab {thickness} spacings thick, {scheme}"))
        .with([
            "dimension=3".into(),
            format!("spacing={:?}", 1.0 / CHORD),
            format!("end_time={end_time:?}"),
            format!("free_stream.velocity=[{MACH:?}, 0.0, 0.0]"),
            "domain.min=[-0.2, -0.8, 0.0]".into(),
            format!("domain.max=[1.2, 0.65, {width:?}]"),
            "domain.sides.z_min=symmetry".into(),
            "domain.sides.z_max=symmetry".into(),
            shape,
            format!(
                "body.plate.place={{ rotate = {{ axis = [0.0, 0.0, 1.0], angle = {:?} }} }}",
                -INCIDENCE
            ),
            format!("body.plate.reference_area={width:?}"),
        ]);
    trial.compare(context, |outcome| {
        let body = outcome.map(|o| &o.summary.bodies["plate"]);
        let mean = |value: Option<f64>| value.unwrap_or(f64::NAN);
        let measured = [
            ("lift coefficient", mean(body.and_then(|b| b.cl_mean)), lift),
            ("drag coefficient", mean(body.and_then(|b| b.cd_mean)), drag),
        ];
        let mut rows: Vec<Row> = measured
            .map(|(quantity, measured, exact)| {
                Row::relative(quantity, THEORY, measured, exact, 5.0)
            })
            .into();
        rows.push(Row::at_most(
            "particles in the plate",
            "a wall is a wall",
            outcome.map_or(f64::NAN, |o| o.summary.leaked as f64),
            0.0,
        ));
        Ok(rows)
    })
}

/// The slab's surface at no incidence, beyond both planes.
fn facets(half: f64, width: f64) -> Vec<Facet> {
    let edge = EDGE[1];
    let outline = [
        [0.0, 0.0],
        [edge, -half],
        [1.0 - edge, -half],
        [1.0, 0.0],
        [1.0 - edge, half],
        [edge, half],
    ];
    let ends = [-0.5 * width, 1.5 * width];
    prism(&outline, ends, |[x, y], z| [x, y, z])
}
