//! The lift of an aerofoil in a stream slower than sound, in boxes of several sizes, against the exact flow around it.

use aero::run::Keep;
use aero_validation::exact::karman_trefftz::KarmanTrefftz;

use super::comparison::{Comparison, Flow};
use super::context::CompareError;
use super::row::Row;
use super::scenes::{Source, scene};
use super::variant::Variant;

const SCENE: Source = scene!("aerofoil");
const THEORY: &str = "von Karman & Trefftz 1918, Glauert 1928";
/// As in the scene: the circle's middle, the angle at the trailing edge and the incidence, degrees.
const ECCENTRICITY: f64 = 0.08;
const TRAILING_EDGE: f64 = 10.0;
const INCIDENCE: f64 = 2.0;

/// A stream in a box.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stream {
    mach: f64,
    /// How far the sides are from the middle of the aerofoil, chords.
    sides: f64,
}

pub const AEROFOIL: Comparison<Stream> = Comparison {
    case: "aerofoil",
    scene: SCENE,
    length: 1.0,
    keep: Keep::End,
    variants: || {
        let stream = |mach, sides| Stream { mach, sides };
        let settled = Variant::new(200, stream(0.2, 5.0)).settled();
        vec![
            settled.both(),
            settled.with(stream(0.2, 2.5)).both(),
            settled.with(stream(0.2, 10.0)),
            settled.with(stream(0.5, 5.0)).both(),
        ]
    },
    label: |v| {
        let Stream { mach, sides } = v.own;
        format!("M {mach}, sides {sides} chords away, dx c/{}", v.cells)
    },
    settings: |v, spacing| {
        let Stream { mach, sides } = v.own;
        vec![
            // The finest of five halvings.
            format!("spacing={:?}", 32.0 * spacing),
            format!("free_stream.mach={mach:?}"),
            format!("domain.min=[{:?}, {:?}]", 0.5 - sides, -sides),
            format!("domain.max=[{:?}, {sides:?}]", 0.5 + sides),
        ]
    },
    rows,
    pictures: |_| Ok(()),
    together: None,
};

fn theory() -> KarmanTrefftz {
    KarmanTrefftz::new(ECCENTRICITY, TRAILING_EDGE.to_radians())
}

#[allow(clippy::unnecessary_wraps)] // a comparison's rows may fail
fn rows(flow: &Flow<'_, Stream>) -> Result<Vec<Row>, CompareError> {
    let body = &flow.outcome.summary.bodies["aerofoil"];
    let [lift, drag] = [body.cl_mean, body.cd_mean].map(|found| found.unwrap_or(f64::NAN));
    let exact = theory().lift_coefficient(INCIDENCE.to_radians(), flow.variant.own.mach);
    Ok(vec![
        Row::relative("lift coefficient", THEORY, lift, exact, [3.0, 5.0]),
        Row::at_most(
            "drag, which there is none of, over lift",
            THEORY,
            drag / lift,
            0.018,
        ),
        flow.no_leaks(),
    ])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_scene_has_the_aerofoil_of_theory() {
        let outline = theory().outline(160);
        let text = |[x, y]: [f64; 2]| format!("[{x:.6}, {y:.6}]").replace("-0.000000", "0.000000");
        for point in outline.into_iter().map(text) {
            assert!(SCENE.text.contains(&point), "{point}");
        }
    }
}
