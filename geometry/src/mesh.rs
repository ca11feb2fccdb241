//! Bodies made of triangles: repaired, oriented, and asked for distances.
//!
//! Loose triangles become a [`Mesh`] only when they enclose a solid; what was wrong and could be
//! mended is listed in [`Mesh::repairs`].

mod build;
mod buried;
mod caps;
mod creases;
mod cuts;
mod edges;
mod exposed;
mod facing;
mod holes;
mod neighbours;
mod nest;
mod openings;
mod orient;
mod patches;
mod pinches;
mod rims;
mod sharp;
mod sheet;
mod slivers;
mod smooth;
mod symmetry;
mod tree;
mod triangle;
mod wedges;
mod weld;
mod winding;
mod wrap;

pub(crate) use caps::triangulate;
pub use sheet::Sheet;
pub(crate) use weld::bounds;

use edges::NONE;
use exposed::Exposed;
use smooth::Smooth;
use tree::Tree;
use triangle::{Feature, OnTriangle, closest_on, normal};
use winding::winding_number;

use crate::stl::Facet;
use crate::{Bounds, Closest, Crease, Shape, Vector};

/// Sine of the angle between the way to the closest point and the normal above which that point is
/// on a border.
const ASLANT: f64 = 1e-3;

/// A solid bounded by triangles. Several solids of one file are one body: their union.
#[derive(Clone, Debug)]
pub struct Mesh {
    vertices: Vec<Vector<3>>,
    /// In the order of the tree's leaves.
    facets: Vec<[u32; 3]>,
    across: Vec<[u32; 3]>,
    /// Triangles that are no part of the surface: needles, and those inside of other solids.
    hidden: Vec<bool>,
    /// The parts of triangles that bound the solid, where not all of them do.
    exposed: Option<Exposed>,
    /// Vertices in which the surface touches itself; empty where there are none.
    pinched: Vec<bool>,
    vertex_normals: Vec<Vector<3>>,
    smooth: Smooth,
    tree: Tree,
    /// True where every triangle parts inside from outside, so that the nearest one tells the
    /// side.
    simple: bool,
    bounds: Bounds<3>,
    mirrors: Vec<(usize, f64)>,
    names: Vec<String>,
    repairs: Vec<String>,
}

impl Mesh {
    /// Names of the solids, in the order of the file.
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// What was wrong with the triangles and what was done, in sentences without a subject.
    pub fn repairs(&self) -> &[String] {
        &self.repairs
    }

    /// Number of triangles.
    pub fn facet_count(&self) -> usize {
        self.facets.len()
    }

    /// Number of smooth patches, which [`Closest::face`] counts.
    pub fn patch_count(&self) -> usize {
        self.smooth.patch_count
    }

