//! Tables of numbers that grow row by row while a run goes on.

use std::fs::File;
use std::io::{self, BufWriter, Seek, SeekFrom, Write as _};
use std::path::{Path, PathBuf};

use super::error::OutputError;

/// A table being written. It grows in place, so that it can be followed while the run goes on; after a crash its last line may be
/// cut short.
#[derive(Debug)]
pub struct Rows {
    path: PathBuf,
    writer: BufWriter<File>,
    bytes: u64,
}

impl Rows {
    /// Starts the file with its header, a line without its end.
    pub fn create(path: &Path, header: &str) -> Result<Self, OutputError> {
        let file = File::create(path).map_err(|source| OutputError::new(path, source))?;
        let mut rows = Self {
            path: path.to_owned(),
            writer: BufWriter::new(file),
            bytes: 0,
        };
        rows.add(header)?;
        Ok(rows)
    }

    /// Goes on with the file after its first `bytes`; what came later is cut off.
    pub fn resume(path: &Path, bytes: u64) -> Result<Self, OutputError> {
        let open = || {
            let mut file = File::options().write(true).open(path)?;
            if file.metadata()?.len() < bytes {
                return Err(io::Error::other(
                    "it is shorter than it was at the checkpoint",
                ));
            }
            file.set_len(bytes)?;
            file.seek(SeekFrom::End(0))?;
            Ok(file)
        };
        let file = open().map_err(|source| OutputError::new(path, source))?;
        Ok(Self {
            path: path.to_owned(),
            writer: BufWriter::new(file),
            bytes,
        })
    }

    /// Length of the file once all rows so far are on disk.
    pub fn bytes(&self) -> u64 {
        self.bytes
    }

    /// Adds a line, given without its end.
    pub fn add(&mut self, line: &str) -> Result<(), OutputError> {
        self.bytes += line.len() as u64 + 1;
        let written = self.writer.write_all(line.as_bytes());
        let written = written.and_then(|()| self.writer.write_all(b"\n"));
        written.map_err(|source| OutputError::new(&self.path, source))
    }

    /// Brings all rows so far to disk.
    pub fn flush(&mut self) -> Result<(), OutputError> {
        let flushed = self.writer.flush();
        flushed.map_err(|source| OutputError::new(&self.path, source))
    }
}
