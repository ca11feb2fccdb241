//! Pieces of cells that lie behind a thin part: the neighbour on their side that they share the most area with takes
//! them, so that no cell straddles a body and the gas is divided without a gap.

use aero_geometry::Vector;

use super::build::CutCell;
use super::part::PartFace;

/// Rounds in which pieces behind pieces find an owner.
const ROUNDS: usize = 8;

/// Who has a piece, and where that cell's point is from the point the piece was cut for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Target<const D: usize> {
    /// The cell.
    pub cell: u32,
    /// From the first point to the cell's.
    pub offset: Vector<D>,
}

/// Owners of all pieces of the cells that were cut.
#[derive(Clone, Debug)]
pub struct Targets<const D: usize> {
    /// By cell and piece.
    pub of_parts: Vec<Vec<Option<Target<D>>>>,
    /// Pieces that changed hands.
    pub given: usize,
    /// Pieces without an owner.
    pub lost: usize,
}

/// Which cells were cut.
#[derive(Clone, Debug)]
pub struct Nodes {
    /// Place among the cells that were cut, by cell.
    place: Vec<u32>,
}

impl Nodes {
    /// Of all cells.
    pub fn new<const D: usize>(is_plain: &[bool], cut: &[CutCell<D>]) -> Self {
        let mut place = vec![u32::MAX; is_plain.len()];
        for (k, cell) in cut.iter().enumerate() {
            place[cell.number as usize] = k as u32;
        }
        Self { place }
    }

    /// True of cells that were not cut.
    pub fn is_plain(&self, cell: u32) -> bool {
        self.place[cell as usize] == u32::MAX
    }

    /// The cell, among those cut, and its piece on the other side of a face of cell `k`.
    pub fn across<const D: usize>(
        &self,
        cut: &[CutCell<D>],
        k: usize,
        face: &PartFace<D>,
    ) -> Option<(usize, usize)> {
        let cell = &cut[k];
        let link = &cell.links[(face.label as usize).checked_sub(2 * D)?];
        let other = self.place[link.to as usize] as usize;
        let beyond = cut.get(other)?;
        if beyond.parts.len() < 2 {
            return Some((other, 0));
        }
        let mut best: Option<(f64, usize)> = None;
        for (piece, part) in beyond.parts.iter().enumerate() {
            for back in &part.faces {
                let Some(number) = (back.label as usize).checked_sub(2 * D) else {
                    continue;
                };
                let Some(way) = beyond.links.get(number) else {
                    continue;
                };
                if way.to != cell.number {
                    continue;
                }
                let miss = (way.apart + link.apart).norm()
                    + (back.centre + link.apart - face.centre).norm();
                if best.is_none_or(|(least, _)| miss < least) {
                    best = Some((miss, piece));
                }
            }
        }
        best.map(|(_, piece)| (other, piece))
    }
}

/// Gives every piece to somebody.
pub fn given<const D: usize>(nodes: &Nodes, cut: &[CutCell<D>]) -> Targets<D> {
    let mut of_parts: Vec<Vec<Option<Target<D>>>> = cut
        .iter()
        .map(|cell| {
            let own = Target {
                cell: cell.number,
                offset: Vector::zeros(),
            };
            let parts = cell.parts.iter();
            parts.map(|part| part.is_own.then_some(own)).collect()
        })
        .collect();
    let mut homeless: Vec<(usize, usize)> = Vec::new();
    for (k, cell) in cut.iter().enumerate() {
        homeless.extend((1..cell.parts.len()).map(|piece| (k, piece)));
    }
    let total = homeless.len();
    for _ in 0..ROUNDS {
        let found: Vec<Option<Target<D>>> = homeless
            .iter()
            .map(|&(k, piece)| taker(nodes, cut, &of_parts, k, piece))
            .collect();
        for (&(k, piece), target) in homeless.iter().zip(found) {
            of_parts[k][piece] = target;
        }
        homeless.retain(|&(k, piece)| of_parts[k][piece].is_none());
        if homeless.is_empty() {
            break;
        }
    }
    Targets {
        of_parts,
        given: total - homeless.len(),
        lost: homeless.len(),
    }
}

/// The owner of the piece across the largest face.
fn taker<const D: usize>(
    nodes: &Nodes,
    cut: &[CutCell<D>],
    of_parts: &[Vec<Option<Target<D>>>],
    k: usize,
    piece: usize,
) -> Option<Target<D>> {
    let mut best: Option<(f64, Target<D>)> = None;
    for face in &cut[k].parts[piece].faces {
        let Some((other, beyond)) = nodes.across(cut, k, face) else {
            continue;
        };
        let Some(target) = of_parts[other][beyond] else {
            continue;
        };
        let area = face.area.norm();
        if best.is_none_or(|(most, _)| area > most) {
            let link = &cut[k].links[face.label as usize - 2 * D];
            let offset = link.apart + target.offset;
            best = Some((area, Target { offset, ..target }));
        }
    }
    best.map(|(_, target)| target)
}
