//! Points in pairs on both sides of the sharp edges of bodies.
//!
//! The gas on one side of a sharp edge goes one way, that on the other side another. A cell that holds both is as good as a blunt
//! nose of its own size: it raises the drag of a slender body and gives a symmetric one lift, wherever its edge happens to lie between the
//! points. A point whose cell holds such an edge becomes two, images of one another in the edge's bisector, which then is the face
//! between their cells.

use aero_geometry::Vector;
use aero_geometry::parallel::prelude::*;

use super::cloud::{Cloud, Place};
use super::part::{Part, PartWall};
use super::plot::{Plot, off_the_walls};
use super::voronoi::Voronoi;
use super::whole::Whole;

/// Cosine between the normals of two faces below which the edge between them is sharp: one of less than 60 degrees. Streams meet blunter ones with a
/// bow shock, or leave them.
const SHARP: f64 = -0.5;

/// Walls smaller than this, in spacings to their power, are what rounding leaves of a face beyond the bisector.
const SLIVER: f64 = 1e-6;

/// Distance of a pair's points from the bisector, in spacings: that of points half as far apart as others.
const APART: f64 = 0.25;

/// Half of the box, in spacings, at whose corners a cell is looked at for edges: points may have moved, and cells with them.
const LOOK: f64 = 0.7;

impl<const D: usize> Cloud<D> {
    /// The same with two points for each whose cell holds a sharp edge.
    #[must_use]
    pub(super) fn paired(mut self, plot: &Plot<'_, D>) -> Self {
        if D == 1 || plot.solids.is_empty() {
            return self;
        }
        let suspects: Vec<usize> = (0..self.places.len())
            .into_par_iter()
            .filter(|&number| may_hold_an_edge(plot, &self.places[number]))
            .collect();
        if suspects.is_empty() {
            return self;
        }
        let positions = self.positions();
        let voronoi = Voronoi::new(*plot, &self, &positions);
        let pairs: Vec<(usize, [Place<D>; 2])> = suspects
            .into_par_iter()
            .filter_map(|number| {
                let (cell, _) = voronoi.cell(number);
                let place = &self.places[number];
                let whole = Whole {
                    cell: &cell,
                    point: &place.position,
                    unit: place.spacing,
                    about_axis: plot.domain.is_axisymmetric(),
                    keeps_rings: false,
                };
                let parts = whole.parts(plot.solids);
                let bisector = Bisector::of(parts.first()?, place.spacing)?;
                Some((number, bisector.pair(plot, place)?))
            })
            .collect();
        for (number, [own, twin]) in pairs.into_iter().rev() {
            self.places[number] = own;
            self.places.insert(number + 1, twin);
        }
        self.number();
        self
    }
}

/// True where normals of the walls around a point look away from each other.
fn may_hold_an_edge<const D: usize>(plot: &Plot<'_, D>, place: &Place<D>) -> bool {
    let half = LOOK * place.spacing;
    if place.distance > half * (D as f64).sqrt() {
        return false;
    }
    let normals: Vec<Vector<D>> = (0..1_usize << D)
        .filter_map(|corner| {
            let step = Vector::from_fn(|k, _| if corner >> k & 1 == 0 { -half } else { half });
            let (_, closest) = plot.solids.closest(&(place.position + step))?;
            Some(closest.normal)
        })
        .collect();
    let mut pairs = normals
        .iter()
        .enumerate()
        .flat_map(|(number, a)| normals[..number].iter().map(move |b| a.dot(b)));
    pairs.any(|cosine| cosine < SHARP)
}

/// A plane through the edge, or between two faces that do not meet, from the cell's point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bisector<const D: usize> {
    /// Unit normal, to the side on which the cell's point is not.
    normal: Vector<D>,
    /// How far along it the plane lies.
    offset: f64,
}

impl<const D: usize> Bisector<D> {
    /// Of the two walls of a piece that look away from each other most, `n_a.(x - c_a) = n_b.(x - c_b)`; none where no walls do. `unit` is
    /// the spacing.
    pub fn of(part: &Part<D>, unit: f64) -> Option<Self> {
        let least = SLIVER * unit.powi(D as i32 - 1);
        let mut best: Option<(f64, Self)> = None;
        for (number, a) in part.walls.iter().enumerate() {
            for b in &part.walls[..number] {
                let [size_a, size_b] = [a, b].map(|wall| wall.area.norm());
                if a.body != b.body || size_a.min(size_b) < least {
                    continue;
                }
                let [to_a, to_b] = [-a.area / size_a, -b.area / size_b];
                let cosine = to_a.dot(&to_b);
                let is_best = best.is_none_or(|(known, _)| cosine < known);
                if cosine < SHARP && is_best && are_apart(a, b) {
                    best = Some((cosine, Self::between([a, b], [to_a, to_b])));
                }
            }
        }
        best.map(|(_, bisector)| bisector)
    }

