//! A polar in one command: lift and drag by theory at every point, for a part of what the runs would take one by one.

use std::path::Path;

use aero_validation::exact::shock_expansion::Biconvex;
use aero_validation::table::{Check, Subject};
use serde_json::Value;

use super::biconvex::{MACH, THICKNESS};
use super::context::{CompareError, Context};
use super::program;
use super::scenes::{Source, scene};
use super::suite::Suite;
use super::variant::Levels;

const NAME: &str = "polar";
const SCENE: Source = scene!("polar");
const THEORY: &str = "shock-expansion theory (Anderson, Modern Compressible Flow, 4.15)";
const GAMMA: f64 = 1.4;

/// Incidences, degrees.
const ANGLES: [i32; 12] = [-3, -2, -1, 0, 1, 2, 3, 4, 5, 6, 7, 8];
const TYPED: &str = "--incidence=-3..8:1";

/// Departure of the lift and of the drag from theory, per cent of the largest.
const OFF: f64 = 2.0;
/// Processor time, over that of as many runs of their own.
const TIME: f64 = 0.5;

/// The polar.
pub const POLAR: Suite = Suite::alone(&[(Levels::Full, compare)]);

fn compare(context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    (context.announce)(&format!("{NAME}: {} points", ANGLES.len()));
    let theory = Biconvex::new(THICKNESS, MACH, GAMMA)?;
    let exact: Vec<[f64; 2]> = ANGLES
        .iter()
        .map(|&angle| {
            let loads = theory.at_incidence(f64::from(angle).to_radians())?;
            Ok([loads.lift, loads.drag])
        })
        .collect::<Result<_, CompareError>>()?;
    let measured = swept(&context.out.join(NAME))?;
    let subject = |what: &'static str, source| Subject::new(NAME, what, source);
    Ok(vec![
        subject(
            "lift, farthest from theory, per cent of the largest",
            THEORY,
        )
        .at_most(farthest(&measured.loads, &exact, 0), OFF),
        subject(
            "drag, farthest from theory, per cent of the largest",
            THEORY,
        )
        .at_most(farthest(&measured.loads, &exact, 1), OFF),
        subject(
            "processor time, over that of twelve runs",
            "the same runs one by one",
        )
        .at_most(measured.time, TIME),
    ])
}

/// What the sweep found.
struct Swept {
    /// Lift and drag at each angle; none where a point is missing.
    loads: Vec<Option<[f64; 2]>>,
    /// Processor time over that of the runs of their own; infinite where it is not known.
    time: f64,
}

/// Runs the sweep, then each of its points on its own.
fn swept(folder: &Path) -> Result<Swept, CompareError> {
    let rows = sweep(folder)?;
    let number = |row: &Value, key: &str| row[key].as_f64();
    let loads = |angle: &i32| {
        let is_there = |row: &&Value| number(row, "incidence") == Some(f64::from(*angle));
        let row = rows.iter().find(is_there)?;
        Some([number(row, "cl")?, number(row, "cd")?])
    };
    let together: Option<f64> = rows.iter().map(|row| number(row, "cpu_seconds")).sum();
    let apart: Vec<Option<f64>> = (ANGLES.iter())
        .map(|&angle| alone(folder, angle))
        .collect::<Result<_, CompareError>>()?;
    Ok(Swept {
        loads: ANGLES.iter().map(loads).collect(),
        time: together
            .zip(apart.into_iter().sum::<Option<f64>>())
            .filter(|(together, _)| *together > 0.0)
            .map_or(f64::INFINITY, |(together, apart)| together / apart),
    })
}

/// The rows of the polar.
fn sweep(folder: &Path) -> Result<Vec<Value>, CompareError> {
    let out = folder.join("sweep");
    // A sweep keeps what is done, also what an earlier comparison has left.
    if out.exists() {
        std::fs::remove_dir_all(&out).map_err(|source| CompareError::Report {
            path: out.clone(),
            source,
        })?;
    }
    let scene = program::given(&folder.join("polar.toml"), SCENE.text.as_bytes())?;
    program::run(&["sweep", &scene, TYPED, "--out", &program::typed(&out)])?;
    let rows = program::json(&out.join("sweep.json"))?;
    Ok(rows.as_array().cloned().unwrap_or_default())
}

/// Processor time of one point on its own, s; none where it is not told.
fn alone(folder: &Path, angle: i32) -> Result<Option<f64>, CompareError> {
    let out = folder.join(format!("alone-{angle}"));
    let incidence = format!("free_stream.incidence={angle}");
    let scene = program::given(&folder.join("polar.toml"), SCENE.text.as_bytes())?;
    let typed = ["run", &scene, "--set", &incidence, "--overwrite", "--out"];
    program::run(&[&typed[..], &[&program::typed(&out)]].concat())?;
    Ok(program::json(&out.join("summary.json"))?["cpu_seconds"].as_f64())
}

/// The largest departure of lift (0) or drag (1), per cent of the largest; infinite where a point is missing.
fn farthest(found: &[Option<[f64; 2]>], exact: &[[f64; 2]], which: usize) -> f64 {
    let largest = exact
        .iter()
        .map(|loads| loads[which].abs())
        .fold(0.0, f64::max);
    let off = |(found, exact): (&Option<[f64; 2]>, &[f64; 2])| {
        found.map_or(f64::INFINITY, |found| (found[which] - exact[which]).abs())
    };
    100.0 * found.iter().zip(exact).map(off).fold(0.0, f64::max) / largest
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_point_that_is_missing_is_as_far_off_as_can_be() {
        let exact = [[0.0, 0.02], [0.2, 0.04]];
        let found = |first| [first, Some([0.201, 0.04])];
        let [lift, drag] = [0, 1].map(|k| farthest(&found(Some([0.0, 0.021])), &exact, k));
        assert!((lift - 0.5).abs() < 1e-9 && (drag - 2.5).abs() < 1e-9);
        assert!(farthest(&found(None), &exact, 0).is_infinite());
    }
}
