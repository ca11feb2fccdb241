//! Exact solutions, metrics, tables and charts. Takes plain arrays and shares no code with the
//! solver, which keeps the check independent.
//!
//! - [`exact`]: solutions of the Euler equations to compare with, one file each.
//! - [`metrics`]: numbers read off particles, one file each.
//! - [`pictures`]: particles, curves and charts as PNG or SVG.
//! - [`mod@reference`]: the small tables that lie in the case folders beside this crate.
//! - [`table`]: comparisons with a verdict, as text, Markdown and JSON.
//!
//! ```
//! use aero_validation::exact::oblique::{Strength, oblique_shock};
//! use aero_validation::table::{Subject, to_text};
//!
//! let theory = oblique_shock(2.5, 20_f64.to_radians(), 1.4, Strength::Weak)?;
//! let angle = Subject::new("wedge", "shock angle, deg", "oblique-shock theory");
//! let row = angle.relative(42.95, theory.angle.to_degrees(), 0.5);
//! assert!(row.pass);
//! println!("{}", to_text(&[row]));
//! # Ok::<(), aero_validation::exact::ExactError>(())
//! ```

pub mod exact;
pub mod metrics;
pub mod pictures;
pub mod reference;
pub mod table;
