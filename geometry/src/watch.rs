//! Long work tells how far it is, to whoever wants to know.

use std::fmt;
use std::sync::Arc;

type Listener = dyn Fn(&str, f64) + Send + Sync;

/// Who is told how far work is; nobody by default.
#[derive(Clone, Default)]
pub struct Watch(Option<Arc<Listener>>);

impl Watch {
    /// Calls `listener` with the name of the stage that begins or goes on, in a few plain words, and the
    /// part of it that is done, zero to one. Called from one thread at a time, some dozens of times.
    pub fn new(listener: impl Fn(&str, f64) + Send + Sync + 'static) -> Self {
        Self(Some(Arc::new(listener)))
    }

    /// `stage` begins.
    pub fn begin(&self, stage: &str) {
        self.show(stage, 0, 1);
    }

    /// `done` of `all` steps of `stage` are done.
    pub fn show(&self, stage: &str, done: usize, all: usize) {
        if let Some(listener) = &self.0 {
            listener(stage, done as f64 / all.max(1) as f64);
        }
    }
}

impl fmt::Debug for Watch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(if self.0.is_some() {
            "Watch(..)"
        } else {
            "Watch"
        })
    }
}
