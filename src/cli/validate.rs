//! `aero validate`.

use std::path::PathBuf;

use clap::Args;

use aero_validation::table;

use super::CommandError;
use aero::output;
use aero_compare::{CompareError, Context, Level, compare};

/// What `aero validate` takes.
#[derive(Args, Debug)]
pub struct ValidateArgs {
    /// Cases to compare; all of them unless named
    #[arg(value_name = "CASE")]
    cases: Vec<String>,
    /// Coarse and short: minutes in all
    #[arg(long, conflicts_with = "full")]
    quick: bool,
    /// At the published resolution
    #[arg(long)]
    full: bool,
    /// Overrides a value in every run, as in `aero run`; may be given many times
    #[arg(long = "set", value_name = "SECTION.KEY=VALUE")]
    set: Vec<String>,
    /// Folder for the table and the pictures
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

/// Compares cases with theory.
pub fn validate(args: &ValidateArgs) -> Result<(), CommandError> {
    let level = if args.full { Level::Full } else { Level::Quick };
    let out = args
        .out
        .clone()
        .unwrap_or_else(|| PathBuf::from("out/validate"));
    output::make_folder(&out).map_err(CommandError::wrong)?;
    let context = Context {
        level,
        settings: &args.set,
        out: &out,
        announce: &|run| note!("running {run}"),
    };
    let checks = compare(&args.cases, &context).map_err(|error| match error {
        CompareError::Unknown { .. } | CompareError::Scene(_) => CommandError::wrong(error),
        _ => CommandError::failed(error),
    })?;
    say_all!("{}", table::to_text(&checks));
    table::write_json(&checks, &out).map_err(CommandError::failed)?;
    let failed = checks.iter().filter(|check| !check.pass).count();
    if failed > 0 {
        let what = format!(
            "{failed} of {} comparisons are off by more than allowed",
            checks.len()
        );
        return Err(CommandError::failed(format!(
            "{what}; see {}",
            out.display()
        )));
    }
    Ok(())
}
