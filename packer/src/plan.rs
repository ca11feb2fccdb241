//! What is to be packed: the part of space, the grid over it and the volume of each layer.

pub(crate) mod to_rows;

use std::collections::HashMap;

use aero_geometry::kernel::{SMOOTHING_RATIO, SUPPORT};
use aero_geometry::parallel::prelude::*;
use aero_geometry::{Bounds, Shape, Vector};

use crate::cutting::cut_up;
use crate::grid::{Cell, Grid, volume_in};
use crate::lattice::lattice_grid;
use crate::mirror::Mirrors;
use crate::room::{Room, Side};
use crate::{PackError, PackOptions};

/// Spacings by which the packing reaches beyond the region, so that its cut ends do not show.
const BEYOND_REGION: f64 = 6.0;

/// Spacings beyond the region from which on seeds stay where the lattice put them.
const FAR_BEYOND: f64 = 3.0;

/// Cells per spacing in the plane: five puts the layers' middles between cell corners, and their
/// faces on them.
const FINENESS: f64 = 5.0;

/// A centre this near to a mirror plane, in edges of its cell, is on it.
const ON_PLANE: f64 = 1e-6;

/// Frame of one packing.
pub(crate) struct Plan<'a, const D: usize> {
    /// The body.
    pub shape: &'a dyn Shape<D>,
    /// What was asked for.
    pub options: &'a PackOptions<D>,
    /// Side of the surface.
    pub side: Side,
    /// Number of layers on this side.
    pub layers: usize,
    /// Mirror planes used: those that meet the packed box.
    pub mirrors: Mirrors,
    /// The part of space that is packed, above all mirror planes.
    pub bounds: Bounds<D>,
    /// Grid over the layers: in space the lattice's cells, in the plane finer ones.
    pub grid: Grid<D>,
    /// Its cells in the layers.
    pub band: Vec<Cell<D>>,
    /// The same, cut up where layers are not smooth.
    cut_band: Vec<Cell<D>>,
    /// Cells with parts that are left to rows, and how many layers have room in all parts of them.
    of_rows: HashMap<[i64; D], usize>,
    /// Volume of the packed part of space that is deeper than all layers.
    pub core_volume: f64,
    /// Volume of all layers inside the region, images included.
    pub shell_volume: f64,
    /// How exactly a point has to meet its level.
    pub tolerance: f64,
}

impl<'a, const D: usize> Plan<'a, D> {
    /// Checks that the body can be packed and lays the grid. `margin` is how far beyond the body
    /// particles may lie, in spacings.
    pub fn new(
        shape: &'a dyn Shape<D>,
        options: &'a PackOptions<D>,
        mirrors: &Mirrors,
        side: Side,
        margin: f64,
    ) -> Result<Self, PackError> {
        let spacing = options.spacing;
        let bounds = packed_box(shape, options, margin)?;
        // A far plane would have the body packed all the way to it.
        let mirrors = mirrors
            .only(|axis, position| (bounds.min[axis]..=bounds.max[axis]).contains(&position));
        let bounds = mirrors.fundamental(&bounds);
        let layers = match side {
            Side::Ghosts => options.layers,
            Side::Fluid => options.fluid_layers,
        };
        let mut grid = lattice_grid(&mirrors, &options.anchor, spacing);
        if D == 2 {
            // The contours' grid has corners on the mirror planes and at the ends of the region.
            grid.step = spacing / FINENESS;
            grid.origin = Vector::from_fn(|k, _| {
                let free = options
                    .region
                    .map_or(options.anchor[k], |region| region.min[k]);
                mirrors.plane(k).unwrap_or(free)
            });
        }
        let depth = layers as f64 * spacing;
        let range = match side {
            Side::Ghosts => (-depth, 0.0),
            Side::Fluid => (0.0, depth),
        };
        let (mut band, beyond) = grid.band(shape, &bounds, range, spacing)?;
        band.par_iter_mut().for_each(|cell| {
            cell.centre = mirrors.snapped(cell.centre, ON_PLANE * cell.step);
            cell.survey(shape, spacing, side);
        });
        let cut_band = if D == 2 && side == Side::Fluid {
            band.clone()
        } else {
            cut_up(shape, &band, &mirrors, (spacing, side))
        };
        let of_rows = to_rows::counted(&cut_band, layers, side);
        let reach = (0..D).fold(0.0, |r: f64, k| {
            r.max(bounds.min[k].abs()).max(bounds.max[k].abs())
        });
        let mut plan = Self {
            shape,
            options,
            side,
            layers,
            mirrors,
            bounds,
            grid,
            band,
            cut_band,
            of_rows,
            core_volume: beyond,
            shell_volume: 0.0,
            tolerance: 1e-12 * spacing + 8.0 * f64::EPSILON * reach,
        };
        plan.core_volume += plan.core_in_cells();
        plan.shell_volume = plan.shell_in_cells();
        Ok(plan)
    }

