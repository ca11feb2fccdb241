//! Cells made by hand: lattices in a box, straight or bent by a map.

use aero_geometry::{Bounds, Vector};

use super::super::{Cells, Face, SideFace, WallFace, WallOwner};
use crate::method::{FixedPoints, Method};
use crate::problem::{Domain, Field, Initial, Problem, Side, State, WallKind};

/// A wall at rest that gas slides along.
pub const WALL: Side = Side::Wall {
    kind: WallKind::Slip,
    velocity: 0.0,
    acceleration: 0.0,
};

/// A problem in the box from zero to `counts * spacing`, at rest unless told otherwise.
pub fn problem<const D: usize>(
    counts: [usize; D],
    spacing: f64,
    sides: [[Side; 2]; D],
) -> Problem<D> {
    let max = Vector::from_fn(|k, _| counts[k] as f64 * spacing);
    let domain = Domain::new(Bounds::new(Vector::zeros(), max), sides);
    let at_rest = State::at_rest(1.0, 1.0 / 1.4);
    Problem {
        method: Method::Fixed(FixedPoints::default()),
        ..Problem::new(crate::gas::Gas::ideal(1.4), domain, at_rest, spacing)
    }
}

/// A start by position.
pub fn field<const D: usize>(
    state: impl Fn(&Vector<D>) -> State<D> + Send + Sync + 'static,
) -> Initial<D> {
    Initial::Field(Field(std::sync::Arc::new(state)))
}

/// The lattice of `problem` in its box.
pub fn lattice<const D: usize>(problem: &Problem<D>) -> Cells<D> {
    let dx = problem.resolution.lattice();
    let bounds = &problem.domain.bounds;
    let counts: [usize; D] = std::array::from_fn(|k| (bounds.size()[k] / dx).round() as usize);
    let mut places: Vec<[usize; D]> = vec![[0; D]];
    for k in 0..D {
        places = places
            .iter()
            .flat_map(|place| {
                (0..counts[k]).map(move |at| {
                    let mut place = *place;
                    place[k] = at;
                    place
                })
            })
            .collect();
    }
    places.sort_by_key(morton);
    let numbers: std::collections::HashMap<[usize; D], u32> =
        places.iter().copied().zip(0..).collect();
    let mut cells = Cells::default();
    let mut faces = Vec::new();
    let area = dx.powi(D as i32 - 1);
    let is_axisymmetric = problem.domain.is_axisymmetric();
    for (i, place) in (0_u32..).zip(&places) {
        let point = Vector::from_fn(|k, _| bounds.min[k] + (place[k] as f64 + 0.5) * dx);
        let radius = |r: f64| if is_axisymmetric { r } else { 1.0 };
        cells.points.push(point);
        let middle = if D > 1 { point[D - 1] } else { 0.0 };
        cells.volumes.push(dx.powi(D as i32) * radius(middle));
        for axis in 0..D {
            for end in [0, 1] {
                let sign = if end == 0 { -1.0 } else { 1.0 };
                let mut normal = Vector::<D>::zeros();
                normal[axis] = sign;
                let shift = if axis == D - 1 { 0.5 * sign * dx } else { 0.0 };
                let full = normal * (area * radius(middle + shift));
                let is_last = place[axis] == if end == 0 { 0 } else { counts[axis] - 1 };
                let side = problem.domain.sides[axis][end];
                let mut next = *place;
                if !is_last {
                    next[axis] = next[axis] + 2 * end - 1;
                } else if side == Side::Periodic {
                    next[axis] = if end == 0 { counts[axis] - 1 } else { 0 };
                } else {
                    let centre = point + normal * (0.5 * dx);
                    if matches!(side, Side::Wall { .. }) {
                        cells.walls.push(WallFace {
                            i,
                            area: full,
                            owner: WallOwner::Side {
                                axis: axis as u8,
                                end: end as u8,
                            },
                            curvature: nalgebra::SMatrix::zeros(),
                            foot: centre,
                            facet: 0,
                        });
                    } else {
                        cells.sides.push(SideFace {
                            i,
                            area: full,
                            axis: axis as u8,
                            end: end as u8,
                            centre,
                        });
                    }
                    continue;
                }
                let j = numbers[&next];
                if i < j {
                    faces.push(Face {
                        i,
                        j,
                        area: full,
                        apart: normal * dx,
                        skew: Vector::zeros(),
                    });
                }
            }
        }
    }
    faces.sort_by_key(|face: &Face<D>| (face.i, face.j));
    cells.faces = faces.into_iter().collect();
    cells
}

