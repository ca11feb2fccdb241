//! Cells in space as the polyhedra that their faces bound.

use std::collections::HashMap;
use std::sync::Arc;

use aero_geometry::Vector;
use aero_geometry::parallel::prelude::*;

use super::bent_face::middle;
use super::cells::Cells;
use super::net::Net;
use super::outline_piece::{CORNERS, Piece};
use super::polytope::{Facet, Polytope};
use super::rim::{closed, polygon};

/// Parts of a cell's volume by which what bounds it may be off: where walls cut cells, faces know it no better.
const OFF: f64 = 0.01;

/// Parts of a length that are rounding.
const EXACT: f64 = 1e-4;

/// Corners that cuts with two planes may add to a piece.
const CUTS: usize = 4;

/// So far from a cell's point, in distances of its farthest face, it ends where no face does it.
const ENDS: f64 = 3.0;

/// Facets with this label or more are those of planes, in their order; those with less are where the box ends that planes were cut from.
const FIRST: u32 = 6;

/// What bounds a cell.
#[derive(Clone, Copy, Debug)]
enum Side<const D: usize> {
    /// A face of this shape, met from its first cell or from its second, and the cell beyond.
    Face {
        shape: u32,
        is_first: bool,
        other: u32,
    },
    /// A wall, or a side of the domain: its unit normal, out of the cell, and its middle, as seen from the cell's point.
    Other { normal: Vector<D>, place: Vector<D> },
}

/// The plane that a side of a cell lies in.
#[derive(Clone, Copy, Debug)]
struct Plane<const D: usize> {
    /// Unit normal, out of the cell.
    normal: Vector<D>,
    /// A point in it, of a face its middle, as seen from the cell's point.
    place: Vector<D>,
}

/// What a cell looks like, as seen from its point; of cells of a lattice it is the same.
#[derive(Clone, Debug)]
pub struct Solid<const D: usize> {
    /// What bounds it.
    pub pieces: Arc<[Piece<D>]>,
    /// Its volume.
    pub volume: f64,
    /// No corner is farther from the point.
    pub radius: f64,
    /// Which piece each side of the cell is.
    piece_of: Vec<Option<u32>>,
}

/// A cell as the polyhedron that its faces and walls bound.
#[derive(Clone, Debug)]
pub struct Hull<const D: usize> {
    /// What it looks like.
    pub solid: Arc<Solid<D>>,
    /// The cell beyond each of its sides.
    beyond: Box<[Option<u32>]>,
}

impl<const D: usize> Hull<D> {
    /// Which piece of it the face to another cell is, where there is one.
    pub fn facet(&self, other: u32) -> Option<u32> {
        let is_it = |beyond: &Option<u32>| *beyond == Some(other);
        let place = self.beyond.iter().position(is_it)?;
        let is_one = !self.beyond[place + 1..].iter().any(is_it);
        self.solid.piece_of[place].filter(|_| is_one)
    }
}

impl<const D: usize> Solid<D> {
    /// A cell that is convex.
    fn within(planes: &[Plane<D>]) -> Option<Self> {
        let offset = |plane: &Plane<D>| plane.normal.dot(&plane.place);
        let unit = planes.iter().map(offset).fold(0.0, f64::max);
        let end = Vector::repeat(ENDS * unit);
        let mut cell = Polytope::block(&-end, &end);
        for (label, plane) in (FIRST..).zip(planes) {
            cell.clip(&plane.normal, offset(plane), label, unit);
        }
        // All that bounds it is a face, or a wall.
        if cell.facets.iter().any(|facet| facet.label < FIRST) {
            return None;
        }
        let ring = |facet: &Facet| {
            let corners = facet.corners.iter();
            corners
                .map(|&corner| cell.vertices[corner as usize])
                .collect()
        };
        let rings: Vec<Vec<Vector<D>>> = cell.facets.iter().map(ring).collect();
        let mut solid = Self::bounded(&rings)?;
        solid.piece_of = vec![None; planes.len()];
        for (number, facet) in (0..).zip(&cell.facets) {
            solid.piece_of[(facet.label - FIRST) as usize] = Some(number);
        }
        Some(solid)
    }

    /// A cell that these polygons bound, of whatever shape; which of its sides they are the planes tell.
    fn of_rings(rings: &[Vec<Vector<D>>], planes: &[Plane<D>]) -> Option<Self> {
        let mut solid = Self::bounded(rings)?;
        let unit = solid.volume.powf(1.0 / D as f64);
        let centre = |ring: &Vec<Vector<D>>| polygon(0, closed(ring)).centre;
        let centres: Vec<Vector<D>> = rings.iter().map(centre).collect();
        // What two cells say of the face between them may differ a little.
        let piece_of = |plane: &Plane<D>| {
            let lies_in = |(piece, centre): (&Piece<D>, &Vector<D>)| {
                let arm = centre - plane.place;
                let off = arm.dot(&plane.normal).abs() / unit;
                let along = Vector::from(piece.normal).dot(&plane.normal);
                (along > 1.0 - EXACT && off < EXACT).then_some(arm.norm())
            };
            let all = (0..).zip(solid.pieces.iter().zip(&centres));
            let each = all.filter_map(|(number, one)| Some((lies_in(one)?, number)));
            let nearest = each.min_by(|a, b| a.0.total_cmp(&b.0));
            nearest.map(|(_, number)| number)
        };
        solid.piece_of = planes.iter().map(piece_of).collect();
        Some(solid)
    }

