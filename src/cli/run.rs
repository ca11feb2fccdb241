//! `aero run`.

use std::path::{Path, PathBuf};

use aero::case::AnyCase;
use aero::check::shortened;
use aero::output::{BodySummary, CHECKPOINT, Summary, can_be_prolonged};
use aero::run::{Destination, RunError, Stopwatch, is_of};
use clap::Args;

use super::interrupt::Interrupt;
use super::minutes::turned_into_points;
use super::scene::{SceneArgs, checked, described, folder, run_watched, tell};
use super::{CommandError, on_threads};

/// What `aero run` takes.
#[derive(Args, Debug)]
pub struct RunArgs {
    #[command(flatten)]
    scene: SceneArgs,
    /// Folder for the results; `out/NAME` unless given
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Go on from the last checkpoint in the folder, where there is one
    #[arg(long)]
    resume: bool,
    /// Write over what a run of another scene has left in the folder
    #[arg(long)]
    overwrite: bool,
}

/// Spread of a force about its mean, in per cent of it, below which it has settled.
const SETTLED: f64 = 1.0;

/// Runs a scene.
pub fn run(args: &RunArgs) -> Result<(), CommandError> {
    let stopwatch = Stopwatch::start();
    let interrupt = Interrupt::listen()?;
    let scene = args.scene.load()?;
    let out = folder(args.out.as_ref(), scene.name());
    let earlier = (!args.overwrite).then_some(out.as_path());
    let scene = on_threads(args.scene.threads, || turned_into_points(scene, earlier))?;
    let scene_lines = scene.lines();
    if args.resume
        && !out.join(CHECKPOINT).exists()
        && has_ended(&out, &scene.lines_from_anywhere())?
    {
        return Ok(());
    }
    let destination = Destination {
        folder: &out,
        scene: &scene_lines,
        noted: &scene.lines_from_anywhere(),
        resume: args.resume,
        skips_start: false,
        overwrite: args.overwrite,
    };
    on_threads(args.scene.threads, || {
        let case = checked(&scene)?;
        let words = described(&scene, &case);
        run_case(case, destination, stopwatch, &interrupt, &words)
    })
}

/// True where the run in `out`, which has no checkpoint of a run under way, has come to its end and `scene` is no longer one; says
/// so.
fn has_ended(out: &Path, scene: &str) -> Result<bool, CommandError> {
    let folder = out.display();
    if !out.join("summary.json").exists() {
        note!("no checkpoint in `{folder}` yet: starting from the beginning");
        return Ok(false);
    }
    if is_of(out, scene) {
        say!(
            "the run in `{folder}` came to its end; go on with it by a later one, `--set end_time=..`, or leave out `--resume` to run \
             it anew"
        );
        return Ok(true);
    }
    if can_be_prolonged(out) {
        return Ok(false);
    }
    Err(CommandError::wrong(format!(
        "the run in `{folder}` came to its end and left nothing to go on from, as a flow that has settled does; leave out `--resume` \
         to run it anew"
    )))
}

fn run_case(
    case: AnyCase,
    destination: Destination<'_>,
    stopwatch: Stopwatch,
    interrupt: &Interrupt,
    words: &[String],
) -> Result<(), CommandError> {
    tell(&case);
    let result = run_watched(case, destination, stopwatch, interrupt, words, &mut |_| {
        false
    });
    let folder = destination.folder.display();
    let go_on = if destination.folder.join(CHECKPOINT).exists() {
        "; the last checkpoint is kept: go on from it with `--resume`"
    } else {
        ""
    };
    match result {
        Ok(summary) => {
            say_all!("{}", lines(&summary, destination.folder));
            if summary.stop_reason != "end time reached" {
                say!("{}", summary.stop_reason);
            }
            Ok(())
        }
        Err(RunError::Stopped { reason, summary }) => {
            say_all!("{}", lines(&summary, destination.folder));
            let go_on = if interrupt.came() { go_on } else { "" };
            Err(CommandError::failed(format!(
                "the run stopped: {reason}; its last frame and summary are in `{folder}`{go_on}"
            )))
        }
        Err(RunError::Output(error)) => Err(CommandError::failed(format!("{error}{go_on}"))),
        Err(error @ (RunError::SetUp(_) | RunError::Resume(_) | RunError::Occupied(_))) => {
            Err(CommandError::wrong(error))
        }
    }
}

