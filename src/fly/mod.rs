//! A body flown from its file: how it lies, the box around it, what it costs, which spacings, and what comes of it with its band.
//! Makes scenes and reads what their runs have written; runs nothing itself.

mod attitude;
mod bluntness;
mod body_view;
mod canvas;
mod centre;
mod curves;
mod domain;
mod error;
mod estimate;
mod extrapolate;
mod figure;
mod fineness;
mod flat;
mod flight;
mod halvings;
mod lee;
mod level;
mod likeness;
mod loops;
mod meridian;
mod pictures;
mod polar_point;
mod read;
mod report;
mod round;
mod section;
mod skins;
mod spans;
mod wishes;
mod written;

pub use attitude::Axes;
pub use centre::Centre;
pub use error::FlyError;
pub use estimate::{Costs, FAMILY, minutes};
pub use extrapolate::{Extrapolated, extrapolate};
pub use flight::{Extent, Flight};
pub use level::{BASE, Coefficients, Level, Shares};
pub use polar_point::{Banded, Bands, Point};
pub use read::last as last_file;
pub use report::{Report, thin_warning, write_report};
pub use wishes::{Air, Wishes};
