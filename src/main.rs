//! The `aero` command: the command line, the comparisons with theory, and the charts.

#![warn(clippy::print_stdout, clippy::print_stderr)]

#[macro_use]
mod say;

mod chart;
mod cli;

use std::process::ExitCode;

use clap::Parser;

fn main() -> ExitCode {
    match cli::Cli::parse().run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            note!("error: {error}");
            error.exit_code()
        }
    }
}