    /// Distance of a layer's middle: negative for ghosts.
    pub fn level(&self, layer: usize) -> f64 {
        self.sign() * (layer as f64 + 0.5) * self.options.spacing
    }

    /// Distance at which layer `layer` begins, seen from the surface.
    fn face(&self, layer: usize) -> f64 {
        self.sign() * layer as f64 * self.options.spacing
    }

    fn sign(&self) -> f64 {
        match self.side {
            Side::Ghosts => -1.0,
            Side::Fluid => 1.0,
        }
    }

    /// Radius of the flow's kernel.
    pub fn support(&self) -> f64 {
        SUPPORT * SMOOTHING_RATIO * self.options.spacing
    }

    /// Volume of one particle.
    pub fn particle_volume(&self) -> f64 {
        self.options.spacing.powi(D as i32)
    }

    /// Volume of each layer in the packed part of space.
    pub fn layer_volumes(&self) -> Vec<f64> {
        self.summed_volumes(|cell| self.part_above(cell))
    }

    /// Part of a cell in the packed part of space: a cell around sites on a mirror plane is half beyond it.
    pub fn part_above(&self, cell: &Cell<D>) -> f64 {
        self.mirrors.share(&cell.centre)
    }

    /// The layers' cells, cut up where layers are not smooth; parts of one cell follow each other.
    pub fn cells(&self) -> &[Cell<D>] {
        &self.cut_band
    }

    /// Cells of the layers that are too thin for them, those of rows aside.
    pub fn thin_cells(&self) -> Vec<Cell<D>> {
        let cells = self.cut_band.iter().copied();
        cells
            .filter(|cell| {
                cell.room == Room::Thin && self.is_inside_layers(cell) && !self.is_of_rows(cell)
            })
            .collect()
    }

    /// `place` where that is on the particles' side of the surface, else `home`.
    pub fn on_side(&self, place: &Vector<D>, home: &Vector<D>) -> Vector<D> {
        let depth = self.sign() * self.shape.signed_distance(place);
        *(if depth >= 0.0 { place } else { home })
    }

    /// Cells of the layers that have room for them.
    pub fn roomy_cells(&self) -> impl Iterator<Item = &Cell<D>> {
        let cells = self.cut_band.iter();
        cells.filter(|cell| cell.room != Room::Thin && self.is_inside_layers(cell))
    }

    /// True where some part is too thin for its layers.
    pub fn has_thin_cells(&self) -> bool {
        self.cut_band
            .iter()
            .any(|cell| cell.room == Room::Thin && self.is_inside_layers(cell))
    }

    /// True for cells with their centre in one of the layers.
    pub fn is_inside_layers(&self, cell: &Cell<D>) -> bool {
        let height = self.sign() * cell.distance;
        height > 0.0 && height < self.layers as f64 * self.options.spacing
    }

    /// Lets go of the cells once all particles are laid: of them all, those that the wall layer is measured by are kept.
    pub fn keep_wall_cells(&mut self) {
        self.band = Vec::new();
        self.cut_band = self.wall_cells().copied().collect();
    }

    /// Cells around the middle of the wall layer that have room for it.
    pub fn wall_cells(&self) -> impl Iterator<Item = &Cell<D>> {
        let level = self.level(0);
        let cells = self.roomy_cells();
        cells.filter(move |cell| (cell.distance - level).abs() < 0.5 * cell.step)
    }

