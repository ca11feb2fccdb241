//! Cells in space whose faces do not say what they look like: those in which surfaces meet, or that took a piece of another.

use std::collections::HashSet;

use aero_geometry::Vector;

use super::cut_cell::CutCell;
use super::merge::Target;
use super::part::Part;

/// The polygons that bound pieces of cells, each as seen from the point of its cell, by whose number they are sorted.
pub type Rings<const D: usize> = Vec<(u32, Vec<Vec<Vector<D>>>)>;

/// The pieces, among those of cells that were `cut`, of such cells, `targets` being the owners of them all; in the plane none.
pub fn cornered<const D: usize>(
    cut: &[CutCell<D>],
    targets: &[Vec<Option<Target<D>>>],
) -> Rings<D> {
    let mut rings = Rings::new();
    if D < 3 {
        return rings;
    }
    let pieces = || {
        let cells = cut.iter().zip(targets);
        cells.flat_map(|(cell, targets)| {
            let owned = cell.parts.iter().zip(targets);
            owned.filter_map(|(part, target)| Some((cell.number, part, target.as_ref()?)))
        })
    };
    let is_meant = |(number, part, target): &(u32, &Part<D>, &Target<D>)| {
        target.cell != *number || part.walls.len() > 1
    };
    let found: HashSet<u32> = pieces()
        .filter(is_meant)
        .map(|(.., target)| target.cell)
        .collect();
    for (_, part, target) in pieces() {
        if found.contains(&target.cell) {
            let seen = |place: &Vector<D>| place - target.offset;
            let each = part.rings.iter();
            let each = each.map(|ring| ring.iter().map(seen).collect());
            rings.push((target.cell, each.collect()));
        }
    }
    rings.sort_by_key(|(cell, _)| *cell);
    rings
}