    /// The triangles that bound the solid, those that others cut as their pieces, counter-clockwise
    /// seen from outside. What lies inside of the solid is left out.
    pub fn surface(&self) -> Box<dyn Iterator<Item = Facet> + '_> {
        match &self.exposed {
            Some(exposed) => Box::new(exposed.corners()),
            None => Box::new((0..self.facets.len() as u32).map(|f| self.corners(f))),
        }
    }

    /// Volume of the solid, cubic metres; what solids share counts once.
    pub fn volume(&self) -> f64 {
        let middle = 0.5 * (self.bounds.min + self.bounds.max);
        let sixfold = |facet: Facet| {
            let [a, b, c] = facet.map(|v| v - middle);
            a.dot(&b.cross(&c))
        };
        self.surface().map(sixfold).sum::<f64>() / 6.0
    }

    /// Area of the surface, square metres.
    pub fn area(&self) -> f64 {
        let doubled = |[a, b, c]: Facet| (b - a).cross(&(c - a)).norm();
        0.5 * self.surface().map(doubled).sum::<f64>()
    }

    /// How many times the surface winds around `p`: a whole number, above zero inside of the body.
    pub fn winding_number(&self, p: &Vector<3>) -> f64 {
        winding_number(&self.tree, p, |f| self.corners(f))
    }

    #[inline]
    fn corners(&self, facet: u32) -> [Vector<3>; 3] {
        self.facets[facet as usize].map(|v| self.vertices[v as usize])
    }

    /// The closest triangle, the closest point on it, and whether that lies where the triangle is
    /// cut off by others.
    fn nearest(&self, p: &Vector<3>) -> (u32, OnTriangle, bool) {
        if let Some((facet, piece)) = self.exposed.as_ref().and_then(|e| e.closest(p)) {
            let on = closest_on(&self.corners(facet), &piece.point);
            let cut = Exposed::is_cut(on.feature, piece.feature);
            let point = piece.point;
            return (facet, OnTriangle { point, ..on }, cut);
        }
        let hidden = |f: u32| self.hidden[f as usize];
        let corners = |f: u32| {
            let [a, b, c] = self.facets[f as usize];
            let at = |v: u32| &self.vertices[v as usize];
            [at(a), at(b), at(c)]
        };
        let nearest = self.tree.closest(p, corners, hidden);
        // A mesh without any visible triangle is never made.
        let (facet, _) = nearest.unwrap_or((0, 0.0));
        (facet, closest_on(&self.corners(facet), p), false)
    }

    /// True where the surface touches itself in this feature, so that more than one pair or fan of
    /// triangles is near.
    fn is_pinched(&self, facet: u32, feature: Feature) -> bool {
        let at = |corner: usize| {
            let vertex = self.facets[facet as usize][corner % 3];
            self.pinched[vertex as usize]
        };
        !self.pinched.is_empty()
            && match feature {
                Feature::Face => false,
                Feature::Edge(edge) => at(edge) && at(edge + 1),
                Feature::Vertex(corner) => at(corner),
            }
    }

    /// Of the triangles that share a feature of `facet` the one that faces `direction` most: all are equally near to what
    /// lies beyond a crease, and a body that is its own mirror image must be seen as one.
    fn facing(&self, facet: u32, feature: Feature, direction: &Vector<3>) -> u32 {
        let faces = |f: u32| normal(&self.corners(f)).dot(direction);
        let mut best = (facet, faces(facet));
        let mut meet = |other: u32| {
            let faced = faces(other);
            if faced > best.1 {
                best = (other, faced);
            }
        };
        match feature {
            Feature::Face => {}
            Feature::Edge(edge) => {
                let other = self.across[facet as usize][edge];
                if other != NONE {
                    meet(other);
                }
            }
            Feature::Vertex(corner) => self.for_each_around(facet, corner, meet),
        }
        best.0
    }

    /// Calls `visit` with the other triangles around a corner of `facet`, as far as they hang together.
    fn for_each_around(&self, facet: u32, corner: usize, mut visit: impl FnMut(u32)) {
        let vertex = self.facets[facet as usize][corner];
        // Out over the edge that leaves the corner, then the other way round over the one that arrives.
        for turn in [0, 2] {
            let mut at = (facet, corner);
            loop {
                let next = self.across[at.0 as usize][(at.1 + turn) % 3];
                if next == facet {
                    return;
                }
                let Some(place) = self
                    .facets
                    .get(next as usize)
                    .and_then(|corners| corners.iter().position(|&other| other == vertex))
                else {
                    break;
                };
                visit(next);
                at = (next, place);
            }
        }
    }

    /// The direction that tells the sides of a feature apart; not a unit vector.
    fn outward(&self, facet: u32, corners: &[Vector<3>; 3], feature: Feature) -> Vector<3> {
        match feature {
            Feature::Face => normal(corners),
            Feature::Edge(edge) => {
                let other = self.across[facet as usize][edge];
                if other == NONE {
                    normal(corners)
                } else {
                    normal(corners) + normal(&self.corners(other))
                }
            }
            Feature::Vertex(corner) => {
                self.vertex_normals[self.facets[facet as usize][corner] as usize]
            }
        }
    }
}

impl Shape<3> for Mesh {
    fn bounds(&self) -> Bounds<3> {
        self.bounds
    }

    fn closest(&self, p: &Vector<3>) -> Closest<3> {
        let (facet, on, cut) = self.nearest(p);
        let corners = self.corners(facet);
        let outward = self.outward(facet, &corners, on.feature);
        let offset = p - on.point;
        let length = offset.norm();
        // The border of what is exposed is a crease, unless it is one between pieces of a triangle.
        let aslant = cut && offset.cross(&outward).norm() > ASLANT * length * outward.norm();
        // Straight above or below the inside of an exposed piece its triangle tells the side.
        let told = match self.exposed {
            Some(_) => on.feature == Feature::Face && !aslant,
            None => self.simple && !self.is_pinched(facet, on.feature),
        };
        let inside = if told {
            offset.dot(&outward) < 0.0
        } else {
            self.winding_number(p) > 0.5
        };
        let sign = if inside { -1.0 } else { 1.0 };
        let size = self.bounds.size().max();
        let on_crease = self.smooth.on_crease(facet, on.feature);
        let creased = on_crease || aslant;
        let normal = if creased && length > 1e-9 * size {
            sign / length * offset
        } else if creased {
            outward.normalize()
        } else {
            self.smooth.normal_at(facet, &on)
        };
        let facing = if on_crease {
            self.facing(facet, on.feature, &(sign * offset))
        } else {
            facet
        };
        Closest {
            point: on.point,
            distance: sign * length,
            normal,
            face: self.smooth.patches[facing as usize],
        }
    }

    fn way_out(&self, from: &Vector<3>, direction: &Vector<3>) -> Option<f64> {
        winding::way_out(&self.tree, from, direction, |f| self.corners(f))
    }

    fn mirror_planes(&self) -> Vec<(usize, f64)> {
        self.mirrors.clone()
    }

    fn facets(&self, _: f64, _: &Bounds<3>) -> Vec<[Vector<3>; 3]> {
        self.surface().collect()
    }

    fn for_each_facet(&self, _: f64, _: &Bounds<3>, visit: &mut dyn FnMut([Vector<3>; 3])) {
        self.surface().for_each(visit);
    }

    fn creases(&self, _: f64, region: &Bounds<3>) -> Vec<Crease<3>> {
        self.sharp_edges(region)
    }

    fn measure(&self) -> Option<f64> {
        Some(self.volume())
    }
}
