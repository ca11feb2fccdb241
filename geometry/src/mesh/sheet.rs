//! A sheet with a thickness: all points nearer to any of its triangles than half of it. Terrain, sails and
//! panels, one-sided or two-sided, become solids so, with round rims.

use std::collections::HashSet;

use super::edges::{half_edges, in_pairs};
use super::slivers::is_sliver;
use super::smooth::Smooth;
use super::tree::Tree;
use super::triangle::{closest_on, normal};
use super::weld::{BackToBack, Indexed, bounds, drop_duplicates, weld};
use super::{build, orient, symmetry};
use crate::error::{GeometryError, positive};
use crate::stl::{Facet, Soup};
use crate::{Bounds, Closest, Shape, Vector, Watch};

/// Points nearer to the sheet than this part of its diagonal have no direction from it.
const NO_DIRECTION: f64 = 1e-12;

/// What lies deeper in the solid than this part of half its thickness is no part of its surface.
const FOLDED: f64 = 1e-3;

/// Triangles and the thickness that they are given.
#[derive(Clone, Debug)]
pub struct Sheet {
    vertices: Vec<Vector<3>>,
    /// In the order of the tree's leaves.
    facets: Vec<[u32; 3]>,
    tree: Tree,
    smooth: Smooth,
    /// Half of the thickness, metres.
    half: f64,
    /// Around the solid.
    bounds: Bounds<3>,
    mirrors: Vec<(usize, f64)>,
    repairs: Vec<String>,
}

impl Sheet {
    /// The triangles of `soup`, however they hang together, `thickness` metres thick.
    ///
    /// # Errors
    /// A thickness that is not above zero; no triangles with an area.
    pub fn new(soup: &Soup, thickness: f64, watch: &Watch) -> Result<Self, GeometryError> {
        let thickness = positive("sheet", "thickness", thickness)?;
        watch.begin("welding");
        let mut repairs = Vec::new();
        let mut mesh = weld(&soup.facets, &mut repairs);
        let copies = drop_duplicates(&mut mesh.facets, BackToBack::KeepOne);
        if copies > 0 {
            repairs.push(format!("dropped {copies} triangles that came twice"));
        }
        let slivers: HashSet<[u32; 3]> = (mesh.facets.iter().copied())
            .filter(|&facet| is_sliver(&mesh, facet))
            .collect();
        mesh.facets.retain(|facet| !slivers.contains(facet));
        if mesh.facets.is_empty() {
            return Err(GeometryError::Surface(
                "has no triangles with an area".into(),
            ));
        }
        let across = in_pairs(&mesh.facets, &half_edges(&mesh.facets));
        // A one-sided sheet has no two sides that could agree, and needs none.
        let _ = orient::agree(&mut mesh, &across);
        watch.begin("sorting triangles");
        let (tree, order) = Tree::new(&mesh.vertices, &mesh.facets);
        let Indexed {
            vertices,
            facets,
            tolerance,
        } = build::reorder(&mesh, &order);
        let across = in_pairs(&facets, &half_edges(&facets));
        let flat: Bounds<3> = bounds(vertices.iter().copied());
        repairs.push(format!(
            "gave {} triangles a thickness of {thickness:.3e}",
            facets.len()
        ));
        let mut sheet = Self {
            smooth: Smooth::new(&vertices, &facets, &across),
            vertices,
            facets,
            tree,
            half: 0.5 * thickness,
            bounds: flat.grown(0.5 * thickness),
            mirrors: Vec::new(),
            repairs,
        };
        watch.begin("looking for symmetry");
        let gap = |p: &Vector<3>| sheet.nearest(p).1;
        sheet.mirrors = symmetry::planes(&flat, &sheet.vertices, tolerance, gap);
        Ok(sheet)
    }

    /// What was done, in sentences without a subject.
    pub fn repairs(&self) -> &[String] {
        &self.repairs
    }

    /// Triangles of the solid's surface, both sides of each of the sheet's, counter-clockwise seen from
    /// outside; round rims and what of a side lies inside of a fold are left out.
    pub fn surface(&self) -> impl Iterator<Item = Facet> + '_ {
        (0..self.facets.len() as u32)
            .flat_map(|facet| {
                let [a, b, c] = self.corners(facet);
                let up = self.half * normal(&[a, b, c]);
                [[a + up, b + up, c + up], [a - up, c - up, b - up]]
            })
            .filter(|[a, b, c]| self.nearest(&((a + b + c) / 3.0)).1 > (1.0 - FOLDED) * self.half)
    }

    fn corners(&self, facet: u32) -> Facet {
        self.facets[facet as usize].map(|v| self.vertices[v as usize])
    }

    /// The closest triangle and the distance to it.
    fn nearest(&self, p: &Vector<3>) -> (u32, f64) {
        let corners = |f: u32| self.facets[f as usize].map(|v| &self.vertices[v as usize]);
        let nearest = self.tree.closest(p, corners, |_| false);
        // A sheet without triangles is never made.
        let (facet, squared) = nearest.unwrap_or((0, 0.0));
        (facet, squared.sqrt())
    }
}

impl Shape<3> for Sheet {
    fn bounds(&self) -> Bounds<3> {
        self.bounds
    }

    fn closest(&self, p: &Vector<3>) -> Closest<3> {
        let (facet, distance) = self.nearest(p);
        let corners = self.corners(facet);
        let on = closest_on(&corners, p).point;
        let up = normal(&corners);
        let out = if distance > NO_DIRECTION * self.bounds.size().norm() {
            (p - on) / distance
        } else {
            up
        };
        let below = u32::from(out.dot(&up) < 0.0);
        Closest {
            point: on + self.half * out,
            distance: distance - self.half,
            normal: out,
            face: 2 * self.smooth.patches[facet as usize] + below,
        }
    }

    fn mirror_planes(&self) -> Vec<(usize, f64)> {
        self.mirrors.clone()
    }

    /// Both sides, without the rims.
    fn facets(&self, _: f64, _: &Bounds<3>) -> Vec<[Vector<3>; 3]> {
        self.surface().collect()
    }
}
