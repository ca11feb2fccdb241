//! Drives a run from its start to its end: when frames are due, what is recorded, what is summed
//! up. Knows neither the equations nor the formats of the files.

mod bends;
mod beside;
mod burst;
mod checkpoint;
mod claim;
mod coefficients;
mod destination;
mod error;
mod far_field;
mod held;
mod inlets;
mod lately;
mod leaks;
mod outcome;
mod outlets;
mod probes;
mod progress;
mod reach;
mod recorder;
mod refined;
mod same;
mod section;
mod settle;
mod shown;
mod stagnation;
mod steady;
mod stopwatch;
mod swing;
mod tally;
mod thrown_back;
mod to_folder;
mod under_way;
mod views;
mod warmth;

pub use burst::{Burst, burst};
pub use claim::is_of;
pub use destination::Destination;
pub use error::RunError;
pub use lately::Coefficients as Latest;
pub use outcome::{History, Keep, Outcome, run_in_memory};
pub use progress::Progress;
pub use stopwatch::Stopwatch;
pub use to_folder::run_any;
