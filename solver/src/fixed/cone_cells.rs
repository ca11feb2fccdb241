//! What the flow about a cone makes of cells and faces.

use super::attached::AttachedShock;
use super::cone_field::Field;
use super::equation_of_state::EquationOfState;
use super::outline_piece::Piece;
use super::root::Plan;
use super::state::{Conserved, Primitive, dot};

/// Cells as far as this from the tip, in their own radii, hold what is at their point, and faces, in their lengths, see what is at their middle.
const FAR: f64 = 12.0;

/// Places of Gauss on a segment, in parts of its half length.
const GAUSS: f64 = 0.577_350_269_189_625_8;

/// Gas at a place as seen from the tip: in `front` ahead of the shock of a cone, and of its `field` behind.
fn at<const D: usize>(
    front: &Primitive<D>,
    shock: &AttachedShock<D>,
    field: &Field<D>,
    place: &[f64; D],
) -> Primitive<D> {
    if dot(place, &shock.normal) < 0.0 {
        field.at(place)
    } else {
        *front
    }
}

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
    if !is_cut && cell.away() > FAR * cell.radius {
        let there = field.at(&cell.point);
        return (there, there.pressure);
    }
    let (mut sum, mut all) = (Conserved::ZERO, 0.0);
    let (mut pressed, mut areas) = (0.0, 0.0);
    for piece in &*cell.pieces {
        let corners = [&cell.point, &piece.corners[0], &piece.corners[1]];
        let area = {
            let [a, b, c] = corners;
            let arm = |p: &[f64; D], k: usize| p[k] - a[k];
            0.5 * (arm(b, 0) * arm(c, 1) - arm(b, 1) * arm(c, 0)).abs()
        };
        // The middles of the four parts that halves of the sides make.
        for weights in [[4.0, 1.0, 1.0], [1.0, 4.0, 1.0], [1.0, 1.0, 4.0], [2.0; 3]] {
            let place: [f64; D] = std::array::from_fn(|k| {
                let each = corners.iter().zip(weights);
                each.map(|(corner, weight)| corner[k] * weight).sum::<f64>() / 6.0
            });
            let weight = area * field.radius(&place).max(0.0);
            let there = at(front, shock, field, &place);
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
    if heights.iter().all(|height| *height < 0.0) {
        let middle: [f64; D] = std::array::from_fn(|k| 0.5 * (from[k] + to[k]));
        if dot(&middle, &middle) > (FAR * piece.size).powi(2) {
            return take(&field.at(&middle), 1.0);
        }
    }
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
            let there = at(front, shock, field, &place);
            take(&there, weight / all);
        }
    }
}

#[cfg(test)]
mod tests {
    use aero_geometry::Vector;
    use approx::assert_relative_eq;

    use super::*;
    use crate::fixed::bend::Bend;
    use crate::fixed::state::front;
    use crate::gas::IdealGas;

    const AIR: IdealGas = IdealGas::new(1.4);

    /// The shock of a cone of 20 degrees at Mach 3, which rises by 29.6.
    fn shock() -> AttachedShock<2> {
        AttachedShock::at_apex(&AIR, &front(), &Bend::ramp(20.0, 1.0)).expect("a shock")
    }

    /// A square around a point, half as wide as this.
    fn square(middle: [f64; 2], half: f64) -> Plan<2> {
        let middle = Vector::from(middle);
        let ways = [[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0]].map(Vector::from);
        let pieces = ways.map(|way| Piece::new(&(middle + way * half), &way, 2.0 * half));
        Plan::new(0, middle, pieces.to_vec()).expect("a square")
    }

    /// Against a thousand small squares: by rings, and the pressure by area.
    #[test]
    fn a_cell_holds_the_mean_of_its_rings() {
        let (shock, front) = (shock(), front());
        let field = shock.field.as_ref().expect("a field");
        for (middle, least) in [([2.0, 0.95], 0.03), ([3.0, 1.25], 1e-3)] {
            let cell = square(middle, 0.25);
            let (found, pressed) = mean(&AIR, &front, &shock, field, &cell);
            let (mut sum, mut all, mut area) = (Conserved::ZERO, 0.0, 0.0);
            for n in 0..1024 {
                let place = [n % 32, n / 32].map(|n| (f64::from(n) + 0.5) / 64.0 - 0.25);
                let place = [middle[0] + place[0], middle[1] + place[1]];
                let is_behind = dot(&place, &shock.normal) < 0.0;
                let there = if is_behind { field.at(&place) } else { front };
                sum = sum.plus(place[1], &there.conserved(&AIR));
                all += place[1];
                area += there.pressure / 1024.0;
            }
            let exact = Conserved::ZERO.plus(1.0 / all, &sum).primitive(&AIR);
            assert_relative_eq!(found.density, exact.density, max_relative = least);
            assert_relative_eq!(found.pressure, exact.pressure, max_relative = least);
            assert_relative_eq!(pressed, area, max_relative = least);
        }
    }

    /// A face across the shock lets through what is on either side, ring by ring; on the cone there is what tables say [Sims 1964, NASA SP-3004].
    #[test]
    fn a_face_is_parted_where_the_shock_crosses_it() {
        let (shock, front) = (shock(), front());
        let field = shock.field.as_ref().expect("a field");
        let rise = (shock.normal[0] / -shock.normal[1]).abs();
        let up = Vector::from([1.0, 0.0]);
        // From the cone to as far above the shock as the cone is below.
        let [low, middle] = [f64::to_radians(20.0).tan(), rise];
        let high = 2.0 * middle - low;
        let face = Piece::new(&Vector::from([1.0, middle]), &up, high - low);
        let (mut ahead, mut behind) = (0.0, 0.0);
        along(&front, &shock, field, &face, &mut |state, part| {
            if state.pressure > 1.0 {
                behind += part;
            } else {
                ahead += part;
            }
        });
        assert_relative_eq!(ahead + behind, 1.0, epsilon = 1e-12);
        let rings = (high * high - middle * middle) / (high * high - low * low);
        assert_relative_eq!(ahead, rings, epsilon = 1e-9);
        assert_relative_eq!(shock.rear.pressure, 2.790_9, epsilon = 1e-4);
        assert_relative_eq!(field.at(&[1.0, low]).pressure, 2.790_9, epsilon = 1e-4);
    }
}
