//! Parts of a section: what of each lies in the gas.

use aero_geometry::Vector;
use aero_geometry::parallel::prelude::*;

use crate::sample::{Lattice, Solids};

/// So many pieces along each axis a part is looked at in that a wall may cut.
const PIECES: usize = 2;

/// A part that lacks less than this is whole.
const ROUND_OFF: f64 = 1e-9;

/// What of a part of a section lies in the gas.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Part<const D: usize> {
    /// Its middle.
    pub(super) middle: Vector<D>,
    /// Its size.
    pub(super) area: f64,
}

/// A rectangle across an axis: its middle, and half its width along each axis.
#[derive(Clone, Copy, Debug)]
struct Piece<const D: usize> {
    middle: Vector<D>,
    half: Vector<D>,
}

/// The parts of a section across `axis` whose middles `lattice` has, as far as `solids` leave of them; those in bodies are left out.
pub(super) fn parts<const D: usize>(
    solids: &Solids<'_, D>,
    axis: usize,
    lattice: &Lattice<D>,
) -> Vec<Part<D>> {
    let others = (0..D).filter(|&k| k != axis);
    let area: f64 = others.map(|k| lattice.spacing[k]).product();
    let mut half = lattice.spacing * 0.5;
    half[axis] = 0.0;
    let numbers: Vec<usize> = (0..lattice.count()).collect();
    let parts = numbers.par_iter().map(|&number| {
        let middle = lattice.place(number);
        match solids.contact(&middle, half.norm()) {
            None => Some(Part { middle, area }),
            Some(contact) if contact.distance <= -half.norm() => None,
            Some(_) => cut(solids, &Piece { middle, half }, area),
        }
    });
    let parts: Vec<Option<Part<D>>> = parts.collect();
    parts.into_iter().flatten().collect()
}

/// What is left of a piece of this `area` that a wall may cut.
fn cut<const D: usize>(solids: &Solids<'_, D>, whole: &Piece<D>, area: f64) -> Option<Part<D>> {
    let along: Vec<usize> = (0..D).filter(|&k| whole.half[k] > 0.0).collect();
    let pieces = PIECES.pow(along.len() as u32);
    let (mut middle, mut total) = (Vector::<D>::zeros(), 0.0);
    for number in 0..pieces {
        let mut piece = *whole;
        for (n, &k) in along.iter().enumerate() {
            let place = number / PIECES.pow(n as u32) % PIECES;
            piece.half[k] = whole.half[k] / PIECES as f64;
            piece.middle[k] += piece.half[k] * (2.0 * place as f64 + 1.0 - PIECES as f64);
        }
        let (own, share) = gas(solids, &piece, &along);
        middle += own * share;
        total += share;
    }
    let part = total / pieces as f64;
    if part > 1.0 - ROUND_OFF {
        let middle = whole.middle;
        return Some(Part { middle, area });
    }
    (part > 0.0).then(|| Part {
        middle: middle / total,
        area: area * part,
    })
}

/// The middle of the gas in a piece, and what part of it that is, by the distances of its corners from the walls.
///
/// Between two corners a distance goes to zero in a straight line; of four, the part is `sum max(d, 0) / sum |d|`, which is exact for walls along
/// their sides and for those through the middle.
fn gas<const D: usize>(
    solids: &Solids<'_, D>,
    piece: &Piece<D>,
    along: &[usize],
) -> (Vector<D>, f64) {
    let reach = 2.0 * piece.half.norm();
    let (mut over, mut all) = (0.0, 0.0);
    let mut towards = Vector::<D>::zeros();
    for number in 0..1_usize << along.len() {
        let mut corner = Vector::<D>::zeros();
        for (n, &k) in along.iter().enumerate() {
            corner[k] = piece.half[k] * if number >> n & 1 == 0 { -1.0 } else { 1.0 };
        }
        let contact = solids.contact(&(piece.middle + corner), reach);
        let distance = contact.map_or(reach, |contact| contact.distance);
        over += distance.max(0.0);
        all += distance.abs();
        towards += corner * distance.signum();
    }
    let part = if all > 0.0 { over / all } else { 0.0 };
    // A wall between two corners leaves the gas at one of them.
    let way = towards / (1_usize << along.len()) as f64;
    (piece.middle + way * (1.0 - part), part)
}

#[cfg(test)]
mod tests {
    use aero_geometry::{Bounds, Shape, bodies};

    use super::*;

    #[test]
    fn a_section_ends_at_the_walls_wherever_its_parts_lie() {
        let ball = bodies::sphere(0.7).unwrap();
        let solids = Solids::section(&ball as &dyn Shape<3>);
        for shift in [0.0, 0.003, 0.011, 0.017] {
            let region = Bounds::new(Vector::<2>::new(0.2, shift), Vector::<2>::new(0.2, 1.0));
            let parts = parts(&solids, 0, &Lattice::middles(&region, 0.025));
            let length: f64 = parts.iter().map(|part| part.area).sum();
            let wall = (0.7_f64.powi(2) - 0.2_f64.powi(2)).sqrt();
            assert!((length - (1.0 - wall)).abs() < 1e-4, "{shift}: {length}");
            let ring: f64 = parts.iter().map(|part| part.area * part.middle[1]).sum();
            let exact = 0.5 * (1.0 - wall * wall);
            assert!((ring - exact).abs() < 1e-4, "{shift}: {ring}");
        }
    }

    #[test]
    fn a_section_around_a_ball_is_a_square_less_a_disc() {
        let ball = bodies::sphere(0.7).unwrap();
        let solids = Solids::<3>::section(&ball as &dyn Shape<3>);
        let region = Bounds::new(
            Vector::<3>::new(0.2, -1.0, -1.0),
            Vector::<3>::new(0.2, 1.0, 1.0),
        );
        let parts = parts(&solids, 0, &Lattice::middles(&region, 0.1));
        let area: f64 = parts.iter().map(|part| part.area).sum();
        let exact = 4.0 - std::f64::consts::PI * (0.49 - 0.04);
        assert!((area / exact - 1.0).abs() < 2e-3, "{area} {exact}");
    }

    #[test]
    fn without_a_wall_parts_are_whole() {
        let region = Bounds::new(Vector::<2>::new(0.2, 0.0), Vector::<2>::new(0.2, 1.0));
        let lattice = Lattice::middles(&region, 0.1);
        let parts = parts(&Solids::none(), 0, &lattice);
        for (n, part) in parts.iter().enumerate() {
            let middle = lattice.place(n);
            assert_eq!(
                *part,
                Part {
                    middle,
                    area: lattice.spacing[1]
                }
            );
        }
    }
}
