//! Cells in space as the polyhedra that their faces bound.

use std::collections::HashMap;
use std::sync::Arc;

use aero_geometry::Vector;
use aero_geometry::parallel::prelude::*;

use super::bent_face::middle;
use super::cells::Cells;
use super::net::Net;
use super::polytope::Polytope;
use super::rim::{closed, polygon};
use super::root::{CORNERS, Piece};

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
struct Plane<const D: usize> {
    /// Unit normal, out of the cell.
    normal: Vector<D>,
    /// A point in it, of a face its middle, as seen from the cell's point.
    place: Vector<D>,
    /// The cell beyond a face.
    other: Option<u32>,
}

/// A cell as the polyhedron that its faces and walls bound.
#[derive(Clone, Debug)]
pub struct Hull<const D: usize> {
    /// What bounds it, as seen from the cell's point.
    pub pieces: Arc<[Piece<D>]>,
    /// Its volume.
    pub volume: f64,
    /// No corner is farther from the point.
    pub radius: f64,
    /// Numbers of the cells beyond its faces, and of the pieces that these are.
    beyond: Vec<(u32, u32)>,
}

impl<const D: usize> Hull<D> {
    /// Which piece of it the face to another cell is, where there is one.
    pub fn facet(&self, other: u32) -> Option<u32> {
        let mut all = self.beyond.iter().filter(|(cell, _)| *cell == other);
        let (_, facet) = all.next()?;
        all.next().is_none().then_some(*facet)
    }

    /// A cell that is convex.
    fn within(planes: &[Plane<D>]) -> Option<Self> {
        let offset = |plane: &Plane<D>| plane.normal.dot(&plane.place);
        let unit = planes.iter().map(offset).fold(0.0, f64::max);
        let end = Vector::repeat(ENDS * unit);
        let mut cell = Polytope::block(&-end, &end);
        for (label, plane) in (FIRST..).zip(planes) {
            cell.clip(&plane.normal, offset(plane), label, unit);
        }
        let of = |label: u32| {
            label
                .checked_sub(FIRST)
                .map(|label| &planes[label as usize])
        };
        // All of its sides are faces, or walls.
        let sides: Option<Vec<&Plane<D>>> =
            cell.facets.iter().map(|facet| of(facet.label)).collect();
        let rings = cell.facets.iter().map(|facet| {
            let corners = facet.corners.iter();
            corners
                .map(|&corner| cell.vertices[corner as usize])
                .collect()
        });
        let hull = Self::bounded(&rings.collect::<Vec<_>>())?;
        let beyond = (0..).zip(sides?);
        Some(Self {
            beyond: beyond
                .filter_map(|(number, side)| Some((side.other?, number)))
                .collect(),
            ..hull
        })
    }

    /// A cell that these polygons bound, of whatever shape; which of its faces they are the planes tell.
    fn of_rings(rings: &[&Vec<Vector<D>>], planes: &[Plane<D>]) -> Option<Self> {
        let rings: Vec<Vec<Vector<D>>> = rings.iter().map(|ring| (*ring).clone()).collect();
        let hull = Self::bounded(&rings)?;
        let unit = hull.volume.powf(1.0 / D as f64);
        let faces = planes
            .iter()
            .filter_map(|plane| Some((plane.other?, plane)));
        let centres: Vec<Vector<D>> = rings
            .iter()
            .map(|ring| polygon(0, closed(ring)).centre)
            .collect();
        // What two cells say of the face between them may differ a little.
        let beyond = faces.filter_map(|(other, plane)| {
            let lies_in = |(piece, centre): (&Piece<D>, &Vector<D>)| {
                let arm = centre - plane.place;
                let off = arm.dot(&plane.normal).abs() / unit;
                let is_it =
                    Vector::from(piece.normal).dot(&plane.normal) > 1.0 - EXACT && off < EXACT;
                is_it.then_some(arm.norm())
            };
            let all = hull.pieces.iter().zip(&centres);
            let each = (0..)
                .zip(all)
                .filter_map(|(number, one)| Some((lies_in(one)?, number)));
            let (_, number) = each.min_by(|a, b| a.0.total_cmp(&b.0))?;
            Some((other, number))
        });
        let beyond: Vec<(u32, u32)> = beyond.collect();
        Some(Self { beyond, ..hull })
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
            beyond: Vec::new(),
        })
    }
}

/// The hulls of these `wanted` cells, as far as they are as their faces say.
pub fn hulls<const D: usize>(
    net: &Net<D>,
    cells: &Cells<D>,
    wanted: &[u32],
) -> HashMap<u32, Hull<D>> {
    let planes = planes(net, cells, wanted);
    let hull = |(&i, planes): (&u32, &Vec<Plane<D>>)| {
        let first = cells.cornered.partition_point(|(cell, _)| *cell < i);
        let cornered = cells.cornered[first..].iter();
        let cornered = cornered.take_while(|(cell, _)| *cell == i);
        let rings: Vec<&Vec<Vector<D>>> = cornered.flat_map(|(_, rings)| rings).collect();
        let hull = if rings.is_empty() {
            Hull::within(planes)
        } else {
            Hull::of_rings(&rings, planes)
        };
        let volume = net.cell(i as usize).volume;
        hull.filter(|hull| (hull.volume / volume - 1.0).abs() < OFF)
    };
    let each: Vec<Option<Hull<D>>> = wanted.par_iter().zip(&planes).map(hull).collect();
    let found = wanted.iter().zip(each);
    found.filter_map(|(&i, hull)| Some((i, hull?))).collect()
}

/// What bounds each of these cells.
fn planes<const D: usize>(net: &Net<D>, cells: &Cells<D>, wanted: &[u32]) -> Vec<Vec<Plane<D>>> {
    let places: HashMap<u32, usize> = wanted.iter().copied().zip(0..).collect();
    let mut planes = vec![Vec::new(); wanted.len()];
    for block in &net.blocks {
        for face in &block.faces {
            let shape = &net.face_shapes[face.shape as usize];
            let normal = Vector::from(shape.area) / shape.size;
            let apart = Vector::from(shape.apart);
            // As seen from the first cell.
            let middle = middle(&Vector::zeros(), shape);
            for (i, other, back, way) in [
                (face.i, face.j, Vector::zeros(), 1.0),
                (face.j, face.i, apart, -1.0),
            ] {
                // A face between two blocks stands in both.
                if block.cells.contains(&(i as usize))
                    && let Some(&place) = places.get(&i)
                {
                    planes[place].push(Plane {
                        normal: normal * way,
                        place: middle - back,
                        other: Some(other),
                    });
                }
            }
        }
        let walls = block.walls.iter().map(|wall| {
            (
                wall.i,
                wall.foot - cells.points[wall.i as usize],
                &wall.image,
            )
        });
        let sides = block
            .sides
            .iter()
            .map(|side| (side.i, Vector::from(side.way()), &side.image));
        for (i, foot, image) in walls.chain(sides) {
            if let Some(&place) = places.get(&i) {
                planes[place].push(Plane {
                    normal: Vector::from(image.normal),
                    place: foot,
                    other: None,
                });
            }
        }
    }
    planes
}
