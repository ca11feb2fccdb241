//! STL files: triangles in, triangles out.
//!
//! Reading keeps every triangle of every solid, and says what and where where a file is damaged.
//! Not responsible for making a body of the triangles: that is [`crate::Mesh`].

mod ascii;
mod binary;

use std::path::Path;

pub use binary::write_binary;

use crate::Vector;
use crate::error::GeometryError;

/// A triangle by its corners, counter-clockwise seen from outside.
pub type Facet = [Vector<3>; 3];

/// The length that one unit of a file stands for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Unit {
    /// Metres.
    #[default]
    Metre,
    /// Millimetres.
    Millimetre,
    /// Inches of 25.4 mm.
    Inch,
}

impl Unit {
    /// The unit in metres.
    pub fn metres(self) -> f64 {
        match self {
            Self::Metre => 1.0,
            Self::Millimetre => 1e-3,
            Self::Inch => 25.4e-3,
        }
    }
}

/// The triangles of a file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Soup {
    /// All triangles, solid after solid.
    pub facets: Vec<Facet>,
    /// Name and first triangle of each solid.
    pub solids: Vec<(String, usize)>,
}

impl Soup {
    /// Begins a solid; one without a name is called by its number.
    pub(crate) fn begin(&mut self, name: &str) {
        let name = if name.is_empty() {
            format!("solid {}", self.solids.len() + 1)
        } else {
            name.to_owned()
        };
        self.solids.push((name, self.facets.len()));
    }
}

/// Reads an ASCII or a binary file.
///
/// # Errors
/// A file that cannot be read, is empty, damaged or cut off.
pub fn read(path: &Path) -> Result<Soup, GeometryError> {
    let bytes = std::fs::read(path).map_err(|source| GeometryError::Read {
        path: path.to_owned(),
        source,
    })?;
    parse(bytes).map_err(|source| GeometryError::In {
        path: path.to_owned(),
        source: Box::new(source),
    })
}

/// Reads the contents of an ASCII or a binary file.
///
/// # Errors
/// See [`read`].
pub fn parse(bytes: Vec<u8>) -> Result<Soup, GeometryError> {
    if bytes.is_empty() {
        return Err(GeometryError::Stl("the file is empty".into()));
    }
    // The length decides before the first word does: binary headers may begin with "solid" too.
    let soup = if binary::promised_length(&bytes) != Some(bytes.len()) && ascii::is_ascii(&bytes) {
        ascii::parse(&bytes)?
    } else {
        binary::parse(bytes)?
    };
    if soup.facets.is_empty() {
        return Err(GeometryError::Stl("the file holds no triangles".into()));
    }
    Ok(soup)
}
