//! Failures and their exit status.

use std::fmt;
use std::process::ExitCode;

/// Why a command did not do what it was asked.
#[derive(Debug)]
pub enum CommandError {
    /// The command, the scene or the body is wrong: status 2.
    Wrong(String),
    /// The run or the comparison failed: status 1.
    Failed(String),
}

impl CommandError {
    /// An error of whoever typed the command.
    pub fn wrong(error: impl fmt::Display) -> Self {
        Self::Wrong(error.to_string())
    }

    /// A failure of a command that was right.
    pub fn failed(error: impl fmt::Display) -> Self {
        Self::Failed(error.to_string())
    }

    /// The status that the process ends with.
    pub fn exit_code(&self) -> ExitCode {
        match self {
            Self::Wrong(_) => ExitCode::from(2),
            Self::Failed(_) => ExitCode::from(1),
        }
    }
}

impl fmt::Display for CommandError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Wrong(message) | Self::Failed(message) => f.write_str(message),
        }
    }
}
