//! What can be typed, and what becomes of it.

mod body;
mod chart;
mod check;
mod converge;
mod error;
mod fly;
mod interrupt;
mod mesh;
mod minutes;
mod neighbour;
mod new;
mod numbers;
mod pack;
mod progress;
mod run;
mod scene;
mod shell;
mod sweep;
mod validate;

pub use error::CommandError;

use clap::{Parser, Subcommand};

/// Compressible flow around real bodies without a mesh.
#[derive(Debug, Parser)]
#[command(version, about, max_term_width = 100)]
pub struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Pack ghost particles into a body or into all bodies of a scene
    Pack(pack::PackArgs),
    /// Say what a scene is, what it costs and what is wrong with it
    Check(check::CheckArgs),
    /// Run a scene
    Run(run::RunArgs),
    /// Write a commented scene to begin with
    New(new::NewArgs),
    /// Run a scene or a body at many Mach numbers and angles: a polar
    Sweep(Box<sweep::SweepArgs>),
    /// Fly a body from its file: drag, lift and a report with error bands
    Fly(Box<fly::FlyArgs>),
    /// Run a scene at several spacings: observed order, extrapolated values, bands
    Converge(converge::ConvergeArgs),
    /// Compare cases with theory
    Validate(validate::ValidateArgs),
    /// Chart speed against accuracy
    Chart(chart::ChartArgs),
    /// Print what a shell needs to complete commands
    Completions(shell::CompletionsArgs),
    /// Print the manual page
    Man,
}

impl Cli {
    /// Does what was typed, on one of the default pool's threads: every loop of another one would wait to be taken over.
    pub fn run(self) -> Result<(), CommandError> {
        rayon::scope(|_| self.command.run())
    }
}

impl Command {
    fn run(self) -> Result<(), CommandError> {
        match self {
            Self::Pack(args) => pack::pack(&args),
            Self::Check(args) => check::check(&args),
            Self::Run(args) => run::run(&args),
            Self::Validate(args) => validate::validate(&args),
            Self::Sweep(args) => sweep::sweep(&args),
            Self::Fly(args) => fly::fly(&args),
            Self::Converge(args) => converge::converge(&args),
            Self::New(args) => new::new(&args),
            Self::Chart(args) => chart::chart(&args),
            Self::Completions(args) => {
                shell::completions(&args);
                Ok(())
            }
            Self::Man => shell::manual(),
        }
    }
}

/// Runs `work` on a pool of so many threads; where it is where no number is given.
fn on_threads<T: Send>(
    threads: Option<u16>,
    work: impl FnOnce() -> Result<T, CommandError> + Send,
) -> Result<T, CommandError> {
    let Some(threads) = threads else {
        return work();
    };
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(threads.into())
        .build();
    let pool = pool
        .map_err(|error| CommandError::wrong(format!("cannot start {threads} threads: {error}")))?;
    pool.install(work)
}
