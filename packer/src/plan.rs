//! What is to be packed: the part of space, the grids over it and the volume of each layer.

use aero_geometry::{Bounds, Shape, Vector};

use crate::grid::{Cell, Grid};
use crate::mirror::Mirrors;
use crate::{PackError, PackOptions};

/// Spacings by which the packing reaches beyond the region, so that its cut ends do not show.
const BEYOND_REGION: f64 = 6.0;

/// Cells per spacing over which layer volumes are summed. Five puts the layers' middles between
/// cell corners, and their faces on them.
const FINENESS: [f64; 2] = [5.0, 2.0];

/// Frame of one packing.
pub(crate) struct Plan<'a, const D: usize> {
    /// The body.
    pub shape: &'a dyn Shape<D>,
    /// What was asked for.
    pub options: &'a PackOptions<D>,
    /// Mirror planes used.
    pub mirrors: Mirrors,
    /// The part of space that is packed, above all mirror planes.
    pub bounds: Bounds<D>,
    /// Fine grid for volumes.
    pub fine: Grid<D>,
    /// Cells of the fine grid in and beside the ghost layers.
    pub band: Vec<Cell<D>>,
    /// How exactly a point has to meet its level.
    pub tolerance: f64,
}

impl<'a, const D: usize> Plan<'a, D> {
    /// Checks that the body can be packed and lays the grids.
    pub fn new(shape: &'a dyn Shape<D>, options: &'a PackOptions<D>) -> Result<Self, PackError> {
        let spacing = options.spacing;
        let body = shape.bounds();
        let mut bounds = body.grown(2.0 * spacing);
        if let Some(region) = &options.region {
            bounds = bounds.intersection(&region.grown(BEYOND_REGION * spacing));
        }
        if let Some(axis) =
            (0..D).find(|&k| !(bounds.min[k].is_finite() && bounds.max[k].is_finite()))
        {
            return Err(PackError::Endless { axis });
        }
        let size = body.size().max();
        if size < 2.0 * spacing {
            return Err(PackError::Coarse { spacing, size });
        }
        if bounds.is_empty() {
            return Err(PackError::Empty);
        }
        let mirrors = Mirrors::of(shape);
        let bounds = mirrors.fundamental(&bounds);
        let step = spacing / FINENESS[D - 2];
        let fine = Grid {
            origin: Vector::from_fn(|k, _| {
                mirrors.plane(k).unwrap_or_else(|| {
                    options
                        .region
                        .map_or(options.anchor[k], |region| region.min[k])
                })
            }),
            step,
        };
        let deep = -(options.layers as f64) * spacing;
        let band = fine.band(shape, &bounds, (deep - step, step), spacing)?;
        let reach = (0..D).fold(0.0, |r: f64, k| {
            r.max(bounds.min[k].abs()).max(bounds.max[k].abs())
        });
        Ok(Self {
            shape,
            options,
            mirrors,
            bounds,
            fine,
            band,
            tolerance: 1e-12 * spacing + 8.0 * f64::EPSILON * reach,
        })
    }

    /// Level of the middle of ghost layer `k`.
    pub fn level(&self, layer: usize) -> f64 {
        -(layer as f64 + 0.5) * self.options.spacing
    }

    /// Volume of each ghost layer in the packed part of space.
    pub fn layer_volumes(&self) -> Vec<f64> {
        self.summed_volumes(|_| 1.0)
    }

    /// Volume of all ghost layers inside the region, images included.
    pub fn shell_volume(&self) -> f64 {
        let volumes = self.summed_volumes(|cell| {
            let centre = self.fine.centre(&cell.index);
            let mut count = usize::from(self.keeps(&centre));
            self.mirrors
                .images(&centre, |_, image| count += usize::from(self.keeps(&image)));
            count as f64
        });
        volumes.iter().sum()
    }

    /// True for points inside the region.
    pub fn keeps(&self, point: &Vector<D>) -> bool {
        self.options
            .region
            .is_none_or(|region| region.contains(point))
    }

    fn summed_volumes(&self, weight: impl Fn(&Cell<D>) -> f64) -> Vec<f64> {
        let spacing = self.options.spacing;
        let step = self.fine.step;
        let cell_volume = step.powi(D as i32);
        let mut volumes = vec![0.0; self.options.layers];
        for cell in &self.band {
            let weight = weight(cell);
            let mut above = cell.fraction_below(0.0, step);
            for (layer, volume) in volumes.iter_mut().enumerate() {
                if above <= 0.0 {
                    break;
                }
                let below = cell.fraction_below(-(layer as f64 + 1.0) * spacing, step);
                *volume += weight * (above - below) * cell_volume;
                above = below;
            }
        }
        volumes
    }
}
