//! `aero check`.

use std::fmt::Write as _;
use std::path::PathBuf;

use aero::output;
use aero::run::{Burst, burst};
use clap::Args;

use super::minutes::turned_into_points;
use super::scene::{SceneArgs, described, folder};
use super::{CommandError, on_threads};

/// What `aero check` takes.
#[derive(Args, Debug)]
pub struct CheckArgs {
    #[command(flatten)]
    scene: SceneArgs,
    /// Folder for the picture; `out/NAME` unless given
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Time to run for, in seconds, to find out how fast it goes
    #[arg(long, value_name = "S", default_value_t = 2.0)]
    seconds: f64,
}

/// Says what a scene is, what it costs and what is wrong with it; runs it for a moment only.
pub fn check(args: &CheckArgs) -> Result<(), CommandError> {
    let scene = args.scene.load()?;
    let name = scene.name().to_owned();
    let folder = folder(args.out.as_ref(), &name);
    on_threads(args.scene.threads, || {
        let scene = turned_into_points(scene, None)?;
        let case = scene.build_any().map_err(CommandError::wrong)?;
        for line in described(&scene, &case) {
            say!("{line}");
        }
        let found = case.check();
        for line in &found.warnings {
            say!("warning: {line}");
        }
        if !found.refusals.is_empty() {
            return Err(CommandError::wrong(found.refusals.join("\n")));
        }
        let (slice, spacing) = (case.slice(), scene.file().spacing.get());
        let shown = burst(case, args.seconds).map_err(CommandError::wrong)?;
        say_all!("{}", cost(&shown));
        output::make_folder(&folder).map_err(CommandError::wrong)?;
        let path = folder.join("check.png");
        output::draw_scene(&path, &name, slice, spacing, &shown.frame)
            .map_err(CommandError::failed)?;
        say!("wrote `{}`", path.display());
        Ok(())
    })
}

/// What a run would cost.
fn cost(burst: &Burst) -> String {
    let mut text = format!(
        "  {} particles or points of gas, {} ghosts or walls",
        burst.gas, burst.ghosts
    );
    // Writing to a string cannot fail.
    if let Some(bytes) = burst.peak_memory {
        let _ = write!(
            text,
            ", {:.2} GiB of memory",
            bytes as f64 / f64::from(1 << 30)
        );
    }
    let minutes = burst.seconds_per_step * burst.steps_to_go / 60.0;
    let what = if burst.settles {
        "iterations until it settles, as flows do"
    } else {
        "steps to the end time"
    };
    let _ = writeln!(
        text,
        "\n  {:.2e} s a step on {} threads, measured over {} steps; about {:.0} {what}: {minutes:.1} minutes",
        burst.seconds_per_step,
        rayon::current_num_threads(),
        burst.steps,
        burst.steps_to_go,
    );
    text
}