    fn bounded(rings: &[Vec<Vector<D>>]) -> Option<Self> {
        let (mut radius, mut volume) = (0.0_f64, 0.0);
        let mut pieces = Vec::with_capacity(rings.len());
        for ring in rings {
            if ring.len() + CUTS > CORNERS {
                return None;
            }
            let area = polygon(0, closed(ring)).area;
            let normal = area.try_normalize(0.0).unwrap_or_else(Vector::zeros);
            let piece = Piece::polygon(&normal, ring);
            radius = ring.iter().map(Vector::norm).fold(radius, f64::max);
            volume += piece.reach(&[0.0; D]);
            pieces.push(piece);
        }
        Some(Self {
            pieces: pieces.into(),
            volume,
            radius,
            piece_of: Vec::new(),
        })
    }
}

/// The hulls of these `wanted` cells, as far as they are as their faces say.
pub fn hulls<const D: usize>(
    net: &Net<D>,
    cells: &Cells<D>,
    wanted: &[u32],
) -> HashMap<u32, Hull<D>> {
    let sides = sides(net, cells, wanted);
    let solid = |i: u32, sides: &[Side<D>]| {
        let planes: Vec<Plane<D>> = sides.iter().map(|side| side.plane(net)).collect();
        let first = cells.cornered.partition_point(|(cell, _)| *cell < i);
        let cornered = cells.cornered[first..].iter();
        let cornered = cornered.take_while(|(cell, _)| *cell == i);
        let rings: Vec<Vec<Vector<D>>> = cornered.flat_map(|(_, rings)| rings.clone()).collect();
        let solid = if rings.is_empty() {
            Solid::within(&planes)
        } else {
            Solid::of_rings(&rings, &planes)
        };
        let volume = net.cell(i as usize).volume;
        let is_all = |solid: &Solid<D>| (solid.volume / volume - 1.0).abs() < OFF;
        solid.filter(is_all).map(Arc::new)
    };
    // Those of a lattice look alike: one of each kind is made.
    let mut kinds: HashMap<Vec<(u32, bool)>, Option<Arc<Solid<D>>>> = HashMap::new();
    let kind =
        |sides: &[Side<D>]| -> Option<Vec<(u32, bool)>> { sides.iter().map(Side::look).collect() };
    for (&i, sides) in wanted.iter().zip(&sides) {
        if let Some(kind) = kind(sides) {
            kinds.entry(kind).or_insert_with(|| solid(i, sides));
        }
    }
    let hull = |(&i, sides): (&u32, &Vec<Side<D>>)| {
        let solid = match kind(sides) {
            Some(kind) => kinds[&kind].clone(),
            None => solid(i, sides),
        };
        Some(Hull {
            solid: solid?,
            beyond: sides.iter().map(Side::beyond).collect(),
        })
    };
    let each: Vec<Option<Hull<D>>> = wanted.par_iter().zip(&sides).map(hull).collect();
    let found = wanted.iter().zip(each);
    found.filter_map(|(&i, hull)| Some((i, hull?))).collect()
}

impl<const D: usize> Side<D> {
    fn plane(&self, net: &Net<D>) -> Plane<D> {
        match *self {
            Self::Face {
                shape, is_first, ..
            } => {
                let shape = &net.face_shapes[shape as usize];
                let normal = Vector::from(shape.area) / shape.size;
                let middle = middle(&Vector::zeros(), shape);
                if is_first {
                    Plane {
                        normal,
                        place: middle,
                    }
                } else {
                    Plane {
                        normal: -normal,
                        place: middle - Vector::from(shape.apart),
                    }
                }
            }
            Self::Other { normal, place } => Plane { normal, place },
        }
    }

    /// What tells its plane; of what is no face nothing does.
    fn look(&self) -> Option<(u32, bool)> {
        match *self {
            Self::Face {
                shape, is_first, ..
            } => Some((shape, is_first)),
            Self::Other { .. } => None,
        }
    }

    fn beyond(&self) -> Option<u32> {
        match *self {
            Self::Face { other, .. } => Some(other),
            Self::Other { .. } => None,
        }
    }
}

/// What bounds each of these cells.
fn sides<const D: usize>(net: &Net<D>, cells: &Cells<D>, wanted: &[u32]) -> Vec<Vec<Side<D>>> {
    let places: HashMap<u32, usize> = wanted.iter().copied().zip(0..).collect();
    let mut found = vec![Vec::new(); wanted.len()];
    for block in &net.blocks {
        for face in &block.faces {
            for (i, other, is_first) in [(face.i, face.j, true), (face.j, face.i, false)] {
                // A face between two blocks stands in both.
                if block.cells.contains(&(i as usize))
                    && let Some(&place) = places.get(&i)
                {
                    found[place].push(Side::Face {
                        shape: face.shape,
                        is_first,
                        other,
                    });
                }
            }
        }
        let walls = block.walls.iter();
        let walls = walls.map(|wall| {
            let place = wall.foot - cells.points[wall.i as usize];
            (wall.i, place, &wall.image)
        });
        let sides = block.sides.iter();
        let sides = sides.map(|side| (side.i, Vector::from(side.way()), &side.image));
        for (i, place, image) in walls.chain(sides) {
            if let Some(&number) = places.get(&i) {
                found[number].push(Side::Other {
                    normal: Vector::from(image.normal),
                    place,
                });
            }
        }
    }
    found
}
