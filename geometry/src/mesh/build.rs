//! The way from a file, or from loose triangles, to a mesh.

use std::path::Path;

use super::edges::half_edges;
use super::neighbours::neighbours;
use super::pinches::Pinches;
use super::slivers::is_sliver;
use super::smooth::{Smooth, vertex_normals};
use super::tree::Tree;
use super::weld::{BackToBack, Indexed, drop_duplicates, weld};
use super::{Mesh, orient, slivers, symmetry, weld as welding};
use crate::error::{GeometryError, no_volume};
use crate::stl::{Facet, Soup, Unit};
use crate::{Bounds, Watch, files};

/// A mesh encloses no solid whose volume is below this part of its bounding cube.
const NO_VOLUME: f64 = 1e-9;

impl Mesh {
    /// The body in a file (STL, OBJ, PLY) whose numbers are in `unit`.
    ///
    /// # Errors
    /// A file that cannot be read or is damaged; triangles that do not enclose a solid.
    pub fn read(path: &Path, unit: Unit) -> Result<Self, GeometryError> {
        Self::read_watched(path, unit, &Watch::default())
    }

    /// As [`Mesh::read`], and tells `watch` how far it is.
    ///
    /// # Errors
    /// See [`Mesh::read`].
    pub fn read_watched(path: &Path, unit: Unit, watch: &Watch) -> Result<Self, GeometryError> {
        watch.begin("reading");
        let soup = files::read(path, unit)?;
        Self::make(soup, false, watch).map_err(|source| GeometryError::In {
            path: path.to_owned(),
            source: Box::new(source),
        })
    }

    /// The body that `facets` enclose.
    ///
    /// # Errors
    /// Corners that are not finite; triangles that do not enclose a solid.
    pub fn from_facets(facets: Vec<Facet>) -> Result<Self, GeometryError> {
        Self::new(Soup {
            facets,
            solids: Vec::new(),
        })
    }

    /// The body that the solids of `soup` make together.
    ///
    /// # Errors
    /// See [`Mesh::from_facets`].
    pub fn new(soup: Soup) -> Result<Self, GeometryError> {
        Self::make(soup, false, &Watch::default())
    }

    /// As [`Mesh::new`], and tells `watch` how far it is.
    ///
    /// # Errors
    /// See [`Mesh::from_facets`].
    pub fn sound(soup: Soup, watch: &Watch) -> Result<Self, GeometryError> {
        Self::make(soup, false, watch)
    }

    /// As [`Mesh::new`], with all holes closed by triangles that span their rims.
    ///
    /// # Errors
    /// See [`Mesh::from_facets`]; a sheet, around which closing its rim makes no solid.
    pub fn filled(soup: Soup, watch: &Watch) -> Result<Self, GeometryError> {
        Self::make(soup, true, watch)
    }

    /// As [`Mesh::from_facets`], and tells `watch` how far it is.
    pub(super) fn from_facets_watched(
        facets: Vec<Facet>,
        watch: &Watch,
    ) -> Result<Self, GeometryError> {
        let solids = Vec::new();
        Self::make(Soup { facets, solids }, false, watch)
    }

    /// Each form of the triangles is let go of once the next is made: millions of them are large.
    fn make(soup: Soup, fill: bool, watch: &Watch) -> Result<Self, GeometryError> {
        let Soup { facets, solids } = soup;
        let not_finite = |facet: &Facet| !facet.iter().flatten().all(|x| x.is_finite());
        if let Some(index) = facets.iter().position(not_finite) {
            return Err(GeometryError::Surface(format!(
                "triangle {} has a corner that is not finite",
                index + 1
            )));
        }
        watch.begin("welding");
        let mut repairs = Vec::new();
        let welded = weld(&facets, &mut repairs);
        drop(facets);
        watch.begin("repairing");
        let mut closed = close(welded, fill, &mut repairs)?;
        slivers::flip(&mut closed, &mut repairs);
        let names = solids.into_iter().map(|(name, _)| name).collect();
        Self::assemble(closed, names, repairs, watch)
    }

