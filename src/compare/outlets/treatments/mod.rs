//! Ways to end a flow, one file each, for verification alone.

mod characteristic;
mod do_nothing;
mod evolved;
mod hybrid;
mod mirror;
mod modified;

use super::treatment::Treatment;

pub use characteristic::Characteristic;
pub use do_nothing::DoNothing;
pub use evolved::Evolved;
pub use hybrid::Hybrid;
pub use mirror::Mirror;
pub use modified::ModifiedDoNothing;

/// All of them: those of the paper in the order of its tables, then the project's own.
pub static ALL: [&dyn Treatment; 6] = [
    &Characteristic,
    &DoNothing,
    &Hybrid,
    &Mirror,
    &ModifiedDoNothing,
    &Evolved,
];
