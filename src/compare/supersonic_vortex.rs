//! A quarter of a vortex between two round walls, faster than sound: what curved walls leave of the order of points that stay.

use std::f64::consts::FRAC_PI_2;
use std::fmt::Write as _;

use aero::run::{Keep, Outcome};
use aero_validation::table::Check;

use super::context::{CompareError, Context, Level};
use super::row::{Heading, Row};
use super::scenes::{Source, scene};
use super::suite::Suite;
use super::variant::{Levels, Motion, Scheme};

const CASE: &str = "supersonic-vortex";
const SCENE: Source = scene!("supersonic-vortex");
const THEORY: &str = "Aftosmis, Gaitonde & Tavares 1994, exact";
const AIR: f64 = 1.4;
/// At the inner wall, where the radius, the density and the speed of sound are 1.
const MACH: f64 = 2.25;
/// Radii of the inner and the outer wall.
const RADII: [f64; 2] = [1.0, 1.384];
const NAMES: [&str; 2] = ["inner", "outer"];
/// Cells across the gap.
const QUICK: [u32; 2] = [10, 20];
const FULL: [u32; 3] = [10, 20, 40];
/// What is allowed at ten cells, and the least order with which it falls.
const DENSITY: (f64, f64) = (0.6e-2, 1.4);
const ENTROPY: (f64, f64) = (0.2e-2, 1.9);
const WALLS: [(f64, f64); 2] = [(2.4e-2, 1.1), (0.75e-2, 1.0)];
const WORST: [(f64, f64); 2] = [(6.5e-2, 0.9), (3.0e-2, 0.7)];

/// The vortex, from coarse to fine.
pub const SUPERSONIC_VORTEX: Suite = Suite::of(&[(Levels::Both, compare)]);

fn compare(context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    let outer = outer(context)?;
    let is_quick = context.level == Level::Quick;
    let cells: &[u32] = if is_quick { &QUICK } else { &FULL };
    let mut checks = Vec::new();
    for &cells in cells {
        let label = format!("dx gap/{cells}, points, settled");
        let heading = Heading {
            case: CASE,
            label: &label,
            only_informs: false,
            is_quick,
        };
        let mut settings = Scheme::USUAL.by_points(Motion::Settled).settings();
        settings.push(format!(
            "spacing={:?}",
            (RADII[1] - RADII[0]) / f64::from(cells)
        ));
        settings.push(outer.clone());
        let outcome = SCENE.run(&settings, Keep::End, context)?;
        checks.extend(rows(&outcome, cells).into_iter().map(|r| r.check(heading)));
    }
    Ok(checks)
}

/// The setting that makes the outer wall as round as the finest spacing asks: facets of the scene's are three spacings long there.
fn outer(context: &Context<'_>) -> Result<String, CompareError> {
    const FACETS: i32 = 240;
    let mut text = String::new();
    for n in -4..=FACETS + 4 {
        let (sine, cosine) = (FRAC_PI_2 * f64::from(n) / f64::from(FACETS)).sin_cos();
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{:?} {:?}", RADII[1] * cosine, RADII[1] * sine);
    }
    text.push_str("-0.1 1.6\n1.6 1.6\n1.6 -0.1\n");
    let path = context.out.join("supersonic-vortex-outer.txt");
    let report = |source| CompareError::Report {
        path: path.clone(),
        source,
    };
    std::fs::create_dir_all(context.out).map_err(report)?;
    std::fs::write(&path, text).map_err(report)?;
    let file = path.display().to_string();
    Ok(format!(
        "body.outer.shape={{ polygon_file = {{ file = {file:?} }} }}"
    ))
}

/// Density and pressure at a radius: one entropy, one total enthalpy, and a speed of `MACH / r`.
fn exact(radius: f64) -> [f64; 2] {
    let heat = 1.0 + 0.5 * (AIR - 1.0) * MACH * MACH * (1.0 - 1.0 / (radius * radius));
    let density = heat.powf(1.0 / (AIR - 1.0));
    [density, density * heat / AIR]
}

fn rows(outcome: &Outcome, cells: u32) -> Vec<Row> {
    let at_most = |(allowed, order): (f64, f64)| allowed * (10.0 / f64::from(cells)).powf(order);
    let [density, entropy] = errors(outcome);
    let mut rows = vec![
        Row::at_most("density, mean departure", THEORY, density, at_most(DENSITY)),
        Row::at_most("entropy, mean departure", THEORY, entropy, at_most(ENTROPY)),
    ];
    for wall in 0..2 {
        let name = NAMES[wall];
        let [mean, worst] = wall_errors(outcome, wall);
        for (what, off, allowed) in [
            ("mean departure", mean, WALLS[wall]),
            ("farthest off", worst, WORST[wall]),
        ] {
            let quantity = format!("pressure on the {name} wall, {what}");
            rows.push(Row::at_most(quantity, THEORY, off, at_most(allowed)));
        }
    }
    rows
}

/// Mean departures of density and of `p / rho^gamma`, by volume.
fn errors(outcome: &Outcome) -> [f64; 2] {
    let gas = &outcome.gas;
    let (mut sums, mut whole) = ([0.0; 2], 0.0);
    for i in 0..gas.kind.len() {
        let [x, y, _] = gas.position[i];
        let [density, _] = exact(x.hypot(y));
        let entropy = AIR * gas.pressure[i] / gas.density[i].powf(AIR);
        sums[0] += gas.volume[i] * (gas.density[i] / density - 1.0).abs();
        sums[1] += gas.volume[i] * (entropy - 1.0).abs();
        whole += gas.volume[i];
    }
    sums.map(|sum| sum / whole)
}

/// Mean and largest departure of the pressure on a wall, up to the sides.
fn wall_errors(outcome: &Outcome, wall: usize) -> [f64; 2] {
    let panels = &outcome.panels;
    let [_, pressure] = exact(RADII[wall]);
    let (mut sum, mut whole, mut worst) = (0.0, 0.0, 0.0_f64);
    for n in 0..panels.area.len() {
        let [x, y, _] = panels.middle(n);
        let is_there = x > 0.0 && y > 0.0 && x.hypot(y) < 1.05 * RADII[1];
        if panels.body[n] as usize == wall && is_there {
            let off = (panels.pressure[n] / pressure - 1.0).abs();
            sum += panels.area[n] * off;
            worst = worst.max(off);
            whole += panels.area[n];
        }
    }
    [sum / whole, worst]
}

#[cfg(test)]
mod tests {
    use super::exact;

    /// What goes round is held by what is outside of it, `dp/dr = rho u^2 / r`.
    #[test]
    fn the_vortex_is_in_balance() {
        let step = 1e-5;
        for radius in [1.0, 1.2, 1.384] {
            let [density, _] = exact(radius);
            let [after, before] = [radius + step, radius - step].map(|r| exact(r)[1]);
            let slope = (after - before) / (2.0 * step);
            let speed = super::MACH / radius;
            let held = density * speed * speed / radius;
            assert!((slope / held - 1.0).abs() < 1e-8, "{slope} {held}");
        }
        assert!((exact(1.0)[1] - 1.0 / 1.4).abs() < 1e-15);
    }
}
