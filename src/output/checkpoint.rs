//! Checkpoints: one file that is there whole or not at all, and says when it is not to be trusted.
//!
//! A line of text that names the format, the length and the FNV-1a sum of the content, then the
//! content, every number with all its bits.

use std::io;
use std::path::{Path, PathBuf};

use serde::de::DeserializeOwned;

use super::error::OutputError;

/// Name of a checkpoint in the folder of its run.
pub const CHECKPOINT: &str = "checkpoint";

/// What the checkpoint of a run is called once that has come to its end: a longer run can go on from it.
const LAST: &str = "last-checkpoint";

/// Changes whenever the content does.
const FORMAT: &str = concat!("aero checkpoint 13, version ", env!("CARGO_PKG_VERSION"));

/// Why a checkpoint is of no use.
#[derive(Debug, thiserror::Error)]
#[error("cannot go on from `{}`: {reason}; leave out `--resume` to start from the beginning", path.display())]
pub struct CheckpointError {
    path: PathBuf,
    reason: String,
}

impl CheckpointError {
    /// The checkpoint in `folder` is of no use.
    pub fn new(folder: &Path, reason: impl Into<String>) -> Self {
        Self {
            path: latest(folder),
            reason: reason.into(),
        }
    }
}

/// Where the checkpoint in `folder` lies, of a run under way or else of one that has ended.
fn latest(folder: &Path) -> PathBuf {
    let [under_way, ended] = [CHECKPOINT, LAST].map(|name| folder.join(name));
    if !under_way.exists() && ended.exists() {
        ended
    } else {
        under_way
    }
}

/// True where a run has ended that a longer one can go on from.
pub fn can_be_prolonged(folder: &Path) -> bool {
    latest(folder).ends_with(LAST)
}

/// The line before content of which this is the sum: of the same length whatever it says, so that it can be written last.
pub(super) fn header(Sum { length, fnv }: &Sum) -> String {
    format!("{FORMAT}, {length:20} bytes, {fnv:016x}\n")
}

/// Reads the checkpoint in `folder`, of a run under way or else of one that has ended; none where there is neither.
pub fn read_checkpoint<T: DeserializeOwned>(folder: &Path) -> Result<Option<T>, CheckpointError> {
    let fail = |reason: String| CheckpointError::new(folder, reason);
    let bytes = match std::fs::read(latest(folder)) {
        Ok(bytes) => bytes,
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(None),
        Err(error) => return Err(fail(error.to_string())),
    };
    let damaged = || fail("it is damaged".into());
    let end = bytes.iter().position(|&byte| byte == b'\n');
    let (line, content) = bytes.split_at(end.ok_or_else(damaged)? + 1);
    let mut sum = Sum::default();
    sum.add(content);
    if line != header(&sum).as_bytes() {
        return Err(if line.starts_with(FORMAT.as_bytes()) {
            damaged()
        } else {
            fail(foreign(line))
        });
    }
    match postcard::take_from_bytes(content) {
        Ok((content, [])) => Ok(Some(content)),
        _ => Err(damaged()),
    }
}

/// What is wrong with a file that begins with another line than those of this program.
fn foreign(header: &[u8]) -> String {
    let line = String::from_utf8_lossy(header);
    match line.trim_end().rsplitn(3, ", ").last() {
        Some(format) if format.starts_with("aero checkpoint ") => {
            format!("another version of this program wrote it ({format}; this one writes {FORMAT})")
        }
        _ => format!("it is not a file of this program ({FORMAT})"),
    }
}

/// Removes what checkpoints there are in `folder`.
pub fn remove_checkpoints(folder: &Path) -> Result<(), OutputError> {
    for name in [CHECKPOINT, LAST] {
        let path = folder.join(name);
        unless_missing(&path, std::fs::remove_file(&path))?;
    }
    Ok(())
}

/// Lays the checkpoint of a run that has come to its end aside.
pub fn close_checkpoint(folder: &Path) -> Result<(), OutputError> {
    rename(folder, CHECKPOINT, LAST)
}

