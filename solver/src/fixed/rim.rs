//! Loops of edges, and the faces that they bound.

use aero_geometry::Vector;

use super::part::PartFace;
use super::polytope::cross;

/// The edges of a loop.
pub fn closed<const D: usize>(
    points: &[Vector<D>],
) -> impl Iterator<Item = (Vector<D>, Vector<D>)> + Clone {
    (0..points.len()).map(|k| (points[k], points[(k + 1) % points.len()]))
}

/// Area and centroid of a plane loop in space.
pub fn polygon<const D: usize>(
    label: u32,
    outline: impl Iterator<Item = (Vector<D>, Vector<D>)> + Clone,
) -> PartFace<D> {
    let Some((base, _)) = outline.clone().next() else {
        return PartFace {
            label,
            area: Vector::zeros(),
            centre: Vector::zeros(),
        };
    };
    let doubled = |(from, to): (Vector<D>, Vector<D>)| cross(&(from - base), &(to - base));
    let area = outline
        .clone()
        .fold(Vector::<D>::zeros(), |sum, edge| sum + doubled(edge) * 0.5);
    let size = area.norm();
    if size == 0.0 {
        return PartFace {
            label,
            area,
            centre: base,
        };
    }
    let normal = area / size;
    let moment = outline.fold(Vector::<D>::zeros(), |sum, edge| {
        let third = (edge.0 - base + edge.1 - base) / 3.0;
        sum + third * (0.5 * doubled(edge).dot(&normal))
    });
    PartFace {
        label,
        area,
        centre: base + moment / size,
    }
}
