//! Pieces of cells that lie behind a thin part: the neighbour on their side that they share the most area with takes
//! them, so that no cell straddles a body and the gas is divided without a gap.

use aero_geometry::Vector;

use super::cut_cell::CutCell;
use super::part::PartFace;

/// A piece smaller than this part of the gas in its cell is the splinter of an edge, and no pocket.
const SPLINTER: f64 = 1e-3;

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
    /// Pieces without an owner, splinters aside.
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
        // A face within a body has nobody beyond it.
        let link = cell.links.get((face.label as usize).checked_sub(2 * D)?)?;
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
        lost: homeless.iter().filter(|lost| is_pocket(cut, lost)).count(),
    }
}

/// True of a piece without an owner that is gas worth a word.
fn is_pocket<const D: usize>(cut: &[CutCell<D>], &(k, piece): &(usize, usize)) -> bool {
    let parts = &cut[k].parts;
    let all: f64 = parts.iter().map(|part| part.volume).sum();
    parts[piece].volume > SPLINTER * all
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

#[cfg(test)]
mod tests {
    use super::super::part::Part;
    use super::super::voronoi::{IN_BODY, Link};
    use super::*;

    /// A piece with faces to other cells of this row, each so long.
    fn piece(is_own: bool, cell: u32, faces: &[(u32, f64)]) -> Part<2> {
        let mut part = Part::new();
        part.is_own = is_own;
        for &(to, length) in faces {
            let apart = f64::from(to) - f64::from(cell);
            part.add_face(PartFace {
                label: 4 + to,
                area: Vector::from([length * apart.signum(), 0.0]),
                // Own pieces meet above, hidden ones below.
                centre: Vector::from([0.5 * apart, if is_own { 0.5 } else { -0.5 }]),
            });
        }
        part
    }

    /// The cell of a row of three, one apart, with a link to each of them under its own number.
    fn cell(number: u32, parts: Vec<Part<2>>) -> CutCell<2> {
        let link = |to: u32| Link {
            to,
            apart: Vector::from([f64::from(to) - f64::from(number), 0.0]),
        };
        let links = (0..3).map(link).collect();
        CutCell {
            number,
            links,
            parts,
            reach: 1.0,
        }
    }

    fn owners(cut: &[CutCell<2>]) -> Targets<2> {
        let nodes = Nodes::new(&[false; 3], cut);
        given(&nodes, cut)
    }

    #[test]
    fn a_hidden_piece_goes_to_the_neighbour_that_it_shares_most_with() {
        for (left, right, expected) in [(0.7, 0.2, 0), (0.2, 0.7, 2)] {
            let cut = [
                cell(0, vec![piece(true, 0, &[(1, left)])]),
                cell(
                    1,
                    vec![
                        piece(true, 1, &[(0, 0.9), (2, 0.9)]),
                        piece(false, 1, &[(0, left), (2, right)]),
                    ],
                ),
                cell(2, vec![piece(true, 2, &[(1, right)])]),
            ];
            let targets = owners(&cut);
            assert_eq!(targets.lost, 0);
            let target = targets.of_parts[1][1].unwrap();
            assert_eq!(target.cell, expected);
            assert_eq!(target.offset.x, f64::from(expected) - 1.0);
            assert_eq!(targets.of_parts[1][0].unwrap().cell, 1);
        }
    }

    #[test]
    fn a_piece_behind_another_goes_where_that_one_goes() {
        let cut = [
            cell(
                0,
                vec![piece(true, 0, &[(1, 0.9)]), piece(false, 0, &[(1, 0.4)])],
            ),
            cell(
                1,
                vec![
                    piece(true, 1, &[(0, 0.9), (2, 0.9)]),
                    piece(false, 1, &[(0, 0.4), (2, 0.3)]),
                ],
            ),
            cell(2, vec![piece(true, 2, &[(1, 0.3)])]),
        ];
        let targets = owners(&cut);
        assert_eq!(targets.lost, 0);
        for k in [0, 1] {
            let target = targets.of_parts[k][1].unwrap();
            assert_eq!((target.cell, target.offset.x), (2, 2.0 - k as f64));
        }
    }

    #[test]
    fn a_piece_that_ends_within_a_body_goes_to_the_neighbour_beside_it() {
        // As in a gap much narrower than a cell, both of whose walls are cut by the plane that bounds cells within bodies.
        let mut hidden = piece(false, 1, &[(0, 0.1)]);
        hidden.add_face(PartFace {
            label: IN_BODY,
            area: Vector::from([0.0, 0.8]),
            centre: Vector::from([0.0, -0.4]),
        });
        let cut = [
            cell(0, vec![piece(true, 0, &[(1, 0.1)])]),
            cell(1, vec![piece(true, 1, &[(0, 0.9), (2, 0.9)]), hidden]),
            cell(2, vec![piece(true, 2, &[(1, 0.9)])]),
        ];
        let targets = owners(&cut);
        assert_eq!(targets.lost, 0);
        assert_eq!(targets.of_parts[1][1].unwrap().cell, 0);
    }

    #[test]
    fn a_pocket_without_a_point_is_lost_and_told() {
        let own = |number| cell(number, vec![piece(true, number, &[])]);
        for (volume, lost) in [(0.2, 1), (2e-3, 1), (5e-4, 0)] {
            let mut hidden = vec![piece(true, 1, &[]), piece(false, 1, &[])];
            (hidden[0].volume, hidden[1].volume) = (1.0, volume);
            let cut = [own(0), cell(1, hidden), own(2)];
            assert_eq!(owners(&cut).lost, lost, "{volume}");
        }
    }
}
