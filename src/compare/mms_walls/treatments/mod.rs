//! The treatments, one file each, for verification alone.

mod adami;
mod colagrossi;
mod esmaili;
mod hashemi;
mod marongiu;
mod marrone;
mod randles;
mod takeda;

use super::treatment::Treatment;

pub use adami::Adami;
pub use colagrossi::Colagrossi;
pub use esmaili::Esmaili;
pub use hashemi::Hashemi;
pub use marongiu::Marongiu;
pub use marrone::Marrone;
pub use randles::RandlesLibersky;
pub use takeda::Takeda;

/// All of them, in the order of the paper's table.
pub static ALL: [&dyn Treatment; 8] = [
    &Adami,
    &Colagrossi,
    &Esmaili,
    &Hashemi,
    &Marongiu,
    &Marrone,
    &RandlesLibersky,
    &Takeda,
];
