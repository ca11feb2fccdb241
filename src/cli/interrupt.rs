//! Ctrl-C and the polite signals to end: the run stops after its step; a second one does not wait.

use std::ops::ControlFlow;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use super::CommandError;

/// Exit status of a process that SIGINT ended, as shells have it.
const ENDED_BY_SIGINT: i32 = 130;

/// Whether a signal to end has come.
#[derive(Clone, Debug)]
pub struct Interrupt(Arc<AtomicBool>);

impl Interrupt {
    /// Listens from now on; once per process.
    pub fn listen() -> Result<Self, CommandError> {
        let came = Arc::new(AtomicBool::new(false));
        let flag = Arc::clone(&came);
        ctrlc::set_handler(move || {
            if flag.swap(true, Ordering::Relaxed) {
                std::process::exit(ENDED_BY_SIGINT);
            }
        })
        .map_err(|error| CommandError::failed(format!("cannot listen for Ctrl-C: {error}")))?;
        Ok(Self(came))
    }

    /// True once a signal has come.
    pub fn came(&self) -> bool {
        self.0.load(Ordering::Relaxed)
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
