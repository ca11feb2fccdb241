//! Creases, smooth patches, and normals that vary smoothly across a patch.

use super::creases::{Creases, FLAT};
use super::edges::{NONE, parts};
use super::triangle::{Feature, OnTriangle, normal};
use crate::Vector;

/// The tip of a cone and a smooth vertex are told apart by how far the normals at the far ends of their triangles lean
/// beyond the triangles' own, as a part of how far the normal at the vertex leans back: one half to one where
/// the surface bends on, zero where it is straight.
const BENDS_ON: f64 = 0.2;

/// What the smooth parts of a surface share.
#[derive(Clone, Debug)]
pub(super) struct Smooth {
    /// Patch of each triangle.
    pub patches: Vec<u32>,
    pub patch_count: usize,
    /// Bits 0-2: the edge is a crease; bits 3-5: the corner lies on one.
    flags: Vec<u8>,
    /// For each corner of each triangle the number of its normal.
    corners: Vec<[u32; 3]>,
    normals: Vec<Vector<3>>,
}

/// The angle of a triangle at corner `k`.
fn angle(corners: &[Vector<3>; 3], k: usize) -> f64 {
    let u = corners[(k + 1) % 3] - corners[k];
    let v = corners[(k + 2) % 3] - corners[k];
    u.cross(&v).norm().atan2(u.dot(&v))
}

/// Normals at the vertices, weighted by angle: they decide on which side of a vertex a point lies.
/// [Baerentzen & Aanaes 2005, IEEE Trans. Vis. Comput. Graph. 11, 243]
pub(super) fn vertex_normals(vertices: &[Vector<3>], facets: &[[u32; 3]]) -> Vec<Vector<3>> {
    let mut normals = vec![Vector::<3>::zeros(); vertices.len()];
    for facet in facets {
        let corners = facet.map(|v| vertices[v as usize]);
        let n = normal(&corners);
        for k in 0..3 {
            normals[facet[k] as usize] += angle(&corners, k) * n;
        }
    }
    normals
}

impl Smooth {
    pub fn new(vertices: &[Vector<3>], facets: &[[u32; 3]], across: &[[u32; 3]]) -> Self {
        let corners = |f: usize| facets[f].map(|v| vertices[v as usize]);
        let mut smooth_across = across.to_vec();
        let mut flags = vec![0_u8; facets.len()];
        let creases = Creases {
            vertices,
            facets,
            across,
        };
        for f in 0..facets.len() {
            for edge in 0..3 {
                if creases.has(f as u32, edge) {
                    flags[f] |= 1 << edge;
                    smooth_across[f][edge] = NONE;
                }
            }
        }
        let (patches, patch_count) = parts(&smooth_across);
        let groups = corner_groups(facets, &smooth_across);
        let mut smooth = Self {
            patches,
            patch_count,
            flags,
            corners: vec![[NONE; 3]; facets.len()],
            normals: Vec::new(),
        };
        smooth.flag_vertices(vertices.len(), facets, &groups);
        smooth.blend(&groups, corners);
        smooth.sharpen_tips(&smooth_across, corners);
        smooth
    }

    /// Marks the corners of vertices whose triangles a crease parts.
    fn flag_vertices(&mut self, vertices: usize, facets: &[[u32; 3]], groups: &[u32]) {
        let mut group = vec![NONE; vertices];
        let mut creased = vec![false; vertices];
        for (f, facet) in facets.iter().enumerate() {
            for k in 0..3 {
                let (vertex, own) = (facet[k] as usize, groups[3 * f + k]);
                creased[vertex] |= group[vertex] != NONE && group[vertex] != own;
                group[vertex] = own;
            }
        }
        for (f, facet) in facets.iter().enumerate() {
            for k in (0..3).filter(|&k| creased[facet[k] as usize]) {
                self.flags[f] |= 8 << k;
            }
        }
    }

    /// One normal per group of corners, weighted by area and angle, so that large flat parts stay
    /// flat beside small rounded ones.
    fn blend(&mut self, groups: &[u32], corners: impl Fn(usize) -> [Vector<3>; 3]) {
        let mut number = vec![NONE; groups.len()];
        for f in 0..self.corners.len() {
            let points = corners(f);
            let doubled = (points[1] - points[0]).cross(&(points[2] - points[0]));
            for k in 0..3 {
                let root = groups[3 * f + k] as usize;
                if number[root] == NONE {
                    number[root] = self.normals.len() as u32;
                    self.normals.push(Vector::<3>::zeros());
                }
                self.corners[f][k] = number[root];
                self.normals[number[root] as usize] += angle(&points, k) * doubled;
            }
        }
        for normal in &mut self.normals {
            *normal = normal.try_normalize(0.0).unwrap_or_default();
        }
    }

