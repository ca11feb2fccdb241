//! Bodies that ask much: convex corners next to vacuum, a blunt nose at Mach 20, wedges on either side
//! of the angle at which their shock leaves them, a plate thinner than the kernel.

use aero_validation::exact::normal::pitot_pressure_ratio;
use aero_validation::exact::oblique::{Strength, detachment, oblique_shock};
use aero_validation::exact::prandtl_meyer::expand;
use aero_validation::table::Check;

use super::rows::{Rows, ended, median};
use super::{Context, GAMMA, Level, PRESSURE, VARIANTS, ValidateError, base, edge, variant};
use crate::validate::outcome::{Source, attempt};

const CORNER: Source = source!("expansion-corner");
const BLUNT: Source = source!("blunt-body");
const PLATE: Source = source!("thin-plate");
const WEDGE: Source = Source {
    name: "wedge",
    text: include_str!("../../../cases/wedge.toml"),
};

/// Runs the bodies in all variants of the level.
pub fn compare(context: &Context<'_>) -> Result<Vec<Check>, ValidateError> {
    let mut checks = Vec::new();
    for (equations, extrapolation, level) in VARIANTS {
        if level == Level::Full && context.level == Level::Quick {
            continue;
        }
        for (mach, turn) in [(2.0, 20.0), (3.0, 45.0)] {
            checks.extend(corner([mach, turn], [equations, extrapolation], context)?);
        }
        checks.extend(blunt([equations, extrapolation], context)?);
        for angle in [29.0, 31.0] {
            checks.extend(wedge(angle, [equations, extrapolation], context)?);
        }
        checks.extend(plate([equations, extrapolation], context)?);
        checks.extend(edge::compare([equations, extrapolation], context)?);
        checks.extend(base::compare([equations, extrapolation], context)?);
    }
    Ok(checks)
}

/// Pressure behind the fan of a convex corner.
fn corner(
    [mach, turn]: [f64; 2],
    scheme: [&str; 2],
    context: &Context<'_>,
) -> Result<Vec<Check>, ValidateError> {
    let [equations, extrapolation] = scheme;
    let mut settings = variant(equations, extrapolation);
    settings.push(format!("free_stream.mach={mach}"));
    settings.push(format!("body.corner.shape.expansion_corner.angle={turn}"));
    let label = format!("M {mach}, {turn} deg, {equations} {extrapolation}");
    let tried = attempt(CORNER, &settings, context)?;
    let mut rows = Rows::new(CORNER.name, &label, equations, &tried);
    let fan = expand(mach, turn.to_radians(), GAMMA)?;
    let outcome = ended(tried);
    // Along the wall behind the fan, thirty spacings and more from the corner.
    let turn = turn.to_radians();
    let wall = outcome.as_deref().map_or(f64::NAN, |o| {
        let surface = &o.surface;
        let along = |p: &[f64; 3]| p[0] * turn.cos() - p[1] * turn.sin();
        let chosen = (0..surface.pressure.len())
            .filter(|&i| (1.5..2.4).contains(&along(&surface.position[i])));
        median(chosen.map(|i| surface.pressure[i]).collect())
    });
    rows.relative(
        "p2/p1 on the wall",
        "Prandtl-Meyer",
        [wall / PRESSURE, fan.pressure_ratio, 5.0],
    );
    Ok(rows.checks)
}

/// Stagnation pressure of a nose at Mach 20, and the entropy of the gas that has not met its shock.
fn blunt(scheme: [&str; 2], context: &Context<'_>) -> Result<Vec<Check>, ValidateError> {
    let [equations, extrapolation] = scheme;
    let label = format!("{equations} {extrapolation}");
    let tried = attempt(BLUNT, &variant(equations, extrapolation), context)?;
    let mut rows = Rows::new(BLUNT.name, &label, equations, &tried);
    let outcome = ended(tried);
    let stagnation = outcome.as_deref().map_or(f64::NAN, |o| {
        let surface = &o.surface;
        let near = (0..surface.pressure.len())
            .filter(|&i| surface.position[i][1].abs() < 0.1 && surface.position[i][0] < 0.0);
        median(near.map(|i| surface.pressure[i]).collect())
    });
    let pitot = pitot_pressure_ratio(20.0, GAMMA);
    rows.relative(
        "stagnation pressure",
        "Rayleigh's pitot formula",
        [stagnation / PRESSURE, pitot, 3.0],
    );
    let change = outcome.as_deref().map_or(f64::NAN, |o| {
        let gas = &o.gas;
        (0..gas.density.len())
            // The shock stands at -1.4, and its kernels reach 0.25 ahead.
            .filter(|&i| gas.position[i][0] < -1.75)
            .map(|i| (gas.pressure[i] / PRESSURE / gas.density[i].powf(GAMMA) - 1.0).abs())
            .fold(0.0, f64::max)
    });
    rows.at_most(
        "entropy ahead of the shock, largest change",
        "it is that of the stream",
        [change, 1e-6],
    );
    Ok(rows.checks)
}