    /// The pair that `place` becomes, itself and its image, where there is room for both.
    fn pair(&self, plot: &Plot<'_, D>, place: &Place<D>) -> Option<[Place<D>; 2]> {
        let foot = place.position + self.normal * self.offset;
        let near = APART * place.spacing;
        let pair = |apart: f64| {
            let own = self.moved(plot, place, &foot, -apart)?;
            let twin = self.moved(plot, place, &foot, apart)?;
            Some([own, Place { site: None, ..twin }])
        };
        pair(near).or_else(|| pair(self.offset.max(near)))
    }

    /// A point of a pair, off the walls and on its side of the plane.
    fn moved(
        &self,
        plot: &Plot<'_, D>,
        place: &Place<D>,
        foot: &Vector<D>,
        along: f64,
    ) -> Option<Place<D>> {
        let to = foot + self.normal * along;
        if !plot.domain.bounds.contains(&to) {
            return None;
        }
        let (position, distance, _) = off_the_walls(plot, to, place.spacing)?;
        let is_beyond = (position - foot).dot(&self.normal) * along > 0.0;
        is_beyond.then_some(Place {
            position,
            distance,
            is_moved: true,
            ..*place
        })
    }

    fn between([a, b]: [&PartWall<D>; 2], [to_a, to_b]: [Vector<D>; 2]) -> Self {
        let across = to_a - to_b;
        let size = across.norm();
        let offset = (to_a.dot(&a.centre) - to_b.dot(&b.centre)) / size;
        let normal = across / size;
        if offset < 0.0 {
            Self {
                normal: -normal,
                offset: -offset,
            }
        } else {
            Self { normal, offset }
        }
    }
}

/// True where the body is between two of its faces, and not gas.
fn are_apart<const D: usize>(a: &PartWall<D>, b: &PartWall<D>) -> bool {
    let apart = b.centre - a.centre;
    a.area.dot(&apart) > 0.0 && b.area.dot(&apart) < 0.0
}

#[cfg(test)]
mod tests {
    use super::*;

    fn wall(area: [f64; 2], centre: [f64; 2]) -> PartWall<2> {
        PartWall {
            body: 0,
            facet: (1000.0 * centre[1]) as u32,
            area: area.into(),
            size: Vector::from(area).norm(),
            centre: centre.into(),
        }
    }

    fn of(walls: &[PartWall<2>]) -> Option<Bisector<2>> {
        let mut part = Part::new();
        part.walls = walls.to_vec();
        Bisector::of(&part, 1.0)
    }

    /// A wedge with its edge at (0.3, 0.2) that opens along x, turned by an angle.
    #[test]
    fn the_bisector_of_a_wedge_goes_through_its_edge() {
        for turn in [0.0, 0.4, 2.0, -1.3] {
            let rotation = nalgebra::Rotation2::new(turn);
            let edge = Vector::<2>::new(0.3, 0.2);
            let face = |slope: f64, length: f64| {
                let along = rotation * Vector::<2>::new(1.0, slope) * length;
                let into = rotation * Vector::<2>::new(slope.abs(), -slope.signum()) * length;
                wall(into.into(), (edge + along * 0.5).into())
            };
            let found = of(&[face(0.2, 0.3), face(-0.2, 0.7)]).unwrap();
            assert!((found.normal.dot(&edge) - found.offset).abs() < 1e-12);
            assert!(found.normal.dot(&(rotation * Vector::<2>::x())).abs() < 1e-12);
            assert!(found.offset >= 0.0);
            // A right angle is no sharp edge.
            assert_eq!(of(&[face(1.0, 0.3), face(-1.0, 0.7)]), None);
        }
    }

    #[test]
    fn a_plate_is_parted_in_its_middle_and_a_gap_is_not() {
        let plate = [wall([0.0, -1.0], [0.1, 0.4]), wall([0.0, 1.0], [0.1, 0.2])];
        let found = of(&plate).unwrap();
        assert!((found.normal.y * found.offset - 0.3).abs() < 1e-12);
        let gap = [wall([0.0, 1.0], [0.1, 0.4]), wall([0.0, -1.0], [0.1, 0.2])];
        assert_eq!(of(&gap), None);
        let sliver = [wall([0.0, -1e-9], [0.1, 0.4]), plate[1]];
        assert_eq!(of(&sliver), None);
    }
}
