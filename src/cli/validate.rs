//! `aero validate` and `aero chart`.

use std::path::PathBuf;

use clap::Args;

use super::CommandError;

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
    /// Folder for the table and the pictures
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

/// What `aero chart` takes.
#[derive(Args, Debug)]
pub struct ChartArgs {
    /// Cases to chart; all of them unless named
    #[arg(value_name = "CASE")]
    cases: Vec<String>,
    /// Folder for the charts
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

/// Compares cases with theory.
pub fn validate(args: &ValidateArgs) -> Result<(), CommandError> {
    Err(not_built("validate", &args.cases))
}

/// Charts speed against accuracy.
pub fn chart(args: &ChartArgs) -> Result<(), CommandError> {
    Err(not_built("chart", &args.cases))
}

fn not_built(command: &str, _cases: &[String]) -> CommandError {
    CommandError::wrong(format!(
        "`aero {command}` is not built yet; run a scene with `aero run`"
    ))
}