/// Interleaves the bits of an index, so that neighbours in space are near in the list.
fn morton<const D: usize>(place: &[usize; D]) -> u64 {
    let mut key = 0;
    for bit in 0..20 {
        for k in 0..D {
            key |= ((place[k] >> bit & 1) as u64) << (bit * D + k);
        }
    }
    key
}

/// Cells between the lines of a lattice that `map` bends, `counts` in the unit square; its edges are the sides of the problem.
pub fn bent(
    problem: &Problem<2>,
    counts: [usize; 2],
    map: impl Fn(f64, f64) -> Vector<2>,
) -> Cells<2> {
    let corner = |i: usize, j: usize| map(i as f64 / counts[0] as f64, j as f64 / counts[1] as f64);
    let mut places: Vec<[usize; 2]> = (0..counts[0])
        .flat_map(|i| (0..counts[1]).map(move |j| [i, j]))
        .collect();
    places.sort_by_key(morton);
    let numbers: std::collections::HashMap<[usize; 2], u32> =
        places.iter().copied().zip(0..).collect();
    let is_axisymmetric = problem.domain.is_axisymmetric();
    let radius = |y: f64| if is_axisymmetric { y } else { 1.0 };
    let middle = |[i, j]: [usize; 2]| {
        let corners = [
            corner(i, j),
            corner(i + 1, j),
            corner(i + 1, j + 1),
            corner(i, j + 1),
        ];
        let (mut sum, mut area) = (Vector::<2>::zeros(), 0.0);
        for triangle in [[0, 1, 2], [0, 2, 3]].map(|t| t.map(|c| corners[c])) {
            let [a, b, c] = triangle;
            let twice = (b - a).perp(&(c - a));
            sum += (a + b + c) / 3.0 * twice;
            area += 0.5 * twice;
        }
        (sum / (2.0 * area), area)
    };
    let mut cells = Cells::default();
    let mut faces = Vec::new();
    for (i, place) in (0_u32..).zip(&places) {
        let (point, area) = middle(*place);
        cells.points.push(point);
        cells.volumes.push(area.abs() * radius(point.y));
        let [x, y] = *place;
        let edges = [
            (0, 0, corner(x, y + 1), corner(x, y)),
            (0, 1, corner(x + 1, y), corner(x + 1, y + 1)),
            (1, 0, corner(x, y), corner(x + 1, y)),
            (1, 1, corner(x + 1, y + 1), corner(x, y + 1)),
        ];
        for (axis, end, from, to) in edges {
            let along = to - from;
            let centre = (from + to) * 0.5;
            let full = Vector::<2>::new(along.y, -along.x) * (radius(centre.y) * area.signum());
            let is_last = place[axis] == if end == 0 { 0 } else { counts[axis] - 1 };
            let mut next = *place;
            if is_last {
                let side = problem.domain.sides[axis][end];
                if matches!(side, Side::Wall { .. }) {
                    cells.walls.push(WallFace {
                        i,
                        area: full,
                        owner: WallOwner::Side {
                            axis: axis as u8,
                            end: end as u8,
                        },
                        curvature: nalgebra::SMatrix::zeros(),
                        foot: centre,
                        facet: 0,
                    });
                } else {
                    cells.sides.push(SideFace {
                        i,
                        area: full,
                        axis: axis as u8,
                        end: end as u8,
                        centre,
                    });
                }
                continue;
            }
            next[axis] = next[axis] + 2 * end - 1;
            let j = numbers[&next];
            if i < j {
                faces.push(Face {
                    i,
                    j,
                    area: full,
                    apart: middle(next).0 - point,
                    skew: Vector::zeros(),
                });
            }
        }
    }
    faces.sort_by_key(|face: &Face<2>| (face.i, face.j));
    cells.faces = faces.into_iter().collect();
    cells
}
