//! `aero completions` and `aero man`: what shells and readers of manuals want to know of the command line.

use std::io;

use clap::{Args, CommandFactory as _};
use clap_complete::Shell;

use super::{Cli, CommandError};

/// What `aero completions` takes.
#[derive(Args, Debug)]
pub struct CompletionsArgs {
    /// The shell; put what is printed where it looks for completions
    shell: Shell,
}

/// Prints completions.
pub fn completions(args: &CompletionsArgs) {
    clap_complete::generate(args.shell, &mut Cli::command(), "aero", &mut io::stdout());
}

/// Prints the manual page: the program, then each command.
pub fn manual() -> Result<(), CommandError> {
    let mut program = Cli::command();
    program.build();
    let pages = [program.clone()].into_iter();
    for page in pages.chain(program.get_subcommands().cloned()) {
        clap_mangen::Man::new(page)
            .render(&mut io::stdout())
            .map_err(CommandError::failed)?;
    }
    Ok(())
}
