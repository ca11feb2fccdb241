//! What of the surface bounds the solid: solids may lie inside of others or overlap, and the surface
//! may fold through itself.

use rayon::prelude::*;

use super::Mesh;
use super::edges::parts;
use super::exposed::{Exposed, Surface};
use super::triangle::normal;
use super::winding::{OFF_SKIN, crossings};
use crate::Vector;
use crate::error::{GeometryError, WRAP};

/// A surface of one part is tried at about so many places for whether it crosses itself.
const PROBES: usize = 20_000;

/// A fold inside out is a flaw without harm if the square root of its area is below this part of the
/// body's diagonal.
const SLIGHT: f64 = 0.02;

impl Mesh {
    /// Leaves of the surface what has the solid on one side and the outside on the other. `crowded`:
    /// more than two triangles meet in some edges.
    pub(super) fn hide_buried(
        &mut self,
        tolerance: f64,
        crowded: bool,
    ) -> Result<(), GeometryError> {
        let step = OFF_SKIN * tolerance;
        let parting = |middle: &Vector<3>, up: &Vector<3>| {
            self.winding_number(&(middle + step * up)) < 0.5
                && self.winding_number(&(middle - step * up)) >= 0.5
        };
        let parts_whole = |f: u32| {
            let corners = self.corners(f);
            let middle = (corners[0] + corners[1] + corners[2]) / 3.0;
            parting(&middle, &normal(&corners))
        };
        let count = self.facets.len();
        let (part, part_count) = parts(&self.across);
        let careful = part_count > 1 || crowded;
        let stride = if careful { 1 } else { count.div_ceil(PROBES) };
        let doubtful: Vec<u32> = (0..count as u32)
            .into_par_iter()
            .step_by(stride)
            .filter(|&f| !self.hidden[f as usize] && !parts_whole(f))
            .collect();
        self.refuse_inside_out(&doubtful, &part, stride, step)?;
        let surface = Surface {
            tree: &self.tree,
            vertices: &self.vertices,
            facets: &self.facets,
            hidden: &self.hidden,
            tolerance,
        };
        if doubtful.is_empty() && (!careful || !surface.crosses_itself()) {
            return Ok(());
        }
        let exposed = Exposed::new(&surface, parting);
        let mut buried = vec![true; count];
        for owner in exposed.iter().flat_map(Exposed::owners) {
            buried[owner as usize] = false;
        }
        let number = (0..count).filter(|&f| buried[f] && !self.hidden[f]).count();
        self.hidden = buried;
        self.exposed = exposed;
        self.simple = false;
        let ignored = match number {
            0 => "ignored what lies inside of the solid of triangles that cross".to_owned(),
            1 => "ignored 1 triangle inside of the solid, and parts of those that cross".to_owned(),
            _ => format!(
                "ignored {number} triangles inside of the solid, and parts of those that cross"
            ),
        };
        self.repairs
            .push(format!("{ignored}; overlapping parts are united"));
        Ok(())
    }

    /// Refuses a connected part of the surface that passes through itself so that it has what it
    /// encloses inside here and outside there. Of the triangles in `doubt` every one in `stride` is
    /// given.
    fn refuse_inside_out(
        &self,
        doubt: &[u32],
        part: &[u32],
        stride: usize,
        step: f64,
    ) -> Result<(), GeometryError> {
        let doubled = |f: u32| {
            let [a, b, c] = self.corners(f);
            (b - a).cross(&(c - a)).norm()
        };
        if doubt.is_empty() {
            return Ok(());
        }
        let mut volumes = vec![0.0; part.iter().max().map_or(0, |&last| last as usize + 1)];
        let centre = 0.5 * (self.bounds.min + self.bounds.max);
        for (f, &own) in part.iter().enumerate() {
            let [a, b, c] = self.corners(f as u32).map(|v| v - centre);
            volumes[own as usize] += a.dot(&b.cross(&c));
        }
        let inwards = |f: u32| volumes[part[f as usize] as usize] < 0.0;
        let wrong: Vec<u32> = (doubt.par_iter().copied())
            .filter(|&f| self.is_inside_out(f, part, inwards(f), step))
            .collect();
        let area = 0.5 * stride as f64 * wrong.iter().map(|&f| doubled(f)).sum::<f64>();
        let largest = wrong
            .iter()
            .copied()
            .max_by(|&a, &b| doubled(a).total_cmp(&doubled(b)));
        let diagonal = self.bounds.size().norm();
        let Some(largest) = largest.filter(|_| area > (SLIGHT * diagonal).powi(2)) else {
            return Ok(());
        };
        let [a, b, c] = self.corners(largest);
        let p = (a + b + c) / 3.0;
        Err(GeometryError::Surface(format!(
            "passes through itself so that a part of it is inside out, near ({:.6}, {:.6}, {:.6}); \
             undo the fold, cut the surface where it crosses itself, or {WRAP}",
            p.x, p.y, p.z
        )))
    }

    /// True where a part that faces outwards winds the wrong way around what is before a triangle; or
    /// one that faces `inwards`, around what is behind.
    fn is_inside_out(&self, facet: u32, part: &[u32], inwards: bool, step: f64) -> bool {
        let own = part[facet as usize];
        let corners = self.corners(facet);
        let middle = (corners[0] + corners[1] + corners[2]) / 3.0;
        let side = if inwards { -1.0 } else { 1.0 };
        let p = middle + side * step * normal(&corners);
        let mut times = 0;
        let wanted = |other: u32| part[other as usize] == own;
        let count = |_, side| times += side;
        crossings(&self.tree, &p, |f| self.corners(f), wanted, count);
        if inwards { times > 0 } else { times < 0 }
    }
}
