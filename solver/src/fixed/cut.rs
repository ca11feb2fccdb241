//! A cell without what lies in the bodies: its pieces, their volumes, faces and walls.
//!
//! A piece that the cell's own point does not see lies behind a thin part; it is somebody else's.

use aero_geometry::Vector;

use super::edges::Edges;
use super::part::{Part, PartFace, PartWall, own_first};
use super::polytope::{Facet, cross};
use super::rim::{closed, polygon};
use super::section::{Along, Piece, Plane, Section, Stretch};
use super::solids::{Line, Solids};
use super::whole::Whole;

/// How many of a piece's edges are looked at from the cell's point.
const LOOKS: usize = 4;

impl<const D: usize> Whole<'_, D> {
    /// The gas in the cell, piece by piece.
    pub fn parts(&self, solids: &Solids<D>) -> Vec<Part<D>> {
        let reach = self.cell.reach_squared().sqrt();
        if solids.distance(self.point) > reach * (1.0 + 1e-9) + 1e-9 * self.unit {
            return vec![self.uncut()];
        }
        let edges = Edges::new(self, solids);
        match D {
            1 => vec![self.interval(solids)],
            2 => self.plane_parts(solids, &edges),
            _ => self.space_parts(solids, &edges),
        }
    }

    fn interval(&self, solids: &Solids<D>) -> Part<D> {
        let mut part = Part::new();
        for facet in &self.cell.facets {
            let end = self.cell.vertices[facet.corners[0] as usize];
            let line = Line {
                from: *self.point,
                to: self.point + end,
                unit: self.unit,
            };
            let heights = [line.from, line.to].map(|p| solids.height(&p));
            let area = Vector::repeat(end[0].signum());
            let stop = solids.crossings(&line, heights).first().copied();
            let centre = end * stop.unwrap_or(1.0);
            part.volume += centre[0].abs();
            match stop.and_then(|_| solids.closest(&(self.point + centre))) {
                Some((body, closest)) => part.add_wall(PartWall {
                    body,
                    facet: closest.face,
                    area,
                    size: 1.0,
                    centre,
                }),
                None => part.add_face(PartFace {
                    label: facet.label,
                    area,
                    centre,
                }),
            }
        }
        part
    }

    fn section<'a>(&'a self, solids: &'a Solids<D>, plane: Plane<D>) -> Section<'a, D> {
        Section {
            solids,
            origin: self.point,
            plane,
            unit: self.unit,
        }
    }

    fn plane_parts(&self, solids: &Solids<D>, edges: &Edges<D>) -> Vec<Part<D>> {
        let outline = self.cell.outline();
        let corners: Vec<u32> = outline.iter().map(|&(corner, _)| corner).collect();
        let section = self.section(solids, Plane::flat());
        let pieces = section.gas(&edges.around(self.cell, &corners));
        let parts = pieces.iter().map(|piece| {
            let mut part = Part::new();
            for stretch in piece {
                let face = self.edge_face(&stretch.from, &stretch.to);
                part.volume += self.fan(&stretch.from, &stretch.to);
                match stretch.along {
                    Along::Edge(edge, _) => part.add_face(PartFace {
                        label: outline[edge].1,
                        ..face
                    }),
                    Along::Wall(body, facet) => part.add_wall(PartWall {
                        body,
                        facet,
                        area: face.area,
                        size: stretch.length(),
                        centre: face.centre,
                    }),
                }
            }
            part.is_own = is_seen(&section, piece.iter());
            if self.keeps_rings {
                part.rings.push(ring(piece));
            }
            part
        });
        own_first(parts.collect())
    }

    fn space_parts(&self, solids: &Solids<D>, edges: &Edges<D>) -> Vec<Part<D>> {
        let mut pieces: Vec<(&Facet, Piece<D>)> = Vec::new();
        for facet in &self.cell.facets {
            let corners = facet.corners.iter();
            let points: Vec<_> = corners
                .map(|&corner| self.cell.vertices[corner as usize])
                .collect();
            let face = polygon(facet.label, closed(&points));
            let size = face.area.norm();
            if size < 1e-14 * self.unit * self.unit {
                continue;
            }
            let section = self.section(solids, Plane::across(&(face.area / size)));
            let gas = section.gas(&edges.around(self.cell, &facet.corners));
            pieces.extend(gas.into_iter().map(|piece| (facet, piece)));
        }
        let group = joined(&pieces);
        let section = self.section(solids, Plane::flat());
        let mut parts = Vec::new();
        for first in 0..pieces.len() {
            if group[first] != first {
                continue;
            }
            let members = || {
                let members = pieces.iter().zip(&group);
                members
                    .filter(|(_, g)| **g == first)
                    .map(|(piece, _)| piece)
            };
            let mut part = Part::new();
            let mut rim: Vec<RimStretch<D>> = Vec::new();
            for (facet, piece) in members() {
                let outline = piece.iter().map(|stretch| (stretch.from, stretch.to));
                let face = polygon(facet.label, outline);
                let walls = piece.iter().filter(|s| matches!(s.along, Along::Wall(..)));
                let inwards = -face.area / face.area.norm().max(f64::MIN_POSITIVE);
                rim.extend(walls.filter_map(|stretch| self.above(solids, stretch, &inwards)));
                part.volume += face.area.dot(&face.centre) / 3.0;
                part.add_face(face);
                if self.keeps_rings {
                    part.rings.push(ring(piece));
                }
            }
            if !rim.is_empty() {
                self.roof(solids, &rim, &mut part);
            }
            part.is_own = is_seen(&section, members().flat_map(|(_, piece)| piece));
            parts.push(part);
        }
        own_first(parts)
    }

    /// Closes a piece over the rim that the walls leave on the facets: a fan of triangles about a point that is on
    /// the surface, on the edge or at the corner, whichever the cell holds (Ju et al. 2002, doi:10.1145/566654.566586).
    fn roof(&self, solids: &Solids<D>, rim: &[RimStretch<D>], part: &mut Part<D>) {
        let apex = self.apex(solids, rim);
        for RimStretch { stretch, wall, .. } in rim {
            let area = 0.5 * cross(&(stretch.to - apex), &(stretch.from - apex));
            let centre = (apex + stretch.from + stretch.to) / 3.0;
            part.volume += area.dot(&centre) / 3.0;
            if self.keeps_rings {
                part.rings.push(vec![apex, stretch.to, stretch.from]);
            }
            part.add_wall(PartWall {
                body: wall.0,
                facet: wall.1,
                area,
                size: area.norm(),
                centre,
            });
        }
    }

    /// What lies over a stretch along the wall within the cell, which is the way `inwards` of it.
    fn above(
        &self,
        solids: &Solids<D>,
        stretch: &Stretch<D>,
        inwards: &Vector<D>,
    ) -> Option<RimStretch<D>> {
        /// So far within the cell, in spacings, the wall is looked for: where a body's edge lies in the facet, both its faces are as near.
        const WITHIN: f64 = 1e-6;
        let place = stretch.middle() + inwards * (WITHIN * self.unit);
        let (body, closest) = solids.closest(&(self.point + place))?;
        Some(RimStretch {
            stretch: *stretch,
            wall: (body, closest.face),
            place,
            normal: closest.normal,
            distance: closest.distance,
        })
    }

    fn apex(&self, solids: &Solids<D>, rim: &[RimStretch<D>]) -> Vector<D> {
        /// Holds the point where walls do not: those that are a little round along an edge say little of where it is there.
        const PULL: f64 = 1e-3;
        /// The same where planes meet in a hollow, and say all: little beside what two do that turn by a degree.
        const SLIGHT: f64 = 1e-5;
        const FAR: f64 = 1.5;
        let total: f64 = rim.iter().map(|s| s.stretch.length()).sum();
        let mean = rim.iter().fold(Vector::<D>::zeros(), |sum, s| {
            sum + s.stretch.middle() * s.stretch.length()
        }) / total.max(f64::MIN_POSITIVE);
        let foot = |place: &Vector<D>| {
            solids
                .closest(&(self.point + place))
                .map_or(*place, |(_, closest)| closest.point - self.point)
        };
        if rim.iter().all(|stretch| stretch.wall == rim[0].wall) {
            return foot(&mean);
        }
        let mut matrix = nalgebra::SMatrix::<f64, D, D>::zeros();
        let mut right = Vector::<D>::zeros();
        for wall in rim {
            let (normal, weight) = (wall.normal, wall.stretch.length() / total);
            let height = normal.dot(&(wall.place - mean)) - wall.distance;
            matrix += normal * normal.transpose() * weight;
            right += normal * (weight * height);
        }
        let pull = if are_planes_in_a_hollow(rim) {
            SLIGHT
        } else {
            PULL
        };
        let shift = (matrix + nalgebra::SMatrix::identity() * pull)
            .try_inverse()
            .map_or_else(Vector::zeros, |inverse| inverse * right);
        if shift.norm() < FAR * self.unit {
            mean + shift
        } else {
            foot(&mean)
        }
    }
}

