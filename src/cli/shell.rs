//! `aero completions` and `aero man`: what shells and readers of manuals want to know of the command line.

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
    let mut text = Vec::new();
    clap_complete::generate(args.shell, &mut Cli::command(), "aero", &mut text);
    say_all!("{}", String::from_utf8_lossy(&text));
}

/// Prints the manual page: the program, then each command.
pub fn manual() -> Result<(), CommandError> {
    let mut program = Cli::command();
    program.build();
    let pages = [program.clone()].into_iter();
    let mut text = Vec::new();
    for page in pages.chain(program.get_subcommands().cloned()) {
        clap_mangen::Man::new(page)
            .render(&mut text)
            .map_err(CommandError::failed)?;
    }
    say_all!("{}", String::from_utf8_lossy(&text));
    Ok(())
}
