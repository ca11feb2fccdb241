//! Shapes as a scene names them.

use std::path::Path;
use std::sync::Arc;

use aero_geometry::Shape;
use aero_packer::{PackOptions, Packing, pack};
use serde::Deserialize;

use super::file::{PlaceEntry, StlEntry};

/// The surface of a body.
#[derive(Clone, Debug, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum ShapeEntry {
    /// A mesh from a file.
    Stl(StlEntry),
}

/// A surface in place, and what was done to its mesh.
#[derive(Clone, Debug)]
pub(crate) struct Made<const D: usize> {
    pub shape: Arc<dyn Shape<D>>,
    pub repairs: Vec<String>,
    pub warnings: Vec<String>,
}

impl<const D: usize> Made<D> {
    /// Packs the surface; the report tells of its mesh too.
    pub(crate) fn pack(&self, options: &PackOptions<D>) -> Result<Packing<D>, String> {
        let mut packing = pack(self.shape.as_ref(), options).map_err(|error| error.to_string())?;
        let report = &mut packing.report;
        report.repairs.splice(0..0, self.repairs.iter().cloned());
        report.warnings.splice(0..0, self.warnings.iter().cloned());
        Ok(packing)
    }
}

impl ShapeEntry {
    /// The surface in dimension `D`.
    pub(crate) fn make<const D: usize>(
        &self,
        _place: Option<&PlaceEntry>,
        _folder: &Path,
    ) -> Result<Made<D>, String> {
        Err(format!("bodies are not made yet: {self:?}"))
    }
}
