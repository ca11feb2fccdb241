//! Openings of the surface: those that lie inside of other parts are no holes of the body, as where a
//! fin's shell is open at its root. The others are filled if that is asked for, or refused.

use std::fmt::Write as _;

use rayon::prelude::*;

use super::caps::span;
use super::edges::HalfEdge;
use super::nest::{Fate, Nest};
use super::rims::{Hole, rims, tell};
use super::triangle::normal;
use super::weld::{Indexed, bounds};
use super::winding::OFF_SKIN;
use crate::Bounds;
use crate::error::{FILL, GeometryError, THICKEN, WRAP};
use crate::halves::ROUNDED;

/// An opening counts as inside of another part where it stands out of that by less than this part of
/// the body's diagonal: roots end on the true surface, a tessellated one cuts below it.
const PROUD: f64 = 2e-3;

/// What is outside of other parts is no hole if its square root is below this part of the diagonal.
const SLIGHT: f64 = 0.01;

/// Most places of one triangle that are asked what is around them.
const MOST_PLACES: usize = 256;

/// An opening with more corners than this is closed only where that is asked for: it costs the square of their number.
const MOST_CORNERS: usize = 5000;

/// More holes than one in so many triangles: these were never a surface.
const SOUP: usize = 8;

/// So many holes at least make a soup.
const FEW: usize = 1000;

/// A hole wider than this part of the diagonal makes the surface a sheet.
const SHEET: f64 = 0.5;

/// What closes the openings, at the end of the list of triangles.
#[derive(Default)]
pub(super) struct Caps {
    first: usize,
    /// The hole of each triangle from the first on.
    hole_of: Vec<usize>,
    holes: Vec<Hole>,
}

impl Caps {
    /// Closes all openings.
    ///
    /// # Errors
    /// A soup, and openings with more than [`MOST_CORNERS`], where `fill` does not ask to close them.
    pub fn new(
        mesh: &mut Indexed,
        half_edges: &[HalfEdge],
        fill: bool,
    ) -> Result<Self, GeometryError> {
        let rims = rims(half_edges);
        let mut caps = Self {
            first: mesh.facets.len(),
            hole_of: Vec::new(),
            holes: rims.iter().map(|rim| Hole::of(mesh, rim)).collect(),
        };
        let is_soup = rims.len() > FEW && rims.len() * SOUP > caps.first;
        if !fill && (is_soup || rims.iter().any(|rim| rim.len() > MOST_CORNERS)) {
            let vertices = mesh.facets.iter().flatten();
            let extent = bounds(vertices.map(|&v| mesh.vertices[v as usize]));
            return Err(caps.refusal(&caps.holes, &extent));
        }
        for (number, rim) in rims.iter().enumerate() {
            let (_, patch) = span(mesh, rim);
            caps.hole_of
                .resize(caps.hole_of.len() + patch.len(), number);
            mesh.facets.extend(patch);
        }
        Ok(caps)
    }

    pub fn is_empty(&self) -> bool {
        self.holes.is_empty()
    }

    /// Notes which openings lie inside of other parts, and fills the others, if that is asked for; or
    /// refuses them.
    pub fn settle(
        &self,
        nest: &Nest<'_>,
        fates: &[Fate],
        fill: bool,
        repairs: &mut Vec<String>,
    ) -> Result<(), GeometryError> {
        if self.is_empty() {
            return Ok(());
        }
        let mesh = nest.mesh;
        let extent = bounds(
            mesh.facets
                .iter()
                .flatten()
                .map(|&v| mesh.vertices[v as usize]),
        );
        let diagonal = extent.size().norm();
        let mut bare = vec![0.0; self.holes.len()];
        let mut slight = (SLIGHT * diagonal).powi(2);
        let areas: Vec<f64> = (self.first as u32..mesh.facets.len() as u32)
            .into_par_iter()
            .map(|facet| bare_area(nest, fates, facet, (PROUD * diagonal, slight)))
            .collect();
        for (area, &hole) in areas.into_iter().zip(&self.hole_of) {
            bare[hole] += area;
        }
        // Many small holes are no small matter.
        let small = bare.iter().filter(|&&area| area <= slight).sum::<f64>();
        if small > slight {
            slight = 0.0;
        }
        let of = |is_bare: bool| {
            let holes = self.holes.iter().zip(&bare);
            holes.filter(move |(_, area)| (**area > slight) == is_bare)
        };
        let buried: Vec<Hole> = of(false).map(|(hole, _)| *hole).collect();
        let open: Vec<Hole> = of(true).map(|(hole, _)| *hole).collect();
        if !open.is_empty() && !fill {
            return Err(self.refusal(&open, &extent));
        }
        if !buried.is_empty() {
            repairs.push(format!(
                "ignored openings inside of other parts, {}",
                tell(&buried)
            ));
        }
        if !open.is_empty() {
            repairs.push(format!("filled {}", tell(&open)));
        }
        Ok(())
    }

