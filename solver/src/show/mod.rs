//! What a run shows of itself: frames, loads, totals and counts, and what it remembers for a later run.

mod checkpoint;
mod snapshot;

pub use checkpoint::Memory;
pub use snapshot::Statistics;
