//! Files written one after another on a thread of their own, while the solver goes on.
//!
//! After the first file that cannot be written no other is begun, so that a checkpoint never tells of
//! frames that are not there.

use std::fmt;
use std::sync::mpsc::{SyncSender, sync_channel};
use std::thread::JoinHandle;

use super::error::OutputError;

/// Something to be written.
type Job = Box<dyn FnOnce() -> Result<(), OutputError> + Send>;

/// Writes what it is handed, in that order.
#[derive(Default)]
pub struct Background(Option<Worker>);

struct Worker {
    jobs: SyncSender<Job>,
    thread: JoinHandle<Result<(), OutputError>>,
}

impl fmt::Debug for Background {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Background").finish_non_exhaustive()
    }
}

impl Background {
    /// Has `job` done after those before it. Waits while one is under way and another in line: what
    /// jobs hold is as large as all particles.
    ///
    /// # Errors
    /// That of the job before that failed; this one is then not done.
    pub fn hand(
        &mut self,
        job: impl FnOnce() -> Result<(), OutputError> + Send + 'static,
    ) -> Result<(), OutputError> {
        let worker = self.0.get_or_insert_with(|| {
            let (jobs, line) = sync_channel::<Job>(1);
            let thread = std::thread::spawn(move || line.into_iter().try_for_each(|job| job()));
            Worker { jobs, thread }
        });
        match worker.jobs.send(Box::new(job)) {
            Ok(()) => Ok(()),
            // It takes no more, because one has failed.
            Err(_) => self.finish(),
        }
    }

    /// Says whether a job has failed by now, without waiting.
    ///
    /// # Errors
    /// That of the job.
    pub fn check(&mut self) -> Result<(), OutputError> {
        match &self.0 {
            Some(worker) if worker.thread.is_finished() => self.finish(),
            _ => Ok(()),
        }
    }

    /// Waits until all is written.
    ///
    /// # Errors
    /// That of the first job that failed.
    pub fn finish(&mut self) -> Result<(), OutputError> {
        let Some(Worker { jobs, thread }) = self.0.take() else {
            return Ok(());
        };
        drop(jobs);
        match thread.join() {
            Ok(result) => result,
            Err(panic) => std::panic::resume_unwind(panic),
        }
    }
}

impl Drop for Background {
    fn drop(&mut self) {
        if let Some(Worker { jobs, thread }) = self.0.take() {
            drop(jobs);
            // Nobody is left to be told.
            let _ = thread.join();
        }
    }
}

#[cfg(test)]
mod tests {
    use std::io;
    use std::path::Path;
    use std::sync::{Arc, Mutex};

    use super::*;

    #[test]
    fn jobs_are_done_in_order_and_all_of_them_by_the_end() {
        let done = Arc::new(Mutex::new(Vec::new()));
        let mut background = Background::default();
        for number in 0..10 {
            let done = Arc::clone(&done);
            let job = move || {
                done.lock().unwrap().push(number);
                Ok(())
            };
            background.hand(job).unwrap();
        }
        background.finish().unwrap();
        assert_eq!(*done.lock().unwrap(), (0..10).collect::<Vec<_>>());
    }

    #[test]
    fn after_a_failure_nothing_is_written_and_the_failure_is_told_once() {
        let fail = || Err(OutputError::new(Path::new("a"), io::Error::other("full")));
        let mut background = Background::default();
        background.hand(fail).unwrap();
        let mut told = 0;
        for _ in 0..3 {
            told += usize::from(background.hand(|| panic!("goes on")).is_err());
            if told > 0 {
                break;
            }
        }
        assert_eq!(told, 1);
        background.finish().unwrap();
        background.hand(fail).unwrap();
        assert!(
            background
                .finish()
                .unwrap_err()
                .to_string()
                .ends_with("full")
        );
    }
}