/// The summary for people.
fn lines(summary: &Summary, out: &Path) -> String {
    use std::fmt::Write as _;
    let mut text = String::new();
    // Writing to a string cannot fail.
    let _ = writeln!(
        text,
        "{}: {} steps to t = {:.6e}, {} fluid and {} ghost particles\n\
         {:.1} s on {} threads, {:.1} s of processor time, {:.0} particle updates per processor second\n\
         {}{}leaked {}{}",
        summary.case,
        summary.steps,
        summary.end_time,
        summary.particles.fluid,
        summary.particles.ghost,
        summary.wall_seconds,
        summary.threads,
        summary.cpu_seconds,
        summary.particle_updates_per_cpu_second,
        memory(summary),
        drift(summary),
        summary.leaked,
        returned(summary),
    );
    if summary.points_per_level.len() > 1 {
        let counts: Vec<String> = summary
            .points_per_level
            .iter()
            .map(usize::to_string)
            .collect();
        let _ = writeln!(
            text,
            "points by halvings of the spacing: {}",
            counts.join(", ")
        );
    }
    for (name, body) in &summary.bodies {
        text.push_str(&loads(name, body));
    }
    for line in &summary.warnings {
        let _ = writeln!(text, "warning: {line}");
    }
    let _ = writeln!(text, "results in `{}`", out.display());
    text
}

/// The loads on a body, and what their coefficients are made of.
fn loads(name: &str, body: &BodySummary) -> String {
    use std::fmt::Write as _;
    let has_coefficients = body.cd_mean.is_some();
    let [x, y, z] = if has_coefficients && body.coefficients == "gauge" {
        body.force_gauge
    } else {
        body.force
    };
    let mut text = format!("body `{name}`: force {x:.4e} {y:.4e} {z:.4e}");
    if !has_coefficients {
        text.push_str(" of absolute pressure");
    }
    // Writing to a string cannot fail.
    if let (Some(cd), Some(cl), Some(cm)) = (body.cd_mean, body.cl_mean, body.cm_mean) {
        let _ = write!(text, ", mean cd {cd:.4}, cl {cl:.4}, cm {cm:.4} nose up");
        if let (Some(ca), Some(cn)) = (body.ca_mean, body.cn_mean) {
            let _ = write!(text, ", axial {ca:.4}, normal {cn:.4}");
        }
        text.push_str(&settled(body));
        let [x, y, z] = body.moment_centre;
        let _ = write!(
            text,
            "\n  of {} pressure, area {}, length {}, moments about {x} {y} {z}",
            body.coefficients,
            shortened(body.reference_area),
            shortened(body.reference_length)
        );
    }
    if let Some(motion) = &body.motion {
        let list = |numbers: &[f64; 3]| numbers.map(|number| format!("{number:.4e}")).join(" ");
        let _ = write!(
            text,
            "\n  at {}, moving at {}, turned by {} degrees, turning at {} rad/s",
            list(&motion.position),
            list(&motion.velocity),
            list(&motion.turn),
            list(&motion.angular_velocity)
        );
    }
    text.push('\n');
    text
}

/// Whether the force on a body has come to rest, by its spread over the time of its mean; nothing where none was taken.
fn settled(body: &BodySummary) -> String {
    let spread = body.settled_percent;
    if spread == 0.0 {
        String::new()
    } else if spread < SETTLED {
        format!("\n  settled: +- {spread:.1} % while the mean was taken")
    } else {
        format!("\n  not settled: +- {spread:.1} % while the mean was taken")
    }
}

/// The drift of what is conserved, where the run went through time.
fn drift(summary: &Summary) -> String {
    summary.conservation.map_or(String::new(), |drift| {
        format!(
            "drift: mass {:.1e}, momentum {:.1e}, energy {:.1e}; ",
            drift.mass, drift.momentum, drift.energy
        )
    })
}

/// What walls sent back, where they did.
fn returned(summary: &Summary) -> String {
    match summary.returned {
        0 => String::new(),
        1 => ", brought back out of a wall once".to_owned(),
        times => format!(", brought back out of walls {times} times"),
    }
}

/// The line about memory, where that is known.
fn memory(summary: &Summary) -> String {
    let particles = summary.particles.fluid + summary.particles.ghost;
    summary.peak_memory_bytes.map_or(String::new(), |bytes| {
        format!(
            "{:.2} GiB of memory at most, {} bytes per particle\n",
            bytes as f64 / f64::from(1 << 30),
            bytes / particles.max(1) as u64
        )
    })
}
