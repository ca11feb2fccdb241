//! How the closed parts of a surface lie within each other, and what that makes of them.
//!
//! A part that lies in no other one, or only half inside of others, faces outwards, whatever the file
//! says: the solid is the union of its parts. One that lies wholly inside of others may be the wall of
//! a cavity or a solid: there the file's orientation tells, and where the file is of two minds the
//! surface is refused.

use std::collections::BTreeMap;

use super::tree::Tree;
use super::triangle::normal;
use super::weld::{Indexed, bounds};
use super::winding::{OFF_SKIN, crossings};
use crate::Vector;
use crate::error::{GeometryError, WRAP};
use crate::stl::Facet;

/// A share of the area that decides beyond doubt.
const CLEAR: f64 = 0.75;

/// A share of the area that is all of it.
const WHOLE: f64 = 0.999;

/// Triangles of a part that are asked what is around them.
const PROBES: usize = 24;

/// The same before a part is taken for the wall of a cavity: what of it stands out would be lost.
const MANY_PROBES: usize = 4096;

/// A connected part of the surface, which is closed.
pub(super) struct Part {
    pub facets: Vec<u32>,
    /// Six times what it encloses; below zero where it faces inwards.
    pub volume: f64,
    pub area: f64,
    /// Share of its area that was turned against the file to agree with the rest.
    turned: f64,
}

impl Part {
    pub fn new(mesh: &Indexed, facets: Vec<u32>, turned: &[bool]) -> Self {
        let area = |&f: &u32| mesh.area(mesh.facets[f as usize]);
        // What fills a hole is in no file.
        let was_turned = |f: &&u32| turned.get(**f as usize) == Some(&true);
        let whole: f64 = facets.iter().map(area).sum();
        let part: f64 = facets.iter().filter(was_turned).map(area).sum();
        Self {
            volume: volume(mesh, &facets),
            area: whole,
            turned: part / whole.max(f64::MIN_POSITIVE),
            facets,
        }
    }

    /// Which way it faces in the file: true for inwards, nothing where that is in doubt.
    pub fn inwards(&self) -> Option<bool> {
        let now = self.volume < 0.0;
        if self.turned <= 1.0 - CLEAR {
            Some(now)
        } else if self.turned >= CLEAR {
            Some(!now)
        } else {
            None
        }
    }
}

/// What becomes of a part.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Fate {
    Outwards,
    /// The wall of a cavity.
    Inwards,
    /// It encloses nothing.
    Dropped,
}

/// How a part lies among the others.
struct Surroundings {
    /// Share of its area that is inside of an odd number of others.
    inside: f64,
    /// The largest of those around it there.
    outermost: Option<u32>,
}

/// The parts, and what is around them.
pub(super) struct Nest<'a> {
    pub mesh: &'a Indexed,
    pub part_of: &'a [u32],
    pub parts: &'a [Part],
    tree: Tree,
    order: Vec<u32>,
}

impl<'a> Nest<'a> {
    pub fn new(mesh: &'a Indexed, part_of: &'a [u32], parts: &'a [Part]) -> Self {
        let (tree, order) = Tree::new(&mesh.vertices, &mesh.facets);
        Self {
            mesh,
            part_of,
            parts,
            tree,
            order,
        }
    }

    fn corners(&self, facet: u32) -> Facet {
        self.mesh.corners(self.mesh.facets[facet as usize])
    }

    /// Some triangles of a part, and points off them on the `side` that their normals lead to.
    fn probes(&self, part: &Part, side: f64, count: usize) -> Vec<(u32, Vector<3>)> {
        let stride = part.facets.len().div_ceil(count).max(1);
        let facets = part.facets.iter().step_by(stride);
        let point = |&facet: &u32| {
            let [a, b, c] = self.corners(facet);
            let offset = side * OFF_SKIN * self.mesh.tolerance * normal(&[a, b, c]);
            (facet, (a + b + c) / 3.0 + offset)
        };
        facets.map(point).collect()
    }

    /// How many times each wanted part winds around a point.
    pub fn around(&self, p: &Vector<3>, wanted: impl Fn(u32) -> bool) -> BTreeMap<u32, i32> {
        let owner = |place: u32| self.part_of[self.order[place as usize] as usize];
        let mut times = BTreeMap::new();
        crossings(
            &self.tree,
            p,
            |place| self.corners(self.order[place as usize]),
            |place| wanted(owner(place)),
            |place, side| *times.entry(owner(place)).or_default() += side,
        );
        times.retain(|_, times| *times != 0);
        times
    }

