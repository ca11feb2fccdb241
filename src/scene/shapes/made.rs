//! A surface that a scene's shape stands for, ready to be packed.

use std::any::Any;
use std::sync::Arc;

use aero_geometry::Shape;
use aero_packer::{PackOptions, Packing, Warning, pack};

/// A surface in place, and what was done to its mesh.
#[derive(Clone, Debug)]
pub(crate) struct Made<const D: usize> {
    /// The surface.
    pub shape: Arc<dyn Shape<D>>,
    /// What was wrong with its mesh and what was done.
    pub repairs: Vec<String>,
    /// What the user should know about its mesh.
    pub warnings: Vec<Warning>,
}

impl<const D: usize> Made<D> {
    /// A surface without a mesh.
    pub(super) fn exact(shape: impl Shape<D> + 'static) -> Self {
        Self {
            shape: Arc::new(shape),
            repairs: Vec::new(),
            warnings: Vec::new(),
        }
    }

    /// Packs the surface; the report tells of its mesh too.
    pub(crate) fn pack(&self, options: &PackOptions<D>) -> Result<Packing<D>, String> {
        let mut packing = pack(self.shape.as_ref(), options).map_err(|error| error.to_string())?;
        let report = &mut packing.report;
        report.repairs.splice(0..0, self.repairs.iter().cloned());
        report.warnings.splice(0..0, self.warnings.iter().cloned());
        Ok(packing)
    }

    /// The same, where `E` is `D` under another name.
    pub(super) fn cast<const E: usize>(self) -> Option<Made<E>> {
        let any: Box<dyn Any> = Box::new(self);
        any.downcast().ok().map(|made| *made)
    }
}
