//! `.pvd` collections: which file shows which time.

use std::fmt::Write as _;
use std::io::Write as _;
use std::path::{Path, PathBuf};

use super::atomic;
use super::error::OutputError;

/// A collection that grows file by file.
#[derive(Clone, Debug)]
pub struct Collection {
    path: PathBuf,
    entries: String,
}

impl Collection {
    /// An empty collection, not yet on disk.
    pub fn new(path: PathBuf) -> Self {
        Self {
            path,
            entries: String::new(),
        }
    }

    /// Where it is written.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Adds `file`, a name in the collection's own folder, without writing yet.
    pub fn note(&mut self, time: f64, file: &str) {
        // Writing to a string cannot fail.
        let _ = writeln!(
            self.entries,
            "    <DataSet timestep=\"{time:?}\" part=\"0\" file=\"{file}\"/>"
        );
    }

    /// Writes the collection.
    pub fn write(&self) -> Result<(), OutputError> {
        atomic::write(&self.path, |writer| {
            write!(
                writer,
                "<?xml version=\"1.0\"?>\n\
                 <VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n  \
                 <Collection>\n{}  </Collection>\n</VTKFile>\n",
                self.entries
            )
        })
    }
}