    fn assemble(
        surface: Indexed,
        names: Vec<String>,
        mut repairs: Vec<String>,
        watch: &Watch,
    ) -> Result<Self, GeometryError> {
        watch.begin("sorting triangles");
        let (tree, order) = Tree::new(&surface.vertices, &surface.facets);
        let closed = reorder(&surface, &order);
        drop((surface, order));
        let Indexed {
            vertices, facets, ..
        } = &closed;
        let corners = |f: u32| facets[f as usize].map(|v| vertices[v as usize]);
        let half_edges = half_edges(facets);
        let across = neighbours(&closed, &half_edges);
        let pinches = Pinches::new(&closed, &half_edges, &across);
        repairs.extend(pinches.note(vertices));
        drop(half_edges);
        let bounds: Bounds<3> = welding::bounds((0..facets.len() as u32).flat_map(corners));
        let smooth = Smooth::new(vertices, facets, &across);
        let hidden: Vec<bool> = facets.iter().map(|&f| is_sliver(&closed, f)).collect();
        let mut mesh = Self {
            simple: !hidden.contains(&true),
            hidden,
            exposed: None,
            pinched: pinches.vertices,
            vertex_normals: vertex_normals(vertices, facets),
            vertices: closed.vertices,
            facets: closed.facets,
            across,
            smooth,
            tree,
            bounds,
            mirrors: Vec::new(),
            names,
            repairs,
        };
        watch.begin("finding out inside and outside");
        mesh.hide_buried(closed.tolerance, pinches.edges > 0)?;
        let solid = mesh.volume() > NO_VOLUME * mesh.bounds.size().max().powi(3);
        if !solid || mesh.hidden.iter().all(|&hidden| hidden) {
            return Err(no_volume());
        }
        watch.begin("looking for symmetry");
        mesh.mirrors = symmetry::mirrors(&mesh, closed.tolerance);
        Ok(mesh)
    }
}

/// Sorts the triangles as the tree holds them, and the vertices as the triangles use them, so that
/// what is near in space is near in memory.
pub(super) fn reorder(mesh: &Indexed, order: &[u32]) -> Indexed {
    let mut number = vec![u32::MAX; mesh.vertices.len()];
    let mut vertices = Vec::with_capacity(mesh.vertices.len());
    let facets = order
        .iter()
        .map(|&facet| {
            mesh.facets[facet as usize].map(|v| {
                let new = &mut number[v as usize];
                if *new == u32::MAX {
                    *new = vertices.len() as u32;
                    vertices.push(mesh.vertices[v as usize]);
                }
                *new
            })
        })
        .collect();
    Indexed {
        vertices,
        facets,
        tolerance: mesh.tolerance,
    }
}

/// Makes the triangles one closed, oriented surface.
fn close(
    mut mesh: Indexed,
    fill: bool,
    repairs: &mut Vec<String>,
) -> Result<Indexed, GeometryError> {
    let original = mesh.facets.clone();
    let mut last = None;
    for rule in [BackToBack::Cancel, BackToBack::KeepOne] {
        mesh.facets.clone_from(&original);
        let mut notes = Vec::new();
        let dropped = drop_duplicates(&mut mesh.facets, rule);
        if dropped > 0 {
            notes.push(format!("dropped {dropped} triangles that came twice"));
        }
        let result = if mesh.facets.is_empty() {
            Err(GeometryError::Surface(
                "has no triangles with an area; give a closed surface around a solid".into(),
            ))
        } else {
            orient::orient(&mut mesh, fill, &mut notes)
        };
        match result {
            Ok(()) => {
                repairs.extend(notes);
                return Ok(mesh);
            }
            Err(error) => last = Some(error),
        }
        if dropped == 0 {
            break;
        }
    }
    Err(last.unwrap_or_else(|| GeometryError::Surface("has no triangles".into())))
}
