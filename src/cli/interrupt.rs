//! Ctrl-C and the polite signals to end: a run that steps stops after its step, and a second signal does not wait; where nothing is
//! lost, as before the first step, the first one ends the command at once.

use std::ops::ControlFlow;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use super::CommandError;

/// Exit status of a process that SIGINT ended, as shells have it.
const ENDED_BY_SIGINT: i32 = 130;

/// Exit status of a run that was interrupted, as of all that fail.
const INTERRUPTED: i32 = 1;

/// Whether a signal to end has come.
#[derive(Clone, Debug)]
pub struct Interrupt(Arc<Flags>);

#[derive(Debug, Default)]
struct Flags {
    came: AtomicBool,
    /// What is under way has something to keep.
    holds: AtomicBool,
}

impl Interrupt {
    /// Listens from now on; once per process.
    pub fn listen() -> Result<Self, CommandError> {
        let own = Arc::new(Flags::default());
        let flags = Arc::clone(&own);
        ctrlc::set_handler(move || {
            if !flags.holds.load(Ordering::Relaxed) {
                note!("error: interrupted while setting up, before the first step");
                std::process::exit(INTERRUPTED);
            }
            if flags.came.swap(true, Ordering::Relaxed) {
                std::process::exit(ENDED_BY_SIGINT);
            }
            note!("interrupted: ends after this step; once more to end at once");
        })
        .map_err(|error| CommandError::failed(format!("cannot listen for Ctrl-C: {error}")))?;
        Ok(Self(own))
    }

    /// True once a signal has come.
    pub fn came(&self) -> bool {
        self.0.came.load(Ordering::Relaxed)
    }

    /// Says that there is something to keep from now on, which a signal waits for, or no more.
    pub fn hold(&self, holds: bool) {
        self.0.holds.store(holds, Ordering::Relaxed);
    }

    /// Whether to go on.
    pub fn wish(&self) -> ControlFlow<()> {
        if self.came() {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    }
}
