//! Everything that is written to disk, one format per file. Takes snapshots, never the solver's
//! own state, and decides nothing about when to write.

mod atomic;
mod background;
mod body_motion;
mod cells;
mod check_picture;
mod checkpoint;
mod draft;
mod earlier;
mod error;
mod field;
mod ghosts;
mod history;
mod line;
mod memory;
mod mirror;
mod packing;
mod packing_picture;
mod particles;
mod picture;
mod pvd;
mod reference;
mod rows;
mod summary;
mod surface;
mod vtk_xml;
mod vtp;

pub use atomic::write_json;
pub use background::Background;
pub use body_motion::BodyMotion;
pub use cells::write_cells;
pub use check_picture::draw_scene;
pub use checkpoint::{
    CHECKPOINT, CheckpointError, can_be_prolonged, close_checkpoint, read_checkpoint,
    remove_checkpoints, reopen_checkpoint,
};
pub use draft::Drafts;
pub use earlier::remove_frames;
pub use error::{OutputError, make_folder};
pub use field::write_field;
pub use history::{History, HistoryRow};
pub use line::{state_columns, state_row, write_line};
pub use memory::peak_memory;
pub use mirror::Mirrors;
pub use packing::write_packing;
pub use particles::write_frame;
pub use picture::{Caption, draw_curve, draw_plane};
pub use pvd::Collection;
pub use reference::Reference;
pub use rows::Rows;
pub use summary::{BodyCoefficients, BodySummary, Conservation, Particles, Summary};
pub use surface::write_surface;