    /// What of the cells is deeper than all layers.
    fn core_in_cells(&self) -> f64 {
        let end = self.face(self.layers);
        let cells = self.cut_band.iter();
        let near = cells.map(|cell| {
            let corner = cell.centre.add_scalar(-0.5 * cell.step);
            cell.fraction_below(end) * volume_in(&self.bounds, &corner, cell.step)
        });
        near.sum()
    }

    /// What of the cells is in a layer inside the region, images included.
    fn shell_in_cells(&self) -> f64 {
        let volumes = self.summed_volumes(|cell| {
            let mut count = usize::from(self.keeps(&cell.centre));
            self.mirrors.images(&cell.centre, |_, image| {
                count += usize::from(self.keeps(&image));
            });
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

    /// True for points of the margin around the region whose particles nothing holds on their other side.
    pub fn is_far_beyond_region(&self, point: &Vector<D>) -> bool {
        let near = FAR_BEYOND * self.options.spacing;
        (self.options.region).is_some_and(|region| !region.grown(near).contains(point))
    }

    /// How many particles inside the region a particle stands for: itself and its images, each
    /// with the part of its cell that is inside.
    pub fn part_in_region(&self, point: &Vector<D>) -> f64 {
        let part = |point: &Vector<D>| {
            self.options.region.map_or(1.0, |region| {
                (0..D)
                    .map(|k| {
                        let room = (point[k] - region.min[k]).min(region.max[k] - point[k]);
                        (room / self.options.spacing + 0.5).clamp(0.0, 1.0)
                    })
                    .product()
            })
        };
        let mut sum = part(point);
        self.mirrors.images(point, |_, image| sum += part(&image));
        sum
    }

    /// True for points inside the packed box or an image of it.
    pub fn inside(&self, point: &Vector<D>) -> bool {
        self.bounds.contains(&self.mirrors.folded(*point))
    }

    /// The parts of a cell that belong to each layer, as `(layer, volume)`.
    pub fn parts(&self, cell: &Cell<D>) -> impl Iterator<Item = (usize, f64)> {
        let step = cell.step;
        let spacing = self.options.spacing;
        let cell_volume = step.powi(D as i32);
        // A cell spans its own diagonal at most, so only few layers can share it.
        let reach = 0.5 * step * (D as f64).sqrt();
        let height = self.sign() * cell.distance;
        let first = ((height - reach) / spacing).floor().max(0.0) as usize;
        let end = (((height + reach) / spacing).ceil().max(0.0) as usize).min(self.layers);
        (first..end).filter_map(move |layer| {
            let near = cell.fraction_below(self.face(layer));
            let far = cell.fraction_below(self.face(layer + 1));
            let volume = (far - near).abs() * cell_volume;
            (volume > 0.0).then_some((layer, volume))
        })
    }

    fn summed_volumes(&self, weight: impl Fn(&Cell<D>) -> f64) -> Vec<f64> {
        let mut volumes = vec![0.0; self.layers];
        for cell in &self.cut_band {
            let weight = weight(cell);
            for (layer, volume) in self.parts(cell) {
                volumes[layer] += weight * volume;
            }
        }
        volumes
    }
}

/// The box in which particles are laid: the body and `margin` spacings around it, cut off a little
/// beyond the region.
fn packed_box<const D: usize>(
    shape: &dyn Shape<D>,
    options: &PackOptions<D>,
    margin: f64,
) -> Result<Bounds<D>, PackError> {
    let spacing = options.spacing;
    let body = shape.bounds();
    let size = body.size().max();
    if size < 2.0 * spacing {
        return Err(PackError::Coarse { spacing, size });
    }
    let mut bounds = body.grown(margin * spacing);
    if let Some(region) = &options.region {
        bounds = bounds.intersection(&region.grown(BEYOND_REGION * spacing));
    }
    let endless = |k: usize| !(bounds.min[k].is_finite() && bounds.max[k].is_finite());
    if let Some(axis) = (0..D).find(|&k| endless(k)) {
        return Err(PackError::Endless { axis });
    }
    if bounds.is_empty() {
        return Err(PackError::Empty);
    }
    Ok(bounds)
}