    /// Gives the triangles around the tip of a cone normals of their own there: one that all shared would lean along the
    /// axis, and lean the normals of triangles that run from tip to base all along their length.
    fn sharpen_tips(
        &mut self,
        smooth_across: &[[u32; 3]],
        corners: impl Fn(usize) -> [Vector<3>; 3],
    ) {
        let mut lean = vec![0.0_f64; self.normals.len()];
        let mut bends_on = vec![0.0_f64; self.normals.len()];
        let mut most = vec![0.0_f64; self.normals.len()];
        for (f, numbers) in self.corners.iter().enumerate() {
            let own = normal(&corners(f));
            let [a, b, c] = numbers.map(|number| self.normals[number as usize]);
            for (k, (at, far)) in [(a, 0.5 * (b + c)), (b, 0.5 * (c + a)), (c, 0.5 * (a + b))]
                .into_iter()
                .enumerate()
            {
                let (number, back) = (numbers[k] as usize, at - own);
                lean[number] += back.norm_squared();
                bends_on[number] += back.dot(&(own - far));
                most[number] = most[number].max(back.norm());
            }
        }
        let is_tip = |number: u32| {
            let n = number as usize;
            most[n] > FLAT && bends_on[n] < BENDS_ON * lean[n]
        };
        let shared = self.corners.clone();
        for (f, numbers) in shared.iter().enumerate() {
            for k in (0..3).filter(|&k| is_tip(numbers[k])) {
                let beside = [smooth_across[f][k], smooth_across[f][(k + 2) % 3]];
                let mean: Vector<3> = [f as u32]
                    .into_iter()
                    .chain(beside)
                    .filter(|&g| g != NONE)
                    .map(|g| normal(&corners(g as usize)))
                    .sum();
                self.corners[f][k] = self.normals.len() as u32;
                self.normals
                    .push(mean.try_normalize(0.0).unwrap_or_default());
                self.flags[f] |= 8 << k;
            }
        }
    }

    /// True where an edge of a triangle is a crease.
    pub fn is_crease(&self, facet: u32, edge: usize) -> bool {
        self.flags[facet as usize] >> edge & 1 == 1
    }

    /// True where the point lies on a crease.
    pub fn on_crease(&self, facet: u32, feature: Feature) -> bool {
        let bit = match feature {
            Feature::Face => return false,
            Feature::Edge(edge) => edge,
            Feature::Vertex(corner) => 3 + corner,
        };
        self.flags[facet as usize] >> bit & 1 == 1
    }

    /// The smooth normal at a point of a triangle; zero where it cannot be told.
    pub fn normal_at(&self, facet: u32, on: &OnTriangle) -> Vector<3> {
        let corners = self.corners[facet as usize];
        let blended: Vector<3> = (0..3)
            .map(|k| on.weights[k] * self.normals[corners[k] as usize])
            .sum();
        blended.try_normalize(0.0).unwrap_or_default()
    }
}

/// Groups the corners (three per triangle) that meet in a vertex without a crease between them;
/// each corner gets the number of one corner of its group.
fn corner_groups(facets: &[[u32; 3]], smooth_across: &[[u32; 3]]) -> Vec<u32> {
    let mut parent: Vec<u32> = (0..3 * facets.len() as u32).collect();
    for f in 0..facets.len() {
        for edge in 0..3 {
            let other = smooth_across[f][edge];
            if other == NONE || (other as usize) < f {
                continue;
            }
            for k in [edge, (edge + 1) % 3] {
                let corner = |g: usize| (0..3).find(|&m| facets[g][m] == facets[f][k]);
                if let Some(m) = corner(other as usize) {
                    let a = root(&mut parent, (3 * f + k) as u32);
                    let b = root(&mut parent, 3 * other + m as u32);
                    parent[a.max(b) as usize] = a.min(b);
                }
            }
        }
    }
    (0..parent.len() as u32)
        .map(|corner| root(&mut parent, corner))
        .collect()
}

fn root(parent: &mut [u32], mut corner: u32) -> u32 {
    while parent[corner as usize] != corner {
        let up = parent[parent[corner as usize] as usize];
        parent[corner as usize] = up;
        corner = up;
    }
    corner
}