    /// True for a wall given from both sides: there is nothing between its triangles.
    pub fn is_thin(&self, number: usize) -> bool {
        let own = |part| part == number as u32;
        let part = &self.parts[number];
        [1.0, -1.0].into_iter().all(|side| {
            let mut probes = self.probes(part, side, PROBES).into_iter();
            probes.all(|(_, p)| self.around(&p, own).is_empty())
        })
    }

    /// How a part lies among those that are not `thin`.
    fn surroundings(&self, number: usize, thin: &[bool], probes: usize) -> Surroundings {
        let wanted = |other: u32| other as usize != number && !thin[other as usize];
        let size = |&other: &u32| self.parts[other as usize].volume.abs();
        let part = &self.parts[number];
        let (mut all, mut inside, mut outermost) = (0.0, 0.0, None);
        // On the side that the part encloses: where it lies on a wall around it, only that is inside.
        for (facet, p) in self.probes(part, -part.volume.signum(), probes) {
            let area = self.mesh.area(self.mesh.facets[facet as usize]);
            let around = self.around(&p, wanted);
            all += area;
            if around.len() % 2 == 1 {
                inside += area;
                let largest = around
                    .into_keys()
                    .max_by(|a, b| size(a).total_cmp(&size(b)));
                outermost = outermost.or(largest);
            }
        }
        Surroundings {
            inside: inside / f64::max(all, f64::MIN_POSITIVE),
            outermost,
        }
    }

    /// Area of a `thin` part that is not inside of others, once for both of its sides.
    pub fn bare_area(&self, number: usize, thin: &[bool]) -> f64 {
        let inside = self.surroundings(number, thin, PROBES).inside;
        0.5 * (1.0 - inside) * self.parts[number].area
    }

    /// What becomes of a part among those that are not `thin`.
    pub fn judge(&self, number: usize, thin: &[bool]) -> Result<Fate, GeometryError> {
        if thin[number] {
            return Ok(Fate::Dropped);
        }
        let Surroundings { inside, outermost } = self.surroundings(number, thin, PROBES);
        let Some(outermost) = outermost.filter(|_| inside > 1.0 - CLEAR) else {
            return Ok(Fate::Outwards);
        };
        // A file that was mirrored is inside out as a whole.
        let mirrored = self.parts[outermost as usize].inwards() == Some(true);
        let part = &self.parts[number];
        let wholly = || self.surroundings(number, thin, MANY_PROBES).inside > WHOLE;
        match part.inwards().map(|inwards| inwards != mirrored) {
            Some(true) if inside >= CLEAR && wholly() => Ok(Fate::Inwards),
            Some(_) => Ok(Fate::Outwards),
            None if inside < CLEAR => Ok(Fate::Outwards),
            None => {
                let fewer = 100.0 * part.turned.min(1.0 - part.turned);
                Err(self.refusal(part, &format!(
                    "may be the wall of a cavity or a solid within the solid, {fewer:.0} % of it facing \
                     the other way than the rest: turn its triangles all inwards or all outwards, or {WRAP}"
                )))
            }
        }
    }

    fn refusal(&self, part: &Part, reason: &str) -> GeometryError {
        let [a, b, c] = self.corners(part.facets[0]);
        let p = (a + b + c) / 3.0;
        GeometryError::Surface(format!(
            "the part of {} triangles near ({:.6}, {:.6}, {:.6}) {reason}",
            part.facets.len(),
            p.x,
            p.y,
            p.z
        ))
    }
}

/// Six times the volume that a connected part of the surface encloses.
fn volume(mesh: &Indexed, facets: &[u32]) -> f64 {
    let corners = |f: u32| mesh.corners(mesh.facets[f as usize]);
    let bounds = bounds(facets.iter().flat_map(|&f| corners(f)));
    // About a point nearby, lest cancellation eat the digits.
    let middle = 0.5 * (bounds.min + bounds.max);
    let doubled = |&f: &u32| {
        let [a, b, c] = corners(f).map(|v| v - middle);
        a.dot(&b.cross(&c))
    };
    facets.iter().map(doubled).sum()
}