/// Takes the checkpoint of a run that had come to its end for one of a run under way.
pub fn reopen_checkpoint(folder: &Path) -> Result<(), OutputError> {
    if folder.join(CHECKPOINT).exists() {
        return Ok(());
    }
    rename(folder, LAST, CHECKPOINT)
}

fn rename(folder: &Path, from: &str, to: &str) -> Result<(), OutputError> {
    let path = folder.join(from);
    unless_missing(&path, std::fs::rename(&path, folder.join(to)))
}

/// `result`, good as well where there is no such file.
fn unless_missing(path: &Path, result: io::Result<()>) -> Result<(), OutputError> {
    match result {
        Err(error) if error.kind() != io::ErrorKind::NotFound => Err(OutputError::new(path, error)),
        _ => Ok(()),
    }
}

/// Length of what was added, and its 64-bit FNV-1a sum (Fowler, Noll & Vo): finds accidents, not forgers.
pub(super) struct Sum {
    length: u64,
    fnv: u64,
}

impl Default for Sum {
    fn default() -> Self {
        Self {
            length: 0,
            fnv: 0xcbf2_9ce4_8422_2325,
        }
    }
}

impl Sum {
    pub(super) fn add(&mut self, bytes: &[u8]) {
        self.length += bytes.len() as u64;
        self.fnv = bytes.iter().fold(self.fnv, |sum, &byte| {
            (sum ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
        });
    }
}

#[cfg(test)]
mod tests {
    use super::super::draft::Drafts;
    use super::*;

    fn write(folder: &Path, content: &[f64]) {
        let draft = Drafts::new(folder).draft(&content).unwrap();
        draft.finish().unwrap();
    }

    #[test]
    fn every_bit_comes_back() {
        let folder = tempfile::tempdir().unwrap();
        let numbers = [0.1, -0.0, f64::INFINITY, f64::MIN_POSITIVE / 2.0];
        write(folder.path(), &numbers);
        let back: Vec<f64> = read_checkpoint(folder.path()).unwrap().unwrap();
        assert_eq!(
            numbers.map(f64::to_bits).to_vec(),
            back.into_iter().map(f64::to_bits).collect::<Vec<_>>()
        );
    }

    #[test]
    fn no_file_is_no_checkpoint() {
        let folder = tempfile::tempdir().unwrap();
        assert!(
            read_checkpoint::<Vec<f64>>(folder.path())
                .unwrap()
                .is_none()
        );
        remove_checkpoints(folder.path()).unwrap();
    }

    #[test]
    fn what_is_laid_aside_is_read_where_nothing_is_under_way() {
        let folder = tempfile::tempdir().unwrap();
        let read = || read_checkpoint::<Vec<f64>>(folder.path()).unwrap().unwrap();
        write(folder.path(), &[1.0]);
        close_checkpoint(folder.path()).unwrap();
        assert!(can_be_prolonged(folder.path()));
        assert_eq!(read(), [1.0]);
        write(folder.path(), &[2.0]);
        assert!(!can_be_prolonged(folder.path()));
        assert_eq!(read(), [2.0]);
        reopen_checkpoint(folder.path()).unwrap();
        assert_eq!(read(), [2.0]);
    }

    #[test]
    fn a_damaged_or_foreign_file_is_refused() {
        let folder = tempfile::tempdir().unwrap();
        write(folder.path(), &[1.0, 2.0]);
        let path = folder.path().join(CHECKPOINT);
        let good = std::fs::read(&path).unwrap();
        let mut flipped = good.clone();
        *flipped.last_mut().unwrap() ^= 1;
        for (bytes, words) in [
            (&good[..good.len() - 1], "damaged"),
            (&flipped[..], "damaged"),
            (&good[..3], "damaged"),
            (&b"# a text\n"[..], "not a file of this program"),
            (
                &b"aero checkpoint 3, version 0.1.0, 1 bytes, af63bd4c8601b7df\n\0"[..],
                "another version of this program wrote it (aero checkpoint 3, version 0.1.0;",
            ),
        ] {
            std::fs::write(&path, bytes).unwrap();
            let error = read_checkpoint::<Vec<f64>>(folder.path()).unwrap_err();
            assert!(error.to_string().contains(words), "{error}");
        }
    }
}
