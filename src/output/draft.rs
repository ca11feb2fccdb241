//! Checkpoints on their way. A draft is on the disk as soon as the run is remembered, and takes the place of the checkpoint before it
//! once the frames that it tells of are there: kept in memory until then, it would be as large as all particles once more.

use std::fs::{self, File};
use std::io::{self, BufWriter, Read as _, Seek as _, SeekFrom, Write};
use std::path::{Path, PathBuf};

use serde::Serialize;

use super::checkpoint::{CHECKPOINT, Sum, header};
use super::error::OutputError;

/// Drafts that there may be at once: one under way to its place, one in line, one that is made, and one to spare.
const MOST: usize = 4;

/// Bytes that are read or written at once.
const BUFFER: usize = 1 << 16;

/// Makes drafts in a folder.
#[derive(Debug)]
pub struct Drafts {
    folder: PathBuf,
    made: usize,
}

impl Drafts {
    /// For the checkpoints in `folder`. Drafts of a run that was killed there are gone afterwards.
    pub fn new(folder: &Path) -> Self {
        for part in (0..MOST).map(|number| path(folder, number)) {
            // What is no file is not a draft.
            if fs::symlink_metadata(&part).is_ok_and(|known| known.is_file()) {
                // What cannot be removed is written over.
                let _ = fs::remove_file(part);
            }
        }
        Self {
            folder: folder.to_owned(),
            made: 0,
        }
    }

    /// Writes `content`, which is then needed no more.
    pub fn draft(&mut self, content: &impl Serialize) -> Result<Draft, OutputError> {
        let draft = Draft {
            part: path(&self.folder, self.made % MOST),
            checkpoint: self.folder.join(CHECKPOINT),
        };
        self.made += 1;
        draft.fill(content).map_err(|error| draft.failed(error))?;
        Ok(draft)
    }
}

fn path(folder: &Path, number: usize) -> PathBuf {
    folder.join(format!("{CHECKPOINT}-{number}.part"))
}

/// A checkpoint that is not yet in its place. It is gone when it is dropped.
#[derive(Debug)]
pub struct Draft {
    part: PathBuf,
    checkpoint: PathBuf,
}

impl Draft {
    fn fill(&self, content: &impl Serialize) -> io::Result<()> {
        let file = File::create(&self.part)?;
        let mut writer = Failing {
            inner: BufWriter::with_capacity(BUFFER, file),
            error: None,
        };
        writer.write_all(header(&Sum::default()).as_bytes())?;
        let result = postcard::to_io(content, &mut writer).map(drop);
        match (writer.error, result) {
            (Some(error), _) => Err(error),
            (None, Err(error)) => Err(io::Error::other(error)),
            (None, Ok(())) => writer.inner.flush(),
        }
    }

    /// Puts it in the place of the checkpoint before.
    pub fn finish(self) -> Result<(), OutputError> {
        self.seal().map_err(|error| self.failed(error))
    }

    fn seal(&self) -> io::Result<()> {
        let mut file = File::options().read(true).write(true).open(&self.part)?;
        file.seek(SeekFrom::Start(header(&Sum::default()).len() as u64))?;
        let (mut sum, mut buffer) = (Sum::default(), vec![0; BUFFER]);
        loop {
            match file.read(&mut buffer)? {
                0 => break,
                length => sum.add(&buffer[..length]),
            }
        }
        file.rewind()?;
        file.write_all(header(&sum).as_bytes())?;
        // A machine that loses power must not keep the name and lose the content.
        file.sync_data()?;
        fs::rename(&self.part, &self.checkpoint)
    }

    fn failed(&self, error: io::Error) -> OutputError {
        OutputError::new(&self.checkpoint, error)
    }
}

impl Drop for Draft {
    fn drop(&mut self) {
        // In its place by now, or of no use.
        let _ = fs::remove_file(&self.part);
    }
}

/// Keeps the error of a file, of which postcard says only that there was one.
struct Failing<W> {
    inner: W,
    error: Option<io::Error>,
}

impl<W: Write> Write for Failing<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.inner.write(bytes).map_err(|error| {
            let kind = error.kind();
            self.error = Some(error);
            kind.into()
        })
    }

    fn flush(&mut self) -> io::Result<()> {
        self.inner.flush()
    }
}

#[cfg(test)]
mod tests {
    use super::super::checkpoint::read_checkpoint;
    use super::*;

    fn files(folder: &Path) -> Vec<String> {
        let names = fs::read_dir(folder).unwrap();
        let names = names.map(|entry| entry.unwrap().file_name().into_string().unwrap());
        let mut names: Vec<String> = names.collect();
        names.sort();
        names
    }

    #[test]
    fn drafts_take_their_place_in_the_order_they_are_finished() {
        let folder = tempfile::tempdir().unwrap();
        let folder = folder.path();
        fs::write(folder.join("checkpoint-2.part"), "of a run that was killed").unwrap();
        let mut drafts = Drafts::new(folder);
        assert!(files(folder).is_empty());
        let made: Vec<Draft> = (0..3_usize)
            .map(|n| drafts.draft(&vec![n; 70_000]).unwrap())
            .collect();
        assert!(read_checkpoint::<Vec<usize>>(folder).unwrap().is_none());
        for (n, draft) in made.into_iter().enumerate() {
            draft.finish().unwrap();
            let content: Vec<usize> = read_checkpoint(folder).unwrap().unwrap();
            assert_eq!(content, vec![n; 70_000]);
        }
        drop(drafts.draft(&1).unwrap());
        assert_eq!(files(folder), [CHECKPOINT]);
    }

    #[test]
    fn a_disk_that_is_full_is_named_and_no_draft_is_left() {
        let folder = tempfile::tempdir().unwrap();
        let mut drafts = Drafts::new(&folder.path().join("absent"));
        let error = drafts.draft(&1).unwrap_err().to_string();
        assert!(error.contains("checkpoint`: No such file"), "{error}");
        let mut full = Failing {
            inner: Full,
            error: None,
        };
        assert!(postcard::to_io(&[1; 9], &mut full).is_err());
        assert_eq!(full.error.unwrap().kind(), io::ErrorKind::StorageFull);
    }

    struct Full;

    impl Write for Full {
        fn write(&mut self, _: &[u8]) -> io::Result<usize> {
            Err(io::ErrorKind::StorageFull.into())
        }

        fn flush(&mut self) -> io::Result<()> {
            Ok(())
        }
    }
}