    /// That the body, of this `extent`, is `open`.
    fn refusal(&self, open: &[Hole], extent: &Bounds<3>) -> GeometryError {
        let diagonal = extent.size().norm();
        let widest = open
            .iter()
            .fold(0.0, |most: f64, hole| most.max(hole.width));
        let mut remedy = if open.len() * SOUP > self.first {
            format!("{THICKEN}, {WRAP}")
        } else if widest > SHEET * diagonal {
            format!("{THICKEN}, {FILL}")
        } else {
            FILL.to_owned()
        };
        if let Some(way) = cut(open, extent) {
            let _ = write!(
                remedy,
                ", `--half {way}` (in a scene, `half = \"{way}\"`) joins the mirror image of half a body"
            );
        }
        let holes = tell(open);
        GeometryError::Surface(format!("is open at {holes}; close it, or {remedy}"))
    }
}

/// The direction in which the other half of a body may lie that is `open` only where it ends that way, at the end of its `extent`.
fn cut(open: &[Hole], extent: &Bounds<3>) -> Option<String> {
    let tolerance = ROUNDED * extent.size().norm();
    let ends = (0..3).flat_map(|axis| [("-", axis, extent.min), ("+", axis, extent.max)]);
    let mut cut = ends.filter(|(_, axis, end)| {
        open.iter()
            .all(|hole| hole.lies_in(*axis, end[*axis], tolerance))
    });
    cut.next()
        .map(|(sign, axis, _)| format!("{sign}{}", ["x", "y", "z"][axis]))
}

/// How much of a cap's triangle is not inside of other parts, nor nearly so.
fn bare_area(nest: &Nest<'_>, fates: &[Fate], facet: u32, (proud, slight): (f64, f64)) -> f64 {
    let own = nest.part_of[facet as usize];
    let mesh = nest.mesh;
    let corners = mesh.corners(mesh.facets[facet as usize]);
    // Out of the part, once it faces outwards.
    let out = normal(&corners) * nest.parts[own as usize].volume.signum();
    let inside = |p| {
        let around = nest.around(&p, |other| {
            other != own && fates[other as usize] != Fate::Dropped
        });
        let once = |(part, times): (u32, i32)| match fates[part as usize] {
            Fate::Inwards => -times.abs(),
            _ => times.abs(),
        };
        around.into_iter().map(once).sum::<i32>() > 0
    };
    let near = OFF_SKIN * mesh.tolerance;
    let area = mesh.area(mesh.facets[facet as usize]);
    let places = quarters(
        corners,
        (16.0 * area / slight).min(MOST_PLACES as f64) as usize,
    );
    let bare = places.iter().filter(|place| {
        let middle = (place[0] + place[1] + place[2]) / 3.0;
        !inside(middle + near * out) && !inside(middle + proud * out)
    });
    let share = bare.count() as f64 / places.len() as f64;
    share * area
}

/// A triangle in at least so many equal parts.
fn quarters(corners: [crate::Vector<3>; 3], count: usize) -> Vec<[crate::Vector<3>; 3]> {
    let mut parts = vec![corners];
    while parts.len() < count {
        parts = parts
            .into_iter()
            .flat_map(|[a, b, c]| {
                let (ab, bc, ca) = (0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + a));
                [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
            })
            .collect();
    }
    parts
}
