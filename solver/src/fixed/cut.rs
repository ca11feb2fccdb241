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
            let mut rim: Piece<D> = Vec::new();
            for (facet, piece) in members() {
                let outline = piece.iter().map(|stretch| (stretch.from, stretch.to));
                let face = polygon(facet.label, outline);
                part.volume += face.area.dot(&face.centre) / 3.0;
                part.add_face(face);
                if self.keeps_rings {
                    part.rings.push(ring(piece));
                }
                rim.extend(piece.iter().filter(|s| matches!(s.along, Along::Wall(..))));
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
    fn roof(&self, solids: &Solids<D>, rim: &[Stretch<D>], part: &mut Part<D>) {
        let apex = self.apex(solids, rim);
        for stretch in rim {
            let Along::Wall(body, facet) = stretch.along else {
                continue;
            };
            let area = 0.5 * cross(&(stretch.to - apex), &(stretch.from - apex));
            let centre = (apex + stretch.from + stretch.to) / 3.0;
            part.volume += area.dot(&centre) / 3.0;
            if self.keeps_rings {
                part.rings.push(vec![apex, stretch.to, stretch.from]);
            }
            part.add_wall(PartWall {
                body,
                facet,
                area,
                size: area.norm(),
                centre,
            });
        }
    }

    fn apex(&self, solids: &Solids<D>, rim: &[Stretch<D>]) -> Vector<D> {
        /// Holds the point where walls do not: those that are a little round along an edge say little of where it is there.
        const PULL: f64 = 1e-3;
        /// The same where planes meet in a hollow, and say all: little beside what two do that turn by a degree.
        const SLIGHT: f64 = 1e-5;
        const FAR: f64 = 1.5;
        let total: f64 = rim.iter().map(Stretch::length).sum();
        let mean = rim.iter().fold(Vector::<D>::zeros(), |sum, stretch| {
            sum + stretch.middle() * stretch.length()
        }) / total.max(f64::MIN_POSITIVE);
        let foot = |place: &Vector<D>| {
            solids
                .closest(&(self.point + place))
                .map_or(*place, |(_, closest)| closest.point - self.point)
        };
        if rim.iter().all(|stretch| stretch.along == rim[0].along) {
            return foot(&mean);
        }
        let mut matrix = nalgebra::SMatrix::<f64, D, D>::zeros();
        let mut right = Vector::<D>::zeros();
        let mut walls: Vec<(Along, Vector<D>, Vector<D>)> = Vec::new();
        for stretch in rim {
            let middle = stretch.middle();
            if let Some((_, closest)) = solids.closest(&(self.point + middle)) {
                walls.push((stretch.along, middle, closest.normal));
                let weight = stretch.length() / total;
                let height = closest.normal.dot(&(middle - mean)) - closest.distance;
                matrix += closest.normal * closest.normal.transpose() * weight;
                right += closest.normal * (weight * height);
            }
        }
        let pull = if are_planes_in_a_hollow(&walls) {
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

/// True of walls, each with a place on it and its normal there, that are planes and face each other.
fn are_planes_in_a_hollow<const D: usize>(walls: &[(Along, Vector<D>, Vector<D>)]) -> bool {
    const FLAT: f64 = 1e-6;
    walls.iter().enumerate().all(|(k, (along, place, normal))| {
        walls[..k].iter().all(|(other, there, facing)| {
            if other == along {
                (facing - normal).norm() < FLAT
            } else {
                let arm = place - there;
                arm.dot(facing) > 0.0 && arm.dot(normal) < 0.0
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
