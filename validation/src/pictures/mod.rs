//! Pictures of runs: particles coloured by a value, profiles against exact curves, histories, and
//! error against computing time.
//!
//! PNG or SVG by the file's extension. The font is part of the program, so a picture looks the same
//! on every machine and needs nothing installed.

mod axes;
mod band;
mod bar;
mod canvas;
mod colour;
mod curve_page;
pub mod curves;
mod dashes;
mod font;
mod legend;
pub mod mosaic;
mod particle_page;
pub mod particles;
pub mod raster;
pub mod speed;
mod ticks;

pub use colour::{BLACK, Colour, schlieren, viridis};

use std::path::{Path, PathBuf};

/// Why a picture could not be made.
#[derive(Debug, thiserror::Error)]
pub enum PictureError {
    /// There is nothing to draw.
    #[error("picture `{0}`: no finite values to draw; check the run's last frame")]
    Empty(String),
    /// Arrays that belong together differ in length.
    #[error("picture `{title}`: {what} has {found} entries for {expected} particles")]
    Length {
        /// Title of the picture.
        title: String,
        /// The array.
        what: &'static str,
        /// Its length.
        found: usize,
        /// The number of particles.
        expected: usize,
    },
    /// The file's extension is neither `.png` nor `.svg`.
    #[error("cannot tell the format of `{}`: end its name in .png or .svg", .0.display())]
    UnknownFormat(PathBuf),
    /// The drawing backend or the file system failed.
    #[error("cannot write picture `{}`: {reason}", path.display())]
    Write {
        /// The file.
        path: PathBuf,
        /// What went wrong.
        reason: String,
    },
}

/// What a path asks for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Format {
    Png,
    Svg,
}

fn format_of(path: &Path) -> Result<Format, PictureError> {
    let extension = path.extension().map(std::ffi::OsStr::to_ascii_lowercase);
    match extension.as_ref().and_then(|e| e.to_str()) {
        Some("png") => Ok(Format::Png),
        Some("svg") => Ok(Format::Svg),
        _ => Err(PictureError::UnknownFormat(path.to_owned())),
    }
}
