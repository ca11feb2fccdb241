//! From triangles to a solid, by the way that was asked for.

use std::sync::Arc;

use crate::error::GeometryError;
use crate::stl::Soup;
use crate::{Mesh, Shape, Sheet, Watch};

/// What to do with triangles that enclose no solid.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Mending {
    /// Refuse them. Cracks and small holes are closed all the same.
    #[default]
    Refuse,
    /// Close all holes.
    Fill,
    /// Make them so many metres thick.
    Thicken(f64),
    /// Lay a closed surface around them that resolves this spacing, metres.
    Wrap(f64),
}

/// A solid made of triangles, and what was done to them.
#[derive(Clone, Debug)]
pub struct Solid {
    /// Its surface.
    pub shape: Arc<dyn Shape<3>>,
    /// What was wrong with the triangles and what was done, in sentences without a subject.
    pub repairs: Vec<String>,
}

impl Solid {
    /// The solid that the triangles of `soup` make by `mending`. `watch` is told how far it is.
    ///
    /// # Errors
    /// Triangles that do not enclose a solid; numbers out of range.
    pub fn new(soup: Soup, mending: Mending, watch: &Watch) -> Result<Self, GeometryError> {
        let of_mesh = |mesh: Mesh| Self {
            repairs: mesh.repairs().to_vec(),
            shape: Arc::new(mesh),
        };
        match mending {
            Mending::Refuse => Mesh::sound(soup, watch).map(of_mesh),
            Mending::Fill => Mesh::filled(soup, watch).map(of_mesh),
            Mending::Wrap(spacing) => Mesh::wrapped(&soup, spacing, watch).map(of_mesh),
            Mending::Thicken(thickness) => {
                let sheet = Sheet::new(&soup, thickness, watch)?;
                Ok(Self {
                    repairs: sheet.repairs().to_vec(),
                    shape: Arc::new(sheet),
                })
            }
        }
    }
}