/// A wedge of Mach 2.5, whose shock leaves it at 29.8 degrees.
fn wedge(
    angle: f64,
    scheme: [&str; 2],
    context: &Context<'_>,
) -> Result<Vec<Check>, ValidateError> {
    let [equations, extrapolation] = scheme;
    let mut settings = variant(equations, extrapolation);
    settings.push(format!("body.ramp.shape.compression_corner.angle={angle}"));
    let limit = detachment(2.5, GAMMA)?.deflection.to_degrees();
    let word = if angle < limit {
        "attached"
    } else {
        "detached"
    };
    let label = format!("M 2.5, {angle} deg ({word}), {equations} {extrapolation}");
    let tried = attempt(WEDGE, &settings, context)?;
    Ok(Rows::new("wedge", &label, equations, &tried).checks)
}

/// Half the plate's thickness, and the length of its edges, in chords.
const PLATE_EDGE: [f64; 2] = [0.02, 0.12];

/// A panel of one side of the plate: pressure over the stream's, extent along the chord, rise towards the gas.
struct PlatePanel {
    pressure: f64,
    length: f64,
    rise: f64,
}

/// The panels of the side of the plate that is turned into the stream by `incidence`, from the leading edge: a shock at
/// the edge, a fan at each corner (shock-expansion theory).
fn plate_side(mach: f64, incidence: f64) -> Result<[PlatePanel; 3], ValidateError> {
    let [half, edge] = PLATE_EDGE;
    let slope = half.atan2(edge);
    let shock = oblique_shock(mach, slope + incidence, GAMMA, Strength::Weak)?;
    let first = expand(shock.mach, slope, GAMMA)?;
    let second = expand(first.mach, slope, GAMMA)?;
    let flat = shock.pressure_ratio * first.pressure_ratio;
    let panel = |pressure, length, rise| PlatePanel {
        pressure,
        length,
        rise,
    };
    Ok([
        panel(shock.pressure_ratio, edge, half),
        panel(flat, 1.0 - 2.0 * edge, 0.0),
        panel(flat * second.pressure_ratio, edge, -half),
    ])
}

/// Pressure on the flat parts of a thin plate at incidence, lift and drag; no gas may go through it.
fn plate(scheme: [&str; 2], context: &Context<'_>) -> Result<Vec<Check>, ValidateError> {
    const MACH: f64 = 2.0;
    const INCIDENCE: f64 = 5.0;
    let [equations, extrapolation] = scheme;
    let label = format!("{equations} {extrapolation}");
    let tried = attempt(PLATE, &variant(equations, extrapolation), context)?;
    let mut rows = Rows::new(PLATE.name, &label, equations, &tried);
    let incidence = INCIDENCE.to_radians();
    let (windward, leeward) = (plate_side(MACH, incidence)?, plate_side(MACH, -incidence)?);
    let outcome = ended(tried);

    let (sin, cos) = incidence.sin_cos();
    // Behind the waves that the corner of the leading edge sends to the shock and back.
    let flat = |side: f64| {
        outcome.as_deref().map_or(f64::NAN, |o| {
            let surface = &o.surface;
            let is_flat = |p: &[f64; 3]| (0.5..0.8).contains(&(p[0] * cos - p[1] * sin));
            let chosen = (0..surface.pressure.len())
                .filter(|&i| is_flat(&surface.position[i]) && surface.normal[i][1] * side > 0.0);
            median(chosen.map(|i| surface.pressure[i]).collect())
        })
    };
    for (name, side, panels) in [("below", -1.0, &windward), ("above", 1.0, &leeward)] {
        rows.relative(
            &format!("p/p1 on the flat part {name}"),
            "shock-expansion theory",
            [flat(side) / PRESSURE, panels[1].pressure, 3.0],
        );
    }

    let over = |panel: &PlatePanel| panel.pressure - 1.0;
    let lift = |side: &[PlatePanel; 3]| side.iter().map(|p| over(p) * p.length).sum::<f64>();
    let push = |side: &[PlatePanel; 3]| side.iter().map(|p| over(p) * p.rise).sum::<f64>();
    let scale = 2.0 / (GAMMA * MACH * MACH);
    let normal = scale * (lift(&windward) - lift(&leeward));
    let axial = scale * (push(&windward) + push(&leeward));
    let body = outcome.as_deref().map(|o| &o.summary.bodies["plate"]);
    let coefficients = [
        (
            "lift coefficient",
            body.and_then(|b| b.cl_mean),
            normal * cos - axial * sin,
        ),
        (
            "drag coefficient",
            body.and_then(|b| b.cd_mean),
            normal * sin + axial * cos,
        ),
    ];
    for (name, measured, exact) in coefficients {
        rows.relative(
            name,
            "shock-expansion theory",
            [measured.unwrap_or(f64::NAN), exact, 5.0],
        );
    }
    let leaked = outcome
        .as_deref()
        .map_or(f64::NAN, |o| o.summary.leaked as f64);
    rows.at_most("particles in the plate", "a wall is a wall", [leaked, 0.0]);
    Ok(rows.checks)
}
