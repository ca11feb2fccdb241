//! The nozzle with a pressure held at its end: where its shock stands.

use aero::run::Keep;
use aero_solver::frame::{Frame, Kind};
use aero_validation::exact::nozzle::{BackNozzle, Section, shock_for_back_pressure};

use super::stations::{INCH, INLET};
use super::{GAMMA, THEORY};
use crate::comparison::{Comparison, Flow};
use crate::context::CompareError;
use crate::row::Row;
use crate::scenes::scene;
use crate::variant::Variant;

const HELD: &str = "what is held";
/// Total pressure of the reservoir: 230 412 Pa at Mach 0.29615.
const TOTAL: f64 = 244_870.7;
/// Ends of the nozzle, inches from the throat.
const END: f64 = 3.0;
const LENGTH: f64 = 2.0 * END;
/// Largest distance from theory, as a part of the length, on the coarser points and particles of the quick level, and at the full one.
const ALLOWED: [f64; 2] = [0.016, 0.02];
/// Bands of equal height between axis and wall, each with its own shock.
const BANDS: usize = 8;
/// Inches over which a band's mean is taken.
const STRIP: f64 = 0.1;

/// Four back pressures, as parts of the total pressure.
pub const BACK_PRESSURE: Comparison<f64> = Comparison {
    case: "nozzle-back-pressure",
    scene: scene!("nozzle-back-pressure"),
    length: INLET * INCH,
    keep: Keep::Frames,
    variants: || {
        let mut variants = Vec::new();
        for part in [0.896, 0.808, 0.725, 0.649] {
            let variant = Variant::new(30, part);
            if part == 0.808 {
                variants
                    .extend([variant.cells(24), variant.cells(20).marched()].map(Variant::quick));
            }
            variants.extend([variant, variant.marched()]);
        }
        variants
    },
    label: |v| format!("p / p0 {}, dx R/{}, {}", v.own, v.cells, v.scheme.laws()),
    settings: |v, _| {
        let pressure = v.own * TOTAL;
        vec![format!(
            "domain.sides.x_max={{ outlet = {{ pressure = {pressure}, relaxation = 4.0 }} }}"
        )]
    },
    rows,
    pictures: |_| Ok(()),
    together: None,
};

fn rows(flow: &Flow<'_, f64>) -> Result<Vec<Row>, CompareError> {
    let shape = BackNozzle::in_inches();
    let exit = shape.area_ratio(END, Section::Planar);
    let shock = shock_for_back_pressure(flow.variant.own, exit, GAMMA)?;
    let cone = shape.joints()[2];
    let rise = shock.area_ratio * shape.throat - shape.half_height(cone);
    let theory = cone + rise / shape.divergence.tan();
    let frames = &flow.outcome.history.frames;
    let count = frames.len() as f64;
    let place = frames.iter().map(shock_place).sum::<f64>() / count;
    let pressure = frames.iter().map(end_pressure).sum::<f64>() / count;
    Ok(vec![
        Row::absolute(
            "shock behind the throat / length, mean over the height",
            THEORY,
            place / LENGTH,
            theory / LENGTH,
            ALLOWED,
        ),
        Row::informs(
            "pressure at the end / total pressure",
            HELD,
            pressure / TOTAL,
            flow.variant.own,
        ),
        flow.no_leaks(),
    ])
}

/// Inches from the throat to where the Mach number falls through one for good, mean over bands of the height; not a number where a
/// band has no such place.
fn shock_place(frame: &Frame) -> f64 {
    /// Strips from throat to end.
    const STRIPS: usize = (END / STRIP) as usize;
    let shape = BackNozzle::in_inches();
    let mut sums = vec![[(0.0, 0.0); STRIPS]; BANDS];
    for i in (0..frame.kind.len()).filter(|&i| frame.kind[i] == Kind::Fluid as u8) {
        let [x, y] = [0, 1].map(|k| frame.position[i][k] / INCH);
        let band = y / shape.half_height(x) * BANDS as f64;
        let strip = x / STRIP;
        if strip >= 0.0 && (strip as usize) < STRIPS {
            let sum = &mut sums[(band.max(0.0) as usize).min(BANDS - 1)][strip as usize];
            sum.0 += frame.volume[i] * frame.mach[i];
            sum.1 += frame.volume[i];
        }
    }
    let places = sums.iter().map(|band| {
        // Rows of thin gas may stand further apart than a strip is wide.
        let filled = band.iter().enumerate();
        let filled = filled.filter(|(_, (_, volume))| *volume > 0.0);
        let means: Vec<[f64; 2]> = filled
            .map(|(n, (sum, volume))| [(n as f64 + 0.5) * STRIP, sum / volume])
            .collect();
        let falls = |m: &&[[f64; 2]]| m[0][1] > 1.0 && m[1][1] <= 1.0;
        let shock = means.windows(2).rfind(falls);
        shock.map_or(f64::NAN, |m| {
            let part = (m[0][1] - 1.0) / (m[0][1] - m[1][1]);
            m[0][0] + part * (m[1][0] - m[0][0])
        })
    });
    places.sum::<f64>() / BANDS as f64
}

/// Mean pressure of the last strip.
fn end_pressure(frame: &Frame) -> f64 {
    let fluid = (0..frame.kind.len()).filter(|&i| frame.kind[i] == Kind::Fluid as u8);
    let last = fluid.filter(|&i| ((END - STRIP)..END).contains(&(frame.position[i][0] / INCH)));
    let sums = last.fold((0.0, 0.0), |(sum, volume), i| {
        (
            sum + frame.volume[i] * frame.pressure[i],
            volume + frame.volume[i],
        )
    });
    sums.0 / sums.1
}
