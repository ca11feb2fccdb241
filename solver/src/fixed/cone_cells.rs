//! What the flow about a cone makes of cells and faces.

use super::apex::Field;
use super::attached::AttachedShock;
use super::equation_of_state::EquationOfState;
use super::outline_piece::Piece;
use super::root::Plan;
use super::state::{Conserved, Primitive, dot};

/// Cells as far as this from the tip, in their own radii, hold what is at their point.
const FAR: f64 = 12.0;

/// Places of Gauss on a segment, in parts of its half length.
const GAUSS: f64 = 0.577_350_269_189_625_8;

/// The mean of a cell, ring by ring: gas in `front` ahead of the shock of a cone, and that of its `field` behind. With the mean of its pressure by area, which
/// its rings press outwards with.
pub fn mean<G: EquationOfState, const D: usize>(
    gas: &G,
    front: &Primitive<D>,
    shock: &AttachedShock<D>,
    field: &Field<D>,
    cell: &Plan<D>,
) -> (Primitive<D>, f64) {
    let is_cut = cell.height(&shock.normal).abs() < cell.radius;
    let away = dot(&cell.point, &cell.point).sqrt();
    if !is_cut && away > FAR * cell.radius {
        let there = field.at(&cell.point);
        return (there, there.pressure);
    }
    let (mut sum, mut all) = (Conserved::ZERO, 0.0);
    let (mut pressed, mut areas) = (0.0, 0.0);
    for piece in &*cell.pieces {
        let corners = [&cell.point, &piece.corners[0], &piece.corners[1]];
        let area = {
            let [a, b, c] = corners;
            let at = |p: &[f64; D], k: usize| p[k] - a[k];
            0.5 * (at(b, 0) * at(c, 1) - at(b, 1) * at(c, 0)).abs()
        };
        // The middles of the four parts that halves of the sides make.
        for weights in [[4.0, 1.0, 1.0], [1.0, 4.0, 1.0], [1.0, 1.0, 4.0], [2.0; 3]] {
            let place: [f64; D] = std::array::from_fn(|k| {
                let each = corners.iter().zip(weights);
                each.map(|(corner, weight)| corner[k] * weight).sum::<f64>() / 6.0
            });
            let weight = area * field.radius(&place).max(0.0);
            let there = if dot(&place, &shock.normal) < 0.0 {
                field.at(&place)
            } else {
                *front
            };
            sum = sum.plus(weight, &there.conserved(gas));
            all += weight;
            pressed += area * there.pressure;
            areas += area;
        }
    }
    let mean = Conserved::ZERO.plus(1.0 / all, &sum).primitive(gas);
    (mean, pressed / areas)
}

/// Hands out the states along a piece of an outline, and their parts of it, all around the axis.
pub fn along<const D: usize>(
    front: &Primitive<D>,
    shock: &AttachedShock<D>,
    field: &Field<D>,
    piece: &Piece<D>,
    take: &mut impl FnMut(&Primitive<D>, f64),
) {
    let [from, to] = [&piece.corners[0], &piece.corners[1]];
    let heights = [from, to].map(|end| dot(end, &shock.normal));
    let cut = heights[0] / (heights[0] - heights[1]);
    let ends = if (0.0..1.0).contains(&cut) {
        [[0.0, cut], [cut, 1.0]]
    } else {
        [[0.0, 0.0], [0.0, 1.0]]
    };
    let mut places = [([0.0; D], 0.0); 4];
    let mut all = 0.0;
    for (n, place) in places.iter_mut().enumerate() {
        let [start, end] = ends[n / 2];
        let side = if n % 2 == 0 { -GAUSS } else { GAUSS };
        let part = 0.5 * (start + end + side * (end - start));
        place.0 = std::array::from_fn(|k| from[k] + (to[k] - from[k]) * part);
        place.1 = 0.5 * (end - start) * field.radius(&place.0).max(0.0);
        all += place.1;
    }
    for (place, weight) in places {
        if weight > 0.0 {
            let there = if dot(&place, &shock.normal) < 0.0 {
                field.at(&place)
            } else {
                *front
            };
            take(&there, weight / all);
        }
    }
}
