//! `aero chart`.

use std::path::PathBuf;

use aero::output;
use clap::Args;

use super::CommandError;
use crate::chart::{self, Wishes};
use aero_compare::CompareError;

/// What `aero chart` takes.
#[derive(Args, Debug)]
pub struct ChartArgs {
    /// Cases to chart; all of them unless named
    #[arg(value_name = "CASE")]
    cases: Vec<String>,
    /// With finer spacings as well: an hour and more instead of minutes
    #[arg(long)]
    full: bool,
    /// At most so many spacings, the coarsest
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    spacings: Option<u16>,
    /// Folder for charts and tables
    #[arg(long, value_name = "DIR", default_value = "out/chart")]
    out: PathBuf,
}

/// Charts speed against accuracy.
pub fn chart(args: &ChartArgs) -> Result<(), CommandError> {
    output::make_folder(&args.out).map_err(CommandError::wrong)?;
    let wishes = Wishes {
        full: args.full,
        spacings: args.spacings.map(usize::from),
        out: &args.out,
        announce: &|line| note!("{line}"),
    };
    let files = chart::chart(&args.cases, wishes).map_err(|error| match error {
        CompareError::Unknown { .. } => CommandError::wrong(error),
        _ => CommandError::failed(error),
    })?;
    for path in files {
        say!("wrote `{}`", path.display());
    }
    Ok(())
}
