//! The program itself, run as it would be typed.

use std::ffi::OsStr;
use std::path::Path;
use std::process::{Command, Stdio};

use serde_json::Value;

use super::context::CompareError;

/// Runs the program with `arguments`, without a word.
///
/// # Errors
/// What it says where it fails.
pub fn run<A: AsRef<OsStr>>(arguments: &[A]) -> Result<(), CompareError> {
    let failed = |reason: String| {
        let typed = arguments.iter().map(|word| word.as_ref().to_string_lossy());
        CompareError::Program {
            typed: typed.collect::<Vec<_>>().join(" "),
            reason,
        }
    };
    let program = std::env::current_exe().map_err(|error| failed(error.to_string()))?;
    let mut command = Command::new(program);
    command.args(arguments).stdout(Stdio::null());
    let output = (command.output()).map_err(|error| failed(error.to_string()))?;
    if output.status.success() {
        return Ok(());
    }
    Err(failed(
        String::from_utf8_lossy(&output.stderr).trim().to_owned(),
    ))
}

/// Writes what it is to be given, and the folder around that; returns the path as it is typed.
///
/// # Errors
/// Where that cannot be written.
pub fn given(path: &Path, content: &[u8]) -> Result<String, CompareError> {
    let report = |source| CompareError::Report {
        path: path.to_owned(),
        source,
    };
    if let Some(folder) = path.parent() {
        std::fs::create_dir_all(folder).map_err(report)?;
    }
    std::fs::write(path, content).map_err(report)?;
    Ok(typed(path))
}

/// A path as it is typed.
pub fn typed(path: &Path) -> String {
    path.to_string_lossy().into_owned()
}

/// What it wrote into a file.
///
/// # Errors
/// Where that cannot be read.
pub fn json(path: &Path) -> Result<Value, CompareError> {
    let unreadable = |reason: String| CompareError::Unreadable {
        path: path.to_owned(),
        reason,
    };
    let text = std::fs::read_to_string(path).map_err(|error| unreadable(error.to_string()))?;
    serde_json::from_str(&text).map_err(|error| unreadable(error.to_string()))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The program of these tests knows as little of it as the other.
    #[test]
    fn what_a_program_that_fails_says_is_told() {
        let failed = run(&["--no-such-flag"]).expect_err("no such flag");
        let said = failed.to_string();
        assert!(said.matches("no-such-flag").count() > 1, "{said}");
    }
}
