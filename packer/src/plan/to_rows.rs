//! What of the layers' cells is left to rows mid-way between two faces, and where those may be.

use std::collections::HashMap;

use aero_geometry::Vector;

use super::Plan;
use crate::grid::Cell;
use crate::room::Side;
use crate::room_inside::has_room;

/// Places per spacing at which cells are looked up on a way through them.
const ON_THE_WAY: usize = 2;

/// Depth of the first of them, in spacings.
const JUST_INSIDE: f64 = 0.1;

/// A piece of a thin part: its centre and volume.
pub(crate) type Bit<const D: usize> = (Vector<D>, f64);

impl<const D: usize> Plan<'_, D> {
    /// True where what `full` layers of ghosts leave belongs to rows mid-way between two faces: in space everywhere, in the plane where
    /// not even the wall layers of both faces fit. What deeper layers leave there is a slender wedge as a rule, and filled by volume.
    pub fn has_rows_below(full: usize) -> bool {
        D == 3 || full == 0
    }

    pub(super) fn is_of_rows(&self, cell: &Cell<D>) -> bool {
        is_of_rows(cell, self.side)
    }

    /// False at a place on `level`, in space, where its layer has no room and a row stands: the wall layer of what carries a fin must not
    /// creep up the fin.
    pub fn may_stand(&self, place: &Vector<D>, level: f64) -> bool {
        let layer = (level.abs() / self.options.spacing).floor() as usize;
        let full = self.of_rows.get(&self.grid.index(place));
        D == 2 || full.is_none_or(|&full| layer < full) || {
            let seen = self.shape.closest(place);
            let seen = (place, seen.distance, &seen.normal);
            has_room(self.shape, seen, layer, self.options.spacing)
        }
    }

    /// True where there may be parts that are left to rows straight below a place of the surface: in space, where a cell on the way down
    /// through the layers has some.
    pub fn may_have_rows_below(&self, point: &Vector<D>, normal: &Vector<D>) -> bool {
        D == 2
            || (0..=ON_THE_WAY * self.layers).any(|n| {
                let depth = (n as f64 / ON_THE_WAY as f64).max(JUST_INSIDE);
                let below = point - depth * self.options.spacing * normal;
                let cell = self.grid.index(&self.mirrors.folded(below));
                self.of_rows.contains_key(&cell)
            })
    }

    /// The pieces of the parts of rows: centres and volumes.
    pub fn row_bits(&self) -> Vec<Bit<D>> {
        let cells = self.cut_band.iter().filter(|cell| self.is_of_rows(cell));
        cells
            .map(|cell| (cell.centre, self.thin_part(cell)))
            .filter(|bit: &Bit<D>| bit.1 > 0.0)
            .collect()
    }

    /// Volume of the parts that are too thin for the layers, those of rows aside.
    pub fn thin_volume(&self) -> f64 {
        let cells = self.cut_band.iter().filter(|cell| !self.is_of_rows(cell));
        cells.map(|cell| self.thin_part(cell)).sum()
    }

    /// Volume of the part of a cell that is too thin for its layers.
    fn thin_part(&self, cell: &Cell<D>) -> f64 {
        if cell.full >= self.layers {
            return 0.0;
        }
        let thin = self.parts(cell).filter(|part| part.0 >= cell.full);
        thin.map(|part| part.1).sum()
    }

    /// True where a layer has no room in a cell and leaves it to rows.
    pub fn leaves_to_rows(&self, cell: &Cell<D>, layer: usize) -> bool {
        layer >= cell.full && self.is_of_rows(cell)
    }
}

/// The cells of `band` with parts that are left to rows, and how many of so many `layers` have room in all parts of them.
pub(super) fn counted<const D: usize>(
    band: &[Cell<D>],
    layers: usize,
    side: Side,
) -> HashMap<[i64; D], usize> {
    let mut counted = HashMap::new();
    for cell in band {
        if cell.full < layers && is_of_rows(cell, side) {
            let full = counted.entry(cell.index).or_insert(cell.full);
            *full = cell.full.min(*full);
        }
    }
    counted
}

fn is_of_rows<const D: usize>(cell: &Cell<D>, side: Side) -> bool {
    side == Side::Ghosts && Plan::<D>::has_rows_below(cell.full)
}
