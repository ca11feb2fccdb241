//! Compressible flow around real bodies without a mesh: scenes, how they are run, and what they write.
//!
//! Every public function takes a scene of any dimension, so that the solver is compiled here and
//! nowhere above. The command line, the comparisons and the charts stand on it.

mod base64;
pub mod case;
pub mod check;
pub mod fly;
pub mod nearest;
pub mod output;
pub mod pack;
pub mod run;
pub mod sample;
pub mod scene;