/// A stretch along the wall on a facet of a cell, and the wall over it within the cell.
#[derive(Clone, Copy, Debug)]
struct RimStretch<const D: usize> {
    stretch: Stretch<D>,
    /// Body and smooth face.
    wall: (u32, u32),
    /// Where the wall is looked for, from the cell's point.
    place: Vector<D>,
    /// Normal of the wall there.
    normal: Vector<D>,
    /// Height of the place over it.
    distance: f64,
}

/// True of walls that are planes and face each other.
fn are_planes_in_a_hollow<const D: usize>(walls: &[RimStretch<D>]) -> bool {
    const FLAT: f64 = 1e-6;
    walls.iter().enumerate().all(|(k, one)| {
        walls[..k].iter().all(|other| {
            if other.wall == one.wall {
                (other.normal - one.normal).norm() < FLAT
            } else {
                let arm = one.place - other.place;
                arm.dot(&other.normal) > 0.0 && arm.dot(&one.normal) < 0.0
            }
        })
    })
}

/// True where the cell's point sees one of the piece's longest edges.
fn is_seen<'a, const D: usize>(
    section: &Section<'_, D>,
    stretches: impl Iterator<Item = &'a Stretch<D>>,
) -> bool {
    let mut edges: Vec<&Stretch<D>> = stretches
        .filter(|stretch| matches!(stretch.along, Along::Edge(..)))
        .collect();
    edges.sort_by(|a, b| b.length().total_cmp(&a.length()));
    let mut looks = edges.iter().take(LOOKS);
    looks.any(|edge| section.sees(&Vector::zeros(), &edge.middle()))
}

fn ring<const D: usize>(piece: &Piece<D>) -> Vec<Vector<D>> {
    piece.iter().map(|stretch| stretch.from).collect()
}

/// To which piece, the first of them, each is connected over edges of the cell.
fn joined<const D: usize>(pieces: &[(&Facet, Piece<D>)]) -> Vec<usize> {
    let mut group: Vec<usize> = (0..pieces.len()).collect();
    let mut seen: Vec<([u32; 2], usize, usize)> = Vec::new();
    for (number, (facet, piece)) in pieces.iter().enumerate() {
        for stretch in piece {
            let Along::Edge(edge, place) = stretch.along else {
                continue;
            };
            let count = facet.corners.len();
            let (a, b) = (facet.corners[edge], facet.corners[(edge + 1) % count]);
            let key = [a.min(b), a.max(b)];
            match seen.iter().find(|(k, p, _)| *k == key && *p == place) {
                Some(&(_, _, other)) => {
                    let (a, b) = (group[number], group[other]);
                    let (kept, lost) = (a.min(b), a.max(b));
                    group
                        .iter_mut()
                        .filter(|g| **g == lost)
                        .for_each(|g| *g = kept);
                }
                None => seen.push((key, place, number)),
            }
        }
    }
    group
}
