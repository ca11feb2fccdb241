//! What an earlier run has left in a folder that is written anew.

use std::fs;
use std::path::Path;

use super::error::OutputError;

/// Names and kinds of the files that are numbered frame by frame.
const FRAMES: [(&str, &str); 6] = [
    ("frame", "vtp"),
    ("ghosts", "vtp"),
    ("surface", "vtp"),
    ("cells", "vtu"),
    ("field", "vti"),
    ("picture", "png"),
];

/// Files that list these.
const LISTS: [&str; 4] = ["run.pvd", "surface.pvd", "cells.pvd", "field.pvd"];

/// Removes the frames in `folder`. Viewers take all numbered files of a name for one series, and would show those beyond the last of a shorter run as
/// that run's.
///
/// # Errors
/// A file that cannot be removed.
pub fn remove_frames(folder: &Path) -> Result<(), OutputError> {
    let failed = |error| OutputError::new(folder, error);
    for entry in fs::read_dir(folder).map_err(failed)? {
        let entry = entry.map_err(failed)?;
        if entry.file_name().to_str().is_some_and(is_of_a_frame) {
            let path = entry.path();
            fs::remove_file(&path).map_err(|error| OutputError::new(&path, error))?;
        }
    }
    Ok(())
}

fn is_of_a_frame(name: &str) -> bool {
    let numbered = |(kind, ending): (&str, &str)| {
        let number = name.strip_prefix(kind)?.strip_prefix('-')?;
        number.strip_suffix(ending)?.strip_suffix('.')
    };
    let is_number = |number: &str| number.len() >= 6 && number.bytes().all(|b| b.is_ascii_digit());
    LISTS.contains(&name) || FRAMES.into_iter().filter_map(numbered).any(is_number)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn frames_go_and_what_is_not_of_this_program_stays() {
        let folder = tempfile::tempdir().unwrap();
        let stays = [
            "frame-1.vtp",
            "frame-000001.vtp.txt",
            "my-frame-000001.vtp",
            "summary.json",
        ];
        let goes = ["frame-000013.vtp", "picture-1000000.png", "run.pvd"];
        for name in stays.iter().chain(&goes) {
            fs::write(folder.path().join(name), "").unwrap();
        }
        remove_frames(folder.path()).unwrap();
        assert!(stays.iter().all(|name| folder.path().join(name).exists()));
        assert!(!goes.iter().any(|name| folder.path().join(name).exists()));
    }
}
